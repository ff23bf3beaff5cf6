"""A sheet to hand out: questions about the present machine with space to write, or the key; the browser prints it."""

from __future__ import annotations

import streamlit as st

from ramanujan import Oscillator
from ramanujan.lesson.picture import machine_svg
from ramanujan.lesson.worksheet import Question, questions
from ramanujan.shell import address, drawings, sidebar, widgets
from ramanujan.shell.parameters import QUANTITIES
from ramanujan.translation import _

PAPER = address.Choice("paper", ("questions", "key"), "questions")
SEED = address.Count("seed", 9999)
KEYS = (PAPER, SEED)
PAPER_WORDS = {"questions": _("Questions"), "key": _("Key")}


def show() -> None:
    """Draw the page."""
    machine = sidebar.oscillator()
    paper, seed = choose()
    asked = questions(machine, str(seed))
    calculations = [number for number, question in enumerate(asked, start=1) if not question.options]
    head(machine, paper, seed, calculations)
    for number, question in enumerate(asked, start=1):
        draw(number, question, paper == "key")


def choose() -> tuple[str, int]:
    """Draw the choice between questions and key, and the seed; none of it is printed."""
    with st.container(horizontal=True, vertical_alignment="bottom", key="sheet_choices"):
        paper = widgets.chips(PAPER, _("Sheet"), PAPER_WORDS, label_visibility="collapsed")
        seed = widgets.count(SEED, _("Seed"), width=150)
        st.caption(_("Another seed makes another sheet. Print this page with Ctrl+P or ⌘P, on A4 or Letter."))
    return paper, seed


def head(machine: Oscillator, paper: str, seed: int, calculations: list[int]) -> None:
    """Draw the title with the seed, by which sheet and key find each other, and the machine of the calculations."""
    titles = {
        "questions": _("Ramanujan’s oscillator: worksheet {seed}"),
        "key": _("Ramanujan’s oscillator: key {seed}"),
    }
    st.title(titles[paper].format(seed=seed), anchor=False)
    values = ", ".join(f"{each.symbol} = {each.written(each.present)}" for each in QUANTITIES.values())
    with st.container(key="sheet_picture"):
        drawings.draw(
            machine_svg(machine, sidebar.compression()),
            alt=_("The machine, drawn to scale: block, hoop, lower cylinder, slab, spring and top cylinder."),
            style="width:560px;max-width:100%;background:#fff",
        )
    st.markdown(
        _("The machine of questions {first} to {last}: {values}.").format(
            first=calculations[0], last=calculations[-1], values=values
        )
    )


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


if __name__ == "__main__":
    show()
