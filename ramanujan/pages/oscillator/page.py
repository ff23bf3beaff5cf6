"""Page 1: the machine in motion, its frequency on the curve, and the derivation in six steps."""

import math
import re
from collections.abc import Sequence

import streamlit as st

from ramanujan import Oscillator
from ramanujan.browser import stage
from ramanujan.browser.components import pick
from ramanujan.browser.components import story as story_button
from ramanujan.browser.containers import container
from ramanujan.derivation.numbers import Numbers, state_numbers
from ramanujan.derivation.rows import Row, align, align_for_phone
from ramanujan.figures.oscillator_page import NEAR_MARK
from ramanujan.pages.oscillator import cache, shared_with_file, story
from ramanujan.shell import display_mode, drawings, first_run, menu, sidebar, stages, theme, widgets
from ramanujan.shell.display_mode import slide
from ramanujan.shell.sections import cubes
from ramanujan.text.numerals import filled, number
from ramanujan.text.translation import _

# Two squared frequencies with a smaller relative difference are considered equal.
_ROUNDING_ERROR = 1e-12

# Keys of the parameters with a slider above the machine.
SLIDERS = ("m_prime", "m", "k")


def warm_up() -> None:
    """Fill the caches that the first visitor would wait for."""
    cache.curve()
    cache.summary(Numbers(1.0, 1.0, 1.0))


def draw_header() -> bool:
    """Draw the machine and its controls, and return True. On a projector, the first slide has only the slider of m′."""
    if display_mode.is_projector():
        with slide("machine", _("The machine")):
            draw_composition()
        sidebar.draw((), menu.PAGES["oscillator"].folded_parameters, placed=SLIDERS[:1])
        return True
    draw_composition()
    if not first_run.draws_only_machine():
        sidebar.draw_more(sidebar.PRESETS, ("compression", "radius"))
        sidebar.end()
    return True


def show() -> None:
    """Draw the page."""
    publish_machine()
    if first_run.draws_only_machine():
        # Reserve the height of the other elements: a scroll bar that appears later would move the machine.
        st.container(height=5000, border=False)
        return
    if not display_mode.hides("curve"):
        pick.mount("curve", set_clicked_ratio)
        with slide("curve", _("The curve")):
            draw_curve()
    if display_mode.hides("steps"):
        sidebar.set_dependent_fragments(*dependent_fragments())
    else:
        draw_derivation()


def dependent_fragments() -> list[str]:
    """Return the keys of the fragments above the six steps that depend on the machine."""
    return ["machine", "present"] if shows_numbers() else ["machine"]


def shows_numbers() -> bool:
    """Return whether the numbers are below the curve. In the projector view they are next to the machine."""
    return not (display_mode.hides("curve", "numbers") or display_mode.is_projector())


@st.fragment(key="machine")
def publish_machine() -> None:
    """Publish the machine to the stage and the boxes of the sliders."""
    machine = stage.payload(sidebar.oscillator(), sidebar.compression())
    stages.publish(machine, name="oscillator", more=sidebar.collect_box_messages())


def draw_derivation() -> None:
    """Draw the short derivation, and the link to the full one. They share one slide of the projector view."""
    with slide("steps", shared_with_file.STEPS_HEADING):
        st.header(shared_with_file.STEPS_HEADING, anchor=False)
        six_steps = st.container(key="six_steps")
        page = menu.PAGES["derivation"]
        # Draw the link first, because the steps take longer.
        st.page_link(page.file, label=_("The whole derivation, in many ways"), icon=f":material/{page.icon}:")
        with six_steps:
            if display_mode.is_projector():
                draw_results()
            else:
                draw_six_steps()


def draw_composition() -> None:
    """Draw the opening and the machine."""
    with st.container(key="composition"):
        draw_opening()
        stages.mount(None, name="oscillator", layers=())
        if not (first_run.draws_only_machine() or display_mode.hides("clocks", "numbers")):
            draw_reason()


def draw_reason() -> None:
    """Draw why the ratio in step is remarkable. The style sheet shows it while the hands are locked."""
    with st.container(key="why"):
        st.markdown(cubes.reason())
        if not display_mode.is_projector():
            page = menu.PAGES["taxicab"]
            st.page_link(page.file, label=_("Why it appears in a machine → 1729"), width="content")
        cubes.draw_stacks(with_values=False)


def draw_opening() -> None:
    """Draw the question, the button of the story and the sliders; on a reader's screen also the link to the lesson."""
    st.title(_("Ramanujan’s oscillator"), anchor=False)
    has_clocks = not display_mode.hides("clocks", "numbers")
    question = _("**When does this machine of five bodies oscillate in step with a plain mass on the same spring?**")
    if has_clocks:
        question = shared_with_file.question()
    st.markdown(question)
    if has_clocks:
        draw_story_button()
    if not display_mode.is_projector():
        with st.container(key="to_lesson"):
            draw_lesson_link()
    if first_run.draws_only_machine():
        reserve_places()
        return
    for key in SLIDERS[:1] if display_mode.is_projector() else SLIDERS:
        sidebar.draw_slider(key)


def draw_story_button() -> None:
    """Draw the button of the story. In the first run, only reserve its place."""
    if first_run.draws_only_machine():
        st.container(key="place_of_story").empty()
    else:
        story_button.mount(story.collect_data())


def reserve_places() -> None:
    """Reserve the places of the sliders, which come with the second run.

    The number of elements is that of the second run. Otherwise Streamlit would remove the machine and draw it again.
    """
    st.container(key="place_of_sliders").empty()
    for _number in range(2 * len(SLIDERS) - 1):
        st.empty()


def draw_lesson_link() -> None:
    """Draw the link to the lesson. In the first run, only reserve its place."""
    if first_run.draws_only_machine():
        st.empty()
        return
    st.page_link(menu.PAGES["lesson"].file, label=_("New to this? Take the lesson"), width="content")


def draw_curve() -> None:
    """Draw the Ω² curve with a ring at the current machine."""
    curve = cache.curve()
    st.header(shared_with_file.CURVE_HEADING, anchor=False)
    text, figure = display_mode.columns("curve")
    with text:
        st.markdown(shared_with_file.CURVE_TEXT)
        with container("click", "curve"):
            st.caption(shared_with_file.CURVE_HINT)
        if not display_mode.is_projector():
            stage.mount_small("stage_beside_curve", follows="oscillator", limits=stages.LIMITS)
        if shows_numbers():
            describe_machine()
    with figure:
        # The ring shows the current machine, so the figure is sent to a page only once.
        alternative = shared_with_file.curve_alternative(curve)
        drawings.plot(cache.figure(theme.current()), "curve", alternative)


@st.fragment(key="present")
def describe_machine() -> None:
    """Describe the position of the current machine on the curve, and compare it with the plain mass."""
    machine = sidebar.oscillator()
    sentence = _(
        "**Your machine**: ε\u00a0=\u00a0{ratio}, Ω²m/k\u00a0=\u00a0{normalized:7}, Ω\u00a0=\u00a0{omega:5 rad/s}, "
        "period {period:4 s}."
    )
    numbers = filled(
        sentence,
        ratio=number(machine.mass_ratio, 5, strip=True),
        normalized=machine.normalized_frequency_squared,
        omega=machine.natural_frequency,
        period=machine.period,
    )
    with st.container(key="your_machine"):
        st.markdown(numbers if display_mode.hides("clocks") else f"{numbers} {compare_with_plain_mass(machine)}")


def compare_with_plain_mass(machine: Oscillator) -> str:
    """Compare a machine with the plain mass: in step, faster or slower. How much is below the clock."""
    difference = machine.normalized_frequency_squared - 1
    if abs(difference) < _ROUNDING_ERROR:
        return _("It is in step with the plain mass.")
    return _("It is faster than the plain mass.") if difference > 0 else _("It is slower than the plain mass.")


def set_clicked_ratio(point: dict[str, float]) -> None:
    """Callback: set the mass ratio of the clicked point, exact near a mark, elsewhere with three significant digits."""
    curve = cache.curve()
    for mark in (curve.equal, curve.unit):
        if math.isclose(point["x"], mark.ratio, rel_tol=NEAR_MARK):
            sidebar.request_ratio(mark.ratio)
            return
    sidebar.request_ratio(point["x"], 3)


def draw_results() -> None:
    """Draw the headings of the six steps and their results on a slide."""
    sidebar.set_dependent_fragments(*dependent_fragments())
    rows = [(_("Step"), _("Result"))]
    for n, step in enumerate(cache.summary(None), start=1):
        # Break a line before a sign. KaTeX would break it after the sign.
        results = re.sub(r" ([+-]) ", r" \\allowbreak\1\\nobreak ", join_results(step))
        rows.append((f"**{n}. {step.heading}**", results))
    widgets.table(rows, "six_steps")


def join_results(step: cache.SummaryStep) -> str:
    """Return the results of a step in one line of Markdown."""
    return " ".join(f"${result}$" for result in step.results).replace(r"\frac", r"\dfrac")


@st.fragment(key="six_steps")
def draw_six_steps() -> None:
    """Draw the short derivation with an expander for each step."""
    machine = sidebar.oscillator()
    numbers = None if display_mode.hides("numbers") else Numbers.of(machine)
    # The sliders rerun this fragment only while it shows numbers.
    shows_steps = False
    for n, step in enumerate(cache.summary(numbers), start=1):
        label = f"**{n}. {step.heading}** *{step.idea}* {join_results(step)}"
        line = st.expander(label, key=f"summary_{n}", type="compact", on_change="rerun")
        if line.open:
            shows_steps = True
            with line:
                draw_step(n, step, numbers)
    fragments = dependent_fragments()
    if shows_steps:
        fragments.append("six_steps")
    sidebar.set_dependent_fragments(*fragments)


def draw_step(n: int, step: cache.SummaryStep, numbers: Numbers | None) -> None:
    """Explain line n of the short derivation, with its results for the current machine."""
    for index, detail in enumerate(step.steps):
        st.markdown(detail.reason)
        draw_equations(f"{n}_{index}", detail.details)
    if numbers and step.numbers:
        heading = _("Your machine")
        st.markdown(f"### {heading}\n{state_numbers(numbers)}")
        draw_equations(f"{n}_numbers", step.numbers)


def draw_equations(key: str, rows: Sequence[Row]) -> None:
    """Draw equations aligned at their equals signs, if there are any."""
    if rows:
        widgets.equations(key, align(rows, cache.LINE_WIDTH), align_for_phone(rows))


if __name__ == "__main__":
    show()
