"""Every quantity of one machine at one moment of an exact motion, under the name that LaTeX gives it.

Mass and stiffness matrix come from Kane's method (`reference`), everything else from definitions: the accelerations
from Mq̈ = −Kq, the forces from each roller's own balance. All numbers have 60 digits.
"""

from collections.abc import Mapping
from functools import cache
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from ramanujan.derivation.symbols import R, k, m, m_prime
from tests import reference

BODIES = ("block", "hoop", "cylinder", "slab", "top")


@cache
def _twice_the_matrices() -> Any:
    """Return a function of m, m′, k and R for 2M and 2K, whose coefficients are integers."""
    return sp.lambdify((m, m_prime, k, R), [list(sp.expand(2 * each)) for each in reference.mass_and_stiffness()])


def inverted(matrix: np.ndarray) -> np.ndarray:
    return np.array((mpmath.matrix(matrix.tolist()) ** -1).tolist(), dtype=object)


def quantities(
    machine: Mapping[str, Any], start: Mapping[str, Any], unit_ratio: Any, *, in_mode: bool
) -> dict[str, Any]:
    """Return LaTeX name → value.

    Parameters
    ----------
    machine : m, m_prime, k, R
    start : X, phi, Phi, X_dot, phi_dot, Phi_dot at that moment
    unit_ratio : ε*
    in_mode : take X, Φ and their rates from the oscillating mode instead
    """
    mass, roller, stiffness, radius = (machine[name] for name in ("m", "m_prime", "k", "R"))
    M, K = (
        np.array(each, dtype=object).reshape(3, 3) / 2
        for each in _twice_the_matrices()(mass, roller, stiffness, radius)
    )
    inverse = inverted(M)
    shape = inverse[:, 1] / inverse[1, 1]
    frequency = np.trace(inverse @ K)
    q = np.array([start[name] for name in ("X", "phi", "Phi")], dtype=object)
    v = np.array([start[name] for name in ("X_dot", "phi_dot", "Phi_dot")], dtype=object)
    if in_mode:
        q, v = shape * q[1], shape * v[1]
    a = -inverse @ K @ q
    others = [0, 2]
    p, p_dot = M @ v, M @ a
    free = inverted(M[np.ix_(others, others)])
    least = (M[1, 1] - M[1, others] @ free @ M[others, 1]) / radius**2

    masses = dict(zip(BODIES, (mass, roller, roller, mass, mass), strict=True))
    spin = {"hoop": 1, "cylinder": 1, "top": 2}
    inertia = {"hoop": roller * radius**2, "cylinder": roller * radius**2 / 2, "top": mass * radius**2 / 2}
    velocity, acceleration = (
        {
            "block": -x[0],
            "hoop": radius * x[1] - x[0],
            "cylinder": radius * x[1] - x[0],
            "slab": 2 * radius * x[1] - x[0],
            "top": radius * x[2] - x[0],
        }
        for x in (v, a)
    )
    kinetic = {
        body: masses[body] * velocity[body] ** 2 / 2 + (inertia[body] * v[spin[body]] ** 2 / 2 if body in spin else 0)
        for body in BODIES
    }
    T, U = sum(kinetic.values()), stiffness * (2 * radius * q[1]) ** 2 / 2
    named: dict[str, Any] = {}
    for body in BODIES:
        named[rf"v_{{\text{{{body}}}}}"] = velocity[body]
        named[rf"a_{{\text{{{body}}}}}"] = acceleration[body]
        named[rf"T_{{\text{{{body}}}}}"] = kinetic[body]
    for body, place in spin.items():
        # What moves the centre is the sum of a roller's two forces, what turns it their difference.
        total, turning = masses[body] * acceleration[body], inertia[body] * a[place] / radius
        named[rf"\alpha_{{\text{{{body}}}}}"] = a[place]
        named[rf"I_{{\text{{{body}}}}}"] = inertia[body]
        named[rf"S_{{\text{{{body}}}}}"] = (total + turning) / 2
        named[rf"F_{{\text{{{body}}}}}"] = -turning if body == "top" else (total - turning) / 2
    for letter, place in (("X", 0), (r"\varphi", 1), (r"\Phi", 2)):
        named |= {
            letter: q[place],
            rf"\dot{{{letter}}}": v[place],
            rf"\ddot{{{letter}}}": a[place],
            f"p_{{{letter}}}": p[place],
            rf"\dot{{p}}_{{{letter}}}": p_dot[place],
        }
    return named | {
        "m": mass,
        "m'": roller,
        "k": stiffness,
        "R": radius,
        "T": T,
        "U": U,
        r"\mathcal{L}": T - U,
        r"\mathcal{H}": T + U,
        # At given p_X and p_Φ the energy is least where the rollers stand still and the spring is relaxed.
        r"\mathcal{H}_{0}": p[others] @ free @ p[others] / 2,
        r"\Omega^{2}": frequency,
        r"\Omega_{\text{clamped}}^{2}": K[1, 1] / M[1, 1],
        r"\varepsilon": roller / mass,
        r"\varepsilon_{*}": unit_ratio,
        "M_{e}": least,
        "M_{x}": least / 4,
        r"M_{\text{clamped}}": M[1, 1] / radius**2,
        r"\mu": 2 * T / (radius * v[1]) ** 2,
        r"\xi": v[0] / (radius * v[1]),
        r"\eta": v[2] / v[1],
        "M": M,
        "M^{-1}": inverse,
        "K": K,
        r"\omega": frequency**0.5,
        r"\omega_{1}": frequency * 0,
        r"\omega_{2}": frequency * 0,
        r"\omega_{3}": frequency**0.5,
        "x": 2 * radius * q[1],
        "v": shape.reshape(3, 1),
    }
