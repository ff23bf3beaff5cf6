"""What a derivation is made of: steps with a heading, a reason and equations, and the route they form.

An equation is always a SymPy object. Prose may name a symbol, never a result.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import sympy as sp

from ramanujan.derivation.symbols import COORDINATES


@dataclass(frozen=True)
class Step:
    """One move of a derivation.

    Parameters
    ----------
    key : short name, unique in its route, by which a page or a test finds the step
    heading : what is done
    reason : one sentence why, Markdown with $…$
    equations : what stands afterwards; relations that hold for every machine, or for the masses substituted
    """

    key: str
    heading: str
    reason: str
    equations: tuple[sp.Eq, ...]

    def with_numbers(self, values: Mapping[sp.Symbol, sp.Expr]) -> Step:
        """Return the same step for given exact values of m, m′, k: each side is substituted, then simplified."""
        return replace(self, equations=tuple(_substitute(equation, values) for equation in self.equations))


@dataclass(frozen=True)
class Route:
    """An ordered way from the bodies to Ω²; `natural_frequency_squared` is an expression in m, m′ and k."""

    name: str
    title: str
    steps: tuple[Step, ...]
    natural_frequency_squared: sp.Expr

    def __getitem__(self, key: str) -> Step:
        return next(step for step in self.steps if step.key == key)


def equation(left: sp.Expr | str, right: sp.Expr) -> sp.Eq:
    """Return left = right unevaluated, so that a true statement is not collapsed to True; text becomes a symbol."""
    return sp.Eq(sp.Symbol(left) if isinstance(left, str) else left, right, evaluate=False)


def _substitute(relation: sp.Eq, values: Mapping[sp.Symbol, sp.Expr]) -> sp.Eq:
    return sp.Eq(*(_tidy(side.subs(values)) for side in relation.args), evaluate=False)


def _tidy(expression: sp.Expr) -> sp.Expr:
    """Return a sum with each number as one fraction, no root in a denominator."""
    still, moving = sp.sympify(expression).as_independent(*COORDINATES, as_Add=True)
    terms = (term.as_independent(*COORDINATES, as_Add=False) for term in sp.Add.make_args(moving))
    return sp.Add(_one_fraction(still), *(_one_fraction(number) * rest for number, rest in terms))


def _one_fraction(number: sp.Expr) -> sp.Expr:
    return sp.factor(sp.radsimp(number))
