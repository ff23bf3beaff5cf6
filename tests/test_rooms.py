"""Which room may import which, and what the first page may load: the table of the README, held."""

from __future__ import annotations

import subprocess
import sys

import grimp
import pytest

from tests.browser import ROOT

CORE = {"oscillator", "motion"}
CONTRACT = {"validation", "rounding"}
LANGUAGE = {"translation", "numerals"}
ROOMS = {
    "translation": (set(), set()),
    "numerals": (set(), set()),
    "validation": (set(), {"numpy"}),
    "rounding": (set(), {"numpy"}),
    "frequency": (CONTRACT, {"numpy"}),
    "oscillator": (CONTRACT | {"frequency"}, {"numpy"}),
    "motion": (CONTRACT | {"oscillator"}, {"numpy"}),
    "energy": (CONTRACT | CORE, {"numpy"}),
    "sampling": ({"validation"}, set()),
    "contact": (CONTRACT | CORE, {"numpy"}),
    "record": (CONTRACT | CORE | {"energy", "contact", "table"}, {"numpy"}),
    "table": ({"validation"}, {"numpy"}),
    "integrators": ({"validation"}, {"numpy"}),
    "number_theory": ({"validation"}, {"sympy"}),
    "accuracy": (CORE | {"validation", "frequency", "integrators"}, {"numpy", "mpmath"}),
    "derivation": (set(), {"sympy"}),
    "answers": ({"derivation"}, {"sympy", "mpmath"}),
    "figures": (set(), {"numpy", "plotly"}),
    "lesson": (
        CORE | {"frequency", "integrators", "energy", "contact", "accuracy", "derivation", "answers", "number_theory"},
        {"numpy", "sympy", "psycopg"},
    ),
    "browser": (CORE | {"derivation"}, {"streamlit", "sympy"}),
}
"""Room → rooms it may import from (besides `translation` and `numerals`), third-party packages.

`pages` and `shell` may import all.
"""

OTHER_PAGES = (
    "accuracy",
    "record",
    "table",
    "number_theory",
    "lesson",
    "answers",
    "derivation.export",
)

EVERYONE = {"typing_extensions"} | set(sys.stdlib_module_names)


@pytest.fixture(scope="module")
def graph() -> grimp.ImportGraph:
    return grimp.build_graph("ramanujan", include_external_packages=True)


def room_of(module: str) -> str:
    return module.split(".")[1] if "." in module else ""


@pytest.mark.parametrize("room", ROOMS)
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
    assert rooms - {"pages", "shell"} == set(ROOMS)


def test_the_names_of_a_notebook_come_from_the_package_itself():
    script = f"""
import sys
from ramanujan import UNIT_MASS_RATIO, InitialState, Oscillator, motion, with_initial_velocities, released
for room in {OTHER_PAGES!r}:
    assert f"ramanujan.{{room}}" not in sys.modules, room
import ramanujan
for name in ramanujan.__all__:
    assert getattr(ramanujan, name) is not None
    assert name in dir(ramanujan)
# Whatever was loaded before, the name is the function.
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
# Negative control: what the page does show is there.
assert "ramanujan.browser.stage" in sys.modules and "plotly" in sys.modules
"""
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr[-2000:]
