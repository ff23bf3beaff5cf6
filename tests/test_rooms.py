"""The imports of the rooms against `.importlinter` and the table in CONTRIBUTING.md, and the guide's names."""

import ast
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import grimp
import pytest
from importlinter.api import read_configuration

from ramanujan.pages.used_by_shell import ENTRIES
from ramanujan.shell import menu
from tests.checks.browser import ROOT
from tests.mutations import MUTATIONS
from tests.settings import PATIENCE

pytestmark = pytest.mark.xdist_group("rooms")

GUIDE = (ROOT / ".github" / "CONTRIBUTING.md").read_text(encoding="utf-8")


FOLDERS = [ROOT / folder for folder in ("", "ramanujan", "ramanujan/browser/stage")]
"""Folders in which the guide's file names begin."""


def test_every_name_in_the_guide_is_defined_in_its_file():
    """The guide contains "`NAME` of `file`" and "`NAME` in `file`"."""
    places = re.findall(r"`(\w+)` (?:of|in) `([\w/]+\.(?:py|js|html|css))`", GUIDE)
    assert len(places) > 8
    for name, file in places:
        (path,) = (folder / file for folder in FOLDERS if (folder / file).is_file())
        code = path.read_text(encoding="utf-8")
        defined = re.search(rf"^(?:(?:def|class) )?{name}\b", code, re.MULTILINE)
        assert defined, f"CONTRIBUTING.md mentions {name} of {file}, which defines no such name."


def test_no_line_of_a_style_sheet_or_module_is_longer_than_one_of_python():
    longest = tomllib.loads((ROOT / ".ruff.toml").read_text(encoding="utf-8"))["line-length"]
    folders = ROOT / "ramanujan", ROOT / "tests"
    for path in (path for folder in folders for kind in ("css", "js") for path in folder.rglob(f"*.{kind}")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            assert len(line) <= longest, f"{path}, line {number} is longer than {longest} characters."


def test_every_mutation_changes_its_file():
    for mutation in MUTATIONS:
        text = (ROOT / "ramanujan/browser" / mutation.file).read_text(encoding="utf-8")
        assert text.count(mutation.old) == 1, f"{mutation.name}: update the text in tests/mutations.py."


def read_floors() -> list[set[str]]:
    """Return the rooms on each floor in `.importlinter`, from the top."""
    contracts = read_configuration(str(ROOT / ".importlinter"))["contracts_options"]
    (layers,) = (contract["layers"] for contract in contracts if contract["id"] == "rooms")
    return [set(re.findall(r"\w+", layer)) for layer in layers]


def read_table() -> list[tuple[int, str, set[str]]]:
    """Return floor, room and third-party packages of each row in the guide."""
    rows = GUIDE.partition("| floor |")[2].partition("\n\n")[0].splitlines()[2:]
    cells = [row.split("|")[1:4] for row in rows]
    return [(int(floor), room.strip(), set(re.findall(r"\w+", packages))) for floor, room, packages in cells]


TABLE = read_table()

OTHER_PAGES = (
    "accuracy",
    "physics.record",
    "lesson",
    "answers",
    "derivation.export",
)

EVERYONE = {"typing_extensions"} | set(sys.stdlib_module_names)


@pytest.fixture(scope="module")
def graph() -> grimp.ImportGraph:
    return grimp.build_graph("ramanujan", include_external_packages=True)


def room_of(module: str) -> str:
    """Return the room of a module."""
    return module.split(".")[1] if "." in module else ""


def test_imports_go_down():
    command = [Path(sys.executable).with_name("lint-imports"), "--no-cache", "--no-logo"]
    report = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE)
    assert report.returncode == 0, report.stdout[-5000:] + report.stderr[-2000:]


def test_no_test_file_imports_from_another():
    """What several test files share is in `tests/checks`."""
    graph = grimp.build_graph("tests")
    tests = {module for module in graph.modules if module.rpartition(".")[2].startswith("test_")}
    assert tests
    assert {module: graph.find_modules_that_directly_import(module) for module in tests} == {
        module: set() for module in tests
    }


def test_the_guide_has_the_floors_of_the_contract():
    floors = read_floors()
    assert [floor for floor, _room, _packages in TABLE] == sorted((row[0] for row in TABLE), reverse=True)
    assert [{room for floor, room, _packages in TABLE if floor == n} for n in range(len(floors), 0, -1)] == floors


@pytest.mark.parametrize(("_floor", "room", "packages"), TABLE)
def test_a_room_imports_only_the_packages_in_its_row(graph, _floor, room, packages):
    modules = {module for module in graph.modules if room_of(module) == room}
    assert modules
    imported = {target for module in modules for target in graph.find_modules_directly_imported_by(module)}
    assert {target for target in imported if not target.startswith("ramanujan")} - EVERYONE <= packages


def test_the_names_of_a_notebook_come_from_the_package_itself():
    script = f"""
import sys
from ramanujan import UNIT_MASS_RATIO, InitialState, Oscillator, motion, with_initial_velocities, released
for room in {OTHER_PAGES!r}:
    assert f"ramanujan.{{room}}" not in sys.modules, room
# The name is the function, although a module of the same name was loaded before.
from ramanujan import motion as again
assert again is motion is sys.modules["ramanujan.physics.motion"].motion
"""
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 0, done.stderr[-2000:]


def test_every_page_has_an_entry():
    assert ENTRIES.keys() == menu.PAGES.keys()


@pytest.mark.parametrize("script", ["app.py", *(page.file for page in menu.PAGES.values())])
def test_no_script_has_an_expression_that_streamlit_draws(script):
    """Streamlit's magic writes bare expressions to the page, except docstrings, calls, yields and awaits."""
    tree = ast.parse((ROOT / script).read_text(encoding="utf-8"))
    functions = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Module)
    documented = [node for node in ast.walk(tree) if isinstance(node, functions) and ast.get_docstring(node)]
    docstrings = {node.body[0] for node in documented}
    undrawn = (ast.Call, ast.Yield, ast.YieldFrom, ast.Await)
    expressions = [node for node in ast.walk(tree) if isinstance(node, ast.Expr) and node not in docstrings]
    assert [node.lineno for node in expressions if not isinstance(node.value, undrawn)] == []
