"""The expressions of the derivation as mpmath functions."""

from functools import cache

import mpmath
import sympy as sp

from ramanujan.derivation import ROUTES
from ramanujan.derivation.model import COORDINATES, VELOCITIES, Phi, R, X, k, m, m_prime, phi, t
from ramanujan.derivation.newton import contact_forces as derived_contact_forces
from ramanujan.derivation.solution import mode_shape

CONTACTS = ["hoop_slab", "cylinder_slab", "hoop_block", "cylinder_block", "top_block"]


@cache
def printed(expression):
    """Return an expression of the derivation as a function of mpmath numbers, and the names of its parameters."""
    plain = expression.doit()
    rates = dict(zip(VELOCITIES, sp.symbols("vX vphi vPhi"), strict=True))
    names = rates | dict(zip(COORDINATES, sp.symbols("qX qphi qPhi"), strict=True))
    plain = plain.xreplace(rates).xreplace(names)
    symbols = sorted(plain.free_symbols, key=str)
    return sp.lambdify(symbols, plain, "mpmath"), [str(symbol) for symbol in symbols]


def evaluated(expression, oscillator, q=(0, 0, 0), q_dot=(0, 0, 0), digits=50, **others):
    """Return the value of an expression of the derivation for a machine in a state, with a number of digits."""
    function, names = printed(sp.sympify(expression))
    values = {str(m): oscillator.m, str(m_prime): oscillator.m_prime, str(k): oscillator.k, str(R): oscillator.radius}
    values |= dict(zip(("qX", "qphi", "qPhi"), q, strict=True)) | dict(zip(("vX", "vphi", "vPhi"), q_dot, strict=True))
    values |= others
    with mpmath.workdps(digits):
        return +mpmath.mpf(function(*(mpmath.mpf(values[name]) for name in names)))


def derived(bodies):
    """Return group → name → expression of the derivation, for a machine with these bodies."""
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
