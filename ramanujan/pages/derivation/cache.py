"""The caches of page 2: the symbolic routes, and their steps as LaTeX, with and without the current masses."""

import math
from collections.abc import Mapping
from functools import partial

import streamlit as st
import sympy as sp

from ramanujan import Oscillator
from ramanujan.answers import QUESTIONS, question
from ramanujan.answers.questions import Question
from ramanujan.derivation import ROUTES, Route, Step
from ramanujan.derivation.energies import belongs_to, symbols_of_part, terms_by_part
from ramanujan.derivation.export import to_beamer, to_latex, to_markdown, to_notebook
from ramanujan.derivation.matrix import Modes, modes
from ramanujan.derivation.model import COORDINATES, MOMENTA, Omega_squared, equation, machine
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.order import InOrder
from ramanujan.derivation.printers import apply_color
from ramanujan.derivation.remarks import conserved_momenta
from ramanujan.derivation.rows import Row, TermCommand, align_for_phone, row, rows
from ramanujan.lesson.picture import machine_tikz
from ramanujan.shell import theme
from ramanujan.shell.cache import responsive, route
from ramanujan.shell.formulas import ROOM, typeset_beside_machine

_CUBE = sp.Integer(3)
"""The power of a side in a volume."""

Inks = tuple[tuple[str, str], ...]
"""Part of the machine, or the larger cube → its colour, #rrggbb."""


@st.cache_data(show_spinner=False, max_entries=1024)
def step(
    name: str,
    number: int,
    numbers: Numbers | None,
    inks: Inks = (),
    *,
    equal_masses: bool = False,
    wide: bool = False,
) -> tuple[str, str, str, str]:
    """Return heading, reason and equations of a step of a route, counted from 0. Terms have the colours of the bodies.

    The equations have two layouts: each operation is behind its line, or below its line for a phone.
    """
    symbolic = route(name, equal_masses).steps[number]
    adapted = symbolic.for_numbers(numbers)
    shown = rows(symbolic, numbers, partial(_row, numbers=numbers, inks=dict(inks)))
    return (
        adapted.heading,
        adapted.reason,
        typeset_beside_machine(shown, math.inf if wide else ROOM),
        align_for_phone(shown),
    )


def all_routes() -> list[Route]:
    """Return all routes."""
    return [route(name) for name in ROUTES]


@st.cache_data(show_spinner=False)
def questions_of_step(name: str, number: int) -> tuple[str, ...]:
    """Return the questions that a step of a route, counted from 0, answers for the first time."""
    steps = route(name).steps

    def first(wanted: Question) -> Step | None:
        if name == "euler_lagrange":
            return route(name)[wanted.steps[-1]]
        return next((step for step in steps if any(wanted.right in each.args for each in step.equations)), None)

    return tuple(each for each in QUESTIONS if first(question(each)) is steps[number])


@st.cache_resource(show_spinner=False)
def agrees(name: str) -> bool:
    """Return whether a route ends in the same expression as the first one. SymPy simplifies the difference to 0."""
    first = next(iter(all_routes()))
    return sp.cancel(first.natural_frequency_squared - route(name).natural_frequency_squared) == 0


@st.cache_data(show_spinner=False, max_entries=256)
def result(numbers: Numbers | None) -> list[str]:
    """Return Ω² as LaTeX in symbols and, if they are given, with numbers."""
    frequency = equation(Omega_squared, next(iter(all_routes())).natural_frequency_squared)
    return [row(frequency, given).latex for given in ([None, numbers] if numbers else [None])]


@st.cache_data(show_spinner=False, max_entries=256)
def spectrum(numbers: Numbers | None) -> tuple[list[str], str]:
    """Return the shapes of the three modes, the oscillating one first, and the conserved momenta of the zero modes."""
    all_modes = _modes()
    name = dict(zip(COORDINATES, MOMENTA, strict=True))
    momenta = [row(equation(name[q], p), numbers) for q, p in conserved_momenta().items()]
    shapes = [row(equation("v", shape), numbers).latex for shape in (all_modes.mode_shape, *all_modes.zero_modes)]
    return shapes, typeset_beside_machine(momenta)


@st.cache_data(show_spinner=False, max_entries=64)
def document(
    name: str,
    numbers: Numbers | None,
    kind: str,
    drawn: tuple[float, float] | None = None,
    step: int | None = None,
    *,
    equal_masses: bool = False,
) -> str:
    """Return a route as LaTeX, Markdown or a notebook, or its slides, in symbols or with numbers.

    The picture on the slides has the radius and the compression [m] in `drawn`. A notebook works for any masses.
    """
    chosen_route = route(name, equal_masses and kind != "notebook")
    if drawn and kind in ("slides", "step"):
        radius, compression = drawn
        picture = machine_tikz(Oscillator(radius=radius), compression, theme.paper_colors())
        return to_beamer(chosen_route, numbers, picture, step)
    write = {"latex": to_latex, "markdown": to_markdown, "notebook": to_notebook}[kind]
    return write(chosen_route, numbers)


@st.cache_resource(show_spinner=False)
@responsive()
def _modes() -> Modes:
    return modes(machine())


def _row(
    symbolic: sp.Eq,
    label: str,
    commands: tuple[TermCommand, ...],
    *,
    numbers: Numbers | None,
    inks: Mapping[str, str],
) -> Row:
    """Return an equation with the colours of the bodies: in a sum by terms, in a line about one body throughout."""
    if inks and isinstance(symbolic.rhs, InOrder):
        for place, part in enumerate(_owners(symbolic)):
            commands += (TermCommand(1, place, rf"\textcolor{{{inks[part]}}}"),)
    symbols = {part: symbols_of_part(part, symbolic) for part in inks}
    parts = [part for part in inks if symbols[part] or belongs_to(part, symbolic)]
    if len(parts) == 1 and belongs_to(parts[0], symbolic):
        return _one_color(row(symbolic, numbers, label=label, commands=commands), inks[parts[0]])
    highlight = tuple((symbol, inks[part]) for part in parts for symbol in sorted(symbols[part], key=str))
    return row(symbolic, numbers, highlight, label, commands)


def _owners(symbolic: sp.Eq) -> list[str]:
    """Return for each term of a sum the part of the machine, or the cube, that gives it its colour."""
    first_term = symbolic.rhs.args[0]
    if first_term.as_base_exp()[1] == _CUBE:
        return ["cube"]
    return [part for part, own_terms in terms_by_part(symbolic).items() for _term in own_terms]


def _one_color(plain: Row, color: str) -> Row:
    """Return a row with all of its terms in one colour."""
    return Row(apply_color(plain.left, color), tuple(apply_color(term, color) for term in plain.terms), plain.value)
