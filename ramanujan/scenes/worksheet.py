"""A sheet to hand out: questions about the present machine with space to write, or the key; the browser prints it."""

from __future__ import annotations

import streamlit as st

from ramanujan.lesson.picture import machine_svg
from ramanujan.lesson.worksheet import Question, questions
from ramanujan.scenes import controls, links
from ramanujan.words import _

SHEETS = {"questions": _("Questions"), "key": _("Key")}
LONGEST = 20


def choose() -> tuple[str, str]:
    """Draw the choice between questions and key, and the seed; none of it is printed."""
    with st.container(horizontal=True, vertical_alignment="bottom", key="sheet_choices"):
        asked = st.query_params.get("paper")
        st.session_state["paper_choice"] = asked if asked in SHEETS else "questions"
        sheet = st.segmented_control(
            _("Sheet"),
            list(SHEETS),
            format_func=SHEETS.get,
            required=True,
            key="paper_choice",
            label_visibility="collapsed",
            on_change=lambda: st.query_params.update(paper=st.session_state["paper_choice"]),
        )
        seed = st.text_input(
            _("Seed"), "1", max_chars=LONGEST, key="seed", bind="query-params", width=180, autocomplete="off"
        )
        st.caption(_("Another seed makes another sheet. Print this page with Ctrl+P or ⌘P, on A4 or Letter."))
    return sheet, (seed or "1")[:LONGEST]


def head(sheet: str) -> None:
    """Draw the title, a line for the name, the machine and its values."""
    titles = {"questions": _("Ramanujan’s oscillator: worksheet"), "key": _("Ramanujan’s oscillator: key")}
    st.title(titles[sheet], anchor=False)
    values = ", ".join(
        f"{each.symbol} = {each.written(st.session_state.get(each.key, each.default))}"
        for each in controls.CONTROLS.values()
    )
    with st.container(key="sheet_picture"):
        st.image(machine_svg(machine, controls.compression()), width=560)
    st.markdown(_("The machine: {values}.").format(values=values))


def draw(number: int, question: Question, with_key: bool) -> None:
    """Draw a question with room to write, or with its answer; it is not cut by the end of a page."""
    options = "".join(f"\n- {option}" for option in question.options)
    with st.container(key=f"question_{number}"):
        st.markdown(f"**{number}.** {question.text}\n{options}")
        if with_key:
            st.markdown(question.answer)
        else:
            lines = "<div style='border-bottom:1px dotted #888;height:1cm'></div>" * round(question.space)
            st.html(f"<div class='room'>{lines}</div>")


machine = controls.oscillator()
controls.complain(
    links.complaints(
        [
            links.one_of("paper", SHEETS),
            links.Key(
                "seed", lambda text: len(text) <= LONGEST, _("longer than {most} characters").format(most=LONGEST)
            ),
        ]
    )
)
sheet, seed = choose()
head(sheet)
for number, question in enumerate(questions(machine, seed), start=1):
    draw(number, question, sheet == "key")
