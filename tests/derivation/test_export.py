"""Downloads: LaTeX that compiles, and notebooks that derive Ω² without the app.

test_my_numbers checks that every file contains the equations of its route.
"""

import itertools
import json
import re
import subprocess
from pathlib import Path

import pytest
import sympy as sp

from ramanujan import UNIT_MASS_RATIO
from ramanujan.derivation import ROUTES
from ramanujan.derivation.export import prose_to_latex, to_latex, to_notebook
from ramanujan.derivation.model import k, m, m_prime
from ramanujan.derivation.nomenclature import nomenclature
from ramanujan.derivation.numbers import Numbers
from ramanujan.pages.derivation import cache as page
from tests.settings import DEEP, PATIENCE

NUMBERS = Numbers(2.0, 2 * UNIT_MASS_RATIO, 7 / 3)


def values_if(numbers: bool):
    return NUMBERS if numbers else None


def typeset(document: str, folder: Path) -> str:
    """Run pdflatex, check that it finds no error, and return its output."""
    (folder / "document.tex").write_text(document, encoding="ascii")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "-draftmode", "document.tex"]
    run = subprocess.run(command, cwd=folder, capture_output=True, encoding="latin-1", check=False)
    assert run.returncode == 0, run.stdout[-2000:]
    return run.stdout


def environments_nest(document: str) -> bool:
    """Return whether every \\begin has its \\end, and every brace its partner."""
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
    route = ROUTES[name]
    document = to_latex(route, values_if(numbers))
    assert document.isascii()
    assert document.startswith(r"\documentclass")
    assert re.findall(r"\\usepackage\{(.*?)\}", document) == ["amsmath"]
    assert document.rstrip().endswith(r"\end{document}")
    assert environments_nest(document)
    assert document.count(r"\section{") == len(route.steps)


def test_the_environment_check_detects_errors():
    assert not environments_nest(r"\begin{a}\begin{b}\end{a}\end{b}")
    assert not environments_nest(r"}{")


@pytest.mark.skipif(not DEEP, reason="pdflatex is used only with RAMANUJAN_DEEP")
@pytest.mark.parametrize("name", ROUTES)
def test_latex_compiles_without_overfull_lines(name, tmp_path):
    longest = OFF_THE_STEPS
    for values in (None, longest):
        document = to_latex(ROUTES[name], values)
        assert not re.findall("Overfull.*|Missing character.*", typeset(document, tmp_path)), document[:40]


def test_prose_is_escaped_outside_formulas_only():
    assert prose_to_latex("50% of $m'$ & {R_0} # 1") == r"50\% of $m'$ \& \{R\_0\} \# 1"
    assert prose_to_latex("Euler–Lagrange, m′ – “so”…") == r"Euler--Lagrange, m$'$ -- ``so''\dots{}"
    assert prose_to_latex(r"a\b") == r"a\textbackslash{}b"


# Notebooks


def code_cells(text: str) -> list[str]:
    return [cell["source"] for cell in json.loads(text)["cells"] if cell["cell_type"] == "code"]


@pytest.mark.parametrize("name", ROUTES)
def test_a_notebook_imports_only_sympy_and_contains_no_result(name):
    source = "\n".join(code_cells(to_notebook(ROUTES[name])))
    assert re.findall(r"^(?:import|from) .*", source, re.MULTILINE) == ["import sympy as sp"]
    # Numbers that belong to the bodies or to counting are small; coefficients of Ω² are not.
    assert {int(digits) for digits in re.findall(r"(?<![\w.])\d+", source)} <= {0, 1, 2, 3, 4, 13}


OFF_THE_STEPS, IN_STEP = MACHINES = Numbers(1.2345678, 0.86, 33.5), Numbers(1.0, UNIT_MASS_RATIO, 10.0)


@pytest.fixture(scope="module")
def kernel():
    """One Python kernel for all notebooks. Each notebook starts with an empty namespace."""
    pytest.importorskip("ipykernel", reason="a notebook needs a Python kernel to run")
    from jupyter_client import KernelManager  # slow import, needed only by one worker

    manager = KernelManager(kernel_name="python3")
    manager.start_kernel()
    yield manager
    manager.shutdown_kernel(now=True)


def executed(text: str, kernel: object) -> object:
    """Run a downloaded notebook after a cell that empties the kernel."""
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.reads(text, as_version=4)
    nbformat.validate(notebook)
    notebook.cells.insert(0, nbformat.v4.new_code_cell("%reset -f"))
    NotebookClient(notebook, timeout=PATIENCE, km=kernel).execute()
    return notebook


def result(notebook: object, key: str) -> str:
    (cell,) = (cell for cell in notebook.cells if cell.get("id") == f"{key}-code")
    return cell.outputs[0].data["text/plain"]


@pytest.mark.parametrize(("name", "numbers"), [*zip(ROUTES, itertools.cycle(MACHINES), strict=False)])
@pytest.mark.xdist_group("notebook")
def test_the_notebook_of_the_download_button_runs(name, numbers, kernel):
    """The notebook computes the Ω² that the page shows, first in symbols, then for a machine."""
    notebook = executed(page.document.__wrapped__(name, numbers, "notebook"), kernel)
    in_symbols = result(notebook, "check").replace("m'", "m_prime")
    in_symbols = sp.sympify(in_symbols, locals={"m": m, "m_prime": m_prime, "k": k})
    assert sp.cancel(in_symbols - ROUTES[name].natural_frequency_squared) == 0
    expected = sp.radsimp(ROUTES[name].natural_frequency_squared.subs(numbers.exact))
    assert sp.sympify(result(notebook, "numbers")) == expected
    distance = result(notebook, "distance")
    assert ("'distance from the root': (0, 0)" in distance) == (numbers == IN_STEP)
    assert ("'Omega^2 m/k': 1," in distance) == (numbers == IN_STEP)


@pytest.mark.xdist_group("notebook")
def test_a_notebook_refuses_a_wrong_frequency(kernel):
    """Negative control."""
    notebook = json.loads(to_notebook(ROUTES["energy"]))
    (check,) = (cell for cell in notebook["cells"] if cell["id"] == "check-code")
    check["source"] = "Omega_squared *= sp.Rational(1000, 999)\n" + "".join(check["source"])
    with pytest.raises(Exception, match="AssertionError"):
        executed(json.dumps(notebook), kernel)


# Symbols


@pytest.mark.parametrize("kind", ["latex", "notebook"])
@pytest.mark.parametrize("name", ROUTES)
def test_every_file_contains_its_steps_and_the_list_of_symbols(name, kind):
    for numbers in (None, OFF_THE_STEPS):
        text = page.document.__wrapped__(name, numbers, kind)
        text = "\n".join(cell["source"] for cell in json.loads(text)["cells"]) if kind == "notebook" else text
        written = prose_to_latex if kind == "latex" else str
        assert kind == "notebook" or all(written(step.heading) in text for step in ROUTES[name].steps)
        for symbol, meaning in nomenclature(ROUTES[name]).items():
            assert f"${symbol}$: {written(meaning)}" in text
        assert "positive to the left" in text
        assert text.count("positive clockwise") >= 2
