"""The end of the lesson: what was shown, what the reader had predicted, and where to go on."""

import streamlit as st

from ramanujan.lesson import Stop
from ramanujan.pages.lesson import progress
from ramanujan.shell.display_mode import is_projector, sheet
from ramanujan.shell.navigation import PAGES
from ramanujan.translation import _

HEADING = _("What you have seen")
_ON_A_SHEET = 9
"""Stops that a sheet of a projector lists."""
_ONWARDS = {
    "oscillator": _("Look for the ratio in step yourself, on the page Oscillator"),
    "derivation": _("Derive Ω² step by step, on the page Derivation"),
    "taxicab": _("Find out more about the number, on the page 1729"),
    "worksheet": _("Print questions with space to write, on the page Worksheet"),
}


def draw(path: tuple[Stop, ...]) -> None:
    """Draw the end: the right answer of every stop that was answered."""
    right, answered, lines = 0, 0, []
    for stop in path:
        chosen, phase = progress.prediction(stop)
        if phase != progress.ANSWERED:
            lines.append(_("- **{heading}** – Not answered yet.").format(heading=stop.heading))
            continue
        answered, right = answered + 1, right + (chosen == stop.right)
        sign = ":green[:material/check_circle:]" if chosen == stop.right else ":red[:material/cancel:]"
        lines.append(f"- {sign} **{stop.heading}** – {stop.options[stop.right]}")
    said = _("You answered {answered} of {stops} questions. Your prediction was right at {right} of them.")
    first = _ON_A_SHEET if is_projector() else len(lines)
    with sheet("seen", HEADING):
        st.title(HEADING, anchor=False)
        st.markdown(said.format(answered=answered, stops=len(path), right=right))
        st.markdown("\n".join(lines[:first]))
    if lines[first:]:
        with sheet("seen_on", _("{heading}, continued").format(heading=HEADING)):
            st.markdown("\n".join(lines[first:]))
    with sheet("onwards", _("Where to go on")):
        st.markdown(_("Where to go on:"))
        st.button(_("Set the machine yourself: twelve tasks"), key="to_tasks", on_click=_to_tasks)
        for name, label in _ONWARDS.items():
            st.page_link(PAGES[name].file, label=label, icon=":material/arrow_forward:")


def _to_tasks() -> None:
    st.session_state[progress.PART.name] = "tasks"
