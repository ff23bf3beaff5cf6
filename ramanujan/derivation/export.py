"""A derivation to take home: a LaTeX article, a Markdown text, or a notebook that derives everything again.

LaTeX and Markdown say what the route says, in symbols or with numbers put in. The notebook is plain SymPy.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping

import sympy as sp

from ramanujan.derivation.notebooks import BODIES, CELLS, CHECK
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import Route, Step

MACHINE = "Ramanujan's oscillator"

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
    "…": r"\dots{}",
}
_LINE_WIDTH = 66
"""Characters of a formula that fit into one line of the article; found by setting all routes with TeX."""
_COMMAND = re.compile(r"\\(?!frac|left|right|mathrm|mathcal|d?dot)[a-zA-Z]+")
_INVISIBLE = re.compile(r"\\[a-zA-Z]+|\\,|[{}^_ ]")
_MATH = re.compile(r"(\$[^$]*\$)")


def to_latex(route: Route) -> str:
    """Return the route as a LaTeX document that needs amsmath and nothing else; it is plain ASCII."""
    body = "\n".join(_latex_section(step) for step in route.steps)
    title = f"\\title{{{prose_to_latex(f'{MACHINE}: {route.title}')}}}\n\\author{{}}\n\\date{{}}\n"
    return f"{_PREAMBLE}{title}\\begin{{document}}\n\\maketitle\n{body}\\end{{document}}\n"


def to_markdown(route: Route) -> str:
    """Return the route as Markdown with $…$ and $$…$$."""
    sections = (
        f"## {number}. {step.heading}\n\n{step.reason}\n\n"
        + "\n\n".join(f"$$\n{latex(equation)}\n$$" for equation in step.equations)
        for number, step in enumerate(route.steps, start=1)
    )
    return f"# {MACHINE}: {route.title}\n\n" + "\n\n".join(sections) + "\n"


def to_notebook(route: Route, values: Mapping[sp.Symbol, sp.Expr] | None = None) -> str:
    """Return a Jupyter notebook (format 4.5, JSON) that derives the route's Ω² from the bodies with plain SymPy.

    Parameters
    ----------
    route : which of `ROUTES`, in symbols
    values : exact m, m′ and k; if given, a last cell puts them in
    """
    cells = [
        _markdown("title", f"# {MACHINE}: {route.title}\n\nFive bodies, three rolling ones among them, one spring."),
        _code("bodies", BODIES),
    ]
    for key, code in CELLS[route.name].items():
        step = route[key]
        cells += [_markdown(key, f"## {step.heading}\n\n{step.reason}"), _code(key, code)]
    cells += [
        _markdown("check", "## Check against another way\n\nThe nonzero root of $\\det(K-\\Lambda M)=0$ is the same."),
        _code("check", CHECK),
    ]
    if values:
        cells += [_markdown("numbers", "## With numbers"), _code("numbers", _numbers(values))]
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    notebook = {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(notebook, ensure_ascii=False, indent=1) + "\n"


def prose_to_latex(text: str) -> str:
    """Return Markdown prose as LaTeX: what stands between dollar signs is kept, everything else is escaped."""
    return "".join(
        part if _MATH.fullmatch(part) else "".join(_IN_PROSE.get(character, character) for character in part)
        for part in _MATH.split(text)
    )


def _latex_section(step: Step) -> str:
    rows = " \\\\\n".join(f"  {_row(equation)}" for equation in step.equations)
    heading, reason = prose_to_latex(step.heading), prose_to_latex(step.reason)
    return f"\\section{{{heading}}}\n{reason}\n\\begin{{align*}}\n{rows}\n\\end{{align*}}\n"


def lines(expression: sp.Expr, write: Callable[[sp.Expr], str] = latex, width: int = _LINE_WIDTH) -> list[str]:
    """Return the LaTeX of an expression, a long sum broken into lines of which each but the first begins with a sign.

    Parameters
    ----------
    expression : what is written
    write : expression → LaTeX
    width : characters that fit into a line
    """
    groups: list[list[sp.Expr]] = [[]]
    for term in expression.as_ordered_terms() if expression.is_Add else [expression]:
        if groups[-1] and extent(latex(sp.Add(*groups[-1], term))) > width:
            groups.append([])
        groups[-1].append(term)
    first, *others = (write(group[0] if len(group) == 1 else sp.Add(*group)) for group in groups)
    return [first, *(other if other.startswith("-") else f"+ {other}" for other in others)]


def _row(equation: sp.Eq) -> str:
    """Return left &= right, a long sum broken into lines."""
    first, *others = lines(equation.rhs)
    return f"{latex(equation.lhs)} &= {first}" + "".join(f" \\\\\n  &\\quad {other}" for other in others)


def extent(formula: str) -> int:
    """Return about how many characters stand side by side."""
    return len(_INVISIBLE.sub("", _COMMAND.sub("x", formula)))


def _numbers(values: Mapping[sp.Symbol, sp.Expr]) -> str:
    pairs = ", ".join(f'{symbol.name}: sp.sympify("{sp.sstr(value)}")' for symbol, value in values.items())
    return f"sp.radsimp(Omega_squared.subs({{{pairs}}}))"


def _markdown(key: str, text: str) -> dict[str, object]:
    return {"cell_type": "markdown", "id": f"{key}-text", "metadata": {}, "source": text}


def _code(key: str, code: str) -> dict[str, object]:
    return {
        "cell_type": "code",
        "execution_count": None,
        "id": f"{key}-code",
        "metadata": {},
        "outputs": [],
        "source": code,
    }
