"""What a task is: something to bring about with the machine, and a judge that works out how close one has come."""

from collections.abc import Callable
from dataclasses import dataclass, field

from ramanujan.lesson.stop import COMPRESSION
from ramanujan.numerals import filled, told_from, with_unit
from ramanujan.oscillator import Oscillator


@dataclass(frozen=True)
class Setting:
    """What a student has set; each task looks at what it needs.

    Parameters
    ----------
    machine, compression : from the sidebar; x₀ [m]
    release : x₀ of a task that allows a relaxed spring [m]
    glide, spin : initial velocity of the machine to the right [m/s], and of the top cylinder, clockwise [rad/s]
    method, steps : an integrator, name in METHODS, and its steps per period
    bodies : left roller, right roller and top body, names in `number_theory.BODIES`
    formula : a formula as it was typed; empty if there is none yet
    part : a part of a period; None if nothing, or nothing that is a number, was typed
    seconds, periods : what a stopwatch showed, None if nothing was measured, and for how many periods
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
class Verdict:
    """Whether the task is done, and a sentence or two that say how far from the goal the student is.

    As long as nothing has been typed or measured, nothing is judged, and the sentence says what to do.
    """

    done: bool
    sentence: str
    is_judged: bool = True


def missed(sentence: str, **values: object) -> Verdict:
    """Return that a task is not done, with a template for `numerals.filled`."""
    return Verdict(False, filled(sentence, **values))


def near(off: float, tolerance: float, sentences: tuple[str, ...], unit: str = "", **values: object) -> Verdict:
    """Return the verdict on a value that misses its goal by so much.

    Parameters
    ----------
    off, tolerance : by how much the value is too large, and how much is allowed
    sentences : if it is near enough, too large, too small; templates for `numerals.filled`
    unit : of `off`, the distance from the goal, as the sentences have it: s, cm or %
    values : other numbers of the sentences
    """
    done = abs(off) <= tolerance
    sentence = sentences[0 if done else 1 if off > 0 else 2]
    scale = {"cm": 100, "%": 100}.get(unit, 1)
    # Near the goal with the digits that show on which side of it the value is.
    distance = with_unit(told_from(scale * abs(off), scale * tolerance), unit)
    return Verdict(done, filled(sentence, off=distance, **values))


@dataclass(frozen=True)
class Task:
    """One task.

    Parameters
    ----------
    id : short and ASCII, as it stands in an address
    heading, text : what is to be done, plain text
    hints : from a nudge to nearly the way, to be shown one by one
    judge : returns the verdict on a setting, by physics
    fields : what of a `Setting` has to be set beside the machine in the sidebar
    hides : parts of the stage that would do the task for the student, names of `stage.PARTS`
    stage : whether the machine is to be seen
    """

    id: str
    heading: str
    text: str
    hints: tuple[str, ...]
    judge: Callable[[Setting], Verdict]
    fields: tuple[str, ...] = ()
    hides: tuple[str, ...] = ()
    stage: bool = True
