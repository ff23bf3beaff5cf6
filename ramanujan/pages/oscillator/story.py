"""The story of the first page: from equal masses to the one mass ratio at which both clock hands turn together.

Times are in periods of the plain mass, masses in units of m, so one story fits every machine. The hands start together,
with the machine that the page opens with. It gains, and with too heavy rollers it falls behind, so long that the hands
meet again at ε*. The machine's hand gains this number of turns:

    ∫ (√f(ε(t)) − 1) dt,    f(ε) = Ω²m/k
"""

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
START = 1.0
"""The mass ratio with which the story begins. For every m, the slider of m′ shows it."""
SCREEN_PERIOD = 0.6
"""Duration of a period of the plain mass on the screen during the story [s]."""
_TOO_HEAVY = 2.0
"""A mass ratio at which the machine clearly falls behind."""
STILL_PERIODS = 2
"""Time at which the still clocks are drawn [periods of the plain mass]."""
_KNOTS = 10
"""Number of straight pieces of a move."""


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
    equal = _still_scene(_("Equal masses: the machine gains slowly."), START, 4)
    heavier = Scene(_("Heavier rollers: the machine slows down."), _moving_ratios(START, _TOO_HEAVY), 3)
    between = Scene(
        _("Between the two, one mass ratio keeps both hands together."),
        _moving_ratios(_TOO_HEAVY, UNIT_MASS_RATIO, stops_slowly=False),
        5,
    )
    # Too heavy rollers lose the turns that the other scenes gain, and one more.
    gained = sum(map(turns_in_scene, (equal, heavier, between)))
    too_heavy_periods = (1 + gained) / -float(turns_gained(_TOO_HEAVY))
    too_heavy = _still_scene(_("Too heavy: the machine falls behind."), _TOO_HEAVY, too_heavy_periods)
    return equal, heavier, too_heavy, between


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


def _moving_ratios(start: float, end: float, *, stops_slowly: bool = True) -> tuple[float, ...]:
    """Return the ratios of a move, which begins slowly, at equal steps of time.

    A slow end at ε* would show a drift of a turn in thousands of periods.
    """
    time = np.linspace(0, 1, _KNOTS + 1)[1:-1]
    progress = time**2 * (3 - 2 * time if stops_slowly else 2 - time)
    # Round the numbers, because every run of the page sends the story.
    ratios = np.round(start * (end / start) ** progress, 3)
    return (start, *map(float, ratios), end)
