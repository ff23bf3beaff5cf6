"""Equations as rows of LaTeX, in symbols or with the numbers of one machine: what both pages and all exports show.

A row is its left side, its sign, the terms of its right side, and the decimal of a right side that is a number.
"""

import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Self

import sympy as sp

from ramanujan.derivation.model import M_clamped, M_e, M_x, Omega_clamped_squared, Omega_squared, epsilon
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.order import InOrder, ordered_terms
from ramanujan.derivation.printers import Highlight, LatexPrinter, decimal_of, exact, number_to_latex, signed
from ramanujan.derivation.steps import Step

Dress = tuple[tuple[int, int, str], ...]
"""Side and place of terms, each with the command of LaTeX that is put before it."""

_UNITS = {
    **dict.fromkeys((Omega_squared, Omega_clamped_squared), r"\,\mathrm{s^{-2}}"),
    **dict.fromkeys((M_e, M_x, M_clamped, M_clamped - M_e), r"\,\mathrm{kg}"),
}
"""The unit of a left side whose right side may become a number."""

SIDES = ("left", "right")
_PLACE = re.compile(r"(left|right) (\d+)")
"""A mark: a side of an equation, and the place of a term on it, counted from 1."""
_MARK = r"\underline"
_COMMAND = re.compile(r"\\(?!frac|left|right|mathrm|text|mathcal|d?dot)[a-zA-Z]+")
_SHORT, _SHORTEST = 8, 20
"""Characters of a left side that take no room from the right one, and of the shortest line of a right side."""
_PHONE = 28
"""Characters of a line that fits on a phone, in letters of 15 px."""
_BELOW = r" \\[.15em] &"
"""Begins a line for an operation."""
_INVISIBLE = re.compile(r"\\textcolor\{#\w+\}|\\[a-zA-Z]+|\\,|[{}^_ ]")


@dataclass(frozen=True)
class Row:
    """An equation as LaTeX.

    Parameters
    ----------
    left : its left side
    terms : the terms of its right side, each with its sign
    value : what follows a right side that is a number: its decimal and its unit, or ""
    operation : what leads to the equation, for the margin, or ""
    """

    left: str
    terms: tuple[str, ...]
    value: str = ""
    operation: str = field(default="", compare=False)

    @property
    def right(self) -> str:
        """The right side in one line."""
        return "".join(self.terms) + self.value

    @property
    def latex(self) -> str:
        """The equation in one line."""
        return f"{self.left} = {self.right}"

    @property
    def unmarked(self) -> Self:
        """The equation without its operation and the marks of that."""
        left, *terms = (part.replace(_MARK, "") for part in (self.left, *self.terms))
        return replace(self, left=left, terms=tuple(terms), operation="")

    @property
    def margin(self) -> str:
        """The operation as LaTeX behind the equation, or ""."""
        return rf"\quad\footnotesize\vert\ {self.operation}" if self.operation else ""

    def lines(self, width: int, beside: int = 0) -> list[str]:
        """Return the right side in lines of about so many characters; each but the first begins with a sign.

        Parameters
        ----------
        width : of a line whose left side is short
        beside : characters of the longest left side with which this row is aligned
        """
        width = max(width - max(beside - _SHORT, 0), _SHORTEST)
        found = [self.terms[0]]
        for term in self.terms[1:]:
            if extent(found[-1] + term) > width:
                found.append(term.strip())
            else:
                found[-1] += term
        found[-1] += self.value
        return found


def rows(step: Step, numbers: Numbers | None = None, make: Callable[..., Row] | None = None) -> list[Row]:
    """Return the equations of a step as rows, with the numbers of a machine if they are given, none twice.

    Parameters
    ----------
    step : one step of a route, in symbols
    numbers : of the machine; none for the symbols
    make : equation, its label and dress → a row; `row` by itself

    >>> from ramanujan.derivation import ROUTES
    >>> from ramanujan.derivation.numbers import Numbers
    >>> [row.latex for row in rows(ROUTES["energy"]["frequency"], Numbers(1, 1, 10))][0]
    'M_{e} = \\\\frac{99}{26} \\\\approx 3.8076923\\\\,\\\\mathrm{kg}'
    """
    said = step.about(numbers)
    none = [""] * len(said.equations)
    # An operation that leads to several lines stands at the first of them.
    once = ("" if above == each else each for above, each in pairwise(("", *(said.operations or none))))
    found: dict[Row, Row] = {}
    for equation, label, operation, marked in zip(
        said.equations, said.labels or none, once, said.marks or none, strict=True
    ):
        dress = tuple((SIDES.index(side), int(place) - 1, _MARK) for side, place in _PLACE.findall(marked))
        made = make(equation, label, dress) if make else row(equation, numbers, label=label, dress=dress)
        found.setdefault(made, replace(made, operation=operation))
    return list(found.values())


def row(
    equation: sp.Eq, numbers: Numbers | None = None, highlight: Highlight = (), label: str = "", dress: Dress = ()
) -> Row:
    """Return one equation as a row.

    Parameters
    ----------
    equation : in symbols
    numbers : of the machine; none for the symbols
    highlight : symbols in a colour
    label : LaTeX before the equation
    dress : what is done to terms
    """
    left, right = (
        side_terms(side, numbers, highlight, [each[1:] for each in dress if each[0] == number])
        for number, side in enumerate(equation.args)
    )
    labelled = [rf"{label}:\ ", *left] if label else left
    return Row("".join(labelled), tuple(right), _value(equation, numbers) if numbers else "")


def side_terms(
    side: sp.Basic,
    numbers: Numbers | None = None,
    highlight: Highlight = (),
    dress: Sequence[tuple[int, str]] = (),
) -> list[str]:
    """Return the terms of one side as LaTeX, each with its sign; what is done to a term is done to all its parts."""
    printer, texts = LatexPrinter(dict(highlight)), []
    parts_of_terms = numbers.terms(side) if numbers else [(term,) for term in ordered_terms(side)]
    for place, parts in enumerate(parts_of_terms):
        for part in parts:
            text = printer.doprint(part)
            for _place, command in (each for each in dress if each[0] == place):
                unsigned = text.removeprefix("- ")
                sign = text.removesuffix(unsigned)
                text = rf"{sign}{command}{{{unsigned}}}"
            if part != 0:
                texts.append(text)
    return signed(texts or ["0"])


def _value(equation: sp.Eq, numbers: Numbers) -> str:
    """Return the decimal of a right side that is a number, and the unit of the quantity at the left.

    The mass ratio itself is what was set; its decimal would add nothing.
    """
    value = numbers.put_into(equation.rhs)
    is_computed = equation.rhs.free_symbols and isinstance(value, sp.Expr) and not isinstance(value, InOrder)
    number = exact(value) if is_computed and value.is_number and equation.lhs != epsilon else None
    if number is None:
        return ""
    unit = _UNITS.get(equation.lhs, "")
    return unit if number_to_latex(number).says_all else f" {decimal_of(number)}{unit}"


def extent(formula: str) -> int:
    """Return about how many characters stand side by side."""
    return len(_INVISIBLE.sub("", _COMMAND.sub("x", formula)))


def aligned(shown: Sequence[Row], width: int, gap: str = ".5em", room: float = math.inf) -> str:
    """Return rows as one display: aligned at the equals signs or, where some say … = 0, at the left; "" for none.

    Parameters
    ----------
    shown : the rows
    width : characters of a right side that fit into a line
    gap : room between equations
    room : characters of an equation behind which its operation still stands; a longer one has it below
    """
    to_zero, beside = any(each.right == "0" for each in shown), widest(shown)
    # Behind broken lines a column of operations would be far away.
    broken = any(len(each.lines(width, beside)) > 1 for each in shown)
    longest = 0 if broken else max((extent(each.right) for each in shown), default=0)
    lines = rf" \\[{gap}] ".join(_marked(each, to_zero, width, beside, longest, room) for each in shown)
    return rf"\begin{{aligned}}{lines}\end{{aligned}}" if lines else ""


def on_a_phone(shown: Sequence[Row]) -> str:
    """Return rows as one display that is narrow enough for a phone: short lines, each operation below its line."""
    return aligned(shown, _PHONE, ".8em", room=0)


def widest(shown: Iterable[Row]) -> int:
    """Return about how many characters the longest left side has."""
    return max((extent(each.left) for each in shown), default=0)


def _marked(shown: Row, to_zero: bool, width: int, beside: int, longest: int, room: float) -> str:
    first, *others = lines = shown.lines(width, beside)
    made, taken, behind = f"&{shown.latex}", extent(shown.left + shown.right), ""
    if not to_zero:
        made = rf"{shown.left} &= {first}" + "".join(rf" \\[.3em] &\quad {other}" for other in others)
        taken, behind = beside + (longest or extent(lines[-1])), " &&" if longest else ""
    return f"{made}{behind if taken <= room else _BELOW}{shown.margin}" if shown.margin else made
