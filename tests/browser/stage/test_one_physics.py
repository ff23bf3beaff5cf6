"""The expressions of the derivation as mpmath functions, and a comparison with the formulas of the browser.

test_whole_range.py compares the numeric core with the same expressions. The JavaScript runs in Playwright's Node.js.
"""

import json
import subprocess

import pytest
import sympy as sp

from ramanujan.browser.stage.formulas import collect_formulas as stage_formulas
from ramanujan.derivation.model import COORDINATES, VELOCITIES, R, t
from ramanujan.derivation.printers import javascript
from tests.checks.browser import NODE
from tests.settings import PATIENCE


def flat(formulas, prefix=""):
    """Return path → expression for a nested dictionary of formulas; the keys of a path are joined with _."""
    values = {}
    for name, each in formulas.items():
        values |= flat(each, f"{prefix}{name}_") if isinstance(each, dict) else {prefix + name: sp.sympify(each)}
    return values


def test_the_browser_computes_the_expressions_of_the_derivation():
    """SymPy prints each formula as JavaScript and as NumPy; both have the same values."""
    formulas = flat(stage_formulas())
    names = dict(zip((*VELOCITIES, *COORDINATES), ("X_dot", "phi_dot", "Phi_dot", "X", "phi", "Phi"), strict=True))
    symbols = set().union(*(formula.free_symbols for formula in formulas.values())) - {t, R}
    # The symbol of an initial value has the name of its coordinate, so both get the same number.
    names |= {R: "radius"} | {symbol: symbol.name for symbol in sorted(symbols, key=str)}
    values = {name: 0.2 + 0.07 * i for i, name in enumerate(dict.fromkeys(names.values()))}
    entries = "Object.entries(formulas).map(([name, formula]) => [name, formula(values)])"
    script = f"const formulas = {javascript(formulas)}, values = {json.dumps(values)};"
    script += f"console.log(JSON.stringify(Object.fromEntries({entries})));"
    done = subprocess.run([NODE, "-e", script], capture_output=True, text=True, check=True, timeout=PATIENCE)
    assert len(formulas) > 30
    for name, computed in json.loads(done.stdout).items():
        expected = sp.lambdify(list(names), formulas[name], "numpy")(*(values[given] for given in names.values()))
        assert computed == pytest.approx(float(expected), rel=1e-13, abs=1e-15), name
