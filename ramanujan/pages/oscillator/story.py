"""The story of the first page: from heavy rollers to the one mass ratio at which both clock hands turn together.

Times are in periods of the plain mass, masses in units of m, so one story fits every machine. The hands start together.
The durations of the pauses are such that the hands meet again at ε*. The machine's hand gains this number of turns:

    ∫ (√f(ε(t)) − 1) dt,    f(ε) = Ω²m/k
"""

import math
from dataclasses import asdict, dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ramanujan import UNIT_MASS_RATIO, normalized_frequency_squared
from ramanujan.pages.oscillator import cache as page_cache
from ramanujan.text.numerals import filled, number
from ramanujan.text.translation import _

RATIO = UNIT_MASS_RATIO
"""The mass ratio at which the story ends."""
START = 2.0
"""The mass ratio with which the story begins. For every m, the slider of m′ shows it."""
SCREEN_PERIOD = 0.6
"""Duration of a period of the plain mass on the screen during the story [s]."""
_TOO_HEAVY = 1.25
"""A mass ratio about as far above ε* as ε = 1 is below ε*. The slider has a step at this ratio."""
STILL_PERIODS = 2
"""Time at which the still clocks are drawn [periods of the plain mass]."""
_KNOTS = 10
"""Number of straight pieces of a move, which begins and ends slowly."""


@dataclass(frozen=True)
class Scene:
    """A part of the story.

    Parameters
    ----------
    sentence : caption of the scene
    ratios : ε at equal steps of time, from the beginning to the end; two equal values while the machine is constant
    periods : duration in periods of the plain mass
    """

    sentence: str
    ratios: tuple[float, ...]
    periods: float


def turns_gained(ratios: ArrayLike) -> NDArray[np.float64]:
    """Return the gain of the machine's hand in each period of the plain mass [turns], √f(ε) − 1."""
    return np.sqrt(normalized_frequency_squared(ratios)) - 1


@cache
def make_story() -> tuple[Scene, ...]:
    """Return the scenes of the story."""
    lighter = Scene(
        _("Lighter rollers: the machine falls behind more slowly."), _moving_ratios(START, UNIT_MASS_RATIO), 5
    )
    # The hand loses turns while the rollers are heavy. The wait and the move together lose a whole number of turns, and
    # the wait lasts at least one period.
    lost_per_period = -float(turns_gained(START))
    lost_in_move = -turns_in_scene(lighter)
    lost = math.ceil(lost_in_move + lost_per_period)
    wait = (lost - lost_in_move) / lost_per_period
    heavy = _("Heavy rollers: the machine falls behind quickly.")
    ahead = (
        Scene(_("Still lighter: now the machine is faster."), _moving_ratios(UNIT_MASS_RATIO, 1.0), 1.2),
        _still_scene(_("Equal masses: the machine gains slowly."), 1.0, 3),
        Scene(_("Heavier again: the machine slows down."), _moving_ratios(1.0, _TOO_HEAVY), 1.5),
    )
    back = Scene(
        _("Between the two, one mass ratio keeps both hands together."),
        _moving_ratios(_TOO_HEAVY, UNIT_MASS_RATIO),
        1.2,
    )
    # Too heavy rollers lose the turns that the other scenes gain.
    gained = sum(map(turns_in_scene, (*ahead, back)))
    too_heavy_periods = gained / -float(turns_gained(_TOO_HEAVY))
    return (
        _still_scene(heavy, START, wait),
        lighter,
        _still_scene(_("Here both hands turn together."), UNIT_MASS_RATIO, 2),
        *ahead,
        _still_scene(_("Too heavy: the machine falls behind again."), _TOO_HEAVY, too_heavy_periods),
        back,
    )


def collect_data() -> dict[str, Any]:
    """Return the data of `components/story`."""
    return {
        "stage": "oscillator",
        "slider": "m_prime",
        "ratio": RATIO,
        "scenes": list(map(asdict, make_story())),
        "screen_period": SCREEN_PERIOD,
        "stills": list_stills(),
        "words": write_words(),
    }


def write_words() -> dict[str, str]:
    """Return the words of the story's button in the format of `components/story`."""
    return {
        "ratio": "ε = m′/m = {ratio}",
        "in_step": _("In step: ε\u00a0=\u00a0{exactly}. So {number}.").format(
            exactly=page_cache.unit_ratio(), number=page_cache.completed_square()
        ),
        "mark": _("in step"),
        "begin": _("Bring them into step"),
        "again": _("Again"),
        "stop": _("Stop"),
        "stills": filled(
            _("Both hands start together. After {periods} periods of the plain mass they stand like this:"),
            periods=STILL_PERIODS,
        ),
        "hint": _("Watch how the hands part as m′ changes, and where they stay together"),
    }


def list_stills() -> list[dict[str, str | float]]:
    """Return still clocks for visitors who prefer reduced motion: labels, and turns between the hands."""
    ratios = {"5": 5.0, "2": 2.0, f"{number(UNIT_MASS_RATIO, 4)}…": UNIT_MASS_RATIO, "1": 1.0, number(0.5, 1): 0.5}
    return [
        {"label": f"ε = {label}", "turns": round(STILL_PERIODS * float(turns_gained(ratio)), 6)}
        for label, ratio in ratios.items()
    ]


def turns_in_scene(scene: Scene) -> float:
    """Return the gain of the machine's hand in a scene [turns]."""
    # Between two knots ε is linear in time.
    knots = np.linspace(0, 1, len(scene.ratios))
    times = np.linspace(0, 1, 50 * len(scene.ratios) + 1)
    ratios = np.interp(times, knots, scene.ratios)
    return scene.periods * float(np.trapezoid(turns_gained(ratios), times))


def _still_scene(sentence: str, ratio: float, periods: float) -> Scene:
    """Return a scene with a constant machine."""
    return Scene(sentence, (ratio, ratio), periods)


def _moving_ratios(start: float, end: float) -> tuple[float, ...]:
    """Return the ratios of a move, which begins and ends slowly, at equal steps of time."""
    time = np.linspace(0, 1, _KNOTS + 1)[1:-1]
    progress = time**2 * (3 - 2 * time)
    # Round the numbers, because every run of the page sends the story.
    ratios = np.round(start * (end / start) ** progress, 3)
    return (start, *map(float, ratios), end)
