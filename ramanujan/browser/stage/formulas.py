"""Every expression that the stage evaluates, taken from the derivation."""

from typing import Any

import sympy as sp

from ramanujan.derivation import model
from ramanujan.derivation.elimination import eliminate
from ramanujan.derivation.model import Machine, R, k, m, m_prime, machine, phi, t
from ramanujan.derivation.newton import CONTACTS, contact_forces, spring_forces
from ramanujan.derivation.printers import plain_text
from ramanujan.derivation.solution import coefficients
from ramanujan.physics.oscillator import EDGE_GAPS, SPACING_GAP, SPACING_PER_RADIUS
from ramanujan.text.names import BODIES

SHAPE_FACTORS = {"hoop": float(model.HOOP), "cylinder": float(model.SOLID_CYLINDER), "top": float(model.SOLID_CYLINDER)}
"""β of the paper's rollers."""


def collect_formulas() -> dict[str, Any]:
    """Return name → expression for every expression that the stage evaluates, for rollers of any shape."""
    shape_factors = {name: sp.Symbol(f"beta_{name}", positive=True) for name in SHAPE_FACTORS}
    general_machine = machine(**shape_factors)
    frequency_squared = eliminate(general_machine).natural_frequency_squared
    Omega = sp.Symbol("Omega", positive=True)
    # Exact fractions of the decimals in the source text, such as 1/4 for 0.25.
    lengths = (SPACING_PER_RADIUS, SPACING_GAP, *EDGE_GAPS)
    per_radius, gap, left, right = (sp.Rational(str(length)) for length in lengths)
    # φ has no drift, so φ̈ = −Ω²φ at all times.
    oscillation = {phi.diff(t, 2): -(Omega**2) * phi}
    total = sum(body.mass for body in general_machine.bodies)
    forces = {name: force.subs(oscillation) for name, force in contact_forces(general_machine).items()}
    compression = sp.Symbol("compression")
    return {
        "natural_frequency": sp.sqrt(frequency_squared),
        "plain_frequency": sp.sqrt(k / m),
        "normalized_frequency_squared": sp.factor(frequency_squared * m / k),
        "mass_ratio": m_prime / m,
        "motion": {
            str(q.func).replace("varphi", "phi"): dict(zip("abcd", parts, strict=True))
            for q, parts in coefficients(general_machine).items()
        },
        "spacing": per_radius * R + gap,
        "edge": {"left": -(R + compression / 2 + left), "right": R + right},
        "deformation": general_machine.deformation,
        "released_angle": sp.solve(general_machine.deformation - compression, general_machine["hoop"].angle)[0],
        "mass": {body.name: body.mass for body in general_machine.bodies},
        "displacement": {body.name: body.displacement for body in general_machine.bodies},
        "angle": {body.name: body.angle for body in general_machine.bodies},
        "velocity": {body.name: body.velocity for body in general_machine.bodies},
        "centre": sum(body.mass * sp.Symbol(body.name) for body in general_machine.bodies) / total,
        "kinetic_energy": {body.name: body.kinetic_energy for body in general_machine.bodies},
        "potential_energy": general_machine.potential_energy,
        "rolling": _rolling(general_machine),
        "contact_force": forces,
        "spring_force": spring_forces(general_machine),
    }


def collect_labels() -> dict[str, Any]:
    """Return the expressions shown in the picture, as text. A contact force has a letter and a subscript."""
    paper_machine = machine()
    letters = {contact.name: str(contact.force.func).partition("_")[0] for contact in CONTACTS}
    return {
        "contact_force": {
            contact.name: [letters[contact.name], BODIES[contact.roller].subscript] for contact in CONTACTS
        },
        "spring_force": {name: plain_text(force) for name, force in spring_forces(paper_machine).items()},
        "deformation": plain_text(paper_machine.deformation),
        "rolling": {name: plain_text(velocity) for name, velocity in _rolling(paper_machine).items()},
    }


def _rolling(any_machine: Machine) -> dict[str, sp.Expr]:
    """Return the velocities of three points of a lower roller relative to the block: its contact, centre and top."""
    roller = any_machine["hoop"]
    centre = sp.expand(roller.velocity - any_machine["block"].velocity)
    rim = R * roller.angle.diff(t)
    return {"contact": centre - rim, "centre": centre, "top": centre + rim}
