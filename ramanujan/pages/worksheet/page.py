"""A printable worksheet: questions about the current machine with space to write, or the answer key."""

from collections.abc import Sequence
from itertools import groupby

import streamlit as st

from ramanujan import Oscillator
from ramanujan.browser.containers import container
from ramanujan.classroom.codes import ALPHABET, format_code
from ramanujan.figures.still_machine import draw_svg
from ramanujan.lesson.worksheet import WorksheetQuestion, make_questions, set_in_a_row
from ramanujan.pages.worksheet import keys
from ramanujan.pages.worksheet.keys import KEY, SEED
from ramanujan.shell import address, drawings, messages, sidebar, theme, widgets
from ramanujan.shell.display_mode import is_projector, slide
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.shell.sections import exercise
from ramanujan.text.numerals import filled
from ramanujan.text.translation import _, ngettext

# TRANSLATORS: a worksheet, and the right answers to it.
PAPER = address.Choice("paper", {"questions": _("Questions"), "key": _("Key")}, "questions")
# TRANSLATORS: kinds of worksheets, the first with most of the derivation printed.
LEVEL_WORDS = {1: _("Derivation with few blanks"), 2: _("With many blanks"), 3: _("On a blank page")}
LEVEL = address.Choice("level", LEVEL_WORDS, 1)
URL_PARAMETERS = (PAPER, SEED, LEVEL, KEY)
# A line to write on, as HTML.
_LINE = "<span style='flex:1;border-bottom:1px solid'></span>"


def show() -> None:
    """Draw the page. A worksheet is for paper, so a projector shows only the choices and the machine."""
    if is_projector():
        with slide("choices", _("Worksheet")):
            st.title(_("Worksheet"), anchor=False)
            _paper, seed, level = draw_options()
            st.markdown(_("A worksheet is for paper. Turn off *Projector* to read and print it."))
            draw_model(sidebar.oscillator(), list_calculations(make_questions(sidebar.oscillator(), seed, level)))
        return
    both = st.container(key="worksheet_columns")
    with both.container(key="worksheet_tools"):
        paper, seed, level = draw_options()
        exercise.draw_composer()
    machine = sidebar.oscillator()
    questions = make_questions(machine, seed, level)
    with both.container(key="worksheet", border=True):
        draw_head(machine, paper, seed, list_calculations(questions), sum(question.points for question in questions))
        for title, numbered in groupby(enumerate(questions, start=1), lambda pair: part_title(pair[1])):
            st.header(title, anchor=False)
            for number, question in numbered:
                draw_question(number, question, paper == "key")


def list_calculations(questions: Sequence[WorksheetQuestion]) -> list[int]:
    """Return the numbers of the questions that are calculations."""
    return [number for number, question in enumerate(questions, start=1) if question.working]


def part_title(question: WorksheetQuestion) -> str:
    """Return the title of the part of the worksheet that contains a question."""
    # TRANSLATORS: the titles of the three parts of a worksheet.
    if question.options:
        return _("Predict")
    return _("Calculate") if question.working else _("Derive")


def question_parts(question: WorksheetQuestion, with_key: bool) -> tuple[str, ...]:
    """Return the parts of a question as Markdown."""
    options = "\n".join(f"- {option}" for option in question.options)
    if not with_key:
        return question.text, options, question.blanks
    return question.text, options, set_in_a_row(question.working), question.answer


def uses_sidebar() -> bool:
    """Return False: the sidebar starts closed, because the page has its own options."""
    return False


def draw_options() -> tuple[str, str, int]:
    """Draw the options, which are not printed, and return paper, name and level.

    If the address contains the answer key, the reader can choose between questions and answers.
    """
    with st.container(horizontal=True, vertical_alignment="bottom", key="worksheet_choices"):
        has_key = keys.has_key()
        paper = "questions"
        if has_key:
            paper = widgets.segmented_control(PAPER, _("Worksheet"), label_visibility="collapsed")
        draw_name_box()
        level = widgets.selectbox(LEVEL, _("Guidance"), width=280)
        st.button(_("New worksheet with its key"), width="stretch", on_click=make_worksheet)
        if not is_projector():
            st.caption(
                _("Another name makes another worksheet. Print this page with Ctrl+P or Cmd+P, on A4 or Letter.")
            )
        if has_key:
            st.caption(
                _("The address of this page contains the key. Save it for yourself: *Copy link* leaves the key out.")
            )
    return paper, address.update(SEED), level


def draw_name_box() -> None:
    """Draw the box for the name of a worksheet. A reader copies this name from paper."""

    def store_name() -> None:
        name = keys.read_name(st.session_state["worksheet_name"])
        if name:
            st.session_state[SEED.name] = name
        else:
            sentence = _("A worksheet’s name has {n} letters, all from {letters}. The old name was kept.")
            messages.note(SEED.name, filled(sentence, n=keys.LETTERS, letters=ALPHABET), is_warning=True)

    st.session_state["worksheet_name"] = format_code(address.current(SEED))
    st.text_input(
        _("Name of the worksheet"),
        key="worksheet_name",
        max_chars=40,
        width=230,
        on_change=store_name,
        autocomplete="off",
    )
    messages.show_note(SEED.name)


def make_worksheet() -> None:
    """Callback: create a new key and its worksheet."""
    key = keys.new()
    st.session_state.update({KEY.name: key, SEED.name: keys.name(key)})


def draw_head(machine: Oscillator, paper: str, seed: str, calculation_numbers: list[int], points: int) -> None:
    """Draw the title, the machine of the calculations, and the name of the worksheet.

    Parameters
    ----------
    machine : the machine whose values the calculations use
    paper : the kind of sheet, "questions" or "key"
    seed : name of the worksheet
    calculation_numbers : the numbers of the questions that are calculations
    points : sum of the points of all questions
    """
    title = _("Ramanujan’s oscillator: key") if paper == "key" else _("Ramanujan’s oscillator: worksheet")
    st.title(title, anchor=False)
    if paper == "questions":
        lines = _("Name {line} Date {line} Points {line} of {points}")
        st.html(f"<p class='name' style='display:flex;gap:.4em'>{lines.format(line=_LINE, points=points)}</p>")
    draw_model(machine, calculation_numbers)
    name = _("Name of this worksheet: {name}. Type it on the page Worksheet to open it again.")
    st.caption(name.format(name=format_code(seed)))


def draw_model(machine: Oscillator, calculation_numbers: list[int]) -> None:
    """Draw the machine of the calculations, and what the questions assume."""
    values = ", ".join(parameter.equation(parameter.value) for parameter in PARAMETERS.values())
    head = st.container(key="worksheet_head")
    with head.container(key="worksheet_picture"):
        drawings.draw(
            draw_svg(machine, sidebar.compression(), theme.paper_colors()),
            alt=_("The machine, drawn to scale: block, hoop, lower cylinder, slab, spring and top cylinder."),
            style="width:100%",
        )
        st.markdown(
            _("The machine of questions {first} to {last}: {values}.").format(
                first=calculation_numbers[0], last=calculation_numbers[-1], values=values
            )
        )
    head.markdown(
        _(
            "Model: the bodies are rigid and the spring is ideal. The three rollers roll without slipping, and the "
            "floor has no friction. The machine oscillates with one angular frequency, Ω. The mass ratio is "
            "$\\varepsilon=m'/m$. “Plain mass” means a mass m that oscillates on an equal spring, with the angular "
            "frequency {frequency}. The block is displaced by X to the left. The lower rollers turn clockwise by φ, "
            "the top cylinder by Φ."
        ).format(frequency="$\\sqrt{k/m}$")
    )


def draw_question(number: int, question: WorksheetQuestion, with_key: bool) -> None:
    """Draw a question with lines to write on, or with its answer."""
    with container("question", str(number)):
        points = ngettext("({n} point)", "({n} points)", question.points).format(n=question.points)
        parts = "\n\n".join(filter(None, question_parts(question, with_key)))
        st.markdown(f"**{number}.** {points} {parts}")
        if not with_key:
            # TRANSLATORS: before the lines on which a student says why an option is right.
            texts = [_("Because") if question.options else "", *[""] * (question.space - 1)]
            style = "border-bottom:1px dotted #888;height:9mm;align-content:end"
            lines = "".join(f"<div style='{style}'>{text}</div>" for text in texts)
            st.html(f"<div class='room'>{lines}</div>")


if __name__ == "__main__":
    show()
