"""A derivation as a file: a LaTeX article, or a notebook that repeats the derivation.

The article contains the route in symbols or with the numbers of one machine. The notebook is plain SymPy.
"""

import json
import re

import sympy as sp

from ramanujan.derivation.nomenclature import DOTS, nomenclature
from ramanujan.derivation.notebooks import BODIES, CHECK, DISTANCE, FREQUENCY
from ramanujan.derivation.numbers import Numbers, state_numbers
from ramanujan.derivation.rows import Row, make_rows, measure_left_sides, measure_width
from ramanujan.derivation.steps import Route, Step
from ramanujan.text.translation import _, pgettext

TITLE = _("Ramanujan’s oscillator: {route}")
_SYMBOLS = pgettext("list of them", "Symbols")
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
_MATH = re.compile(r"(\$[^$]*\$)")


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
    values = f"{prose_to_latex(state_numbers(numbers))}\n\n" if numbers else ""
    opening = f"\\begin{{document}}\n\\maketitle\n{values}{symbols}"
    return f"{_PREAMBLE}{_WORDS}{title}{opening}{body}\\end{{document}}\n"


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
    return f"\\section{{{heading}}}\n{reason}\n{_format_equations(make_rows(step, numbers))}"


def _format_equations(rows: list[Row]) -> str:
    """Return rows as left &= right, with long sums broken into lines; an operation is beside its row or below it."""
    left_width = measure_left_sides(rows)
    equations = []
    for row in rows:
        lines = row.lines(_LINE_WIDTH, left_width)
        below = " \\\\\n  &" if measure_width(lines[-1] + row.margin) > _LINE_WIDTH else ""
        equations.append(f"  {row.left} &= " + " \\\\\n  &\\quad ".join(lines) + below + row.margin)
    return "\\begin{align*}\n" + " \\\\\n".join(equations) + "\n\\end{align*}\n"


def _list_symbols(route: Route) -> str:
    """Return the list of symbols as Markdown."""
    entries = (f"- ${symbol}$: {meaning}" for symbol, meaning in nomenclature(route).items())
    return "\n".join([f"**{_SYMBOLS}**", "", *entries, "", DOTS])


def _assign_numbers(numbers: Numbers) -> str:
    """Return the notebook line that assigns exact values to m, m′ and k, under their names in `BODIES`."""
    pairs = ", ".join(f'{symbol.name}: sp.sympify("{sp.sstr(value)}")' for symbol, value in numbers.exact.items())
    return f"values = {{{pairs}}}\nvalues"


def _make_cell(key: str, kind: str, source: str) -> dict[str, object]:
    cell: dict[str, object] = {"cell_type": kind, "id": f"{key}-{kind}", "metadata": {}, "source": source}
    if kind == "code":
        cell |= {"execution_count": None, "outputs": []}
    return cell
