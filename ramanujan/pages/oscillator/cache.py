"""The caches of page 1: the fixed part of its curve, and the six steps for the current masses."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import streamlit as st
import sympy as sp

from ramanujan import UNIT_MASS_RATIO, normalized_frequency_squared
from ramanujan.derivation import Step
from ramanujan.derivation.model import epsilon
from ramanujan.derivation.numbers import Numbers, unit_frequency_condition
from ramanujan.derivation.rows import Row, align, rows
from ramanujan.figures import Drawn
from ramanujan.figures.oscillator import Curve, Mark, frequency_curve
from ramanujan.shell import theme
from ramanujan.shell.cache import route
from ramanujan.translation import _

CURVE_RANGE = (0.01, 30.0)
"""The range of mass ratios of the Ω² curve. The sliders stay inside."""

_POINTS = 2001
"""Points of the curve. A click selects the nearest one, so they are denser than the pixels of a wide screen. The figure
is large enough for the browser to cache it (`minCachedMessageSize` in .streamlit/config.toml), so it is sent once."""


@st.cache_resource(show_spinner=False)
def curve() -> Curve:
    """Return the Ω² curve with its limits and the two marked ratios."""
    normalized = unit_frequency_condition().normalized_frequency_squared
    ratios = np.geomspace(*CURVE_RANGE, _POINTS)
    light = sp.limit(normalized, epsilon, 0)
    heavy = sp.limit(normalized * epsilon, epsilon, sp.oo) / epsilon
    at_equal = normalized.subs(epsilon, 1)
    headline = f'<span style="font-size: 1.8em; font-weight: 700">{discriminant()}</span>'
    return Curve(
        ratios,
        np.asarray(normalized_frequency_squared(ratios)),
        float(light),
        str(light),
        sp.lambdify(epsilon, heavy, "numpy")(ratios),
        sp.sstr(heavy).replace("varepsilon", "ε").replace("*", ""),
        Mark(1.0, float(at_equal), _("equal masses<br>{value}").format(value=at_equal)),
        Mark(UNIT_MASS_RATIO, 1.0, f"{headline}<br><i>ε</i> = {unit_ratio()}"),
    )


def unit_ratio() -> str:
    """Return ε* as an exact expression."""
    condition = unit_frequency_condition()
    numerator, denominator = sp.fraction(condition.root)
    root = f"({sp.sstr(numerator, order='rev-lex')})/{denominator}".replace("-", "−")
    return root.replace(f"sqrt({condition.discriminant})", f"√{condition.discriminant}")


def discriminant() -> int:
    """Return the discriminant of the unit-frequency condition, 1729."""
    return int(unit_frequency_condition().discriminant)


def taxicab() -> str:
    """Return the unit-frequency condition with a completed square as text, (…)² = 1729."""
    condition = unit_frequency_condition()
    numerator, denominator = sp.fraction(condition.root)
    shift = sp.sqrt(condition.discriminant) - numerator
    return f"({denominator}ε + {shift})² = {condition.discriminant}"


def equal_masses_value() -> str:
    """Return Ω²m/k at equal masses as an exact fraction."""
    return str(unit_frequency_condition().normalized_frequency_squared.subs(epsilon, 1))


@st.cache_resource(show_spinner=False, max_entries=4)
def figure(light_or_dark: str) -> Drawn:
    """Return the figure of the curve in the current theme. It is the same for every machine."""
    return frequency_curve(curve(), theme.colors())


@dataclass(frozen=True)
class StepDetail:
    """A derivation of results: a step of the route, its equations between them, and all of its equations as LaTeX."""

    heading: str
    reason: str
    between: tuple[Row, ...]
    equations: str


@dataclass(frozen=True)
class SummaryStep:
    """A line of the short derivation. All formulas are LaTeX.

    Parameters
    ----------
    heading : heading of the line
    results : the equations that the folded line shows, without the marks of an operation
    ways : the steps of the route that lead to them
    numbers : the equations of the last step, and the other results, with the current numbers
    """

    heading: str
    results: tuple[str, ...]
    ways: tuple[StepDetail, ...]
    numbers: tuple[Row, ...]


LINE_WIDTH, _BESIDE = 60, 40
"""Number of characters of a formula that fit into a window of 1280 px, and next to the machine."""
_NONE, _FIRST, _LAST, _ALL = slice(0), slice(1), slice(-1, None), slice(None)
SUMMARY: tuple[Mapping[str, slice], ...] = (
    {"velocities": _ALL},
    {"energies": _NONE, "lagrangian": _ALL},
    {"rates": _ALL},
    {"elimination": slice(-2, None)},
    {"insertion": _FIRST, "frequency": _LAST},
    {"ratio": _NONE, "unit": _LAST, "root": slice(3, None, 2)},
)
"""The steps of the route in each line, and which of their equations are results. The last step gives the heading."""


@st.cache_data(show_spinner=False, max_entries=256)
def summary(numbers: Numbers | None) -> list[SummaryStep]:
    """Return the derivation in six steps, with the current numbers if they are given."""
    return [_summary_step(wanted, numbers) for wanted in SUMMARY]


@st.cache_resource(show_spinner=False)
def _in_symbols(key: str) -> tuple[Step, list[Row]]:
    step = route("euler_lagrange")[key]
    return step, rows(step)


def _summary_step(wanted: Mapping[str, slice], given: Numbers | None) -> SummaryStep:
    steps = {key: _in_symbols(key) for key in wanted}
    *_before, last = wanted
    in_full = {**wanted, last: _ALL}
    results = [row for key, part in wanted.items() for row in steps[key][1][part]]
    symbols = dict.fromkeys(row for key, part in in_full.items() for row in steps[key][1][part])
    numbers = [row for key, part in in_full.items() for row in rows(steps[key][0], given)[part]]
    return SummaryStep(
        steps[last][0].heading,
        tuple(row.unmarked.latex for row in results),
        tuple(
            StepDetail(
                step.heading,
                step.reason,
                tuple(row for row in all_rows if row not in results),
                align(all_rows, _BESIDE),
            )
            for step, all_rows in steps.values()
        ),
        tuple(row.unmarked for row in numbers if row not in symbols),
    )
