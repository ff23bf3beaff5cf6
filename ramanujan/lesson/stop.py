"""What a stop of the lesson is: a machine, a question with options, an answer that is worked out, and why it holds.

    predict   the question, while what `hides` names is neither in the picture nor anywhere else on the page
    observe   the `runs`: the machine, or several side by side, in motion
    explain   `explanation()`, with the numbers put in

A stop types no result: `answer` and `explanation` are functions that ask the core, SymPy or `number_theory`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

FREQUENCY = ("clocks", "numbers")
"""Parts of the stage that tell how fast the machine is."""
EVERYTHING = ("clocks", "numbers", "motion")
"""What is hidden where the motion itself is the answer: the machine stands still."""


@dataclass(frozen=True)
class Option:
    """One of the answers to choose from: a short ASCII id, which stands in addresses, and a sentence for people."""

    id: str
    label: str


@dataclass(frozen=True)
class Run:
    """A machine that is shown.

    Parameters
    ----------
    machine : the machine
    compression : x₀ at release [m]
    label : what stands under its picture, where several machines are shown side by side
    bodies : left roller, right roller and top body, names in `number_theory.BODIES`
    samples : returns a computed motion to show instead of the exact one: step [s] and X, phi, Phi
    slipping : the contact that slips is marked
    """

    machine: Oscillator
    compression: float = 0.08
    label: str = ""
    bodies: tuple[str, str, str] = ("hoop", "cylinder", "cylinder")
    samples: Callable[[], Mapping[str, object]] | None = None
    slipping: bool = False


@dataclass(frozen=True)
class Stop:
    """One stop of the lesson.

    Parameters
    ----------
    id : short and ASCII, as it stands in an address
    heading, question : what is asked, plain text
    options : the answers to choose from
    answer : returns the id of the right option
    explanation : returns why it is right, with the numbers of this machine
    hints : questions that lead on, to be shown one by one
    minutes : how long the stop takes in a class
    runs : the machines; the first is shown before the prediction
    hides : what a prediction must not see, names of `stage.PARTS`
    presets : presets of the sidebar that would tell the answer, names in `controls.PRESETS`
    layers : what the stage shows besides after the prediction
    dials : the stage shows its clocks and its gauge after the prediction
    then : the machine after the prediction, where it is another one
    size : "large" where the picture matters, "small" where the question needs the room
    page : the page on which it is seen in full, by its folder in `pages`
    link : what the address of that page says besides the machine
    link_label : what the link says
    """

    id: str
    heading: str
    question: str
    options: tuple[Option, ...]
    answer: Callable[[], str]
    explanation: Callable[[], str]
    hints: tuple[str, ...]
    minutes: int
    runs: tuple[Run, ...]
    page: str
    link_label: str
    hides: tuple[str, ...] = EVERYTHING
    presets: tuple[str, ...] = ()
    layers: tuple[str, ...] = ()
    dials: bool = False
    then: Oscillator | None = None
    size: str = "large"
    link: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))

    @property
    def machine(self) -> Oscillator:
        """The machine of the question."""
        return self.runs[0].machine

    @property
    def shown(self) -> Oscillator:
        """The machine after the prediction."""
        return self.then or self.machine

    @property
    def compression(self) -> float:
        """Where it is released, x₀ [m]."""
        return self.runs[0].compression

    def option(self, name: str) -> Option:
        """Return the option with this id; ValueError if there is none."""
        for option in self.options:
            if option.id == name:
                return option
        raise ValueError(_("the stop {stop} has no option {name}").format(stop=self.id, name=name))


def options(**labels: str) -> tuple[Option, ...]:
    """Return options from id=label, in this order."""
    return tuple(Option(name, label) for name, label in labels.items())
