"""What a stop of the lesson is: a machine, a question with options, an answer that is worked out, and why it holds.

    predict   the question, while what `hides` names is neither in the picture nor anywhere else on the page
    observe   the `runs`: the machine, or several side by side, in motion
    explain   `explanation()`, and for a wrong option its `reply()`, with the numbers put in

A stop types no result: `answer` and `numbers` are functions that ask the core, SymPy or `number_theory`.
Options give no reasons, so that nobody can tell the right one by its looks.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple

from numpy.typing import NDArray

from ramanujan.motion import InitialState, motion, released
from ramanujan.numerals import filled
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

FREQUENCY = ("clocks", "numbers")
"""Parts of the stage that tell how fast the machine is."""
EVERYTHING = ("numbers", "motion")
"""What is hidden where the motion itself is the answer: the machine stands still, and both clock hands with it."""

EQUAL = Oscillator(m=1.0, m_prime=1.0, k=10.0)
COMPRESSION = 0.08
"""The machine of most stops, and where it is released [m]."""


@dataclass(frozen=True)
class Run:
    """A machine that is shown.

    Parameters
    ----------
    machine : the machine
    compression : x₀ at release [m]
    label : what stands under its picture, where it follows no slider, as several side by side
    bodies : left roller, right roller and top body, names in `number_theory.BODIES`
    samples : returns a computed motion to show instead of the exact one: per_period and q
    slipping : the contact that slips is marked
    initial : the state at release; without it, at rest with the spring compressed by x₀
    """

    machine: Oscillator = EQUAL
    compression: float = COMPRESSION
    label: str = ""
    bodies: tuple[str, str, str] = ("hoop", "cylinder", "cylinder")
    samples: Callable[[], Mapping[str, object]] | None = None
    slipping: bool = False
    initial: InitialState | None = None


class Onward(NamedTuple):
    """A link to another page.

    label : what the link says
    page : its folder in `pages`
    query : what its address says besides the machine
    """

    label: str
    page: str = "oscillator"
    query: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True)
class Stop:
    """One stop of the lesson.

    All sentences are templates for `numerals.filled`. They may name `equal`, the machine with equal masses, `machine`
    and `shown`, those of this stop, and its `runs`.

    Parameters
    ----------
    id : short and ASCII, as it stands in an address
    heading, question : what is asked, plain text
    options : the answers to choose from: a short ASCII id, which stands in addresses → a sentence for people
    answer : returns the id of the right option
    replies : id of each wrong option → what it would mean for this machine, then a question that leads on
    why : why the right option is right
    given : numbers of the question; all sentences may name them
    numbers : returns numbers of the answer, for `why` and `replies`
    hints : questions that lead on, to be shown one by one
    purpose, expect : for the lecturer: what the stop is for, and what students often answer and why
    minutes : how long the stop takes in a class
    short : the stop also belongs to the short lesson
    runs : the machines; the first is shown before the prediction
    hides : what a prediction must not see, names of `stage.PARTS`
    layers : what the stage shows besides after the prediction
    dials : the stage shows its clocks, and after the prediction its gauge
    periods : of the plain mass, to which a button takes both clocks after the answer
    exhibit : Markdown that is shown above the machine, such as a program
    outcome : the exhibit after the prediction, with what is observed, such as the output of the program
    sliders : what to do with the sliders after the prediction
    then : the machine after the prediction, where it is another one
    onward : where it is seen in full
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
    given: Mapping[str, object] = field(default_factory=lambda: MappingProxyType({}))
    numbers: Callable[[], Mapping[str, object]] = dict
    minutes: int = 2
    short: bool = False
    runs: tuple[Run, ...] = (Run(),)
    hides: tuple[str, ...] = EVERYTHING
    layers: tuple[str, ...] = ()
    dials: bool = False
    periods: int = 0
    exhibit: str = ""
    outcome: str = ""
    sliders: str = ""
    then: Oscillator | None = None

    @property
    def machine(self) -> Oscillator:
        """The machine of the question, as far as sliders hold it; one with a label follows none."""
        return EQUAL if self.runs[0].label else self.runs[0].machine

    @property
    def shown(self) -> Oscillator:
        """The machine after the prediction."""
        return self.then or self.machine

    @property
    def compression(self) -> float:
        """Where it is released, x₀ [m]."""
        return self.runs[0].compression

    @property
    def observation(self) -> str:
        """The label of the button that shows what was predicted: only a machine at rest is started."""
        return _("Run the machine") if "motion" in self.hides and not self.exhibit else _("Check it")

    def __post_init__(self) -> None:
        for name in ("heading", "question"):
            object.__setattr__(self, name, self._filled(getattr(self, name)))
        object.__setattr__(self, "hints", tuple(map(self._filled, self.hints)))
        object.__setattr__(self, "options", {id: self._filled(label) for id, label in self.options.items()})

    @cached_property
    def right(self) -> str:
        """The id of the right option."""
        return self.answer()

    @cached_property
    def _found(self) -> Mapping[str, object]:
        return self.numbers()

    def explanation(self) -> str:
        """Return why the right option is right, with the numbers of this machine; no line breaks at = or +."""
        return self._filled(self.why, **self._found).replace(" = ", "\u00a0=\u00a0").replace(" + ", "\u00a0+\u00a0")

    def reply(self, option: str) -> str:
        """Return what to say to whoever chose this wrong option, with the numbers of this machine."""
        return self._filled(self.replies[option], **self._found)

    def _filled(self, template: str, **numbers: object) -> str:
        machines = {"equal": EQUAL, "machine": self.machine, "shown": self.shown, "runs": self.runs}
        return filled(template, **machines, **self.given, **numbers)


def after(
    part: float | NDArray, machine: Oscillator = EQUAL, compression: float = COMPRESSION
) -> tuple[NDArray, NDArray]:
    """Return the state (q, q̇) of a machine this part of a period, or these, after its release."""
    return motion(machine, released(machine, compression), part * machine.period)


def by_sign(value: Any, negative: str, zero: str, positive: str) -> str:
    """Return one of three ids by the sign of a number."""
    return positive if value > 0 else negative if value < 0 else zero
