"""A derivation as a file: a LaTeX article or slides, a Markdown text, or a notebook that repeats the derivation.

LaTeX and Markdown contain the route in symbols or with the numbers of one machine. The notebook is plain SymPy.
"""

import json
import math
import re

import sympy as sp

from ramanujan.derivation.nomenclature import DOTS, nomenclature
from ramanujan.derivation.notebooks import BODIES, CHECK, DISTANCE, FREQUENCY
from ramanujan.derivation.numbers import Numbers, state_numbers
from ramanujan.derivation.rows import Row, make_rows, measure_left_sides, measure_width
from ramanujan.derivation.steps import Route, Step
from ramanujan.translation import _, pgettext

TITLE = _("Ramanujan’s oscillator: {route}")
_SYMBOLS, _MACHINE = pgettext("list of them", "Symbols"), _("The machine")
_WITH_NUMBERS, _CHECK_HEADING = _("With numbers"), _("Check the result another way")
_BODIES_TEXT = _("The machine has five bodies, three of which roll, and one spring.")
_CHECK_TEXT = _("The nonzero root of $\\det(K-\\omega^2M)=0$ must be the same $\\Omega^2$.")
_DISTANCE_TEXT = _("How far is this machine from the condition $\\Omega^2=k/m$?")
# TRANSLATORS: the name of your language in LaTeX's package babel, such as ngerman.
_BABEL = pgettext("LaTeX package babel", "english")
_WORDS = (
    ""
    if _BABEL == "english"
    else (
        "\\usepackage[T1]{fontenc}\n\\IfFileExists{lmodern.sty}{\\usepackage{lmodern}}{}\n"
        f"\\usepackage[{_BABEL}]{{babel}}\n"
    )
)
"""How LaTeX divides words and sets letters that English does not have."""

_PREAMBLE = r"""\documentclass[a4paper,11pt]{article}
\usepackage{amsmath}
\setlength{\oddsidemargin}{-10mm}
\setlength{\textwidth}{180mm}
\setlength{\parindent}{0pt}
\allowdisplaybreaks
"""

_SLIDES = r"""\documentclass[aspectratio=169,10pt]{beamer}
\usepackage{amsmath,tikz}
\usetikzlibrary{svg.path}
\setbeamertemplate{navigation symbols}{}
\setlength{\jot}{6pt}
"""
_ANY_PICTURE = _("A stage of the app saves its own picture as TikZ: put it here instead of this one.")

_IN_PROSE = {
    "\\": r"\textbackslash{}",
    **{character: f"\\{character}" for character in "#$%&_{}"},
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "–": "--",
    "—": "---",
    "’": "'",
    "“": "``",
    "”": "''",
    "′": "$'$",
    "²": "$^2$",
    "·": r"$\cdot$",
    "…": r"\dots{}",
}
_PROSE_TABLE = str.maketrans(_IN_PROSE)
_LINE_WIDTH = 60
"""Characters of a formula that fit on one line of the article, from typesetting all routes with TeX."""
_SLIDE_WIDTH, _SLIDE_LINES = 50, 5
"""Characters of a formula that fit on one line of a slide, and lines that fit on a slide."""
_MATH = re.compile(r"(\$[^$]*\$)")


BrokenRow = tuple[Row, list[str]]
"""A row, and the lines of its right side."""


def to_latex(route: Route, numbers: Numbers | None = None) -> str:
    """Return the route as a LaTeX document that needs only amsmath; in English it is plain ASCII.

    Parameters
    ----------
    route : one of `ROUTES`, in symbols
    numbers : the machine's numbers; None for a result in symbols
    """
    listed = nomenclature(route).items()
    entries = "".join(f"\\item ${symbol}$: {prose_to_latex(meaning)}\n" for symbol, meaning in listed)
    heading = prose_to_latex(_SYMBOLS)
    symbols = f"\\section*{{{heading}}}\n\\begin{{itemize}}\n{entries}\\end{{itemize}}\n{prose_to_latex(DOTS)}\n"
    body = "".join(_latex_section(step, numbers) for step in route.steps)
    title = f"\\title{{{prose_to_latex(TITLE.format(route=route.title))}}}\n\\author{{}}\n\\date{{}}\n"
    opening = f"\\begin{{document}}\n\\maketitle\n{prose_to_latex(_write_number_paragraph(numbers))}{symbols}"
    return f"{_PREAMBLE}{_WORDS}{title}{opening}{body}\\end{{document}}\n"


def to_beamer(route: Route, numbers: Numbers | None = None, picture: str = "", step: int | None = None) -> str:
    """Return the route as slides for LaTeX's beamer: the machine, then a frame or more for each step.

    Parameters
    ----------
    route : one of `ROUTES`, in symbols
    numbers : the machine's numbers; None for a result in symbols
    picture : the machine as TikZ
    step : number of the requested step, counted from 1; None for all steps
    """
    title = f"\\title{{{prose_to_latex(TITLE.format(route=route.title))}}}\n\\date{{}}\n"
    sentence = f"\n{prose_to_latex(state_numbers(numbers))}\n" if numbers else ""
    machine = f"\\centering\n% {_ANY_PICTURE}\n{picture}{sentence}"
    frames = [("title", "", "\\titlepage\n"), ("machine", prose_to_latex(_MACHINE), machine)]
    steps = route.steps if step is None else route.steps[step - 1 : step]
    for shown_step in steps:
        frames += _build_frames(shown_step, numbers)
    body = "".join(f"\\begin{{frame}}[label={label}]{{{head}}}\n{text}\\end{{frame}}\n" for label, head, text in frames)
    return f"{_SLIDES}{_WORDS}{title}\\begin{{document}}\n{body}\\end{{document}}\n"


def to_markdown(route: Route, numbers: Numbers | None = None) -> str:
    """Return the route as Markdown with $…$ and $$…$$.

    Parameters
    ----------
    route : one of `ROUTES`, in symbols
    numbers : the machine's numbers; None for a result in symbols
    """
    opening = f"# {TITLE.format(route=route.title)}\n\n{_write_number_paragraph(numbers)}{_list_symbols(route)}"
    sections = (_markdown_section(n, step, numbers) for n, step in enumerate(route.steps, start=1))
    return "\n\n".join([opening, *sections]) + "\n"


def to_notebook(route: Route, numbers: Numbers | None = None) -> str:
    """Return a Jupyter notebook (format 4.5, JSON) that derives the route's Ω² from the bodies with plain SymPy.

    Parameters
    ----------
    route : one of `ROUTES`, in symbols
    numbers : the machine's numbers, which the last cells insert; None for no such cells
    """
    cells = [
        _make_cell("title", "markdown", f"# {TITLE.format(route=route.title)}\n\n{_BODIES_TEXT}"),
        _make_cell("symbols", "markdown", _list_symbols(route)),
        _make_cell("bodies", "code", BODIES),
    ]
    parts = [(key, f"## {route[key].heading}\n\n{route[key].reason}", code) for key, code in route.cells.items()]
    parts.append(("check", f"## {_CHECK_HEADING}\n\n{_CHECK_TEXT}", CHECK))
    if numbers:
        parts.append(("values", f"## {_WITH_NUMBERS}\n\n{state_numbers(numbers)}", _assign_numbers(numbers)))
        parts.append(("distance", _DISTANCE_TEXT, DISTANCE))
    for key, text, code in parts:
        cells += [_make_cell(key, "markdown", text), _make_cell(key, "code", code)]
    if numbers:
        cells.append(_make_cell("numbers", "code", FREQUENCY))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    notebook = {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(notebook, ensure_ascii=False, indent=1) + "\n"


def prose_to_latex(text: str) -> str:
    """Return Markdown prose as LaTeX: keep formulas between dollar signs, and escape the remaining text."""
    # `split` also returns the formulas, at the odd indices.
    parts = _MATH.split(text)
    parts[::2] = [part.translate(_PROSE_TABLE) for part in parts[::2]]
    return "".join(parts)


def _latex_section(step: Step, numbers: Numbers | None) -> str:
    adapted = step.for_numbers(numbers)
    heading, reason = prose_to_latex(adapted.heading), prose_to_latex(adapted.reason)
    equations = _format_equations(_break_lines(make_rows(step, numbers), _LINE_WIDTH), _LINE_WIDTH)
    return f"\\section{{{heading}}}\n{reason}\n{equations}"


def _build_frames(step: Step, numbers: Numbers | None) -> list[tuple[str, str, str]]:
    """Return the frames of a step: label, heading and content of each. The first one begins with the step's reason."""
    adapted = step.for_numbers(numbers)
    broken = _break_lines(make_rows(step, numbers), _SLIDE_WIDTH)
    texts = [_format_equations(part, _SLIDE_WIDTH) if part else "" for part in _distribute(broken)]
    texts[0] = f"{prose_to_latex(adapted.reason)}\n{texts[0]}"
    labels = [step.key, *(f"{step.key}-{number}" for number in range(2, len(texts) + 1))]
    heading = prose_to_latex(adapted.heading)
    return [(label, heading, text) for label, text in zip(labels, texts, strict=True)]


def _distribute(broken: list[BrokenRow]) -> list[list[BrokenRow]]:
    """Return the rows of each slide of a step, with about the same number of lines on each slide."""
    total = sum(len(lines) for _row, lines in broken)
    slides = max(1, math.ceil(total / _SLIDE_LINES))
    most_lines = math.ceil(total / slides)
    parts: list[list[BrokenRow]] = [[]]
    used = 0
    for row, lines in broken:
        if used and used + len(lines) > most_lines:
            parts.append([])
            used = 0
        parts[-1].append((row, lines))
        used += len(lines)
    return parts


def _break_lines(shown: list[Row], width: int) -> list[BrokenRow]:
    """Return each row with the lines of its right side, for equations that are aligned at their equals signs."""
    left_width = measure_left_sides(shown)
    return [(row, row.lines(width, left_width)) for row in shown]


def _format_equations(broken: list[BrokenRow], width: int) -> str:
    """Return rows as left &= right, with long sums broken into lines; an operation is beside its row or below it."""
    equations = []
    for row, lines in broken:
        below = " \\\\\n  &" if measure_width(lines[-1] + row.margin) > width else ""
        equations.append(f"  {row.left} &= " + " \\\\\n  &\\quad ".join(lines) + below + row.margin)
    return "\\begin{align*}\n" + " \\\\\n".join(equations) + "\n\\end{align*}\n"


def _markdown_section(number: int, step: Step, numbers: Numbers | None) -> str:
    adapted = step.for_numbers(numbers)
    equations = (f"$$\n{row.latex}{row.margin}\n$$" for row in make_rows(step, numbers))
    return "\n\n".join([f"## {number}. {adapted.heading}", adapted.reason, *equations])


def _list_symbols(route: Route) -> str:
    """Return the list of symbols as Markdown."""
    entries = (f"- ${symbol}$: {meaning}" for symbol, meaning in nomenclature(route).items())
    return "\n".join([f"**{_SYMBOLS}**", "", *entries, "", DOTS])


def _write_number_paragraph(numbers: Numbers | None) -> str:
    return f"{state_numbers(numbers)}\n\n" if numbers else ""


def _assign_numbers(numbers: Numbers) -> str:
    """Return the notebook line that assigns exact values to m, m′ and k, under their names in `BODIES`."""
    pairs = ", ".join(f'{symbol.name}: sp.sympify("{sp.sstr(value)}")' for symbol, value in numbers.exact.items())
    return f"values = {{{pairs}}}\nvalues"


def _make_cell(key: str, kind: str, source: str) -> dict[str, object]:
    cell: dict[str, object] = {"cell_type": kind, "id": f"{key}-{kind}", "metadata": {}, "source": source}
    if kind == "code":
        cell |= {"execution_count": None, "outputs": []}
    return cell
