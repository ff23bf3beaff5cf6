"""How far a reader has come in the lesson: the keys of the address, held in the session, and the predictions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

import streamlit as st

from ramanujan import lesson
from ramanujan.shell import address
from ramanujan.translation import _

_IDS = tuple(stop.id for stop in lesson.STOPS)
_TASKS = tuple(task.id for task in lesson.TASKS)

PART = address.Choice("part", ("stops", "tasks", "notes"), "stops")
STOP = address.Choice("stop", _IDS, _IDS[0])
TASK = address.Choice("task", _TASKS, _TASKS[0])


@dataclass(frozen=True)
class Predictions:
    """A key of the address that lists predictions, such as block.opposite~radius.same: stop → option."""

    bound: ClassVar[bool] = False
    name: str
    default: Mapping[str, str] = field(default_factory=dict)

    def read(self, text: str) -> dict[str, str]:
        """Return the predictions; ValueError if the text is no such list."""
        made = {}
        for entry in text.split("~"):
            name, _dot, option = entry.partition(".")
            made[name] = lesson.stop(name).option(option).id
        return made

    def write(self, made: Mapping[str, str]) -> str:
        """Return the predictions as the address has them."""
        return "~".join(f"{stop}.{option}" for stop, option in made.items())

    def complaint(self) -> str:
        """Return the sentence for a text that does not fit."""
        return _("The value of {name} in the address was ignored: it must list predictions, such as {example}.").format(
            name=self.name, example="radius.same~block.rest"
        )


CHOSEN = Predictions("chosen")
KEYS = (PART, STOP, TASK, CHOSEN)


def predictions() -> Mapping[str, str]:
    """Return stop → option of the predictions that have been made."""
    return address.held(CHOSEN)


def predict(stop: str, option: str | None) -> None:
    """Make a prediction, or take it back."""
    made = {name: chosen for name, chosen in predictions().items() if name != stop}
    st.session_state[CHOSEN.name] = made | ({stop: option} if option else {})
