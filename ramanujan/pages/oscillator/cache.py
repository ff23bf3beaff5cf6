"""The caches of page 1: the fixed part of its curve, and the six steps for the current masses."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
import streamlit as st
import sympy as sp

from ramanujan import UNIT_MASS_RATIO, normalized_frequency_squared
from ramanujan.derivation import Step
from ramanujan.derivation.model import epsilon
from ramanujan.derivation.numbers import Numbers, unit_frequency_condition
from ramanujan.derivation.rows import Row, make_rows
from ramanujan.figures import EncodedFigure
from ramanujan.figures.oscillator_page import FrequencyCurve, Mark, draw_frequency_curve
from ramanujan.shell import theme
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.shell.shared_cache import route
from ramanujan.text.translation import _

CURVE_RANGE = (
    PARAMETERS["m_prime"].least / PARAMETERS["m"].most,
    PARAMETERS["m_prime"].most / PARAMETERS["m"].least,
)
"""The range of mass ratios of the Ω² curve: all ratios that can be set."""

_POINTS = 2001
"""Points of the curve. A click selects the nearest one, so they are denser than the pixels of a wide screen. The figure
is large enough for the browser to cache it (`minCachedMessageSize` in .streamlit/config.toml), so it is sent once."""


@cache
def curve() -> FrequencyCurve:
    """Return the Ω² curve with its limits and the two marked ratios."""
    normalized = unit_frequency_condition().normalized_frequency_squared
    ratios = np.geomspace(*CURVE_RANGE, _POINTS)
    light = sp.limit(normalized, epsilon, 0)
    heavy = sp.limit(normalized * epsilon, epsilon, sp.oo) / epsilon
    at_equal = normalized.subs(epsilon, 1)
    headline = f'<span style="font-size: 1.8em; font-weight: 700">{discriminant()}</span>'
    return FrequencyCurve(
        ratios=ratios,
        values=np.asarray(normalized_frequency_squared(ratios)),
        light_limit=float(light),
        light=str(light),
        heavy_limit=sp.lambdify(epsilon, heavy, "numpy")(ratios),
        heavy=sp.sstr(heavy).replace("varepsilon", "ε").replace("*", ""),
        equal=Mark(1.0, float(at_equal), _("equal masses<br>{value}").format(value=at_equal)),
        unit=Mark(UNIT_MASS_RATIO, 1.0, f"{headline}<br><i>ε</i> = {unit_ratio()}"),
    )


def unit_ratio() -> str:
    """Return ε* as text without a line break, an exact expression with a root."""
    condition = unit_frequency_condition()
    numerator, denominator = sp.fraction(condition.root)
    root = f"({sp.sstr(numerator, order='rev-lex')})/{denominator}".replace("-", "−").replace(" ", "\u00a0")
    return root.replace(f"sqrt({condition.discriminant})", f"√{condition.discriminant}")


def discriminant() -> int:
    """Return the discriminant of the unit-frequency condition, 1729."""
    return int(unit_frequency_condition().discriminant)


def completed_square() -> str:
    """Return the unit-frequency condition as text without a line break, with a completed square: (…)² = 1729."""
    condition = unit_frequency_condition()
    numerator, denominator = sp.fraction(condition.root)
    shift = sp.sqrt(condition.discriminant) - numerator
    return f"({denominator}ε\u00a0+\u00a0{shift})²\u00a0=\u00a0{condition.discriminant}"


def equal_masses_value() -> str:
    """Return Ω²m/k at equal masses as an exact fraction."""
    return str(unit_frequency_condition().normalized_frequency_squared.subs(epsilon, 1))


@cache
def figure(light_or_dark: str) -> EncodedFigure:
    """Return the figure of the curve, which is the same for every machine. The theme's name is the key of the cache."""
    return draw_frequency_curve(curve(), theme.colors())


@dataclass(frozen=True)
class StepDetail:
    """A step of the route that contributes to a line of the short derivation.

    Parameters
    ----------
    reason : its text
    details : its equations without the results of the line
    """

    reason: str
    details: tuple[Row, ...]


@dataclass(frozen=True)
class SummaryStep:
    """A line of the short derivation. The results are LaTeX.

    Parameters
    ----------
    heading : heading of the line
    idea : one sentence on the idea of the line
    results : the equations that the folded line shows, without the marks of an operation
    steps : the steps of the route that lead to the results
    numbers : the results and all equations of the last step, with the current numbers
    """

    heading: str
    idea: str
    results: tuple[str, ...]
    steps: tuple[StepDetail, ...]
    numbers: tuple[Row, ...]


LINE_WIDTH = 60
"""Number of characters of a formula that fit into a window of 1280 px."""
_NONE, _FIRST, _LAST, _ALL = slice(0), slice(1), slice(-1, None), slice(None)
SUMMARY: tuple[tuple[str, Mapping[str, slice]], ...] = (
    (
        _("Without slip, the slab moves twice as fast as the centres below it, relative to the block."),
        {"velocities": _ALL},
    ),
    (_("The Lagrangian is the kinetic energy minus the potential energy."), {"energies": _NONE, "lagrangian": _ALL}),
    (_("There is one equation for each coordinate. Only that of φ contains the spring."), {"rates": _ALL}),
    (_("Both accelerate in proportion to the lower rollers."), {"elimination": slice(-2, None)}),
    (_("One equation of φ is left: that of a harmonic oscillator."), {"insertion": _FIRST, "frequency": _LAST}),
    (
        _("In step means Ω² = k/m. This is a quadratic equation of the mass ratio ε."),
        {"ratio": _NONE, "unit": _LAST, "root": slice(3, None, 2)},
    ),
)
"""For each line: its idea, and key of a step of the route → its equations that are results. The last step has the
line's heading."""


@st.cache_data(show_spinner=False, max_entries=256)
def summary(numbers: Numbers | None) -> list[SummaryStep]:
    """Return the derivation in six steps, with the current numbers if they are given."""
    return [_summary_step(idea, results, numbers) for idea, results in SUMMARY]


def _step(key: str) -> Step:
    return route("euler_lagrange")[key]


@cache
def _symbolic_rows(key: str) -> list[Row]:
    """Return the equations of a step in symbols."""
    return make_rows(_step(key))


def _summary_step(idea: str, selection: Mapping[str, slice], numbers: Numbers | None) -> SummaryStep:
    """Return a line of the short derivation, for a line of `SUMMARY`."""
    last = list(selection)[-1]
    results = _select(selection, None)
    # With numbers, also show the intermediate equations of the last step, but none that contains only symbols.
    with_all_of_last = {**selection, last: _ALL}
    symbolic = set(_select(with_all_of_last, None))
    numeric = [row for row in _select(with_all_of_last, numbers) if row not in symbolic]

    details = []
    for key in selection:
        others = tuple(row for row in _symbolic_rows(key) if row not in results)
        details.append(StepDetail(_step(key).reason, others))
    return SummaryStep(
        _step(last).heading,
        idea,
        tuple(row.unmarked.latex for row in results),
        tuple(details),
        tuple(row.unmarked for row in numeric),
    )


def _select(selection: Mapping[str, slice], numbers: Numbers | None) -> list[Row]:
    """Return the selected equations of some steps, in symbols or with numbers."""
    selected = []
    for key, part in selection.items():
        equations = make_rows(_step(key), numbers) if numbers else _symbolic_rows(key)
        selected += equations[part]
    return selected
