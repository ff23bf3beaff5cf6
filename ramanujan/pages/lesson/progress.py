"""The reader's progress in the lesson: the URL parameters in the session, and the predictions."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import streamlit as st

from ramanujan import lesson
from ramanujan.lesson import Stop
from ramanujan.lesson.class_states import END
from ramanujan.shell import address, class_session
from ramanujan.translation import _

ASKED, PREDICTED, MISSED, ANSWERED = "asked", "predicted", "missed", "answered"
"""State of a stop: no option selected; an option selected, machine at rest; wrong option, machine running, right answer
hidden; right answer shown."""

PART = address.Choice("part", {"stops": _("Stops"), "tasks": _("Tasks"), "notes": _("Lecturer’s notes")}, "stops")
STOP = address.Choice("stop", (*(stop.id for stop in lesson.STOPS), END), lesson.STOPS[0].id)
TASK = address.Choice("task", {task.id: task.heading for task in lesson.TASKS}, lesson.TASKS[0].id)
LENGTH = address.Choice("stops", ("short", "all"))


@dataclass(frozen=True)
class Predictions(address.URLParameter):
    """Predictions in the address: stop → option and progress of the reader.

    In the address: block.opposite~radius.same.predicted; without a third word, the right answer was shown.
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
        return "~".join(".".join((stop, *words)).removesuffix(f".{ANSWERED}") for stop, words in predictions.items())


CHOSEN = Predictions("chosen")
URL_PARAMETERS = (PART, STOP, TASK, LENGTH, CHOSEN)


def prediction(stop: Stop) -> tuple[str | None, str]:
    """Return the selected option of a stop, if any, and its progress."""
    return address.current(CHOSEN).get(stop.id, (None, ASKED))


def predict(stop: Stop, option: str | None, phase: str = PREDICTED) -> None:
    """Write, delete or advance the prediction for a stop."""
    predictions = {name: chosen for name, chosen in address.current(CHOSEN).items() if name != stop.id}
    st.session_state[CHOSEN.name] = predictions | ({stop.id: (option, phase)} if option else {})


def path() -> tuple[Stop, ...]:
    """Return the stops of this lesson: all, or those of a short lecture and the current one."""
    asked = address.current(LENGTH) or ("short" if class_session.lecturer_key() else "all")
    now = address.current(STOP)
    return tuple(stop for stop in lesson.STOPS if asked == "all" or stop.short or stop.id == now)


def following(stop: Stop) -> Stop | None:
    """Return the next stop; None after the last."""
    stops = path()
    at = stops.index(stop) + 1
    return stops[at] if at < len(stops) else None


def previous(place: str) -> Stop | None:
    """Return the previous stop, also before the end; None before the first."""
    stops = path()
    at = len(stops) if place == END else [stop.id for stop in stops].index(place)
    return stops[at - 1] if at else None
