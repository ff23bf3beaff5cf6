"""Remarks on the paper: the few lines with a mistake, and their corrections. The paper's main result is right.

Each remark has a check that SymPy computes from the bodies. It is true if the printed line is wrong and the corrected
line is right. `conserved_momenta` returns the momenta of the two zero modes.
"""

from dataclasses import dataclass
from functools import cache
from itertools import combinations_with_replacement

import sympy as sp

from ramanujan.derivation.elimination import Elimination, Phi_ddot, X_ddot, eliminate, phi_ddot
from ramanujan.derivation.matrix import Modes, find_modes, list_eigenvalues
from ramanujan.derivation.model import COORDINATES, Omega_squared, X, equation, k, m, machine, phi, t
from ramanujan.derivation.printers import latex
from ramanujan.numerals import in_latex
from ramanujan.translation import _


@dataclass(frozen=True)
class Remark:
    """A line of the paper and its correction.

    Parameters
    ----------
    where : the place in the paper
    printed, correct : the printed line and the corrected line, Markdown with $…$
    note : the reason, in one or two sentences
    holds : whether, according to SymPy, the printed line is wrong and the corrected line is right
    """

    where: str
    printed: str
    correct: str
    note: str
    holds: bool


def conserved_momenta() -> dict[sp.Expr, sp.Expr]:
    """Return p_q = ∂ℒ/∂q̇ for each coordinate q that ℒ does not contain.

    A shift of this coordinate costs no energy: it is the direction of a zero-frequency mode. By Noether's theorem its
    momentum is conserved. Keys are X (the whole machine glides) and Φ (the top cylinder rolls freely).
    """
    lagrangian = machine().lagrangian
    return {q: lagrangian.diff(q.diff(t)) for q in COORDINATES if lagrangian.diff(q) == 0}


@cache
def list_remarks() -> tuple[Remark, ...]:
    """Return the remarks in the order of the paper."""
    general, spectrum = eliminate(machine()), find_modes(machine())
    return (
        _taxicab_remark(),
        _rounding_remark(eliminate(machine(roller_mass=m))),
        _coefficient_remark(general),
        _proportionality_remark(general, spectrum),
        _sign_remark(spectrum),
        _one_mode_remark(general, spectrum),
    )


def _taxicab_remark() -> Remark:
    taxicab, _ways = _smallest_in_two_ways(allows_negative=False)
    n, ways = _smallest_in_two_ways(allows_negative=True)
    sides = [str(n)]
    for a, b in ways:
        cubes = [f"{root}^3" if root > 0 else f"({root})^3" for root in sorted((a, b), reverse=True)]
        sides.append("+".join(cubes))
    return Remark(
        where=_("Introduction"),
        printed=_("“the smallest number representable in two ways as a sum of two cubes”"),
        correct=_("the smallest number that is a sum of two *positive* cubes in two ways"),
        note=_("If negative cubes are allowed, there is a smaller one: {number}.").format(
            number=f"${'='.join(sides)}$"
        ),
        holds=taxicab == 1729 and n < taxicab and all(a**3 + b**3 == n for a, b in ways),
    )


def _rounding_remark(equal_masses: Elimination) -> Remark:
    ratio = equal_masses.natural_frequency_squared * m / k
    printed, digits = sp.Rational("1.0506"), 4
    rounded = sp.floor(ratio * 10**digits + sp.Rational(1, 2)) / sp.Integer(10**digits)
    return Remark(
        where=_("Section 1, last equation"),
        printed=f"${latex(ratio)}\\approx{in_latex(f'{float(printed):.{digits}f}')}$",
        correct=f"${latex(ratio)}\\approx{in_latex(f'{float(rounded):.{digits}f}')}$",
        note=_("The last printed digit is one too high. No other result depends on it."),
        holds=bool(abs(ratio - rounded) < abs(ratio - printed)),
    )


def _coefficient_remark(result: Elimination) -> Remark:
    c_1, c_2 = _coupling_constants(result)
    printed = result.Phi_ddot_from_phi_ddot / phi_ddot
    left = sp.Symbol("c_1") / sp.Symbol("c_2")
    return Remark(
        where=_("Section 3, the constants $c_1$ and $c_2$"),
        printed=_("$c_2$ is identified from the relation between $\\ddot\\Phi$ and $\\ddot\\varphi$"),
        correct=_("{constant}; the coefficient in that relation is {ratio}").format(
            constant=f"${latex(equation('c_2', c_2))}$", ratio=f"${latex(equation(left, printed))}$"
        ),
        note=_(
            "With $\\ddot X=c_2\\ddot\\Phi$, the constant $c_2$ follows from the top cylinder’s equation of motion."
        ),
        holds=sp.simplify(printed - c_1 / c_2) == 0 and sp.simplify(printed - c_2) != 0,
    )


def _proportionality_remark(result: Elimination, spectrum: Modes) -> Remark:
    c_1, c_2 = _coupling_constants(result)
    X_0, V, Phi_0, W = sp.symbols("X_0 V Phi_0 W")
    oscillation = _oscillation(spectrum)
    drifting = (X_0 + V * t + c_1 * oscillation, oscillation, Phi_0 + W * t + c_1 / c_2 * oscillation)
    general = sp.Symbol("X_0") + sp.Symbol("V") * t + sp.Symbol("c_1") * phi
    return Remark(
        where=_("Section 3, replacing $\\varphi$"),
        printed="$\\varphi=X/c_1$",
        correct=f"${latex(equation(X, general))}$",
        note=_(
            "The accelerations are proportional. The coordinates may differ in addition by a constant and a steady "
            "drift. After a release from rest there is no drift, but $X$ oscillates about a shifted centre."
        ),
        holds=_solves(spectrum, drifting) and sp.expand(drifting[0] - c_1 * drifting[1]) != 0,
    )


def _sign_remark(spectrum: Modes) -> Remark:
    Omega2 = spectrum.natural_frequency_squared
    mode = tuple(share * _oscillation(spectrum) for share in spectrum.mode_shape)
    has_minus_sign = all(sp.expand(q.diff(t, 2) + Omega2 * q) == 0 for q in mode)
    has_minus_sign &= all(sp.expand(q.diff(t, 2) - Omega2 * q) != 0 for q in mode)
    likewise = _("{equation}, and likewise for $\\Phi$")
    return Remark(
        where=_("Section 3, the four equations"),
        printed=likewise.format(equation=f"${latex(equation(X_ddot, Omega_squared * X))}$"),
        correct=likewise.format(equation=f"${latex(equation(X_ddot, -Omega_squared * X))}$"),
        note=_(
            "Each of them lacks a minus sign. Without it the motion would grow exponentially instead of oscillating."
        ),
        holds=_solves(spectrum, mode) and has_minus_sign,
    )


def _one_mode_remark(result: Elimination, spectrum: Modes) -> Remark:
    eigenvalues = sp.Tuple(*list_eigenvalues(spectrum))
    names = sp.Tuple(*(omega**2 for omega in sp.symbols("omega_1:4")))
    shown = eigenvalues.xreplace({result.natural_frequency_squared: Omega_squared})
    return Remark(
        where=_("Section 3, last sentence"),
        printed=_("“all three modes have the same natural frequency”"),
        correct=_(
            "all three *coordinates* share the frequency of the one oscillating mode; the squared frequencies of the "
            "three modes are {values}"
        ).format(values=f"${latex(equation(names, shown))}$"),
        note=_("The other two modes have frequency zero: the whole machine glides, or the top cylinder rolls freely."),
        holds=spectrum.eigenvalues == {sp.S.Zero: 2, result.natural_frequency_squared: 1},
    )


def _coupling_constants(result: Elimination) -> tuple[sp.Expr, sp.Expr]:
    """Return the paper's c₁ = Ẍ/φ̈ and c₂ = Ẍ/Φ̈."""
    (X_ddot_from_Phi_ddot,) = sp.solve(Phi_ddot - result.Phi_ddot_from_X_ddot, X_ddot)
    return result.X_ddot_from_phi_ddot / phi_ddot, X_ddot_from_Phi_ddot / Phi_ddot


def _oscillation(spectrum: Modes) -> sp.Expr:
    return sp.cos(sp.sqrt(spectrum.natural_frequency_squared) * t)


def _solves(spectrum: Modes, motion: tuple[sp.Expr, ...]) -> bool:
    """Return whether M q̈ + K q = 0 for q = (X, φ, Φ) as functions of time."""
    q = sp.Matrix(motion)
    return (spectrum.mass_matrix * q.diff(t, 2) + spectrum.stiffness_matrix * q).applyfunc(sp.simplify).is_zero_matrix


def _smallest_in_two_ways(*, allows_negative: bool) -> tuple[int, list[tuple[int, int]]]:
    """Return the smallest positive number with two representations a³ + b³, and both representations.

    With `allows_negative`, a and b may be negative. The search is complete up to 1729: with a number below −23, the sum
    is at least 25³ − 24³ = 1801. Without negative numbers, 13³ is greater than 1729.
    """
    cubes = [a for a in range(-24 if allows_negative else 1, 26) if a != 0]
    ways: dict[int, list[tuple[int, int]]] = {}
    for a, b in combinations_with_replacement(cubes, 2):
        ways.setdefault(a**3 + b**3, []).append((a, b))
    smallest = min(n for n, pairs in ways.items() if n > 0 and len(pairs) > 1)
    return smallest, ways[smallest]
