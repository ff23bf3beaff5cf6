"""The door of a class: the controls to open a class or to join one."""

import time

import streamlit as st

from ramanujan.classroom.codes import LONGEST
from ramanujan.classroom.rules import LIFETIME
from ramanujan.pages.classroom import shared_elements
from ramanujan.pages.classroom.desk import ENDED, draw_error
from ramanujan.shell import address, class_keys, class_session, progress
from ramanujan.shell.class_session import lecturer_key, open_class, run_or_refuse, student_seat
from ramanujan.text.translation import _


def draw_door() -> None:
    """Draw the controls to open or to join a class; draw nothing in a class."""
    if lecturer_key() or student_seat():
        return
    if class_session.needs_own_tab():
        code = address.current(class_keys.CLASS)
        url = address.link({"class": code} if code else {})
        st.link_button(_("Open the class in a tab of its own"), url.geturl(), icon=":material/groups:")
        return
    with st.popover(_("Class"), icon=":material/groups:", key="class_door"):
        with st.form("class_join", border=False):
            code = st.text_input(
                _("Students: type the code of your class."),
                max_chars=LONGEST,
                key="class_code",
                autocomplete="off",
            )
            if st.form_submit_button(_("Join"), type="primary"):
                run_or_refuse(class_session.take_seat, code)
                st.rerun()
        # The open popover covers the page, so show the result of a typed code in it.
        if code:
            draw_error()
        _explain_class()
    if not code:
        draw_error()
    if st.session_state.get(ENDED) and address.current(progress.STOP) == progress.STOP.default:
        st.success(_("The class has ended, and its answers are deleted."))
    else:
        st.session_state.pop(ENDED, None)


def _explain_class() -> None:
    """Explain how a class works, with a button that opens one."""
    st.markdown(_("Lecturers: three screens play together."))
    screens = (
        (":material/co_present:", _("**The wall.** The projector shows the code, then the questions and results.")),
        (":material/smartphone:", _("**The phones.** Students scan the code and vote. No names are asked.")),
        (":material/laptop_mac:", _("**The desk.** You ask, show the result, run the machine, name the answer.")),
    )
    with st.container(key="class_screens"):
        for icon, sentence in screens:
            st.markdown(f"{icon} {sentence}")
    st.button(_("Open a class"), key="class_open", type="primary", on_click=run_or_refuse, args=(open_class,))
    st.caption(shared_elements.storage_sentence(time.time() + LIFETIME))
    shared_elements.warn_of_local_address()
