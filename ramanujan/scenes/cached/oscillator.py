"""What page 1 keeps: the fixed part of its curve, and the six steps for the masses that were asked for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import streamlit as st
import sympy as sp

from ramanujan import UNIT_MASS_RATIO, normalized_frequency_squared
from ramanujan.derivation import Step
from ramanujan.derivation.numbers import exact_values, unit
from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import Omega_squared, epsilon
from ramanujan.figures import Drawn, kept
from ramanujan.figures.oscillator import Mark, frequency_curve
from ramanujan.scenes import look
from ramanujan.scenes.cached import route

CURVE_RANGE = (0.01, 30.0)
"""The mass ratios that the Ω² curve shows; the sliders stay inside."""


@dataclass(frozen=True)
class Curve:
    """The fixed part of the Ω² figure; every number and formula in it comes from the core or from SymPy."""

    ratios: np.ndarray
    values: np.ndarray
    light_limit: float
    heavy_limit: np.ndarray
    equal: Mark
    unit: Mark
    light_label: str
    heavy_label: str


@st.cache_resource(show_spinner=False)
def curve() -> Curve:
    """Return the Ω² curve with its limits and the two marked ratios."""
    normalized, condition = unit().normalized_frequency_squared, unit()
    ratios = np.geomspace(*CURVE_RANGE, 101)
    light = sp.limit(normalized, epsilon, 0)
    heavy = sp.limit(normalized * epsilon, epsilon, sp.oo) / epsilon
    at_equal = normalized.subs(epsilon, 1)
    numerator, denominator = sp.fraction(condition.root)
    root = f"({sp.sstr(numerator, order='rev-lex')})/{denominator}".replace("sqrt", "√")
    root = root.replace("√(1729)", "√1729").replace("-", "−")
    return Curve(
        ratios,
        normalized_frequency_squared(ratios),
        float(light),
        np.array([float(heavy.subs(epsilon, ratio)) for ratio in ratios]),
        Mark(1.0, float(at_equal), f"equal masses<br>{at_equal}"),
        Mark(UNIT_MASS_RATIO, 1.0, f"<b>Ω² = k/m</b><br>ε = {root}"),
        f"{light} for ε → 0",
        f"{sp.sstr(heavy).replace('varepsilon', 'ε').replace('*', '')}<br>for ε → ∞",
    )


@st.cache_resource(show_spinner=False, max_entries=4)
def figure(theme: str) -> Drawn:
    """Return the figure of the curve in the present theme; it is the same for every machine."""
    base, colors = curve(), look.colors()
    return kept(
        frequency_curve(
            base.ratios,
            base.values,
            light_limit=base.light_limit,
            heavy_limit=base.heavy_limit,
            limit_labels=(base.light_label, base.heavy_label),
            equal=base.equal,
            unit=base.unit,
            colors={**colors, "marker": colors["hoop_ink"], "accent": colors["top"]},
        )
    )


@dataclass(frozen=True)
class SummaryStep:
    """A step as the page shows it: words, and one block of LaTeX, in symbols, then with the present numbers."""

    heading: str
    reason: str
    equations: str


_SUMMARY = ("velocities", "lagrangian", "motion", "elimination", "frequency", "root")


@st.cache_data(show_spinner=False, max_entries=256)
def summary(m: float, m_prime: float, k: float) -> list[SummaryStep]:
    """Return the derivation in six steps, in symbols and with the present masses and stiffness."""
    values = exact_values(m, m_prime, k)
    steps = (route("euler_lagrange")[key] for key in _SUMMARY)
    return [_with_numbers(step, values) for step in steps]


def _with_numbers(step: Step, values: dict[sp.Symbol, Any]) -> SummaryStep:
    symbols = [latex(equation) for equation in step.equations]
    if step.key == "root":
        numbers = [latex(equation) for equation in _distance_from_unity(values)]
    else:
        numbers = [latex(equation) + _decimal(equation) for equation in step.with_numbers(values).equations]
    return SummaryStep(step.heading, step.reason, _aligned(symbols, [] if numbers == symbols else numbers))


def _aligned(*blocks: list[str]) -> str:
    """Return blocks of equations as one: aligned at the equals signs or, where some say … = 0, at the left."""
    to_zero = any(line.endswith("= 0") for block in blocks for line in block)
    marked = ([r"&" + line if to_zero else line.replace("=", "&=", 1) for line in block] for block in blocks if block)
    return r"\begin{aligned}" + r" \\[1.6em] ".join(r" \\[.5em] ".join(block) for block in marked) + r"\end{aligned}"


def _decimal(relation: sp.Eq) -> str:
    """Return unit and six digits for Ω², which a person will want to compare with the stage."""
    if relation.lhs != Omega_squared:
        return ""
    is_whole = relation.rhs.is_Integer
    return r"\,\mathrm{s^{-2}}" if is_whole else rf" \approx {sp.latex(relation.rhs.evalf(6))}\,\mathrm{{s^{{-2}}}}"


def _distance_from_unity(values: dict[sp.Symbol, Any]) -> tuple[sp.Eq, sp.Eq]:
    """Return the present ε and its (36ε + 1)², to be held against 1729."""
    left = unit().completed_square.lhs
    present = sp.expand(left.subs(epsilon, values[epsilon]))
    return sp.Eq(epsilon, values[epsilon], evaluate=False), sp.Eq(left, present, evaluate=False)
