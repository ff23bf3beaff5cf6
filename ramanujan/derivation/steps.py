"""The parts of a derivation: steps with a heading, a reason and equations, and routes of such steps.

An equation is always a SymPy object. Prose may contain a symbol, but never a result.
"""

from collections import UserDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from threading import RLock
from typing import Any

import sympy as sp

from ramanujan.derivation.model import Machine, m, machine
from ramanujan.derivation.numbers import Numbers, state_factor_one
from ramanujan.derivation.printers import latex
from ramanujan.text.translation import _


@dataclass(frozen=True)
class Step:
    """One step of a derivation.

    Parameters
    ----------
    key : short name, unique in its route
    heading : the action of the step, in a few words
    reason : why the step is allowed, in one sentence or a few, Markdown with $…$
    equations : relations that hold for every machine, or state a condition on ε
    variant : function (numbers of a machine) → variant of the step in symbols, for equations that state a condition.
        None if the numbers can be inserted into the equations.
    labels : LaTeX before each equation, such as the coordinate to which it belongs; or none
    operations : LaTeX in the margin of each equation, for the operation that leads to it; or none
    underlined_terms : the terms of each equation that an operation removes, adds or moves, such as "left 2, right 1",
        in printed order; or none
    """

    key: str
    heading: str
    reason: str
    equations: tuple[sp.Eq, ...]
    variant: Callable[[Numbers], "Step"] | None = None
    labels: tuple[str, ...] = ()
    operations: tuple[str, ...] = ()
    underlined_terms: tuple[str, ...] = ()

    def for_numbers(self, numbers: Numbers | None) -> "Step":
        """Return the variant of the step for the numbers of a machine, still in symbols, or the step itself.

        Its reason mentions a mass of 1 kg that is not written as a factor.
        """
        if not numbers:
            return self
        adapted = self.variant(numbers) if self.variant else self
        note = state_factor_one(numbers, adapted.equations)
        return replace(adapted, reason=f"{adapted.reason} {note}") if note else adapted

    def _repr_markdown_(self) -> str:
        """Return the step as Markdown for a notebook."""
        equations = (f"$${latex(equation)}$$" for equation in self.equations)
        return "\n\n".join([f"**{self.heading}.** {self.reason}", *equations])


def step(key: str, heading: str, reason: str, *equations: sp.Eq, **more: Any) -> Step:
    """Return a step with these equations; `more` are the other fields of `Step`."""
    return Step(key, heading, reason, equations, **more)


def margin_text(operation: str, *expressions: sp.Basic | str) -> str:
    """Return an operation as LaTeX for the margin; expressions, or their LaTeX, fill the slot {what}.

    >>> print(margin_text("insert {what}", sp.Symbol("x"), "y"))
    \\text{insert $x$, $y$}
    """
    formulas = [text if isinstance(text, str) else latex(text) for text in expressions]
    what = ", ".join(f"${formula}$" for formula in formulas)
    return rf"\text{{{operation.format(what=what)}}}"


def insert(*expressions: sp.Basic | str) -> str:
    """Return the operation that inserts known expressions."""
    # TRANSLATORS: an operation, written beside an equation; {what} is a formula.
    return margin_text(_("insert {what}"), *expressions)


def solve_for(unknown: sp.Basic) -> str:
    """Return the operation that solves for an unknown."""
    # TRANSLATORS: an operation, written beside an equation; {what} is a symbol.
    return margin_text(_("solve for {what}"), unknown)


def compare_factors(expression: sp.Basic) -> str:
    """Return the operation that compares the factors of an expression in two forms of one equation."""
    # TRANSLATORS: an operation, written beside an equation; {what} is a symbol.
    return margin_text(_("compare the factors of {what}"), expression)


@dataclass(frozen=True)
class Route:
    """An ordered derivation of Ω² from the bodies.

    Parameters
    ----------
    name : the key in `ROUTES`
    title : the title on a page
    idea : what the route starts from, and what it does without, in a few words
    steps : the steps in their order
    natural_frequency_squared : the result, an expression in m, m′ and k
    cells : step key → plain SymPy code that repeats the step, for the notebook
    """

    name: str
    title: str
    idea: str
    steps: tuple[Step, ...]
    natural_frequency_squared: sp.Expr
    cells: Mapping[str, str] = field(default_factory=dict, repr=False)

    def __getitem__(self, key: str) -> Step:
        """Return the step with this key."""
        return {step.key: step for step in self.steps}[key]

    def _repr_markdown_(self) -> str:
        """Return the route as Markdown for a notebook, with a numbered section for each step."""
        sections = (f"{n}. {step._repr_markdown_()}" for n, step in enumerate(self.steps, start=1))
        return "\n\n".join([f"### {self.title}", *sections])


class Routes(UserDict[str, Any]):
    """Routes by name, in the order in which they were added; each is derived at its first use, and cached.

    Simultaneous first visitors wait for one derivation, which takes SymPy about a second.
    """

    _one_at_a_time = RLock()

    def add(self, name: str) -> Callable[[Callable[[Machine], Route]], Callable[[Machine], Route]]:
        """Return a decorator that adds a function, machine → route, under this name."""

        def register(build: Callable[[Machine], Route]) -> Callable[[Machine], Route]:
            self.data[name] = cache(build)
            return build

        return register

    def __getitem__(self, name: str) -> Route:
        with self._one_at_a_time:
            return self.data[name](machine())

    def with_equal_masses(self, name: str) -> Route:
        """Return the route for m′ = m, the first case of the paper."""
        with self._one_at_a_time:
            route = self.data[name](machine(roller_mass=m))
        return replace(route, title=_("{route}, equal masses").format(route=route.title))


ROUTES = Routes()
"""The routes of the package, added by the modules that `ramanujan.derivation` imports."""
