"""One expression in LaTeX and in JavaScript says the same."""

from __future__ import annotations

import json
import re
import shutil
import subprocess

import pytest
import sympy as sp

from ramanujan.derivation import ROUTES
from ramanujan.derivation.printers import javascript, latex
from ramanujan.derivation.remarks import conserved_momenta
from ramanujan.derivation.rows import rows
from ramanujan.derivation.symbols import (
    ACCELERATIONS,
    COORDINATES,
    MOMENTA,
    VELOCITIES,
    Omega_clamped_squared,
    Omega_squared,
    R,
    X,
    epsilon,
    k,
    m,
    m_prime,
    machine,
    t,
)
from tests.reference import numpy_function

FREQUENCY = ROUTES["matrix"].natural_frequency_squared
UNIT_MASSES = {m: sp.Integer(3), m_prime: (sp.sqrt(1729) - 1) / 12, k: sp.Rational(5, 7)}
ALL_STEPS = [step for name in ROUTES for step in ROUTES[name].steps]

# LaTeX


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (m_prime, "m'"),
        (m_prime**2, "m'^{2}"),
        (epsilon, r"\varepsilon"),
        (Omega_squared, r"\Omega^{2}"),
        (Omega_clamped_squared, r"\Omega_{\text{clamped}}^{2}"),
        (VELOCITIES[0], r"\dot{X}"),
        (VELOCITIES[1], r"\dot{\varphi}"),
        (ACCELERATIONS[2], r"\ddot{\Phi}"),
        (MOMENTA[0], "p_{X}"),
        (MOMENTA[1], r"p_{\varphi}"),
        (MOMENTA[2].diff(t), r"\dot{p}_{\Phi}"),
        (sp.Symbol("T_block"), r"T_{\text{block}}"),
        (sp.Function("alpha_hoop")(t), r"\alpha_{\text{hoop}}"),
        (sp.Symbol("L"), r"\mathcal{L}"),
        (m * X, r"m\,X"),
        (sp.MatrixSymbol("M", 3, 3).I, "M^{-1}"),
    ],
)
def test_symbols_look_as_physicists_write_them(expression, expected):
    assert latex(expression) == expected


@pytest.mark.parametrize("values", [None, UNIT_MASSES], ids=["symbols", "numbers"])
@pytest.mark.parametrize("step", ALL_STEPS)
def test_latex_of_every_equation_is_well_formed(step, values):
    for source in (row.latex for row in rows(step, values)):
        assert source.isascii()
        assert source.count("=") + source.count(r"\approx") in ((1,) if values is None else (1, 2))
        assert source.count("{") == source.count("}")
        assert source.count(r"\left") == source.count(r"\right")
        assert source.count(r"\begin") == source.count(r"\end")
        # No name of the program shows: not an underscore inside a word, not a Greek letter spelled out.
        assert not re.search(r"[a-z]_[a-z]|(?<!\\)\b(Phi|phi|varphi|alpha|prime|ddot|squared)\b", source)


# JavaScript


def test_javascript_is_an_object_of_arrow_functions_by_name():
    text = javascript({"frequency": k / m, "momenta": {"X": m_prime * VELOCITIES[0]}})
    assert text == "{frequency: ({k, m}) => k/m, momenta: {X: ({X_dot, m_prime}) => X_dot*m_prime}}"


@pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")
def test_javascript_and_numpy_agree():
    momentum = conserved_momenta()[X]
    energies = {body.name: body.kinetic_energy for body in machine().bodies}
    formulas = {"frequency": FREQUENCY, "energies": energies, "momentum": momentum}
    state = {"m": 1.3, "m_prime": 0.7, "k": 11.0, "radius": 0.2}
    state |= {"X": 0.1, "phi": -0.4, "Phi": 2.0, "X_dot": 0.3, "phi_dot": -1.7, "Phi_dot": 0.9}
    script = f"""
    const formulas = {javascript(formulas)}, state = {json.dumps(state)};
    const each = (f) => Object.fromEntries(Object.entries(f).map(([name, value]) => [name, call(value)]));
    const call = (f) => (typeof f === "function" ? f(state) : each(f));
    console.log(JSON.stringify(call(formulas)));
    """
    run = subprocess.run(["node", "-e", script], capture_output=True, text=True, check=True)
    found = json.loads(run.stdout)

    def by_numpy(expression: sp.Expr) -> float:
        arguments = [m, m_prime, k, R, *COORDINATES, *VELOCITIES]
        return numpy_function(arguments, expression)(*state.values())

    # Both round each operation once, in nearly the same order.
    assert found["frequency"] == pytest.approx(by_numpy(FREQUENCY), rel=1e-15)
    assert found["momentum"] == pytest.approx(by_numpy(momentum), rel=1e-14)
    assert found["energies"] == pytest.approx({name: by_numpy(e) for name, e in energies.items()}, rel=1e-14)
