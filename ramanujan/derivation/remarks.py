"""Remarks on the paper: the few lines with a mistake, and their corrections. The paper's main result is right.

The remarks are texts. `tests/derivation/test_remarks.py` proves that each printed line is wrong and each corrected line
is right.
"""

from dataclasses import dataclass

from ramanujan.text.numerals import in_latex
from ramanujan.text.translation import _


@dataclass(frozen=True)
class Remark:
    """A line of the paper and its correction.

    Parameters
    ----------
    where : the place in the paper
    printed, correct : the printed line and the corrected line, Markdown with $…$
    note : the reason, in one or two sentences
    """

    where: str
    printed: str
    correct: str
    note: str


_LIKEWISE = _("{equation}, and likewise for $\\Phi$")

REMARKS = (
    Remark(
        where=_("Introduction"),
        printed=_("“the smallest number representable in two ways as a sum of two cubes”"),
        correct=_("the smallest number that is a sum of two *positive* cubes in two ways"),
        note=_("If negative cubes are allowed, there is a smaller one: {number}.").format(
            number="$91=6^3+(-5)^3=4^3+3^3$"
        ),
    ),
    Remark(
        where=_("Section 1, last equation"),
        printed=f"$\\frac{{104}}{{99}}\\approx{in_latex('1.0506')}$",
        correct=f"$\\frac{{104}}{{99}}\\approx{in_latex('1.0505')}$",
        note=_("The last printed digit is one too high. No other result depends on it."),
    ),
    Remark(
        where=_("Section 3, the constants $c_1$ and $c_2$"),
        printed=_("$c_2$ is identified from the relation between $\\ddot\\Phi$ and $\\ddot\\varphi$"),
        correct=_("{constant}; the coefficient in that relation is {ratio}").format(
            constant=r"$c_{2} = \frac{3}{2}\,R$",
            ratio=r"$\frac{c_{1}}{c_{2}} = \frac{4\,\left(m + m'\right)}{7\,m + 6\,m'}$",
        ),
        note=_(
            "With $\\ddot X=c_2\\ddot\\Phi$, the constant $c_2$ follows from the top cylinder’s equation of motion."
        ),
    ),
    Remark(
        where=_("Section 3, replacing $\\varphi$"),
        printed=r"$\varphi=X/c_1$",
        correct=r"$X = \varphi\,c_{1} + V\,t + X_{0}$",
        note=_(
            "The accelerations are proportional. The coordinates may differ in addition by a constant and a steady "
            "drift. After a release from rest there is no drift, but $X$ oscillates about a shifted centre."
        ),
    ),
    Remark(
        where=_("Section 3, the four equations"),
        printed=_LIKEWISE.format(equation=r"$\ddot{X} = \Omega^{2}\,X$"),
        correct=_LIKEWISE.format(equation=r"$\ddot{X} = - \Omega^{2}\,X$"),
        note=_(
            "Each of them lacks a minus sign. Without it the motion would grow exponentially instead of oscillating."
        ),
    ),
    Remark(
        where=_("Section 3, last sentence"),
        printed=_("“all three modes have the same natural frequency”"),
        correct=_(
            "all three *coordinates* share the frequency of the one oscillating mode; the squared frequencies of the "
            "three modes are {values}"
        ).format(
            values=r"$\left( \omega_{1}^{2}, \  \omega_{2}^{2}, \  \omega_{3}^{2}\right) "
            r"= \left( 0, \  0, \  \Omega^{2}\right)$"
        ),
        note=_("The other two modes have frequency zero: the whole machine glides, or the top cylinder rolls freely."),
    ),
)
"""The remarks in the order of the paper."""
