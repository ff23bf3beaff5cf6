"""One physics: what the derivation says, as functions of mpmath, to which test_whole_range holds the numeric core.

The motion is held to it here, and what the browser gets of it, run by the JavaScript engine that Playwright brings.
"""

import json
import subprocess
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy as sp

from ramanujan import (
    InitialState,
    Oscillator,
    motion,
)
from ramanujan.browser.stage.formulas import formulas as stage_formulas
from ramanujan.derivation import ROUTES
from ramanujan.derivation.model import COORDINATES, VELOCITIES, Phi, R, X, k, m, m_prime, phi, t
from ramanujan.derivation.newton import contact_forces as derived_contact_forces
from ramanujan.derivation.printers import javascript
from ramanujan.derivation.solution import INITIAL, INITIAL_RATE, Omega, coefficients, mode_shape
from tests.test_numerals import NODE

EXACT = 3e-15
"""A dozen roundings of the largest term."""


def cases():
    """Thirty random machines, each with a state in which no term takes digits from another, and a time."""
    rng = np.random.default_rng(1729)
    for _ in range(30):
        oscillator = Oscillator(*(10.0 ** rng.uniform([-1, -2, -1, -2], [1, 1, 3, 0])).tolist())
        q, q_dot = abs(rng.normal(size=(2, 3))) * [-1, 1, 1]
        yield oscillator, q, q_dot, float(rng.uniform(-20, 20))


@cache
def printed(expression):
    """An expression of the derivation as a function of mpmath numbers, and the names of its arguments."""
    plain = expression.doit()
    rates = dict(zip(VELOCITIES, sp.symbols("vX vphi vPhi"), strict=True))
    names = rates | dict(zip(COORDINATES, sp.symbols("qX qphi qPhi"), strict=True))
    plain = plain.xreplace(rates).xreplace(names)
    symbols = sorted(plain.free_symbols, key=str)
    return sp.lambdify(symbols, plain, "mpmath"), [str(symbol) for symbol in symbols]


def evaluated(expression, oscillator, q=(0, 0, 0), q_dot=(0, 0, 0), digits=50, **more):
    """The value of an expression of the derivation for a machine in a state, to so many digits."""
    function, names = printed(sp.sympify(expression))
    values = {str(m): oscillator.m, str(m_prime): oscillator.m_prime, str(k): oscillator.k, str(R): oscillator.radius}
    values |= dict(zip(("qX", "qphi", "qPhi"), q, strict=True)) | dict(zip(("vX", "vphi", "vPhi"), q_dot, strict=True))
    values |= more
    with mpmath.workdps(digits):
        return +mpmath.mpf(function(*(mpmath.mpf(values[name]) for name in names)))


def derived(bodies):
    """What the derivation says of a machine with these bodies, in groups: name → expression.

    That the core has these numbers, whatever the size of a machine, is asked by test_whole_range.
    """
    spring, block = bodies.potential_energy, bodies["block"]
    squared = ROUTES["newton"].natural_frequency_squared
    rolling = {phi.diff(t, 2): -squared * phi}
    carried = [body for body in bodies.bodies if body is not block]
    kinds = ("translation", "rotation")
    parts = {f"{body.name}_{kind}": getattr(body, kind) for body in bodies.bodies for kind in kinds}
    return {
        "mass matrix": dict(enumerate(sp.hessian(sp.expand(bodies.kinetic_energy), VELOCITIES))),
        "stiffness matrix": dict(enumerate(sp.hessian(sp.expand(spring), COORDINATES))),
        "frequency squared": {name: ROUTES[name].natural_frequency_squared for name in ROUTES},
        "mode shape": dict(enumerate(mode_shape(bodies)[q] for q in COORDINATES)),
        "energies": {name: part for name, part in parts.items() if part != 0} | {"spring": spring},
        "momenta": {f"p_{q.func}": bodies.lagrangian.diff(q.diff(t)) for q in (X, Phi)},
        "momenta of bodies": {body.name: body.mass * body.velocity for body in bodies.bodies},
        "forces": {name: sp.factor(force.subs(rolling)) for name, force in derived_contact_forces(bodies).items()}
        | {"spring": -sp.diff(spring, phi) / (2 * R)},
        "places": {body.name: body.displacement for body in bodies.bodies},
        "velocities": {body.name: body.velocity for body in bodies.bodies},
        "places on the block": {body.name: body.displacement - block.displacement for body in carried},
        "velocities on the block": {body.name: body.velocity - block.velocity for body in carried},
    }


def close(value, truth, scale):
    return abs(mpmath.mpf(float(value)) - truth) <= EXACT * abs(scale)


def test_the_motion_is_the_derived_solution():
    solution = coefficients()
    for oscillator, q, q_dot, time in cases():
        with mpmath.workdps(50):
            omega = mpmath.sqrt(evaluated(ROUTES["matrix"].natural_frequency_squared, oscillator))
            cosine, sine = mpmath.cos(omega * time), mpmath.sin(omega * time)
        names = {str(INITIAL[x]): value for x, value in zip(COORDINATES, q, strict=True)}
        names |= {str(INITIAL_RATE[x]): value for x, value in zip(COORDINATES, q_dot, strict=True)}
        names[str(Omega)] = omega
        found, found_rate = motion(oscillator, InitialState(*q, *q_dot), time)
        for i, coordinate in enumerate(COORDINATES):
            a, b, c, d = (evaluated(part, oscillator, **names) for part in solution[coordinate])
            with mpmath.workdps(50):
                # The phase is reduced to 1e-15 rad, whatever the drift has done in that time.
                size = abs(q[i]) + abs(b * time) + abs(c) + abs(d)
                assert close(found[i], a + b * time + c * cosine + d * sine, size)
                rate_size = abs(b) + omega * (abs(c) + abs(d))
                assert close(found_rate[i], b + omega * (d * cosine - c * sine), rate_size)


def flat(formulas, prefix=""):
    """Every formula of a tree of formulas: its names, joined → expression."""
    found = {}
    for name, each in formulas.items():
        found |= flat(each, f"{prefix}{name}_") if isinstance(each, dict) else {prefix + name: sp.sympify(each)}
    return found


def test_the_browser_computes_the_expressions_of_the_derivation():
    """One expression, two printers: JavaScript and NumPy get the same numbers from the same names."""
    formulas = flat(stage_formulas())
    names = dict(zip((*VELOCITIES, *COORDINATES), ("X_dot", "phi_dot", "Phi_dot", "X", "phi", "Phi"), strict=True))
    symbols = set().union(*(formula.free_symbols for formula in formulas.values())) - {t, R}
    # An initial value is a symbol of its own with the name of its coordinate: one number serves both.
    names |= {R: "radius"} | {symbol: symbol.name for symbol in sorted(symbols, key=str)}
    values = {name: 0.2 + 0.07 * i for i, name in enumerate(dict.fromkeys(names.values()))}
    entries = "Object.entries(formulas).map(([name, formula]) => [name, formula(values)])"
    script = f"const formulas = {javascript(formulas)}, values = {json.dumps(values)};"
    script += f"console.log(JSON.stringify(Object.fromEntries({entries})));"
    done = subprocess.run([NODE, "-e", script], capture_output=True, text=True, check=True, timeout=60)
    assert len(formulas) > 30
    for name, found in json.loads(done.stdout).items():
        expected = sp.lambdify(list(names), formulas[name], "numpy")(*(values[given] for given in names.values()))
        assert found == pytest.approx(float(expected), rel=1e-13, abs=1e-15), name
