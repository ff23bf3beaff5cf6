"""What page 2 keeps: the routes in symbols once for all, their steps as LaTeX, with and without the present masses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import zip_longest

import streamlit as st
import sympy as sp

from ramanujan.derivation import ROUTES, Route
from ramanujan.derivation.answers import QUESTIONS, Question, Verdict, judge, question
from ramanujan.derivation.export import extent, lines, to_latex, to_markdown, to_notebook
from ramanujan.derivation.expressions import typeset
from ramanujan.derivation.matrix import Modes, modes
from ramanujan.derivation.numbers import exact_values
from ramanujan.derivation.parser import UnreadableError, parse
from ramanujan.derivation.printers import colored, latex
from ramanujan.derivation.remarks import conserved_momenta, remarks
from ramanujan.derivation.shares import PARTS, belongs_to, names, terms
from ramanujan.derivation.steps import equation
from ramanujan.derivation.substitution import put_in
from ramanujan.derivation.symbols import COORDINATES, MOMENTA, Omega_squared, machine
from ramanujan.scenes.cached import route

_LINE_WIDTH = 54
"""Characters of a formula that fit beside the sidebar on a projector of 1280 points; longer sums are broken."""

_MANY = 6
"""Rows of equations that no longer fit on one screen below each other."""

_HALF_WIDTH = 40
"""Characters of a formula that leave room for another beside it; a fraction counts above and below its bar."""

_LONGEST_DENOMINATOR = 10**12
"""Ω² is written as a fraction up to here, as a decimal alone beyond."""

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
    shown = symbolic.with_numbers(values)
    rows = [_row(s, e, part, color) for s, e in zip(symbolic.equations, shown.equations, strict=True)]
    split = next((e for e in symbolic.equations if part and terms(e)), None)
    by_body = _by_body(split, values, part, color) if split is not None else ""
    return ShownStep(symbolic.heading, symbolic.reason, _aligned(rows), by_body)


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
    values = _values(masses)
    return [_result(route(name), values) for name in ROUTES]


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
    values, found = _values(masses), _modes()
    name = dict(zip(COORDINATES, MOMENTA, strict=True))
    momenta = [equation(name[q], put_in(p, values)) for q, p in conserved_momenta().items()]
    shapes = (equation("v", put_in(shape, values)) for shape in (found.mode_shape, *found.zero_modes))
    return Spectrum(*map(latex, shapes), _aligned([_row(each, each, None, None) for each in momenta]))


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
    values = _values(masses)
    if kind == "notebook":
        return to_notebook(route(name), values)
    return {"latex": to_latex, "markdown": to_markdown}[kind](route(name).with_numbers(values))


def _values(masses: Masses) -> dict[sp.Symbol, sp.Expr]:
    return exact_values(*masses) if masses else {}


@st.cache_resource(show_spinner=False)
def _modes() -> Modes:
    return modes(machine())


def _result(way: Route, values: Mapping[sp.Symbol, sp.Expr]) -> Result:
    symbolic, number = way.natural_frequency_squared, put_in(way.natural_frequency_squared, values)
    return Result(
        way.title,
        len(way.steps),
        sum(len(each.equations) for each in way.steps),
        latex(symbolic),
        " ".join(_number(number)),
    )


@dataclass(frozen=True)
class _Row:
    """An equation as LaTeX: its left side, = or ≈, its right side in lines."""

    left: str
    sign: str
    right: list[str]


def _row(symbolic: sp.Eq, shown: sp.Eq, part: str | None, color: str | None) -> _Row:
    """Return an equation; one about the chosen part is in its colour, in any other only what names the part."""
    if symbolic.lhs == Omega_squared and not shown.rhs.free_symbols:
        sign, value = _number(shown.rhs)
        return _Row(latex(shown.lhs), sign, [value])
    if part and belongs_to(part, symbolic):
        right = lines(shown.rhs, width=_LINE_WIDTH)
        return _Row(colored(latex(shown.lhs), color), "=", [colored(line, color) for line in right])
    write = partial(latex, highlight=dict.fromkeys(names(part, shown), color) if part else None)
    return _Row(write(shown.lhs), "=", lines(shown.rhs, write, _LINE_WIDTH))


def _number(value: sp.Expr) -> tuple[str, str]:
    """Return a value of Ω² as LaTeX: = and the exact value with its decimal, or ≈ and the decimal alone."""
    decimal = rf"{latex(value.evalf(8))}\,\mathrm{{s^{{-2}}}}"
    if value.is_Integer:
        return "=", rf"{latex(value)}\,\mathrm{{s^{{-2}}}}"
    if not value.is_Rational:
        return "=", rf"{latex(value)} \approx {decimal}"
    if value.q >= _LONGEST_DENOMINATOR:
        return r"\approx", decimal
    # Written as a quotient, it stays one however long it is.
    quotient = sp.Mul(value.p, sp.Pow(value.q, -1, evaluate=False), evaluate=False)
    return "=", rf"{latex(quotient)} \approx {decimal}"


def _aligned(rows: list[_Row]) -> str:
    """Return the equations as one block, aligned at the equals signs; those that say … = 0, at the left."""
    if any(row.right == ["0"] for row in rows):
        left = (f"&{row.left} {row.sign} {row.right[0]}" for row in rows)
        return _block(left, ".5em")
    if len(rows) >= _MANY and all(len(row.right) == 1 and extent(row.right[0]) <= _HALF_WIDTH for row in rows):
        return _block(_in_two_columns(rows), ".5em")
    aligned = [
        line
        for row in rows
        for line in (f"{row.left} &{row.sign} {row.right[0]}", *(rf"&\quad {more}" for more in row.right[1:]))
    ]
    return _block(aligned, ".5em" if len(aligned) < _MANY else ".15em")


def _in_two_columns(rows: list[_Row]) -> Iterator[str]:
    """Yield the rows side by side, the first half at the left."""
    written = [f"{row.left} &{row.sign} {row.right[0]}" for row in rows]
    half = (len(written) + 1) // 2
    for left, right in zip_longest(written[:half], written[half:], fillvalue=""):
        yield rf"{left} &\qquad {right}" if right else left


def _block(rows: Iterable[str], gap: str) -> str:
    return r"\begin{aligned}" + rf" \\[{gap}] ".join(rows) + r"\end{aligned}"


def _by_body(stated: sp.Eq, values: Mapping[sp.Symbol, sp.Expr], part: str, color: str) -> str:
    """Return T or ℒ with a line for each part of the machine, the chosen one in its colour."""
    rows: list[str] = []
    for name, own in terms(stated).items():
        ink = color if name == part else None
        signed = "".join(_with_sign(put_in(term, values)) for term in own)
        # The first row carries what is split up, the others their sign.
        start, formula = (r"&\quad", signed) if rows else (f"{latex(stated.lhs)} &=", signed.removeprefix("{}+"))
        formula, word = rf"\textstyle {formula}", rf"\text{{{PARTS[name]}}}"
        rows.append(rf"{start} {colored(formula, ink)} &&{colored(word, ink)}")
    return _block(rows, gap=".15em")


def _with_sign(term: sp.Expr) -> str:
    minus = term.could_extract_minus_sign()
    # With nothing before it, TeX would take the sign for one that belongs to the number, and move it close.
    return f"{{}}-{latex(-term)}" if minus else f"{{}}+{latex(term)}"
