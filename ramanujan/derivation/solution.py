"""The motion in closed form: q(t) = a + b·t + c·cos Ωt + d·sin Ωt for each coordinate, from any initial state.

The form follows from the spectrum. The shape of the oscillating mode comes from the elimination, and the two zero modes
are a drift of X and of Φ. The six initial values determine the six constants.
"""

from functools import cache

import sympy as sp

from ramanujan.derivation.elimination import eliminate
from ramanujan.derivation.model import COORDINATES, Machine, Phi, X, machine, phi, t

Omega = sp.Symbol("Omega", positive=True)
INITIAL = {q: sp.Symbol(name) for q, name in zip(COORDINATES, ("X", "phi", "Phi"), strict=True)}
INITIAL_RATE = {q: sp.Symbol(f"{symbol.name}_dot") for q, symbol in INITIAL.items()}
"""The initial values of the coordinates and of their time derivatives."""


@cache
def mode_shape(bodies: Machine | None = None) -> dict[sp.Expr, sp.Expr]:
    """Return the amplitudes κR, 1, λ of X, φ and Φ in the oscillating mode, if the amplitude of φ is one radian.

    >>> mode_shape()[X]
    6*R*(m + m_prime)/(7*m + 6*m_prime)
    """
    result = eliminate(bodies or machine())
    return {
        X: sp.factor(result.X_ddot_from_phi_ddot / phi.diff(t, 2)),
        phi: sp.S.One,
        Phi: sp.factor(result.Phi_ddot_from_phi_ddot / phi.diff(t, 2)),
    }


def coefficients(bodies: Machine | None = None) -> dict[sp.Expr, tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]]:
    """Return (a, b, c, d) of each coordinate in terms of the initial values, Ω, the masses and R.

    >>> coefficients()[phi]
    (0, 0, phi, phi_dot/Omega)
    """
    shape = mode_shape(bodies)
    # The unknowns: the amplitudes of φ, and the constant part and the drift of X and Φ.
    cosine, sine = sp.symbols("cosine sine")
    start = {q: sp.Symbol(f"start_{q.func}") for q in (X, Phi)}
    drift = {q: sp.Symbol(f"drift_{q.func}") for q in (X, Phi)}
    at_start = [start.get(q, 0) + shape[q] * cosine - INITIAL[q] for q in COORDINATES]
    rate_at_start = [drift.get(q, 0) + shape[q] * sine * Omega - INITIAL_RATE[q] for q in COORDINATES]
    unknowns = [cosine, sine, *start.values(), *drift.values()]
    solved = sp.solve([*at_start, *rate_at_start], unknowns, dict=True)[0]
    result = {}
    for q in COORDINATES:
        a, b = start.get(q, sp.S.Zero), drift.get(q, sp.S.Zero)
        c, d = shape[q] * cosine, shape[q] * sine
        result[q] = tuple(sp.factor(part.subs(solved)) for part in (a, b, c, d))
    return result
