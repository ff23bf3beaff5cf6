"""What a student takes home: LaTeX that compiles, Markdown, and notebooks that derive Ω² again by themselves."""

from __future__ import annotations

import json
import re
import shutil
import subprocess

import nbformat
import pytest
import sympy as sp
from nbclient import NotebookClient

from ramanujan.derivation import ROUTES
from ramanujan.derivation.export import prose_to_latex, to_latex, to_markdown, to_notebook
from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import k, m, m_prime

VALUES = {m: sp.Integer(2), m_prime: (sp.sqrt(1729) - 1) / 18, k: sp.Rational(7, 3)}
ENGINE = shutil.which("pdflatex")


def as_it_stands(name: str, numbers: bool):
    return ROUTES[name].with_numbers(VALUES) if numbers else ROUTES[name]


def environments_nest(document: str) -> bool:
    """Tell whether every \\begin meets its own \\end and every brace its partner."""
    open_environments: list[str] = []
    for kind, name in re.findall(r"\\(begin|end)\{([a-z*]+)\}", document):
        if kind == "begin":
            open_environments.append(name)
        elif not open_environments or open_environments.pop() != name:
            return False
    depth = 0
    for brace in re.findall(r"(?<!\\)[{}]", document):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return not open_environments and depth == 0


# LaTeX


@pytest.mark.parametrize("numbers", [False, True])
@pytest.mark.parametrize("name", ROUTES)
def test_latex_is_a_whole_document_in_ascii(name, numbers):
    route = as_it_stands(name, numbers)
    document = to_latex(route)
    assert document.isascii()
    assert document.startswith(r"\documentclass")
    assert re.findall(r"\\usepackage\{(.*?)\}", document) == ["amsmath"]
    assert document.rstrip().endswith(r"\end{document}")
    assert environments_nest(document)
    assert document.count(r"\section{") == len(route.steps)
    equations = [relation for step in route.steps for relation in step.equations]
    assert document.count(" &= ") == len(equations)


def test_the_environment_check_sees_what_is_wrong():
    assert not environments_nest(r"\begin{a}\begin{b}\end{a}\end{b}")
    assert not environments_nest(r"}{")


@pytest.mark.skipif(ENGINE is None, reason="no pdflatex is installed")
@pytest.mark.parametrize(("name", "numbers"), [(name, name in ("hamilton", "matrix")) for name in ROUTES])
def test_latex_compiles_and_nothing_sticks_out(name, numbers, tmp_path):
    (tmp_path / "route.tex").write_text(to_latex(as_it_stands(name, numbers)), encoding="ascii")
    command = [ENGINE, "-interaction=nonstopmode", "-halt-on-error", "-draftmode", "route.tex"]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout[-2000:]
    assert "Overfull" not in run.stdout


def test_prose_is_escaped_outside_formulas_only():
    assert prose_to_latex("50% of $m'$ & {R_0} # 1") == r"50\% of $m'$ \& \{R\_0\} \# 1"
    assert prose_to_latex("Euler–Lagrange, m′ – “so”…") == r"Euler--Lagrange, m$'$ -- ``so''\dots{}"
    assert prose_to_latex(r"a\b") == r"a\textbackslash{}b"


# Markdown


@pytest.mark.parametrize("numbers", [False, True])
@pytest.mark.parametrize("name", ROUTES)
def test_markdown_holds_every_step_and_equation(name, numbers):
    route = as_it_stands(name, numbers)
    text = to_markdown(route)
    assert text.startswith("# ")
    assert text.count("$$") == 2 * sum(len(step.equations) for step in route.steps)
    for number, step in enumerate(route.steps, start=1):
        assert f"## {number}. {step.heading}\n\n{step.reason}\n" in text
        assert all(f"$$\n{latex(relation)}\n$$" in text for relation in step.equations)


# Notebooks


def code_cells(text: str) -> list[str]:
    return [cell["source"] for cell in json.loads(text)["cells"] if cell["cell_type"] == "code"]


def run(cells: list[str]) -> dict:
    namespace: dict = {}
    for cell in cells:
        exec(cell, namespace)
    return namespace


@pytest.mark.parametrize("values", [None, VALUES], ids=["symbols", "numbers"])
@pytest.mark.parametrize("name", ROUTES)
def test_notebook_is_valid(name, values):
    notebook = nbformat.reads(to_notebook(ROUTES[name], values), as_version=nbformat.NO_CONVERT)
    nbformat.validate(notebook)
    assert (notebook.nbformat, notebook.nbformat_minor) == (4, 5)
    assert len({cell.id for cell in notebook.cells}) == len(notebook.cells)


@pytest.mark.parametrize("name", ROUTES)
def test_notebook_derives_the_frequency_from_plain_sympy(name):
    cells = code_cells(to_notebook(ROUTES[name]))
    assert re.findall(r"^(?:import|from) .*", "\n".join(cells), re.MULTILINE) == ["import sympy as sp"]
    namespace = run(cells)
    found = namespace["Omega_squared"].xreplace({namespace["m_prime"]: m_prime})
    assert sp.simplify(found - ROUTES[name].natural_frequency_squared) == 0


@pytest.mark.parametrize("name", ROUTES)
def test_no_cell_holds_a_result(name):
    # Numbers that belong to the bodies or to counting are small; coefficients of Ω² are not.
    source = "\n".join(code_cells(to_notebook(ROUTES[name])))
    numbers = {int(digits) for digits in re.findall(r"(?<![\w.])\d+", source)}
    assert numbers <= {0, 1, 2, 3, 4, 13}


def test_the_check_refuses_a_wrong_frequency():
    *derivation, check = code_cells(to_notebook(ROUTES["energy"]))
    with pytest.raises(AssertionError):
        run([*derivation, "Omega_squared *= sp.Rational(1000, 999)", check])


def test_the_notebook_follows_the_bodies():
    # With a hoop in the cylinder's place both ways change together, so the check still passes.
    cells = code_cells(to_notebook(ROUTES["newton"]))
    changed = [cell.replace("m_prime * R**2 / 2", "m_prime * R**2") for cell in cells]
    assert changed != cells
    namespace, ours = run(changed), run(cells)
    assert sp.simplify(namespace["independent"] - namespace["Omega_squared"]) == 0
    assert namespace["Omega_squared"] != ours["Omega_squared"]


def test_notebook_runs_in_jupyter_and_puts_the_numbers_in():
    pytest.importorskip("ipykernel", reason="a notebook needs a Python kernel to run")
    notebook = nbformat.reads(to_notebook(ROUTES["hamilton"], VALUES), as_version=4)
    NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    assert notebook.cells[-1].outputs[0].data["text/plain"] == "7/6"
