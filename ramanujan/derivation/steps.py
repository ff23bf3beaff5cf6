"""The parts of a derivation: steps with a heading, a reason and equations, and the route that they form.

An equation is always a SymPy object. Prose may name a symbol, but it never states a result.
"""

from collections import UserDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import sympy as sp

from ramanujan.derivation.model import Machine, m, machine
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.printers import latex
from ramanujan.translation import _


@dataclass(frozen=True)
class Step:
    """One step of a derivation.

    Parameters
    ----------
    key : short name, unique in its route, by which pages and tests find the step
    heading : what is done
    reason : why the step is allowed, in one sentence or a few, Markdown with $…$
    equations : relations that hold for every machine, or state a condition on ε
    special : numbers → what the step says about one given machine, still in symbols, where its own equations state a
        condition. None where numbers can be put into the equations themselves.
    labels : LaTeX before each equation, such as the coordinate to which it belongs; or none
    operations : LaTeX in the margin of each equation: what leads to it, in the words of a blackboard; or none
    marks : the terms of each equation that an operation takes out, brings in or moves, such as "left 2, right 1",
        counted as they are printed; or none
    """

    key: str
    heading: str
    reason: str
    equations: tuple[sp.Eq, ...]
    special: Callable[[Numbers], "Step"] | None = None
    labels: tuple[str, ...] = ()
    operations: tuple[str, ...] = ()
    marks: tuple[str, ...] = ()

    def about(self, numbers: Numbers | None) -> "Step":
        """Return what the step says, still in symbols, about the machine with those numbers, if there are any."""
        return self.special(numbers) if numbers and self.special else self

    def _repr_markdown_(self) -> str:
        """Show the step in a notebook."""
        return "\n\n".join([f"**{self.heading}.** {self.reason}", *(f"$${latex(e)}$$" for e in self.equations)])


def step(key: str, heading: str, reason: str, *equations: sp.Eq, **more: Any) -> Step:
    """Return a step with these equations; `more` are the other fields of `Step`."""
    return Step(key, heading, reason, equations, **more)


def blackboard(operation: str, *what: sp.Basic | str) -> str:
    """Return an operation as LaTeX for the margin; `what`, or LaTeX that says it, fills the slot of that name.

    >>> print(blackboard("insert {what}", sp.Symbol("x"), "y"))
    \\text{insert $x$, $y$}
    """
    said = ", ".join(f"${each if isinstance(each, str) else latex(each)}$" for each in what)
    return rf"\text{{{operation.format(what=said)}}}"


def insert(*what: sp.Basic | str) -> str:
    """Return the operation that inserts what is known."""
    # TRANSLATORS: an operation, written beside an equation; {what} is a formula.
    return blackboard(_("insert {what}"), *what)


def solve_for(what: sp.Basic) -> str:
    """Return the operation that solves for an unknown."""
    # TRANSLATORS: an operation, written beside an equation; {what} is a symbol.
    return blackboard(_("solve for {what}"), what)


def compare(what: sp.Basic) -> str:
    """Return the operation that reads a value off two forms of one equation."""
    # TRANSLATORS: an operation, written beside an equation; {what} is a symbol.
    return blackboard(_("compare the factors of {what}"), what)


@dataclass(frozen=True)
class Route:
    """An ordered derivation of Ω² from the bodies.

    Parameters
    ----------
    name : the key in `ROUTES`
    title : what a page calls it
    steps : the steps in their order
    natural_frequency_squared : the result, an expression in m, m′ and k
    cells : step key → plain SymPy code that repeats the step, for the notebook
    """

    name: str
    title: str
    steps: tuple[Step, ...]
    natural_frequency_squared: sp.Expr
    cells: Mapping[str, str] = field(default_factory=dict, repr=False)

    def __getitem__(self, key: str) -> Step:
        """Return the step of that key."""
        return {step.key: step for step in self.steps}[key]

    def _repr_markdown_(self) -> str:
        """Show the route in a notebook, one numbered section for each step."""
        sections = (f"{n}. {step._repr_markdown_()}" for n, step in enumerate(self.steps, start=1))
        return "\n\n".join([f"### {self.title}", *sections])


class Routes(UserDict[str, Any]):
    """Routes by name, in the order in which they were added; each is derived at its first use, and cached."""

    def add(self, name: str) -> Callable[[Callable[[Machine], Route]], Callable[[Machine], Route]]:
        """Return a decorator that enters a function, which derives a route from the bodies, under a name."""

        def enter(build: Callable[[Machine], Route]) -> Callable[[Machine], Route]:
            self.data[name] = cache(build)
            return build

        return enter

    def __getitem__(self, name: str) -> Route:
        return self.data[name](machine())

    def with_equal_masses(self, name: str) -> Route:
        """Return the route for m′ = m, with which the paper begins."""
        route = self.data[name](machine(roller_mass=m))
        return replace(route, title=_("{route}, equal masses").format(route=route.title))


ROUTES = Routes()
"""The routes of the package; `ramanujan.derivation` imports the files that add theirs."""
