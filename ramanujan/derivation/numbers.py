"""The present masses as exact numbers, so that a derivation can be read with them.

A float stands for the decimal that a person sees: 0.1 is 1/10. One ratio is better known than its decimals: where m′/m
is the nearest float to ε*, m′ is taken as (√1729 − 1)/36 · m itself, and Ω² comes out as k/m to the last digit.
"""

from __future__ import annotations

import math
from functools import cache

import sympy as sp

from ramanujan.derivation import ROUTES
from ramanujan.derivation.euler_lagrange import UnitCondition, unit_condition
from ramanujan.derivation.symbols import epsilon, k, m, m_prime


def exact_values(mass: float, roller_mass: float, stiffness: float) -> dict[sp.Symbol, sp.Expr]:
    """Return m, m′, k and ε = m′/m as exact SymPy numbers.

    Parameters
    ----------
    mass, roller_mass : m, m′ [kg]
    stiffness : k [N/m]
    """
    exact_mass = _decimal(mass)
    root = unit().root
    # m′ = fl(ε*·m), then divided by m again, has been rounded twice.
    at_unit = math.isclose(roller_mass / mass, float(root), rel_tol=4 * 2**-53, abs_tol=0)
    exact_roller_mass = root * exact_mass if at_unit else _decimal(roller_mass)
    return {
        m: exact_mass,
        m_prime: exact_roller_mass,
        k: _decimal(stiffness),
        epsilon: sp.factor(exact_roller_mass / exact_mass),
    }


@cache
def unit() -> UnitCondition:
    """Return the unit-frequency condition of the machine."""
    return unit_condition(ROUTES["euler_lagrange"].natural_frequency_squared)


def _decimal(value: float) -> sp.Rational:
    return sp.Rational(repr(float(value)))
