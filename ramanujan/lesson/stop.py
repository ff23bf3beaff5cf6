"""A stop of the lesson: a machine, a question with options, its computed answer, and an explanation.

    predict   the question; the page hides everything that `hides` names
    observe   the `runs`: one machine, or several side by side, in motion
    explain   `explanation()`, and for a wrong option its `reply()`, with their numbers

A stop contains no typed results: `answer` and `answer_numbers` are functions that call the core, SymPy or
`number_theory`. Options contain no reasons, so the wording does not reveal the right one.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ramanujan.physics.motion import InitialState, motion, released
from ramanujan.physics.oscillator import Oscillator
from ramanujan.text.numerals import filled
from ramanujan.text.translation import _

FREQUENCY = ("clocks", "numbers")
"""The parts of the stage that reveal the frequency."""
EVERYTHING = ("numbers", "motion")
"""The hidden parts if the motion is the answer: machine and clock hands are at rest."""

EQUAL = Oscillator(m=1.0, m_prime=1.0, k=10.0)
COMPRESSION = 0.08
"""The machine of most stops, and its compression at release [m]."""


@dataclass(frozen=True)
class Run:
    """A machine on the stage.

    Parameters
    ----------
    machine : the machine
    compression : x₀ at release [m]
    label : the caption of a machine that does not follow the sliders, such as one of several side by side
    bodies : left roller, right roller and top body, names in `number_theory.BODIES`
    samples : returns a computed motion that replaces the exact one: per_period, q and energies
    most_energy : returns the energy of a full bar of energies, in multiples of that at release
    slipping : whether the stage marks the slipping contact
    initial : the state at release; by default at rest with the spring compressed by x₀
    """

    machine: Oscillator = EQUAL
    compression: float = COMPRESSION
    label: str = ""
    bodies: tuple[str, str, str] = ("hoop", "cylinder", "cylinder")
    samples: Callable[[], Mapping[str, object]] | None = None
    most_energy: Callable[[], float] | None = None
    slipping: bool = False
    initial: InitialState | None = None


class Onward(NamedTuple):
    """A link to another page.

    label : the text of the link
    page : the folder of the page in `pages`
    query : the parameters of the URL, besides the machine
    """

    label: str
    page: str = "oscillator"
    query: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True)
class Stop:
    """One stop of the lesson.

    All sentences are templates for `numerals.filled`. Their slots are `question_numbers`, `answer_numbers`, and:

        equal             the machine with equal masses
        machine, shown    the machines before and after the prediction
        runs              the runs of the stop

    Parameters
    ----------
    id : short ASCII text for URLs
    heading, question : plain text
    options : id of each option, short ASCII text for URLs → its sentence
    answer : returns the id of the right option
    replies : id of each wrong option → its consequence for this machine, then the next question
    why : the explanation of the right option
    question_numbers : numbers of the question, for all sentences
    answer_numbers : returns numbers of the answer, for `why` and `replies`
    hints : questions that lead to the answer, shown one by one
    purpose, expect : notes for the lecturer: the purpose of the stop, and frequent answers with their reasons
    minutes : duration in class
    is_in_short_lesson : whether the stop also belongs to the short lesson
    runs : the machines; only the first is visible before the prediction
    hides : parts of the stage that would reveal the answer, names of `stage.PARTS`
    layers : optional layers of the stage after the prediction
    shows_dials : whether the stage shows its clocks, and after the prediction the drift
    periods : number of periods of the plain mass in the question. The motion pauses there by itself, and the result
        appears. With dials, a button then sets both clocks to this moment.
    exhibit : Markdown above the machine, such as a program
    outcome : the exhibit after the prediction, with the observation, such as the output of the program
    sliders : instructions for the sliders after the prediction
    changed_machine : the machine after the prediction, if it changes
    onward : link to a page about the same subject
    """

    id: str
    heading: str
    question: str
    options: Mapping[str, str]
    answer: Callable[[], str]
    replies: Mapping[str, str]
    why: str
    hints: tuple[str, ...]
    purpose: str
    expect: str
    onward: Onward
    question_numbers: Mapping[str, object] = field(default_factory=lambda: MappingProxyType({}))
    answer_numbers: Callable[[], Mapping[str, object]] = dict
    minutes: int = 2
    is_in_short_lesson: bool = False
    runs: tuple[Run, ...] = (Run(),)
    hides: tuple[str, ...] = EVERYTHING
    layers: tuple[str, ...] = ()
    shows_dials: bool = False
    periods: int = 0
    exhibit: str = ""
    outcome: str = ""
    sliders: str = ""
    changed_machine: Oscillator | None = None

    @property
    def machine(self) -> Oscillator:
        """The machine of the question, for the sliders; a machine with a label does not follow them."""
        return EQUAL if self.runs[0].label else self.runs[0].machine

    @property
    def final_machine(self) -> Oscillator:
        """The machine after the prediction."""
        return self.changed_machine or self.machine

    @property
    def compression(self) -> float:
        """The compression at release, x₀ [m]."""
        return self.runs[0].compression

    @property
    def observation(self) -> str:
        """The label of the button after the prediction; it starts a machine at rest, or shows the result."""
        return _("Run the machine") if "motion" in self.hides and not self.exhibit else _("Check it")

    def __post_init__(self) -> None:
        # The texts before the prediction need no `answer_numbers`, which take long to compute, so fill them at once.
        # A frozen dataclass allows no assignments, only `object.__setattr__`.
        for name in ("heading", "question"):
            object.__setattr__(self, name, self._fill(getattr(self, name)))
        object.__setattr__(self, "hints", tuple(map(self._fill, self.hints)))
        object.__setattr__(self, "options", {id: self._fill(label) for id, label in self.options.items()})

    @cached_property
    def right(self) -> str:
        """The id of the right option."""
        return self.answer()

    @cached_property
    def _numbers(self) -> Mapping[str, object]:
        return self.answer_numbers()

    def explanation(self) -> str:
        """Return the explanation with the numbers of this machine, without line breaks at = and +."""
        explanation = self._fill(self.why, **self._numbers)
        return explanation.replace(" = ", "\u00a0=\u00a0").replace(" + ", "\u00a0+\u00a0")

    def reply(self, option: str) -> str:
        """Return the reply to a wrong option, with the numbers of this machine."""
        return self._fill(self.replies[option], **self._numbers)

    def _fill(self, template: str, **numbers: object) -> str:
        machines = {"equal": EQUAL, "machine": self.machine, "shown": self.final_machine, "runs": self.runs}
        return filled(template, **machines, **self.question_numbers, **numbers)


def state_after(
    part: float | NDArray[np.float64], machine: Oscillator = EQUAL, compression: float = COMPRESSION
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the state (q, q̇) of a machine after a part of a period from its release; several parts are an array."""
    return motion(machine, released(machine, compression), part * machine.period)


def choose_by_sign(value: Any, negative: str, zero: str, positive: str) -> str:
    """Return the id for a negative, a zero or a positive value."""
    if value < 0:
        return negative
    return positive if value > 0 else zero
