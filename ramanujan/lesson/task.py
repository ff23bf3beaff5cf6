"""A task: a goal to reach with the machine, and a judge that computes the distance of an attempt from the goal."""

from collections.abc import Callable
from dataclasses import dataclass, field

from ramanujan.lesson.stop import COMPRESSION
from ramanujan.physics.oscillator import Oscillator
from ramanujan.text.numerals import distinct_from, filled, with_unit


@dataclass(frozen=True)
class Attempt:
    """A student's attempt; each task reads the fields that it needs.

    Parameters
    ----------
    machine, compression : the machine and x₀ [m] of the sidebar
    release : x₀ in a task that also allows a relaxed spring [m]
    glide, spin : initial velocity of the machine to the right [m/s], and of the top cylinder, clockwise [rad/s]
    method, steps : name of an integrator in METHODS, and its steps per period
    bodies : left roller, right roller and top body, names in `number_theory.BODIES`
    formula : the typed formula; empty if none was typed
    part : a typed part of a period, None without a readable number
    seconds, periods : the time on the stopwatch, None before a measurement, and the number of measured periods
    """

    machine: Oscillator = field(default_factory=lambda: Oscillator(k=10.0))
    compression: float = COMPRESSION
    release: float = COMPRESSION
    glide: float = 0.0
    spin: float = 0.0
    method: str = "explicit_euler"
    steps: int = 100
    bodies: tuple[str, str, str] = ("hoop", "cylinder", "cylinder")
    formula: str = ""
    part: float | None = None
    seconds: float | None = None
    periods: int = 10


@dataclass(frozen=True)
class TaskVerdict:
    """The verdict on an attempt.

    is_done : whether the goal is reached
    sentence : the result: success, or the distance from the goal; without an attempt, instructions
    is_judged : False if there was no attempt to judge, such as a typed number or a measurement
    """

    is_done: bool
    sentence: str
    is_judged: bool = True


def miss_goal(sentence: str, **values: object) -> TaskVerdict:
    """Return the verdict on an attempt that misses the goal; `sentence` is a template for `numerals.filled`."""
    return TaskVerdict(is_done=False, sentence=filled(sentence, **values))


def compare_with_goal(
    off: float, tolerance: float, sentences: tuple[str, ...], unit: str = "", **values: object
) -> TaskVerdict:
    """Return the verdict on a value near its goal.

    Parameters
    ----------
    off, tolerance : the value minus its goal, and the largest allowed difference
    sentences : three templates for `numerals.filled`: for a value within the tolerance, above it, and below it. The
        last one is omitted if no value is below.
    unit : the unit of `off` in the sentences: s, cm or %
    values : other numbers of the sentences
    """
    is_done = abs(off) <= tolerance
    near_enough, too_large, *too_small = sentences
    if is_done:
        sentence = near_enough
    elif off > 0:
        sentence = too_large
    else:
        (sentence,) = too_small
    scale = {"cm": 100, "%": 100}.get(unit, 1)
    # The distance has enough digits to differ from the tolerance.
    distance = with_unit(distinct_from(scale * abs(off), scale * tolerance), unit)
    return TaskVerdict(is_done, filled(sentence, off=distance, **values))


@dataclass(frozen=True)
class Task:
    """One task.

    Parameters
    ----------
    id : short ASCII text for URLs
    heading, text : the goal, plain text
    hints : shown one by one, each more explicit than the one before
    judge : computes the verdict on an attempt
    fields : fields of an `Attempt` that the task needs besides the sidebar
    hides : parts of the stage that would solve the task, names of `stage.PARTS`
    has_stage : whether the task shows the stage
    """

    id: str
    heading: str
    text: str
    hints: tuple[str, ...]
    judge: Callable[[Attempt], TaskVerdict]
    fields: tuple[str, ...] = ()
    hides: tuple[str, ...] = ()
    has_stage: bool = True
