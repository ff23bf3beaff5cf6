"""What a derivation is made of: steps with a heading, a reason and equations, and the route they form.

An equation is always a SymPy object. Prose may name a symbol, never a result.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import sympy as sp

from ramanujan.derivation.substitution import put_in


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
        return replace(self, equations=tuple(put_in(equation, values) for equation in self.equations))


@dataclass(frozen=True)
class Route:
    """An ordered way from the bodies to Ω²; `natural_frequency_squared` is an expression in m, m′ and k."""

    name: str
    title: str
    steps: tuple[Step, ...]
    natural_frequency_squared: sp.Expr

    def __getitem__(self, key: str) -> Step:
        return next(step for step in self.steps if step.key == key)

    def with_numbers(self, values: Mapping[sp.Symbol, sp.Expr]) -> Route:
        """Return the same route for given exact values of m, m′, k, Ω² included."""
        steps = tuple(step.with_numbers(values) for step in self.steps)
        return replace(self, steps=steps, natural_frequency_squared=put_in(self.natural_frequency_squared, values))


def equation(left: sp.Expr | str, right: sp.Expr) -> sp.Eq:
    """Return left = right unevaluated, so that a true statement is not collapsed to True; text becomes a symbol."""
    return sp.Eq(sp.Symbol(left) if isinstance(left, str) else left, right, evaluate=False)
