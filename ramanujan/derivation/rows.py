"""Equations as rows of LaTeX, in symbols or with the numbers of one machine, for the pages and the exports.

A row consists of left side, relation sign, terms of the right side, and the decimal of a numeric right side.
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
"""Side and place of each marked term, and the LaTeX command before it."""

_UNITS = {
    **dict.fromkeys((Omega_squared, Omega_clamped_squared), r"\,\mathrm{s^{-2}}"),
    **dict.fromkeys((M_e, M_x, M_clamped, M_clamped - M_e), r"\,\mathrm{kg}"),
}
"""The unit of each left side whose right side may become a number."""

SIDES = ("left", "right")
_PLACE = re.compile(r"(left|right) (\d+)")
"""A mark: a side of an equation, and the place of a term on it, counted from 1."""
_MARK = r"\underline"
_COMMAND = re.compile(r"\\(?!frac|left|right|mathrm|text|mathcal|d?dot)[a-zA-Z]+")
_SHORT, _SHORTEST = 8, 20
"""Characters of a left side that leave the full width to the right side, and of its shortest line."""
_PHONE = 28
"""Characters of a line that fits on a phone at a font size of 15 px."""
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
    value : decimal and unit after a right side that is a number, or ""
    operation : the operation that leads to the equation, for the margin, or ""
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
        """The equation without its operation and the operation's marks."""
        left, *terms = (part.replace(_MARK, "") for part in (self.left, *self.terms))
        return replace(self, left=left, terms=tuple(terms), operation="")

    @property
    def margin(self) -> str:
        """The operation as LaTeX after the equation, or ""."""
        return rf"\quad\footnotesize\vert\ {self.operation}" if self.operation else ""

    def lines(self, width: int, beside: int = 0) -> list[str]:
        """Return the right side broken into lines of about equal width; each line after the first begins with a sign.

        Parameters
        ----------
        width : characters of a line with a short left side
        beside : characters of the longest left side in the alignment
        """
        width = max(width - max(beside - _SHORT, 0), _SHORTEST)
        lines = [self.terms[0]]
        for term in self.terms[1:]:
            if extent(lines[-1] + term) > width:
                lines.append(term.strip())
            else:
                lines[-1] += term
        lines[-1] += self.value
        return lines


def rows(step: Step, numbers: Numbers | None = None, make: Callable[..., Row] | None = None) -> list[Row]:
    """Return the equations of a step as rows without duplicates, with the numbers of a machine if given.

    Parameters
    ----------
    step : one step of a route, in symbols
    numbers : of the machine; none for the symbols
    make : function of the equation, its label and `dress` that returns a row; `row` by default

    >>> from ramanujan.derivation import ROUTES
    >>> from ramanujan.derivation.numbers import Numbers
    >>> [row.latex for row in rows(ROUTES["energy"]["frequency"], Numbers(1, 1, 10))][0]
    'M_{e} = \\\\frac{99}{26} \\\\approx 3.8076923\\\\,\\\\mathrm{kg}'
    """
    adapted = step.for_numbers(numbers)
    none = [""] * len(adapted.equations)
    # An operation that leads to several equations is shown beside the first one.
    once = ("" if above == each else each for above, each in pairwise(("", *(adapted.operations or none))))
    distinct: dict[Row, Row] = {}
    for equation, label, operation, marks in zip(
        adapted.equations, adapted.labels or none, once, adapted.marks or none, strict=True
    ):
        dress = tuple((SIDES.index(side), int(place) - 1, _MARK) for side, place in _PLACE.findall(marks))
        new_row = make(equation, label, dress) if make else row(equation, numbers, label=label, dress=dress)
        distinct.setdefault(new_row, replace(new_row, operation=operation))
    return list(distinct.values())


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
    dress : function applied to the terms
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
    """Return the terms of one side as LaTeX, each with its sign; `dress` is applied to all parts of a term."""
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
    """Return the decimal of a numeric right side, and the unit of the quantity on the left.

    The mass ratio is a setting, so its decimal is omitted.
    """
    value = numbers.insert_into(equation.rhs)
    is_computed = equation.rhs.free_symbols and isinstance(value, sp.Expr) and not isinstance(value, InOrder)
    number = exact(value) if is_computed and value.is_number and equation.lhs != epsilon else None
    if number is None:
        return ""
    unit = _UNITS.get(equation.lhs, "")
    return unit if number_to_latex(number).needs_no_decimal else f" {decimal_of(number)}{unit}"


def extent(formula: str) -> int:
    """Return the approximate width of an expression in characters."""
    return len(_INVISIBLE.sub("", _COMMAND.sub("x", formula)))


def aligned(shown: Sequence[Row], width: int, gap: str = ".5em", room: float = math.inf) -> str:
    """Return rows as one display: aligned at the left if a row is … = 0, else at the equals signs; "" for none.

    Parameters
    ----------
    shown : the rows
    width : characters of a right side that fit into a line
    gap : space between equations
    room : the largest number of characters of an equation with its operation beside it instead of below
    """
    to_zero, beside = any(each.right == "0" for each in shown), widest(shown)
    # A column of operations would be far away from broken lines.
    broken = any(len(each.lines(width, beside)) > 1 for each in shown)
    longest = 0 if broken else max((extent(each.right) for each in shown), default=0)
    lines = rf" \\[{gap}] ".join(_marked(each, to_zero, width, beside, longest, room) for each in shown)
    return rf"\begin{{aligned}}{lines}\end{{aligned}}" if lines else ""


def on_a_phone(shown: Sequence[Row]) -> str:
    """Return rows as one display for a phone: short lines, each operation below its line."""
    return aligned(shown, _PHONE, ".8em", room=0)


def widest(shown: Iterable[Row]) -> int:
    """Return the approximate number of characters of the longest left side."""
    return max((extent(each.left) for each in shown), default=0)


def _marked(shown: Row, to_zero: bool, width: int, beside: int, longest: int, room: float) -> str:
    first, *others = lines = shown.lines(width, beside)
    text, taken, behind = f"&{shown.latex}", extent(shown.left + shown.right), ""
    if not to_zero:
        text = rf"{shown.left} &= {first}" + "".join(rf" \\[.3em] &\quad {other}" for other in others)
        taken, behind = beside + (longest or extent(lines[-1])), " &&" if longest else ""
    return f"{text}{behind if taken <= room else _BELOW}{shown.margin}" if shown.margin else text
