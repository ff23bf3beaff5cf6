"""What page 2 keeps: the routes in symbols once for all, their steps as LaTeX, with and without the present masses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import zip_longest

import streamlit as st
import sympy as sp

from ramanujan.answers import QUESTIONS, Question, Verdict, judge, question
from ramanujan.answers.grammar import UnreadableError, parse, typeset
from ramanujan.derivation import ROUTES, Route
from ramanujan.derivation.export import to_latex, to_markdown, to_notebook
from ramanujan.derivation.matrix import Modes, modes
from ramanujan.derivation.nomenclature import DOTS, nomenclature
from ramanujan.derivation.numbers import exact_values, stated
from ramanujan.derivation.printers import InOrder, colored, latex
from ramanujan.derivation.remarks import conserved_momenta, remarks
from ramanujan.derivation.rows import Row, aligned, extent, row, side_terms
from ramanujan.derivation.shares import PARTS, belongs_to, names, terms
from ramanujan.derivation.steps import equation
from ramanujan.derivation.symbols import COORDINATES, MOMENTA, Omega_squared, machine
from ramanujan.derivation.templates import Values
from ramanujan.shell.cache import route

_LINE_WIDTH = 54
"""Characters of a formula that fit beside the sidebar on a projector of 1280 points; longer sums are broken."""

_MANY = 6
"""Rows of equations that no longer fit on one screen below each other."""

_HALF_WIDTH = 40
"""Characters of a formula that leave room for another beside it; a fraction counts above and below its bar."""

Masses = tuple[float, float, float] | None
"""m, m′ [kg] and k [N/m]; None for the derivation in symbols."""


@dataclass(frozen=True)
class ShownStep:
    """A step as the page shows it: words, its equations as one block of LaTeX, T or ℒ body by body (or nothing)."""

    heading: str
    reason: str
    equations: str
    by_body: str


@st.cache_data(show_spinner=False)
def titles() -> dict[str, str]:
    """Return the routes' names and titles, in their order."""
    return {name: route(name).title for name in ROUTES}


@st.cache_data(show_spinner=False, max_entries=1024)
def step(name: str, number: int, masses: Masses, part: str | None, color: str | None) -> ShownStep:
    """Return a step of a route, counted from 0, with the terms of one part of the machine in its colour."""
    symbolic = route(name).steps[number]
    values = _values(masses)
    said = symbolic.about(values) if values else symbolic
    numbers = values if said.case is None else None
    split = next((e for e in said.equations if part and terms(e)), None)
    by_body = _by_body(split, numbers, part, color) if split is not None else ""
    labels = said.labels or [""] * len(said.equations)
    # Line by line, the sum over the bodies says what the sum in one line says.
    shown = dict.fromkeys(
        _row(e, numbers, part, color, label)
        for e, label in zip(said.equations, labels, strict=True)
        if e is not split or not isinstance(e.rhs, InOrder)
    )
    return ShownStep(said.heading, said.reason, _aligned(list(shown)) if shown else "", by_body)


@dataclass(frozen=True)
class Result:
    """Where a route ends: its Ω² in symbols and with numbers, and the number of its steps and equations."""

    title: str
    steps: int
    equations: int
    symbols: str
    numbers: str


@st.cache_resource(show_spinner=False)
def all_agree() -> bool:
    """Tell whether every route ends in the same expression: each difference from the first is worked out and is 0."""
    first, *others = (route(name).natural_frequency_squared for name in ROUTES)
    return all(sp.cancel(first - other) == 0 for other in others)


@st.cache_data(show_spinner=False, max_entries=256)
def results(masses: tuple[float, float, float]) -> list[Result]:
    """Return where each route ends, for the present masses too."""
    numbers = _values(masses)
    return [_result(route(name), numbers) for name in ROUTES]


@dataclass(frozen=True)
class Spectrum:
    """The three modes as LaTeX: the shape of each, and the momenta that the zero modes conserve."""

    oscillating: str
    glide: str
    free_rolling: str
    momenta: str


@st.cache_data(show_spinner=False, max_entries=256)
def spectrum(masses: Masses) -> Spectrum:
    """Return the modes and the conserved momenta, in symbols or with the present masses."""
    numbers, found = _values(masses), _modes()
    name = dict(zip(COORDINATES, MOMENTA, strict=True))
    momenta = [row(equation(name[q], p), numbers) for q, p in conserved_momenta().items()]
    shapes = (row(equation("v", shape), numbers).latex for shape in (found.mode_shape, *found.zero_modes))
    return Spectrum(*shapes, _aligned(momenta))


@dataclass(frozen=True)
class Note:
    """A remark on a line of the paper, Markdown, and whether SymPy confirms it."""

    where: str
    printed: str
    correct: str
    note: str
    holds: bool


@st.cache_data(show_spinner=False)
def notes() -> list[Note]:
    """Return the remarks on the paper, each checked."""
    return [Note(r.where, r.printed, r.correct, r.note, r.holds()) for r in remarks()]


@st.cache_data(show_spinner=False)
def questions() -> dict[str, Question]:
    """Return what the page asks, by name."""
    return {name: question(name) for name in QUESTIONS}


@st.cache_resource(show_spinner=False)
def prepare(name: str) -> bool:
    """Derive the answer to a question and its typical mistakes before the first student answers."""
    judge(name, "1")
    return True


@st.cache_data(show_spinner=False, max_entries=512)
def verdict(name: str, text: str) -> Verdict:
    """Return the verdict on an answer."""
    return judge(name, text)


@st.cache_data(show_spinner=False, max_entries=512)
def as_read(text: str) -> str | None:
    """Return the LaTeX of what the parser understands, or None where it does not understand."""
    try:
        return typeset(parse(text))
    except UnreadableError:
        return None


@st.cache_data(show_spinner=False, max_entries=64)
def document(name: str, masses: Masses, kind: str) -> str:
    """Return the route as a LaTeX, Markdown or notebook file, in symbols or with the present masses."""
    write = {"latex": to_latex, "markdown": to_markdown, "notebook": to_notebook}[kind]
    return write(route(name), _values(masses))


@st.cache_data(show_spinner=False)
def symbols(name: str) -> str:
    """Return what each symbol of a route means, in one line of Markdown."""
    entries = "; ".join(f"${entry.latex}$: {entry.meaning}" for entry in nomenclature(route(name)))
    # A square bracket before a round one would be read as a link.
    return f"{entries}. {DOTS}".replace("[", "\\[").replace("]", "\\]")


@st.cache_data(show_spinner=False, max_entries=256)
def numbers_stated(masses: tuple[float, float, float]) -> str:
    """Return the sentence that says whose numbers the steps show."""
    return stated(_values(masses))


def _values(masses: Masses) -> Values | None:
    return exact_values(*masses) if masses else None


@st.cache_resource(show_spinner=False)
def _modes() -> Modes:
    return modes(machine())


def _result(way: Route, numbers: Values) -> Result:
    frequency = equation(Omega_squared, way.natural_frequency_squared)
    return Result(
        way.title,
        len(way.steps),
        sum(len(each.equations) for each in way.steps),
        row(frequency).right,
        f"= {row(frequency, numbers).right}",
    )


def _row(symbolic: sp.Eq, numbers: Values | None, part: str | None, color: str | None, label: str) -> Row:
    """Return an equation; one about the chosen part is in its colour, in any other only what names the part."""
    if not part:
        return row(symbolic, numbers, label=label)
    if belongs_to(part, symbolic):
        plain = row(symbolic, numbers, label=label)
        return Row(colored(plain.left, color), tuple(colored(term, color) for term in plain.terms), plain.value)
    return row(symbolic, numbers, tuple((each, color) for each in sorted(names(part, symbolic), key=str)), label)


def _aligned(rows: list[Row]) -> str:
    """Return the equations as one block, aligned at the equals signs; those that say … = 0, at the left."""
    broken = [row.lines(_LINE_WIDTH) for row in rows]
    fits = all(len(right) == 1 and extent(right[0]) <= _HALF_WIDTH for right in broken)
    if len(rows) >= _MANY and fits and all(row.right != "0" for row in rows):
        return _block(_in_two_columns(rows), ".5em")
    return aligned([rows], _LINE_WIDTH, ".5em" if sum(map(len, broken)) < _MANY else ".15em")


def _in_two_columns(rows: list[Row]) -> Iterator[str]:
    """Yield the rows side by side, the first half at the left."""
    written = [f"{row.left} &= {row.right}" for row in rows]
    half = (len(written) + 1) // 2
    for left, right in zip_longest(written[:half], written[half:], fillvalue=""):
        yield rf"{left} &\qquad {right}" if right else left


def _block(rows: Iterable[str], gap: str) -> str:
    return r"\begin{aligned}" + rf" \\[{gap}] ".join(rows) + r"\end{aligned}"


def _by_body(stated: sp.Eq, numbers: Values | None, part: str, color: str) -> str:
    """Return T or ℒ with a line for each part of the machine, the chosen one in its colour."""
    rows: list[str] = []
    for name, own in terms(stated).items():
        ink = color if name == part else None
        signed = "".join(_with_sign(side_terms(term, numbers)[0]) for term in own)
        # The first row carries what is split up, the others their sign.
        start, formula = (r"&\quad", signed) if rows else (f"{latex(stated.lhs)} &=", signed.removeprefix("{}+"))
        formula, word = rf"\textstyle {formula}", rf"\text{{{PARTS[name]}}}"
        rows.append(rf"{start} {colored(formula, ink)} &&{colored(word, ink)}")
    return _block(rows, gap=".15em")


def _with_sign(term: str) -> str:
    # With nothing before it, TeX would take the sign for one that belongs to the number, and move it close.
    return f"{{}}-{term[1:].lstrip()}" if term.startswith("-") else f"{{}}+{term}"
