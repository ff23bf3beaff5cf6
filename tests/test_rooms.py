"""The imports of the rooms against the table in CONTRIBUTING.md, and the modules that the first page loads."""

import ast
import asyncio
import gc
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import grimp
import pytest

import ramanujan.pages
from ramanujan.shell import navigation, server
from tests.browser import ROOT
from tests.mutations import MUTATIONS

pytestmark = pytest.mark.xdist_group("rooms")
LANGUAGE = {"catalogue", "translation", "numerals"}
"""Rooms that every room may import."""


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


def test_every_mutation_changes_its_file():
    for mutation in MUTATIONS:
        text = (ROOT / "ramanujan/browser" / mutation.file).read_text(encoding="utf-8")
        assert text.count(mutation.old) == 1, f"{mutation.name}: update the text in tests/mutations.py."


def import_table() -> dict[str, tuple[set[str], set[str]]]:
    """Return room → rooms from which it may import, besides those of `LANGUAGE`; third-party packages."""
    rows = GUIDE.partition("| room |")[2].partition("\n\n")[0].splitlines()[2:]
    table = {}
    for row in rows:
        names, inside, outside = row.split("|")[1:4]
        allowed = set(re.findall(r"\w+", inside)), set(re.findall(r"\w+", outside))
        for room in re.findall(r"\w+", names.partition("(")[0]):
            table[room] = allowed
    return table


ROOMS = import_table()

OTHER_PAGES = (
    "accuracy",
    "record",
    "lesson",
    "answers",
    "derivation.export",
)

EVERYONE = {"typing_extensions"} | set(sys.stdlib_module_names)


@pytest.fixture(scope="module")
def graph() -> grimp.ImportGraph:
    return grimp.build_graph("ramanujan", include_external_packages=True)


def room_of(module: str) -> str:
    """Return the room of a module. The standalone file is in the browser's folder but counts as a page."""
    if module.startswith("ramanujan.browser.standalone"):
        return "standalone"
    return module.split(".")[1] if "." in module else ""


@pytest.mark.parametrize("room", sorted(ROOMS.keys() - {"pages", "shell", "standalone"}))
def test_a_room_imports_only_what_its_row_allows(graph, room):
    rooms, packages = ROOMS[room]
    modules = {module for module in graph.modules if room_of(module) == room}
    assert modules
    imported = {target for module in modules for target in graph.find_modules_directly_imported_by(module)}
    inside = {room_of(target) for target in imported if target.startswith("ramanujan.")}
    outside = {target for target in imported if not target.startswith("ramanujan")}
    assert inside - {room} - LANGUAGE <= rooms
    assert outside - EVERYONE <= packages


def test_every_room_has_its_row(graph):
    rooms = {room_of(module) for module in graph.modules if module.startswith("ramanujan.")}
    assert rooms == set(ROOMS)


def test_the_names_of_a_notebook_come_from_the_package_itself():
    script = f"""
import sys
from ramanujan import UNIT_MASS_RATIO, InitialState, Oscillator, motion, with_initial_velocities, released
for room in {OTHER_PAGES!r}:
    assert f"ramanujan.{{room}}" not in sys.modules, room
# The name is the function, although a module of the same name was loaded before.
from ramanujan import motion as again
assert again is motion is sys.modules["ramanujan.motion"].motion
"""
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr[-2000:]


def test_the_first_page_loads_nothing_that_only_other_pages_need():
    script = f"""
import sys
from streamlit.testing.v1 import AppTest
app = AppTest.from_file({str(ROOT / "app.py")!r}, default_timeout=60).run()
assert not app.exception and app.title
for room in {OTHER_PAGES!r}:
    assert f"ramanujan.{{room}}" not in sys.modules, room
# Negative control: the modules that the first page needs are loaded.
assert "ramanujan.browser.stage" in sys.modules and "plotly" in sys.modules
"""
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr[-2000:]


def test_every_listed_page_is_warmed_up(tmp_path, monkeypatch):
    (tmp_path / "another").mkdir()
    (tmp_path / "another" / "page.py").write_text("warm = []\n\n\ndef warm_up():\n    warm.append(True)\n")
    monkeypatch.setattr(ramanujan.pages, "__path__", [*ramanujan.pages.__path__, str(tmp_path)])
    monkeypatch.setitem(navigation.PAGES, "another", navigation.Page("another", "Another", "waves", "another"))
    monkeypatch.setattr(gc, "freeze", lambda: None)

    async def start() -> None:
        async with server.lifespan(None):
            pass

    # Playwright's own loop runs in the thread of the tests.
    with ThreadPoolExecutor(1) as own:
        own.submit(asyncio.run, start()).result()
    assert sys.modules["ramanujan.pages.another.page"].warm == [True]


def test_pages_import_no_other_page(graph):
    """The shell uses a list of pages. Code shared by two pages is in shell/sections."""
    wrong = []
    for module in graph.modules:
        room, _, page = module.removeprefix("ramanujan.").partition(".")
        for target in graph.find_modules_directly_imported_by(module):
            target_page = target.removeprefix("ramanujan.pages.").partition(".")[0]
            is_own = room == "pages" and page.partition(".")[0] == target_page
            if room in ("pages", "shell") and target.startswith("ramanujan.pages.") and not is_own:
                wrong.append((module, target))
    assert wrong == []


@pytest.mark.parametrize("script", ["app.py", *(page.file for page in navigation.PAGES.values())])
def test_no_script_has_an_expression_that_streamlit_draws(script):
    """Streamlit's magic writes bare expressions to the page, except docstrings, calls, yields and awaits."""
    tree = ast.parse((ROOT / script).read_text(encoding="utf-8"))
    functions = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Module)
    documented = [node for node in ast.walk(tree) if isinstance(node, functions) and ast.get_docstring(node)]
    docstrings = {node.body[0] for node in documented}
    undrawn = (ast.Call, ast.Yield, ast.YieldFrom, ast.Await)
    expressions = [node for node in ast.walk(tree) if isinstance(node, ast.Expr) and node not in docstrings]
    assert [node.lineno for node in expressions if not isinstance(node.value, undrawn)] == []
