"""Messages about a visitor’s input: problems of the address on the page, all others at the box of a slider."""

import streamlit as st

from ramanujan.text.catalogue import COMPLETE
from ramanujan.text.translation import LANGUAGE, TRANSLATED, _

_ABOUT_ADDRESS = "messages_address"
"""Session state: the sentences about the address that the page shows."""
_NOTES = "messages_notes"
"""Session state: key of a parameter → the message at its box in the next run, and whether it is a warning."""
_SHOWN = "messages_shown"
"""Session state: the notes that the current run shows."""
_REPEAT = "messages_repeat"
"""Session state: whether the next run repeats the messages of this one."""


def begin(problems: list[str]) -> None:
    """Begin a run: show the problems of the address. After `keep_in_next_run` the run also shows the old messages."""
    repeats = st.session_state.pop(_REPEAT, False)
    old_problems = st.session_state.get(_ABOUT_ADDRESS, []) if repeats else []
    old_notes = st.session_state.get(_SHOWN, {}) if repeats else {}
    problems = [*old_problems, *problems]
    st.session_state[_ABOUT_ADDRESS] = problems
    st.session_state[_SHOWN] = old_notes | st.session_state.pop(_NOTES, {})
    # Show them on the page, since the sidebar of a phone starts closed.
    if problems:
        st.warning(" ".join(problems))


def warn(sentence: str) -> None:
    """Show one more problem of the address on the page."""
    st.warning(sentence)
    st.session_state[_ABOUT_ADDRESS] = [*st.session_state.get(_ABOUT_ADDRESS, []), sentence]


def note(key: str, sentence: str, is_warning: bool = False) -> None:
    """Store a sentence for the next run, which shows it at the box of a parameter.

    Parameters
    ----------
    key : key of the parameter
    sentence : the message
    is_warning : whether to show it as a warning instead of a note
    """
    st.session_state[_NOTES] = {**st.session_state.get(_NOTES, {}), key: (sentence, is_warning)}


def show_note(key: str) -> None:
    """Draw the message at the box of a parameter, if there is one."""
    notes = st.session_state.get(_SHOWN, {})
    if key not in notes:
        return
    sentence, is_warning = notes[key]
    draw = st.warning if is_warning else st.info
    draw(sentence)


def are_shown() -> bool:
    """Return whether the page shows a message that would disappear in the next run."""
    return bool(st.session_state.get(_ABOUT_ADDRESS) or st.session_state.get(_SHOWN))


def keep_in_next_run() -> None:
    """Keep the messages during the next run, because it does not follow an action of the visitor."""
    st.session_state[_REPEAT] = True


def run_again() -> None:
    """Run the page again to show new data; the messages stay."""
    keep_in_next_run()
    st.rerun()


def show_how_much_is_translated() -> None:
    """Draw one line about the untranslated part of a page, unless its language is complete."""
    if TRANSLATED < 100 and LANGUAGE not in COMPLETE:
        st.caption(_("{percentage} % of this app is translated. The rest is in English.").format(percentage=TRANSLATED))
