"""What page 2 keeps: the routes in symbols once for all, their steps as LaTeX, with and without the present masses."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import zip_longest

import streamlit as st
import sympy as sp

from ramanujan import Oscillator
from ramanujan.answers import Verdict, judge, shown_step
from ramanujan.answers.grammar import UnreadableError, typeset
from ramanujan.derivation import ROUTES, Route
from ramanujan.derivation.energies import PARTS, belongs_to, names, terms
from ramanujan.derivation.export import to_beamer, to_latex, to_markdown, to_notebook
from ramanujan.derivation.matrix import Modes, modes
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.printers import InOrder, colored, latex
from ramanujan.derivation.remarks import conserved_momenta
from ramanujan.derivation.rows import Row, aligned, extent, row, rows, side_terms, widest
from ramanujan.derivation.steps import equation
from ramanujan.derivation.symbols import COORDINATES, MOMENTA, Omega_squared, machine
from ramanujan.lesson.picture import machine_tikz
from ramanujan.shell import theme
from ramanujan.shell.cache import giving_way, route

LINE_WIDTH, BESIDE_MACHINE = 54, 44
"""Characters of a formula that fit beside the sidebar in a window of 1280 points, and beside the machine on a
projector; longer sums are broken."""

_MANY = 6
"""Rows of equations that no longer fit on one screen below each other."""

_HALF_WIDTH = 40
"""Characters of a formula that leave room for another beside it; a fraction counts above and below its bar."""


@dataclass(frozen=True)
class ShownStep:
    """A step as the page shows it: words, its equations as one block of LaTeX, T or ℒ body by body (or nothing)."""

    heading: str
    reason: str
    equations: str
    by_body: str


@st.cache_data(show_spinner=False, max_entries=1024)
def step(
    name: str,
    number: int,
    numbers: Numbers | None,
    part: str | None,
    color: str | None,
    width: int = LINE_WIDTH,
    *,
    equal_masses: bool = False,
) -> ShownStep:
    """Return a step of a route, counted from 0, with the terms of one part of the machine in its colour."""
    symbolic = route(name, equal_masses).steps[number]
    said = symbolic.about(numbers)
    split = next((e for e in said.equations if part and terms(e)), None)
    by_body = _by_body(split, numbers, part, color) if split is not None else ""

    def written(symbolic: sp.Eq, label: str, marks: tuple[tuple[int, int], ...]) -> Row | None:
        # Line by line, the sum over the bodies says what the sum in one line says.
        is_sum = symbolic == split and isinstance(symbolic.rhs, InOrder)
        return None if is_sum else _row(symbolic, numbers, part, color, label, marks)

    shown = rows(symbolic, numbers, written)
    return ShownStep(said.heading, said.reason, _aligned(shown, width) if shown else "", by_body)


def all_routes() -> list[Route]:
    """Return all routes."""
    return [route(name) for name in ROUTES]


@st.cache_resource(show_spinner=False)
def all_agree() -> bool:
    """Tell whether every route ends in the same expression: each difference from the first is worked out and is 0."""
    first, *others = (each.natural_frequency_squared for each in all_routes())
    return all(sp.cancel(first - other) == 0 for other in others)


@st.cache_data(show_spinner=False, max_entries=256)
def results(numbers: Numbers) -> list[tuple[str, str, str, str]]:
    """Return for each route its title, the number of its steps, and its Ω² in symbols and with these numbers."""
    found = []
    for way in all_routes():
        frequency = equation(Omega_squared, way.natural_frequency_squared)
        found.append((way.title, str(len(way.steps)), row(frequency).right, row(frequency, numbers).right))
    return found


@st.cache_data(show_spinner=False, max_entries=256)
def spectrum(numbers: Numbers | None) -> tuple[list[str], str]:
    """Return the shapes of the three modes, the oscillating one first, and the momenta that the others conserve."""
    found = _modes()
    name = dict(zip(COORDINATES, MOMENTA, strict=True))
    momenta = [row(equation(name[q], p), numbers) for q, p in conserved_momenta().items()]
    shapes = [row(equation("v", shape), numbers).latex for shape in (found.mode_shape, *found.zero_modes)]
    return shapes, _aligned(momenta)


@st.cache_data(show_spinner=False)
def step_to_answer(name: str) -> str:
    """Return the step that leads to the answer of a question, as one block of LaTeX."""
    return _aligned([row(each) for each in shown_step(name)])


@st.cache_data(show_spinner=False, max_entries=512)
@giving_way()
def verdict(name: str, text: str) -> Verdict:
    """Return the verdict on an answer; the first one of a question also derives its answer and typical mistakes."""
    return judge(name, text)


@st.cache_data(show_spinner=False, max_entries=512)
def as_read(text: str, is_equation: bool = False) -> str | None:
    """Return the LaTeX of what the parser understands, or None where it does not understand."""
    try:
        return typeset(text, is_equation=is_equation)
    except UnreadableError:
        return None


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
    """Return the route as LaTeX, Markdown or a notebook, or it or one step as slides, in symbols or with numbers.

    Slides show the machine that is `drawn`, of a radius and with a compression [m]. A notebook takes any masses.
    """
    way = route(name, equal_masses and kind != "notebook")
    if drawn and kind in ("slides", "step"):
        radius, compression = drawn
        picture = machine_tikz(Oscillator(radius=radius), compression, theme.on_paper())
        return to_beamer(way, numbers, picture, step)
    write = {"latex": to_latex, "markdown": to_markdown, "notebook": to_notebook}[kind]
    return write(way, numbers)


@st.cache_resource(show_spinner=False)
@giving_way()
def _modes() -> Modes:
    return modes(machine())


def _row(
    symbolic: sp.Eq,
    numbers: Numbers | None,
    part: str | None,
    color: str | None,
    label: str,
    marks: tuple[tuple[int, int], ...],
) -> Row:
    """Return an equation; one about the chosen part is in its colour, in any other only what names the part."""
    if not part:
        return row(symbolic, numbers, label=label, marks=marks)
    if belongs_to(part, symbolic):
        plain = row(symbolic, numbers, label=label, marks=marks)
        return Row(colored(plain.left, color), tuple(colored(term, color) for term in plain.terms), plain.value)
    named = tuple((each, color) for each in sorted(names(part, symbolic), key=str))
    return row(symbolic, numbers, named, label, marks)


def _aligned(shown: list[Row], width: int = LINE_WIDTH) -> str:
    """Return the equations as one block, aligned at the equals signs; those that say … = 0, at the left."""
    broken = [each.lines(width, widest(shown)) for each in shown]
    fits = all(len(right) == 1 and extent(right[0]) <= _HALF_WIDTH for right in broken)
    if len(shown) >= _MANY and fits and all(each.right != "0" for each in shown):
        return _block(_in_two_columns(shown), ".5em")
    return aligned([shown], width, ".5em" if sum(map(len, broken)) < _MANY else ".15em")


def _in_two_columns(shown: list[Row]) -> Iterator[str]:
    """Yield the rows side by side, the first half at the left."""
    written = [f"{row.left} &= {row.right}" for row in shown]
    half = (len(written) + 1) // 2
    for left, right in zip_longest(written[:half], written[half:], fillvalue=""):
        yield rf"{left} &\qquad {right}" if right else left


def _block(rows: Iterable[str], gap: str) -> str:
    return r"\begin{aligned}" + rf" \\[{gap}] ".join(rows) + r"\end{aligned}"


def _by_body(stated: sp.Eq, numbers: Numbers | None, part: str, color: str) -> str:
    """Return T or ℒ with a line for each part of the machine, the chosen one in its colour."""
    lines: list[str] = []
    for name, own in terms(stated).items():
        ink = color if name == part else None
        signed = "".join(_with_sign(side_terms(term, numbers)[0]) for term in own)
        # The first row carries what is split up, the others their sign.
        start, formula = (r"&\quad", signed) if lines else (f"{latex(stated.lhs)} &=", signed.removeprefix("{}+"))
        formula, word = rf"\textstyle {formula}", rf"\text{{{PARTS[name]}}}"
        lines.append(rf"{start} {colored(formula, ink)} &&{colored(word, ink)}")
    return _block(lines, gap=".15em")


def _with_sign(term: str) -> str:
    # With nothing before it, TeX would take the sign for one that belongs to the number, and move it close.
    return f"{{}}-{term[1:].lstrip()}" if term.startswith("-") else f"{{}}+{term}"
