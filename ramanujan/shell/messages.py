"""Messages about a person’s input: on the page about its address, at a slider about its box."""

import streamlit as st

from ramanujan.catalogue import COMPLETE
from ramanujan.translation import LANGUAGE, TRANSLATED, _

_ABOUT_ADDRESS = "messages_address"
_NOTES = "messages_notes"
"""Session state: key of a parameter → the message at its box in the next run, and whether it is a warning."""
_SHOWN = "messages_shown"
_RUN_AGAIN = "run_again"


def begin(sentences: list[str]) -> None:
    """Begin a run: say what is wrong with the address. A run that the page asked for itself repeats what was said."""
    again = st.session_state.pop(_RUN_AGAIN, False)
    said = [*(st.session_state.get(_ABOUT_ADDRESS, []) if again else []), *sentences]
    shown = st.session_state.get(_SHOWN, {}) if again else {}
    st.session_state[_SHOWN] = shown | st.session_state.pop(_NOTES, {})
    st.session_state[_ABOUT_ADDRESS] = said
    # On the page itself, since the sidebar of a phone is closed at first.
    if said:
        st.warning(" ".join(said))


def warn(sentence: str) -> None:
    """Say on the page what it cannot use of its address."""
    st.warning(sentence)
    st.session_state[_ABOUT_ADDRESS] = [*st.session_state.get(_ABOUT_ADDRESS, []), sentence]


def note(key: str, sentence: str, warning: bool = False) -> None:
    """Say a sentence at the box of a parameter; where the box is drawn already, in the run that follows."""
    st.session_state[_NOTES] = {**st.session_state.get(_NOTES, {}), key: (sentence, warning)}


def show_note(key: str) -> None:
    """Draw the message at the box of a parameter."""
    if found := st.session_state.get(_SHOWN, {}).get(key):
        sentence, warning = found
        (st.warning if warning else st.info)(sentence)


def are_shown() -> bool:
    """Tell whether the page says anything to the person that its next run would not."""
    return bool(st.session_state.get(_ABOUT_ADDRESS) or st.session_state.get(_SHOWN))


def stay() -> None:
    """Keep the messages in the run that follows, which the page asks for itself."""
    st.session_state[_RUN_AGAIN] = True


def run_again() -> None:
    """Run the page again to show what has come in; the messages stay."""
    stay()
    st.rerun()


def runs_again() -> bool:
    """Tell whether this run was asked for by the page itself, so that no message of the browser belongs to it."""
    return bool(st.session_state.get(_RUN_AGAIN))


def show_how_much_is_translated() -> None:
    """Draw one line about the English rest of a page, unless its language is complete."""
    if TRANSLATED < 100 and LANGUAGE not in COMPLETE:
        st.caption(_("{percentage} % of this app is translated. The rest is in English.").format(percentage=TRANSLATED))
