"""The reader's progress in the lesson: the URL parameters in the session, and the predictions."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import streamlit as st

from ramanujan import lesson
from ramanujan.classroom.states import END
from ramanujan.lesson import Stop
from ramanujan.shell import address, class_session
from ramanujan.text.translation import _

ASKED, PREDICTED, MISSED, ANSWERED = "asked", "predicted", "missed", "answered"
"""The phases of a stop for a reader:

    ASKED       no option is selected
    PREDICTED   an option is selected, and the machine is at rest
    MISSED      the option is wrong, the machine runs, and the right answer is hidden
    ANSWERED    the right answer is shown
"""

PART = address.Choice("part", {"stops": _("Stops"), "tasks": _("Tasks"), "notes": _("Lecturer’s notes")}, "stops")


@dataclass(frozen=True)
class StopChoice(address.Choice):
    """A stop or the end. The address may also contain the number of a stop in this lesson."""

    def read(self, text: str) -> str:
        """Return the id of the stop. Raise `ValueError` for an invalid text."""
        included = filter(_is_included, lesson.STOPS)
        numbers = {str(number): stop.id for number, stop in enumerate(included, start=1)}
        return numbers.get(text) or super().read(text)


STOP = StopChoice("stop", (*(stop.id for stop in lesson.STOPS), END), lesson.STOPS[0].id)
TASK = address.Choice("task", {task.id: task.heading for task in lesson.TASKS}, lesson.TASKS[0].id)
LENGTH = address.Choice("stops", ("short", "all"))


@dataclass(frozen=True)
class Predictions(address.URLParameter):
    """The predictions of a reader: stop → option and phase.

    An example of the text in the address is block.opposite~radius.same.predicted. Without a third word the phase is
    ANSWERED.
    """

    name: str
    default: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    example: str = "radius.same~block.rest"
    template = _("The value of {name} in the address was ignored: it must list predictions, such as {example}.")

    def read(self, text: str) -> dict[str, tuple[str, str]]:
        """Return the predictions. Raise `ValueError` for an invalid text."""
        predictions = {}
        options = {stop.id: stop.options for stop in lesson.STOPS}
        for entry in text.split("~"):
            name, option, *phase = entry.split(".")
            if phase not in ([], [PREDICTED], [MISSED]) or option not in options.get(name, ()):
                raise ValueError(self.name)
            predictions[name] = option, phase[0] if phase else ANSWERED
        return predictions

    def write(self, predictions: Mapping[str, tuple[str, str]]) -> str:
        """Return the text of the predictions in the address."""
        entries = []
        for stop, (option, phase) in predictions.items():
            entries.append(f"{stop}.{option}" if phase == ANSWERED else f"{stop}.{option}.{phase}")
        return "~".join(entries)


CHOSEN = Predictions("chosen")
URL_PARAMETERS = (PART, LENGTH, STOP, TASK, CHOSEN)
"""The length precedes the stop, whose number depends on it."""


def read_prediction(stop: Stop) -> tuple[str | None, str]:
    """Return the option that the reader has selected at a stop, or None, and the reader's phase there."""
    return address.current(CHOSEN).get(stop.id, (None, ASKED))


def predict(stop: Stop, option: str | None, phase: str = PREDICTED) -> None:
    """Store an option and a phase as the prediction for a stop. Without an option, delete the prediction."""
    predictions = dict(address.current(CHOSEN))
    # Remove it first, so that the newest prediction is the last one in the address.
    predictions.pop(stop.id, None)
    if option:
        predictions[stop.id] = option, phase
    st.session_state[CHOSEN.name] = predictions


def list_stops() -> tuple[Stop, ...]:
    """Return the stops of this lesson: all, or those of a short lecture and the current one."""
    current = address.current(STOP)
    return tuple(stop for stop in lesson.STOPS if _is_included(stop) or stop.id == current)


def _is_included(stop: Stop) -> bool:
    """Return whether a lesson of the selected length includes a stop."""
    length = address.current(LENGTH) or ("short" if class_session.lecturer_key() else "all")
    return length == "all" or stop.is_in_short_lesson


def find_next_stop(stop: Stop) -> Stop | None:
    """Return the next stop; None after the last."""
    stops = list_stops()
    index = stops.index(stop) + 1
    return stops[index] if index < len(stops) else None


def find_previous_stop(name: str) -> Stop | None:
    """Return the stop before a stop or before the end; None before the first."""
    stops = list_stops()
    index = len(stops) if name == END else [stop.id for stop in stops].index(name)
    return stops[index - 1] if index else None
