"""A step underlines exactly the terms that its operation removes, adds or moves to the other side.

A line comes from the one above it or from one of an earlier step. SymPy proves this: the sum of the changed terms is
zero, or a multiple of another line. Definitions of the step may be inserted first.
"""

from collections.abc import Collection, Sequence
from functools import cache

import pytest
import sympy as sp
from sympy.core.function import AppliedUndef

from ramanujan.derivation import ROUTES
from ramanujan.derivation.model import R
from ramanujan.derivation.numbers import GIVEN
from ramanujan.derivation.order import order_terms
from ramanujan.derivation.rows import SIDES

_CONSTANTS = {*GIVEN, R}
_FEW = 2
"""Largest number of marked terms. A change of more terms concerns the whole line, so it has no marks."""

Equations = Sequence[sp.Eq]
Places = frozenset[tuple[int, int]]
"""Terms of an equation, each by its side, 0 or 1, and its place on it."""


@pytest.mark.parametrize("name", ROUTES)
@pytest.mark.parametrize("of", [ROUTES.__getitem__, ROUTES.with_equal_masses], ids=["any masses", "equal masses"])
def test_the_marks_of_a_route_are_the_terms_that_change(name, of):
    route = of(name)
    for step, changed_terms in zip(route.steps, changes([step.equations for step in route.steps]), strict=True):
        marks = []
        for terms in changed_terms:
            marks.append(", ".join(f"{SIDES[side]} {place + 1}" for side, place in sorted(terms)))
        assert tuple(marks) == (step.underlined_terms or ("",) * len(step.equations)), step.key


def changes(steps: Sequence[Equations]) -> list[list[Places]]:
    """Return, for each equation of each step of a route, the terms that change."""
    changed_terms = [[frozenset() for _line in step] for step in steps]
    for n, step in enumerate(steps):
        before = [line for earlier in steps[:n] for line in earlier]
        for at, line in enumerate(step):
            above = step[max(at - 1, 0) : at]
            for source in (*above, *reversed(before)):
                change = _find_change(source, line, step, (*before, *step[:at]))
                if change:
                    removed, added = change
                    changed_terms[n][at] |= added
                    # Mark the removed terms in the line above, unless all terms of that line would be marked.
                    if source in above:
                        marked = changed_terms[n][at - 1] | removed
                        leaves_a_term = marked < _terms(source).keys()
                        if leaves_a_term:
                            changed_terms[n][at - 1] = marked
                    break
    return changed_terms


def _find_change(source: sp.Eq, line: sp.Eq, step: Equations, known: Equations) -> tuple[Places, Places] | None:
    """Return the changed terms of the source and of the line, or None if the line has another source."""
    old, new = _terms(source), _terms(line)
    factor = _factor(source, line)
    times = (lambda term, factor: term) if factor == 1 else (lambda term, factor: sp.factor(factor * term))
    expected = {place: times(term, factor) for place, term in old.items()}
    # The place of a term in the line → its place in the source.
    old_places: dict[tuple[int, int], tuple[int, int]] = {}
    for place, term in new.items():
        same = [old_place for old_place in old.keys() - old_places.values() if expected[old_place] == times(term, 1)]
        if same:
            side, _place = place
            # Prefer a term on the same side.
            old_places[place] = min(same, key=lambda old_place: (old_place[0] != side, old_place))
    sides = [side for side, _place in new]
    removed, added = old.keys() - old_places.values(), new.keys() - old_places.keys()
    has_only_single_terms = all(sides.count(side) == 1 for side, _place in old_places)
    if has_only_single_terms or len(added) > _FEW:
        return None
    gained = sp.Add(*(new[place] for place in added), *(-factor * old[place] for place in removed))
    if not _vanishes(gained, [other for other in step if other not in (source, line)], known):
        return None
    moved = {place for place, old_place in old_places.items() if place[0] != old_place[0]}
    marked_in_source = removed if len(removed) <= _FEW else ()
    marked_in_line = added if removed or added else moved
    return frozenset(marked_in_source), frozenset(marked_in_line)


def _factor(source: sp.Eq, line: sp.Eq) -> sp.Expr:
    """Return the ratio of a line to its source, or 1 if it is not a multiple of it."""
    is_like = _unknowns(source) == _unknowns(line) and source.free_symbols >= line.free_symbols
    return _ratio(_difference(line), _difference(source)) or sp.S.One if is_like else sp.S.One


def _vanishes(gained: sp.Expr, step: Equations, known: Equations) -> bool:
    """Return whether an expression is zero by a known equation or by a definition in the step."""
    definitions = {equation.lhs: equation.rhs for equation in step if equation.lhs.is_Symbol}
    if sp.cancel(gained.subs(definitions)) == 0:
        return True
    alike = [equation for equation in known if _unknowns(equation) == _unknowns(gained)]
    return any(_ratio(gained, _difference(equation)) for equation in alike)


def _ratio(numerator: sp.Expr, denominator: sp.Expr) -> sp.Expr | None:
    """Return the quotient of two expressions if all unknowns cancel from it."""
    quotient = sp.cancel(numerator / denominator) if denominator != 0 else sp.nan
    return quotient if quotient != sp.nan and quotient.free_symbols <= _CONSTANTS else None


@cache
def _terms(equation: sp.Eq) -> dict[tuple[int, int], sp.Expr]:
    """Return place → term. Terms of the right side have their sign on the left side."""
    is_scalar = all(isinstance(side, sp.Expr) and not side.is_Matrix for side in equation.args)
    sides = zip((1, -1), equation.args if is_scalar else (), strict=False)
    return {
        (side, place): sign * term
        for side, (sign, expression) in enumerate(sides)
        for place, term in enumerate(order_terms(expression))
        if term != 0
    }


@cache
def _difference(equation: sp.Eq) -> sp.Expr:
    return sp.Add(*_terms(equation).values())


@cache
def _unknowns(expression: sp.Basic) -> Collection[sp.Basic]:
    """Return all symbols that are not constants of the machine."""
    return expression.atoms(AppliedUndef, sp.Derivative, sp.Symbol) - _CONSTANTS
