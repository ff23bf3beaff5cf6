"""The section of page 2 in which a student types a formula and is told whether it is right."""

from __future__ import annotations

import string

import streamlit as st

from ramanujan.answers import QUESTIONS
from ramanujan.answers.grammar import MAX_LENGTH
from ramanujan.pages.derivation import cache
from ramanujan.shell import address, widgets
from ramanujan.translation import _

QUESTION = address.Choice("question", tuple(QUESTIONS), next(iter(QUESTIONS)))
VERDICTS = {
    "right": (st.success, ":material/check_circle:"),
    "unsimplified": (st.info, ":material/compress:"),
    "wrong": (st.warning, ":material/lightbulb:"),
    "unreadable": (st.error, ":material/help:"),
}


def try_it() -> None:
    """Ask for a formula, and say whether it is right or what is missing."""
    st.header(_("Try it yourself"), anchor=False)
    asked = cache.questions()
    titles = {name: question.quantity[:1].upper() + question.quantity[1:] for name, question in asked.items()}
    key = widgets.menu(QUESTION, _("What do you want to work out?"), titles)
    question = asked[key]
    st.markdown(question.prompt)
    if question.names:
        names = " ".join(f"`{name}`" for name in question.names)
        st.markdown(_(":small[You may use] {names}").format(names=names))
    with st.form("answer", border=False):
        text = st.text_input(
            _("Your formula"),
            key=f"answer_{key}",
            placeholder=_("For example {formula}").format(formula=question.example),
            max_chars=2 * MAX_LENGTH,
        )
        st.form_submit_button(_("Check"), type="primary")
    if text:
        verdict, read = cache.verdict(key, text), cache.as_read(text)
        box, icon = VERDICTS[verdict.kind]
        if read:
            st.latex(read)
        box(plain(verdict.message), icon=icon)
    with st.spinner(_("Deriving the answer …"), show_time=False):
        cache.prepare(key)


def plain(text: str) -> str:
    """Return text such that Markdown shows it as it is."""
    return "".join(f"\\{character}" if character in string.punctuation else character for character in text)
