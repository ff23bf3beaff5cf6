"""The caches of page 2: the symbolic routes, and their steps as LaTeX, with and without the current masses."""

import math
from collections.abc import Mapping
from functools import partial

import streamlit as st
import sympy as sp

from ramanujan import Oscillator
from ramanujan.answers import QUESTIONS, find_question
from ramanujan.answers.questions import Question
from ramanujan.derivation import ROUTES, Route, Step
from ramanujan.derivation.energies import belongs_to, symbols_of_part, terms_by_part
from ramanujan.derivation.export import to_beamer, to_latex, to_markdown, to_notebook
from ramanujan.derivation.matrix import Modes, find_modes
from ramanujan.derivation.model import COORDINATES, MOMENTA, Omega_squared, equation, machine
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.order import InOrder
from ramanujan.derivation.printers import apply_color
from ramanujan.derivation.remarks import conserved_momenta
from ramanujan.derivation.rows import Row, TermCommand, align_for_phone, make_row, make_rows
from ramanujan.lesson.picture import draw_tikz
from ramanujan.shell import theme
from ramanujan.shell.cache import responsive, route
from ramanujan.shell.formulas import ROOM, typeset_beside_machine

_CUBE = sp.Integer(3)
"""The exponent of a cube."""

Inks = tuple[tuple[str, str], ...]
"""Pairs of a part of the machine, or "cube" for the larger cube, and its colour, #rrggbb."""


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
    """Return heading, reason and equations of a step, the equations as LaTeX for a window and for a phone.

    Parameters
    ----------
    name : name of the route
    number : number of the step, counted from 0
    numbers : numbers to insert, or None for symbols
    inks : colours of the terms
    equal_masses : whether m′ = m
    wide : whether each operation, such as “divide by m”, is always to the right of its equation; otherwise it is
        below an equation that is too long
    """
    symbolic = route(name, equal_masses).steps[number]
    adapted = symbolic.for_numbers(numbers)
    equations = make_rows(symbolic, numbers, partial(_row, numbers=numbers, inks=dict(inks)))
    block = typeset_beside_machine(equations, math.inf if wide else ROOM)
    return adapted.heading, adapted.reason, block, align_for_phone(equations)


def all_routes() -> list[Route]:
    """Return all routes."""
    return [route(name) for name in ROUTES]


@st.cache_data(show_spinner=False)
def questions_of_step(name: str, number: int) -> tuple[str, ...]:
    """Return the questions that a step of a route, counted from 0, answers for the first time."""
    step = route(name).steps[number]
    return tuple(question for question in QUESTIONS if _answering_step(name, find_question(question)) is step)


def _answering_step(name: str, question: Question) -> Step | None:
    """Return the first step of a route that answers a question, or None."""
    if name == "euler_lagrange":
        return route(name)[question.steps[-1]]
    for step in route(name).steps:
        if any(question.right in equation.args for equation in step.equations):
            return step
    return None


@st.cache_resource(show_spinner=False)
def agrees(name: str) -> bool:
    """Return whether a route ends in the same expression as the first one. SymPy simplifies the difference to 0."""
    first = next(iter(all_routes()))
    return sp.cancel(first.natural_frequency_squared - route(name).natural_frequency_squared) == 0


@st.cache_data(show_spinner=False, max_entries=256)
def result(numbers: Numbers | None) -> list[str]:
    """Return Ω² as LaTeX in symbols and, if they are given, with numbers."""
    frequency = equation(Omega_squared, next(iter(all_routes())).natural_frequency_squared)
    lines = [make_row(frequency).latex]
    if numbers:
        lines.append(make_row(frequency, numbers).latex)
    return lines


@st.cache_data(show_spinner=False, max_entries=256)
def spectrum(numbers: Numbers | None) -> tuple[list[str], str]:
    """Return the shapes of the three modes, the oscillating one first, and the conserved momenta of the zero modes."""
    all_modes = _modes()
    symbols = dict(zip(COORDINATES, MOMENTA, strict=True))
    momenta = [make_row(equation(symbols[q], momentum), numbers) for q, momentum in conserved_momenta().items()]
    shapes = [make_row(equation("v", shape), numbers).latex for shape in (all_modes.mode_shape, *all_modes.zero_modes)]
    return shapes, typeset_beside_machine(momenta)


@st.cache_data(show_spinner=False, max_entries=64)
def document(
    name: str,
    numbers: Numbers | None,
    kind: str,
    radius_and_compression: tuple[float, float] | None = None,
    step: int | None = None,
    *,
    equal_masses: bool = False,
) -> str:
    """Return a route as a file, in symbols or with numbers.

    Parameters
    ----------
    name : name of the route
    numbers : numbers to insert, or None for symbols
    kind : a key of `FILES` on the page. A notebook is always for any masses.
    radius_and_compression : of the machine on the slides [m]
    step : number of the step for the kind "step", counted from 1
    equal_masses : whether m′ = m
    """
    chosen_route = route(name, equal_masses and kind != "notebook")
    if radius_and_compression and kind in ("slides", "step"):
        radius, compression = radius_and_compression
        picture = draw_tikz(Oscillator(radius=radius), compression, theme.paper_colors())
        return to_beamer(chosen_route, numbers, picture, step)
    write = {"latex": to_latex, "markdown": to_markdown, "notebook": to_notebook}[kind]
    return write(chosen_route, numbers)


@st.cache_resource(show_spinner=False)
@responsive()
def _modes() -> Modes:
    return find_modes(machine())


def _row(
    symbolic: sp.Eq,
    label: str,
    commands: tuple[TermCommand, ...],
    *,
    numbers: Numbers | None,
    inks: Mapping[str, str],
) -> Row:
    """Return an equation with the colours of the bodies.

    In a sum of contributions, each term has the colour of its body. An equation about a single body has one colour.
    Otherwise the symbols of each body have its colour.
    """
    right_side = 1
    if inks and isinstance(symbolic.rhs, InOrder):
        for index, part in enumerate(_owners(symbolic)):
            commands += (TermCommand(right_side, index, rf"\textcolor{{{inks[part]}}}"),)
    symbols = {part: symbols_of_part(part, symbolic) for part in inks}
    parts = [part for part in inks if symbols[part] or belongs_to(part, symbolic)]
    if len(parts) == 1 and belongs_to(parts[0], symbolic):
        return _one_color(make_row(symbolic, numbers, label=label, commands=commands), inks[parts[0]])
    highlight = []
    for part in parts:
        highlight += [(symbol, inks[part]) for symbol in sorted(symbols[part], key=str)]
    return make_row(symbolic, numbers, tuple(highlight), label, commands)


def _owners(symbolic: sp.Eq) -> list[str]:
    """Return the part of the machine for each term of a sum.

    In a sum of two cubes only the first cube has a colour, "cube".
    """
    _base, exponent = symbolic.rhs.args[0].as_base_exp()
    if exponent == _CUBE:
        return ["cube"]
    return [part for part, own_terms in terms_by_part(symbolic).items() for _term in own_terms]


def _one_color(plain: Row, color: str) -> Row:
    """Return a row with all of its terms in one colour."""
    return Row(apply_color(plain.left, color), tuple(apply_color(term, color) for term in plain.terms), plain.value)
