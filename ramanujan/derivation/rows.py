"""Equations as rows of LaTeX, in symbols or with the numbers of one machine, for the pages and the exports.

A row consists of left side, relation sign, terms of the right side, and the decimal of a numeric right side.
"""

import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple, Self

import sympy as sp

from ramanujan.derivation.model import M_clamped, M_e, M_x, Omega_clamped_squared, Omega_squared, epsilon
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.order import InOrder, order_terms
from ramanujan.derivation.printers import (
    Highlight,
    LatexPrinter,
    add_signs,
    format_decimal,
    number_to_latex,
    to_quadratic,
)
from ramanujan.derivation.steps import Step


class TermCommand(NamedTuple):
    """A LaTeX command for one term of an equation: the side, 0 or 1, the place of the term from 0, the command."""

    side: int
    place: int
    command: str


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
_SHORT_LEFT_SIDE = 8
"""Characters of a left side that leave the full width to the right side."""
_SHORTEST_LINE = 20
"""Characters of a line of the right side beside a very long left side."""
_PHONE = 28
"""Characters of a line that fits on a phone at a font size of 15 px."""
_BELOW = r" \\[.15em] &"
"""Line break before an operation below its equation."""
_INVISIBLE = re.compile(r"\\textcolor\{#\w+\}|\\[a-zA-Z]+|\\,|[{}^_ ]")


@dataclass(frozen=True)
class Row:
    """An equation as LaTeX.

    Parameters
    ----------
    left : its left side
    terms : the terms of its right side, each with its sign
    value : decimal and unit after a right side that is a number; otherwise ""
    operation : the operation that leads to the equation, for the margin; or ""
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
        terms = tuple(term.replace(_MARK, "") for term in self.terms)
        return replace(self, left=self.left.replace(_MARK, ""), terms=terms, operation="")

    @property
    def margin(self) -> str:
        """The operation as LaTeX after the equation, or ""."""
        return rf"\quad\footnotesize\vert\ {self.operation}" if self.operation else ""

    def lines(self, width: int, left_width: int = 0) -> list[str]:
        """Return the right side in lines, each filled up to the width. Each line after the first begins with a sign.

        Parameters
        ----------
        width : characters of a line beside a left side of at most `_SHORT_LEFT_SIDE` characters
        left_width : characters of the longest left side; the additional ones are subtracted from the width
        """
        width = max(width - max(left_width - _SHORT_LEFT_SIDE, 0), _SHORTEST_LINE)
        lines = [self.terms[0]]
        for term in self.terms[1:]:
            if measure_width(lines[-1] + term) > width:
                lines.append(term.strip())
            else:
                lines[-1] += term
        lines[-1] += self.value
        return lines


def make_rows(step: Step, numbers: Numbers | None = None, make: Callable[..., Row] | None = None) -> list[Row]:
    """Return the equations of a step as rows without duplicates, in symbols or with the numbers of a machine.

    Parameters
    ----------
    step : one step of a route, in symbols
    numbers : the machine's numbers; None for a result in symbols
    make : function (equation, label, commands) → row; `make_row` by default

    >>> from ramanujan.derivation import ROUTES
    >>> from ramanujan.derivation.numbers import Numbers
    >>> [row.latex for row in make_rows(ROUTES["energy"]["frequency"], Numbers(1, 1, 10))][0]
    'M_{e} = \\\\frac{99}{26} \\\\approx 3.8076923\\\\,\\\\mathrm{kg}'
    """
    adapted = step.for_numbers(numbers)
    empty = ("",) * len(adapted.equations)
    labels, operations = adapted.labels or empty, adapted.operations or empty
    underlined_terms = adapted.underlined_terms or empty
    previous_operation = ""
    # `Row` compares rows without their operations, so a duplicate with another operation is omitted, too.
    distinct: dict[Row, Row] = {}
    for equation, label, operation, underlined in zip(
        adapted.equations, labels, operations, underlined_terms, strict=True
    ):
        commands = _underline(underlined)
        new_row = (
            make(equation, label, commands) if make else make_row(equation, numbers, label=label, commands=commands)
        )
        # An operation that leads to several equations is shown beside the first of them.
        shown_operation = "" if operation == previous_operation else operation
        distinct.setdefault(new_row, replace(new_row, operation=shown_operation))
        previous_operation = operation
    return list(distinct.values())


def _underline(terms: str) -> tuple[TermCommand, ...]:
    """Return the commands that underline terms, such as "left 2, right 1"."""
    places = _PLACE.findall(terms)
    return tuple(TermCommand(SIDES.index(side), int(place) - 1, _MARK) for side, place in places)


def make_row(
    equation: sp.Eq,
    numbers: Numbers | None = None,
    highlight: Highlight = (),
    label: str = "",
    commands: Sequence[TermCommand] = (),
) -> Row:
    """Return one equation as a row.

    Parameters
    ----------
    equation : in symbols
    numbers : the machine's numbers; None for a result in symbols
    highlight : symbols in a colour
    label : LaTeX before the equation
    commands : LaTeX commands for some terms
    """
    left = side_terms(equation.lhs, numbers, highlight, [command for command in commands if command.side == 0])
    right = side_terms(equation.rhs, numbers, highlight, [command for command in commands if command.side == 1])
    labelled = [rf"{label}:\ ", *left] if label else left
    return Row("".join(labelled), tuple(right), _format_value(equation, numbers) if numbers else "")


def side_terms(
    side: sp.Basic,
    numbers: Numbers | None = None,
    highlight: Highlight = (),
    commands: Sequence[TermCommand] = (),
) -> list[str]:
    """Return the terms of one side as LaTeX, each with its sign.

    With numbers, a term may have several parts. A command for a term is applied to all of its parts.
    """
    printer = LatexPrinter(dict(highlight))
    texts = []
    parts_of_terms = numbers.terms(side) if numbers else [(term,) for term in order_terms(side)]
    for place, parts in enumerate(parts_of_terms):
        of_term = [command.command for command in commands if command.place == place]
        for part in parts:
            if part != 0:
                texts.append(_apply_commands(printer.doprint(part), of_term))
    return add_signs(texts or ["0"])


def _apply_commands(term: str, commands: Sequence[str]) -> str:
    """Return a term as the argument of LaTeX commands, with its sign before them."""
    for command in commands:
        unsigned = term.removeprefix("- ")
        sign = term.removesuffix(unsigned)
        term = rf"{sign}{command}{{{unsigned}}}"
    return term


def _format_value(equation: sp.Eq, numbers: Numbers) -> str:
    """Return the decimal of a numeric right side, and the unit of the quantity on the left.

    An equation for ε has no decimal, because the reader has set this number.
    """
    value = numbers.insert_into(equation.rhs)
    is_computed = equation.rhs.free_symbols and isinstance(value, sp.Expr) and not isinstance(value, InOrder)
    number = to_quadratic(value) if is_computed and value.is_number and equation.lhs != epsilon else None
    if number is None:
        return ""
    unit = _UNITS.get(equation.lhs, "")
    return unit if number_to_latex(number).needs_no_decimal else f" {format_decimal(number)}{unit}"


def measure_width(formula: str) -> int:
    """Return the approximate width of an expression in characters."""
    return len(_INVISIBLE.sub("", _COMMAND.sub("x", formula)))


def align(rows: Sequence[Row], width: int, gap: str = ".5em", room: float = math.inf) -> str:
    """Return rows as one display: aligned at the left if a row ends in = 0, else at the equals signs; "" for no rows.

    Parameters
    ----------
    rows : the rows
    width : characters of a right side that fit into a line
    gap : space between equations
    room : the most characters of an equation with its operation beside it; for a longer one the operation is below
    """
    left_width = measure_left_sides(rows)
    if any(row.right == "0" for row in rows):
        texts = [_format_in_one_line(row, room) for row in rows]
    else:
        # A column of operations would be far away from broken lines.
        is_broken = any(len(row.lines(width, left_width)) > 1 for row in rows)
        column = 0 if is_broken else max((measure_width(row.right) for row in rows), default=0)
        texts = [_format_in_lines(row, width, left_width, column, room) for row in rows]
    lines = rf" \\[{gap}] ".join(texts)
    return rf"\begin{{aligned}}{lines}\end{{aligned}}" if lines else ""


def align_for_phone(rows: Sequence[Row]) -> str:
    """Return rows as one display for a phone: short lines, each operation below its line."""
    return align(rows, _PHONE, ".8em", room=0)


def measure_left_sides(rows: Iterable[Row]) -> int:
    """Return the approximate number of characters of the longest left side."""
    return max((measure_width(row.left) for row in rows), default=0)


def _format_in_one_line(row: Row, room: float) -> str:
    """Return an equation that is aligned at its beginning."""
    return f"&{row.latex}" + _add_operation(row, measure_width(row.left + row.right), "", room)


def _format_in_lines(row: Row, width: int, left_width: int, column: int, room: float) -> str:
    """Return an equation that is aligned at its equals sign.

    Parameters
    ----------
    row : the row
    width, left_width : as in `Row.lines`
    column : characters between the equals signs and a column of operations; 0 if there is no such column
    room : as in `align`
    """
    lines = row.lines(width, left_width)
    text = rf"{row.left} &= " + r" \\[.3em] &\quad ".join(lines)
    text_width = left_width + (column or measure_width(lines[-1]))
    return text + _add_operation(row, text_width, " &&" if column else "", room)


def _add_operation(row: Row, text_width: int, separator: str, room: float) -> str:
    """Return the operation of a row, after a separator, or below the row if the row is wider than `room`."""
    if not row.margin:
        return ""
    return f"{separator if text_width <= room else _BELOW}{row.margin}"
