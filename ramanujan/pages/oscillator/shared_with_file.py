"""The texts that the first page shares with the standalone file."""

from ramanujan.figures.oscillator_page import FrequencyCurve
from ramanujan.pages.oscillator import cache
from ramanujan.text.translation import _

CURVE_HEADING = _("When is it in step with the plain mass?")
CURVE_TEXT = _(
    "The plain mass $m$ on the spring $k$ has the angular frequency $\\sqrt{{k/m}}$, the machine has "
    "$\\Omega$. They are in step where $\\Omega^2m/k=1$. This depends only on the mass ratio "
    "$\\varepsilon=m'/m$."
).format()
"""The explanation of the curve, with formulas between dollar signs."""
CURVE_HINT = _("Choose a point of the curve to build the machine with that mass ratio.")
STEPS_HEADING = _("The derivation in six steps")


def question() -> str:
    """Return the question of the page in Markdown. It compares the machine with the plain mass."""
    return _(
        "Each clock hand turns once in a period (oscillation): one for the machine, one for the plain mass. "
        "**Which lower-roller mass m′ keeps them in step?**"
    )


def curve_alternative(curve: FrequencyCurve) -> str:
    """Return the text alternative of the curve."""
    sentences = _(
        "Ω²m/k over the mass ratio ε, falling from {light} for light rollers towards {heavy} for heavy ones: heavier "
        "rollers make the machine slower. It is {equal} at equal masses, and exactly 1 at one ratio only."
    )
    return sentences.format(light=curve.light, heavy=curve.heavy, equal=cache.equal_masses_value())
