"""A printable worksheet: questions about the current machine with space to write, or the answer key."""

from collections.abc import Iterable, Iterator
from contextlib import nullcontext

import streamlit as st

from ramanujan import Oscillator
from ramanujan.browser.roles import container
from ramanujan.lesson.class_codes import ALPHABET, format_code
from ramanujan.lesson.picture import draw_svg
from ramanujan.lesson.worksheet import WorksheetQuestion, make_questions, set_in_a_row
from ramanujan.numerals import filled
from ramanujan.shell import address, drawings, messages, sidebar, theme, widgets, worksheet_keys
from ramanujan.shell.display_mode import floated, is_projector, slide
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.shell.sections import exercise
from ramanujan.translation import _, ngettext

# TRANSLATORS: a worksheet, and the right answers to it.
PAPER = address.Choice("paper", {"questions": _("Questions"), "key": _("Key")}, "questions")
SEED = worksheet_keys.name_parameter("seed", default="BCDFHJKLMN")
KEY = worksheet_keys.key_parameter("key")
# TRANSLATORS: kinds of worksheets, the first with most of the derivation printed.
LEVEL_WORDS = {1: _("Derivation with few blanks"), 2: _("With many blanks"), 3: _("On a blank page")}
LEVEL = address.Choice("level", LEVEL_WORDS, 1)
URL_PARAMETERS = (PAPER, SEED, LEVEL, KEY)
_LINES_PER_SLIDE = {"questions": 15, "key": 11}
# Number of characters in a line of a slide: of text, and of LaTeX for formulas in a row.
_TEXT_WIDTH, _FORMULA_WIDTH = 105, 330
# A line to write on, as HTML.
_LINE = "<span style='flex:1;border-bottom:1px solid'></span>"


def show() -> None:
    """Draw the page."""
    machine = sidebar.oscillator()
    first_slide = slide("machine", _("The machine"))
    with first_slide, st.container(key="worksheet_tools"):
        paper, seed, level = draw_options()
        if not is_projector():
            exercise.draw_composer()
    numbered = make_questions(machine, seed, level)
    calculation_numbers = [number for number, question in enumerate(numbered, start=1) if question.working]
    with nullcontext() if is_projector() else st.container(key="worksheet", border=True):
        with first_slide:
            draw_head(machine, paper, seed, calculation_numbers, sum(question.points for question in numbered))
        first = 1
        for group in slides_of(numbered, paper == "key"):
            last = first + len(group) - 1
            title = _("Question {first}") if first == last else _("Questions {first} to {last}")
            with slide(f"question_{first}", title.format(first=first, last=last)):
                for number, question in enumerate(group, start=first):
                    draw_question(number, question, paper == "key")
            first = last + 1


def slides_of(questions: Iterable[WorksheetQuestion], with_key: bool) -> Iterator[list[WorksheetQuestion]]:
    """Yield groups of successive questions that fit on one slide."""
    room = _LINES_PER_SLIDE["key" if with_key else "questions"]
    group: list[WorksheetQuestion] = []
    used = 0.0
    for question in questions:
        height = height_of(question, with_key)
        if group and used + height > room:
            yield group
            group, used = [], 0.0
        group.append(question)
        used += height
    yield group


def height_of(question: WorksheetQuestion, with_key: bool) -> float:
    """Return the estimated height of a question on a slide [lines of text]."""
    height = 0.0
    for part in question_parts(question, with_key):
        for line in part.splitlines():
            if "$$" in line:
                height += 1.5 * (1 + len(line) // _FORMULA_WIDTH)
            elif line:
                height += 1 + len(line) // _TEXT_WIDTH
    return height


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
        has_key = worksheet_keys.fits(KEY, address.current(SEED))
        paper = "questions"
        if has_key:
            paper = widgets.segmented_control(PAPER, _("Worksheet"), label_visibility="collapsed")
        draw_name_box()
        level = widgets.selectbox(LEVEL, _("Guidance"), width=280)
        if not is_projector():
            st.button(_("New worksheet with its key"), width="stretch", on_click=make_worksheet)
        if not is_projector():
            st.caption(
                _("Another name makes another worksheet. Print this page with Ctrl+P or Cmd+P, on A4 or Letter.")
            )
        if has_key and not is_projector():
            st.caption(
                _("The address of this page contains the key. Save it for yourself: *Copy link* leaves the key out.")
            )
    return paper, address.update(SEED), level


def draw_name_box() -> None:
    """Draw the box for the name of a worksheet. A reader copies this name from paper."""

    def store_name() -> None:
        name = worksheet_keys.read_name(st.session_state["worksheet_name"])
        if name:
            st.session_state[SEED.name] = name
        else:
            sentence = _("A worksheet’s name has {n:word} letters, all from {letters}. The old name was kept.")
            messages.note(SEED.name, filled(sentence, n=worksheet_keys.LETTERS, letters=ALPHABET), is_warning=True)

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
    key = worksheet_keys.new()
    st.session_state.update({KEY.name: key, SEED.name: worksheet_keys.name(key)})


def draw_head(machine: Oscillator, paper: str, seed: str, calculation_numbers: list[int], points: int) -> None:
    """Draw the title with the name of the worksheet, and the machine of the calculations.

    Parameters
    ----------
    machine : the machine whose values the calculations use
    paper : the kind of sheet, "questions" or "key"
    seed : name of the worksheet
    calculation_numbers : the numbers of the questions that are calculations
    points : sum of the points of all questions
    """
    title = _("Ramanujan’s oscillator: key {seed}") if paper == "key" else _("Ramanujan’s oscillator: worksheet {seed}")
    st.title(title.format(seed=format_code(seed)), anchor=False)
    if paper == "questions" and not is_projector():
        lines = _("Name {line} Date {line} Points {line} of {points}")
        st.html(f"<p class='name' style='display:flex;gap:.4em'>{lines.format(line=_LINE, points=points)}</p>")
    picture, words = floated("model")
    values = ", ".join(parameter.equation(parameter.value) for parameter in PARAMETERS.values())
    with picture, st.container(key="worksheet_picture"):
        drawings.draw(
            draw_svg(machine, sidebar.compression(), theme.paper_colors()),
            alt=_("The machine, drawn to scale: block, hoop, lower cylinder, slab, spring and top cylinder."),
            style=f"width:{'100%' if is_projector() else '35rem'};max-width:100%",
        )
    sentences = [
        _(
            "Model: the bodies are rigid and the spring is ideal. The three rollers roll without slipping, and the "
            "floor has no friction. The machine oscillates with one angular frequency, Ω. The mass ratio is "
            "$\\varepsilon=m'/m$. “Plain mass” means a mass m that oscillates on an equal spring, with the angular "
            "frequency {frequency}. The block is displaced by X to the left. The lower rollers turn clockwise by φ, "
            "the top cylinder by Φ."
        ).format(frequency="$\\sqrt{k/m}$"),
        _("The machine of questions {first} to {last}: {values}.").format(
            first=calculation_numbers[0], last=calculation_numbers[-1], values=values
        ),
    ]
    with words:
        st.markdown("\n\n".join(sentences))


def draw_question(number: int, question: WorksheetQuestion, with_key: bool) -> None:
    """Draw a question with lines to write on, or with its answer. A page break may come only between these lines."""
    with container("question", str(number)):
        points = ngettext("({n} point)", "({n} points)", question.points).format(n=question.points)
        begin = f"**{number}.** " if is_projector() else f"**{number}.** {points} "
        st.markdown(begin + "\n\n".join(filter(None, question_parts(question, with_key))))
        if not (with_key or is_projector()):
            lines = "<div style='border-bottom:1px dotted #888;height:1cm'></div>" * question.space
            st.html(f"<div class='room'>{lines}</div>")


if __name__ == "__main__":
    show()
