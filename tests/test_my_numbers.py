"""“My numbers” tell the truth: each equation that a page or a file shows is read back and holds along the exact motion.

The LaTeX is read and evaluated by `tests.latex`, the motion comes from `tests.motion_by_hand`; neither knows how the
derivation puts numbers into its formulas.
"""

from __future__ import annotations

import random
from functools import cache

import mpmath

from ramanujan import UNIT_MASS_RATIO
from ramanujan.derivation import ROUTES
from ramanujan.derivation.numbers import stands_for_the_root
from ramanujan.scenes.cached import derivation as page
from tests.latex import equations, holds
from tests.motion_by_hand import quantities

START = {
    name: mpmath.mpf(n) / 7
    for name, n in zip(("X", "phi", "Phi", "X_dot", "phi_dot", "Phi_dot"), (3, -5, 2, 11, 4, -9), strict=True)
}
"""A moment of a motion in which every mode takes part."""

UNIT_RATIO = (mpmath.sqrt(1729) - 1) / 36


@cache
def machines(count: int) -> list[tuple[float, float, float]]:
    """Return machines on the sliders' steps, machines off them, extreme ones, and ε* for several m."""
    source = random.Random(1729)
    on_steps = [
        (source.randint(10, 100) / 20, source.randint(1, 1000) / 100, source.randint(2, 400) / 2) for _ in range(count)
    ]
    off_steps = [tuple(10 ** source.uniform(-3, 3) for _ in range(3)) for _ in range(count // 4)]
    equal = [(mass, mass, 7.0) for mass in (0.5, 1.0, 1.2345678)]
    at_root = [
        (mass, UNIT_MASS_RATIO * mass, stiffness) for mass, stiffness in ((1.0, 10.0), (3.7, 1.0), (1.2345678, 3.3))
    ]
    near_root = [(1.0, 1.127256827016210, 1.0), (1.0, 1.13, 1.0), (2.0, 2.254513654, 9.0)]
    return [*at_root, *equal, *near_root, (1.0, 5 / 6, 1.0), *off_steps, *on_steps][:count]


def along_the_motion(masses: tuple[float, float, float], key: str, name: str) -> dict[str, object]:
    """Return what each symbol is for a machine; for the case m′ = m where a step is about that."""
    mass, roller, stiffness = (mpmath.mpf(repr(each)) for each in masses)
    if key.startswith("equal_"):
        roller = mass
    elif stands_for_the_root(*masses[:2]):
        roller = UNIT_RATIO * mass
    machine = {"m": mass, "m_prime": roller, "k": stiffness, "R": mpmath.mpf(3) / 8}
    # Rayleigh's quotient is about the oscillating mode alone.
    return quantities(machine, START, UNIT_RATIO, in_mode=name == "energy")


def test_every_equation_of_every_route_holds_along_the_exact_motion():
    for masses in machines(60):
        for name in ROUTES:
            values = {}
            for number, step in enumerate(ROUTES[name].steps):
                kind = step.key.startswith("equal_")
                values[kind] = values.get(kind) or along_the_motion(masses, step.key, name)
                for equation in equations(page.step.__wrapped__(name, number, masses, None, None).equations):
                    assert holds(equation, values[kind]), (masses, name, step.key, equation)
