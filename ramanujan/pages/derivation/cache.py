"""The caches of page 2: the symbolic routes, and their steps as LaTeX, with and without the current masses."""

import math
from collections.abc import Mapping
from functools import cache, partial

import streamlit as st
import sympy as sp

from ramanujan.derivation import ROUTES, Route
from ramanujan.derivation.export import to_latex, to_notebook
from ramanujan.derivation.lagrangian import belongs_to, symbols_of_part, terms_by_part
from ramanujan.derivation.matrix import conserved_momenta, find_modes
from ramanujan.derivation.model import COORDINATES, MOMENTA, Omega_squared, equation, machine
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.order import InOrder
from ramanujan.derivation.printers import apply_color
from ramanujan.derivation.rows import Row, TermCommand, align_for_phone, make_row, make_rows
from ramanujan.shell.equation_blocks import ROOM, typeset_beside_machine
from ramanujan.shell.shared_cache import route

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


@cache
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
    all_modes = find_modes(machine())
    symbols = dict(zip(COORDINATES, MOMENTA, strict=True))
    momenta = [make_row(equation(symbols[q], momentum), numbers) for q, momentum in conserved_momenta().items()]
    shapes = [make_row(equation("v", shape), numbers).latex for shape in (all_modes.mode_shape, *all_modes.zero_modes)]
    return shapes, typeset_beside_machine(momenta)


@st.cache_data(show_spinner=False, max_entries=64)
def document(
    name: str,
    numbers: Numbers | None,
    kind: str,
    *,
    equal_masses: bool = False,
) -> str:
    """Return a route as a file, in symbols or with numbers.

    Parameters
    ----------
    name : name of the route
    numbers : numbers to insert, or None for symbols
    kind : a key of `FILES` on the page. A notebook is always for any masses.
    equal_masses : whether m′ = m
    """
    chosen_route = route(name, equal_masses and kind != "notebook")
    write = {"latex": to_latex, "notebook": to_notebook}[kind]
    return write(chosen_route, numbers)


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
