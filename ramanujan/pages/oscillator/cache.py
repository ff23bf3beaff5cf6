"""What page 1 keeps: the fixed part of its curve, and the six steps for the masses that were asked for."""

from dataclasses import dataclass

import numpy as np
import streamlit as st
import sympy as sp

from ramanujan import UNIT_MASS_RATIO, normalized_frequency_squared
from ramanujan.derivation import Step
from ramanujan.derivation.numbers import Numbers, unit_frequency_condition
from ramanujan.derivation.rows import Row, aligned, rows
from ramanujan.derivation.symbols import epsilon
from ramanujan.figures import Drawn
from ramanujan.figures.oscillator import Curve, Mark, frequency_curve
from ramanujan.shell import theme
from ramanujan.shell.cache import route
from ramanujan.translation import _

CURVE_RANGE = (0.01, 30.0)
"""The mass ratios that the Ω² curve shows; the sliders stay inside."""

_POINTS = 2001
"""Of the curve: a click takes the nearest one, so they lie closer than the pixels of a wide screen. They also make the
figure large enough for the page to keep (`minCachedMessageSize` in .streamlit/config.toml): it is sent only once."""


@st.cache_resource(show_spinner=False)
def curve() -> Curve:
    """Return the Ω² curve with its limits and the two marked ratios."""
    normalized = unit_frequency_condition().normalized_frequency_squared
    ratios = np.geomspace(*CURVE_RANGE, _POINTS)
    light = sp.limit(normalized, epsilon, 0)
    heavy = sp.limit(normalized * epsilon, epsilon, sp.oo) / epsilon
    at_equal = normalized.subs(epsilon, 1)
    return Curve(
        ratios,
        normalized_frequency_squared(ratios),
        float(light),
        str(light),
        sp.lambdify(epsilon, heavy, "numpy")(ratios),
        sp.sstr(heavy).replace("varepsilon", "ε").replace("*", ""),
        Mark(1.0, float(at_equal), _("equal masses<br>{value}").format(value=at_equal)),
        Mark(UNIT_MASS_RATIO, 1.0, f"Ω² = <i>k</i>/<i>m</i><br><i>ε</i> = {unit_ratio()}"),
    )


@st.cache_data(show_spinner=False)
def unit_ratio() -> str:
    """Return ε* as an exact expression."""
    condition = unit_frequency_condition()
    numerator, denominator = sp.fraction(condition.root)
    root = f"({sp.sstr(numerator, order='rev-lex')})/{denominator}".replace("-", "−")
    return root.replace(f"sqrt({condition.discriminant})", f"√{condition.discriminant}")


def taxicab() -> str:
    """Return the number as the square of an expression in ε."""
    condition = unit_frequency_condition()
    numerator, denominator = sp.fraction(condition.root)
    shift = sp.sqrt(condition.discriminant) - numerator
    return f"({denominator}ε + {shift})² = {condition.discriminant}"


def equal_masses_value() -> str:
    """Return Ω²m/k at equal masses as an exact fraction."""
    return str(unit_frequency_condition().normalized_frequency_squared.subs(epsilon, 1))


@st.cache_resource(show_spinner=False, max_entries=4)
def figure(light_or_dark: str) -> Drawn:
    """Return the figure of the curve in the present theme; it is the same for every machine."""
    return frequency_curve(curve(), theme.colors())


@dataclass(frozen=True)
class SummaryStep:
    """A step as the page shows it: words, and one block of LaTeX, in symbols, then with the present numbers.

    A step of many equations also has its two parts, which stand side by side on a projector.
    """

    heading: str
    reason: str
    equations: str
    parts: tuple[str, ...] = ()


_LINE_WIDTH = 60
"""Characters of a formula that fit beside the sidebar in a window of 1280 points."""

_HIGH = 8
"""Equations that fit below one another on a projector."""
_SUMMARY = ("velocities", "lagrangian", "rates", "elimination", "frequency", "root")


@st.cache_data(show_spinner=False, max_entries=256)
def summary(numbers: Numbers | None) -> list[SummaryStep]:
    """Return the derivation in six steps, in symbols, and with the present numbers where these are given."""
    return [_with_numbers(step, symbols, numbers) for step, symbols in _in_symbols()]


@st.cache_resource(show_spinner=False)
def _in_symbols() -> list[tuple[Step, list[Row]]]:
    steps = (route("euler_lagrange")[key] for key in _SUMMARY)
    return [(step, rows(step)) for step in steps]


def _with_numbers(step: Step, symbols: list[Row], given: Numbers | None) -> SummaryStep:
    numbers = rows(step, given) if given else symbols
    blocks = [symbols] if numbers == symbols else [symbols, numbers]
    parts = tuple(aligned([block], _LINE_WIDTH) for block in blocks) if sum(map(len, blocks)) > _HIGH else ()
    return SummaryStep(step.heading, step.reason, aligned(blocks, _LINE_WIDTH), parts)
