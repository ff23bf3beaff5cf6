"""The unit of a formula: the powers of kg, m and s in each of its terms."""

from __future__ import annotations

from fractions import Fraction

from sympy.polys.rings import PolyElement

from ramanujan.derivation.expansion import NormalForm
from ramanujan.derivation.polynomials import VARIABLES, Monomial
from ramanujan.numerals import superscript

_UNITS = {
    "m": (1, 0, 0),
    "m'": (1, 0, 0),
    "k": (1, 0, -2),
    "R": (0, 1, 0),
    "X": (0, 1, 0),
    "X'": (0, 1, -1),
    "phi": (0, 0, 0),
    "phi'": (0, 0, -1),
    "Phi": (0, 0, 0),
    "Phi'": (0, 0, -1),
}
"""Exponents of kg, m and s; angles are plain numbers."""

_COLUMNS = tuple(zip(*(_UNITS[name] for name in VARIABLES), strict=True))

Unit = tuple[Fraction, Fraction, Fraction]


def unit_of_monomial(monomial: Monomial) -> Unit:
    """Return the exponents of kg, m and s of a product of names."""
    return tuple(Fraction(sum(n * e for n, e in zip(monomial, column, strict=True))) for column in _COLUMNS)


def units(form: NormalForm) -> tuple[Unit, ...] | None:
    """Return the units that occur among the terms of a formula, sorted; None if a denominator or root has several."""
    below = _units_of(form.denominator)
    found: set[Unit] = set()
    for roots, polynomial in form.numerators:
        inside = [_units_of(radicand) for radicand in roots]
        if any(len(each) > 1 for each in (below, *inside)):
            return None
        half = [sum(column) / 2 for column in zip(*(next(iter(each)) for each in inside), strict=True)] or [0, 0, 0]
        for unit in _units_of(polynomial):
            found.add(tuple(a + b - c for a, b, c in zip(unit, half, *below, strict=True)))
    return tuple(sorted(found))


def unit_text(unit: Unit) -> str:
    """Return a unit as text, such as kg·m²/s²; empty for a plain number."""
    above = [_factor(name, n) for name, n in zip(("kg", "m", "s"), unit, strict=True) if n > 0]
    below = [_factor(name, -n) for name, n in zip(("kg", "m", "s"), unit, strict=True) if n < 0]
    if not below:
        return "·".join(above)
    denominator = "·".join(below)
    return ("·".join(above) or "1") + (f"/({denominator})" if len(below) > 1 else f"/{denominator}")


def _units_of(polynomial: PolyElement) -> set[Unit]:
    return {unit_of_monomial(monomial) for monomial in polynomial}


def _factor(name: str, exponent: Fraction) -> str:
    if exponent == 1:
        return name
    if exponent.denominator == 1:
        return f"{name}{superscript(exponent.numerator)}"
    return f"{name}^({exponent})"
