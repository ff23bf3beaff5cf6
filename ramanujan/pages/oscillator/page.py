"""Page 1: the machine in motion, its frequency on the curve, and the derivation in six steps."""

import math
from collections.abc import Collection
from dataclasses import asdict

import streamlit as st

from ramanujan import UNIT_MASS_RATIO
from ramanujan.browser import page, stage
from ramanujan.derivation.numbers import Numbers
from ramanujan.numerals import number
from ramanujan.pages.oscillator import cache, story
from ramanujan.pages.oscillator.story import gained
from ramanujan.shell import address, display_mode, drawings, navigation, sidebar, stages, theme
from ramanujan.shell.cache import numbers_stated
from ramanujan.shell.display_mode import sheet
from ramanujan.translation import _

FOUND = address.Choice("found", ("on",))
"""Whether the slider of m′ marks the ratio before it has been found."""
URL_PARAMETERS = (FOUND,)


def lead() -> Collection[str]:
    """Draw the opening with the slider that its question names, and return that slider's key."""
    if display_mode.is_projector():
        return ()
    with st.container(key="opening_words"):
        opening()
        with st.container(horizontal=True, vertical_alignment="center", gap="small", key="lead"):
            sidebar.slider("m_prime")
    return ("m_prime",)


def show() -> None:
    """Draw the page."""
    with sheet("machine", _("The machine")):
        if display_mode.is_projector():
            opening()
        stages.mount(None, name="oscillator")
    told()
    if stages.alone():
        # Room for what comes: with a scroll bar that comes later the machine would jump.
        st.container(height=5000, border=False)
        return
    if not display_mode.hides("curve"):
        page.pick("curve", take_clicked)
        with sheet("curve", _("The curve")):
            the_curve()
    if display_mode.hides("steps"):
        sidebar.follow("machine")
    else:
        the_steps()


@st.fragment(key="machine")
def told() -> None:
    """Tell the stage and the boxes what the sliders hold."""
    machine = stage.payload(sidebar.oscillator(), sidebar.compression())
    stages.tell(machine, name="oscillator", more=sidebar.followed())


def the_steps() -> None:
    """Draw the derivation in short, and the way to the whole."""
    if display_mode.is_projector():
        six_steps()
        return
    st.header(_("The derivation in six steps"), anchor=False)
    lines, derivation = st.container(key="steps"), navigation.PAGES["derivation"]
    st.page_link(derivation.file, label=_("The whole derivation, in many ways"), icon=f":material/{derivation.icon}:")
    with lines:
        six_steps()


def opening() -> None:
    """Say what this is, what it asks and what to do first; on a reader's screen also where to learn more."""
    st.title(_("Ramanujan’s oscillator"), anchor=False)
    question = _("When does this machine of five bodies oscillate in step with a plain mass on the same spring?")
    first = _("Drag the slab and let go.")
    if not display_mode.hides("clocks", "numbers"):
        question = _(
            "Two machines, one spring: with equal masses they are almost in step. Their hands part by one full turn in "
            "{periods} periods."
        ).format(periods=number(1 / float(gained(1.0)), 2))
        first = _("At which mass ratio do they stay together? Move m′ until both hands turn together.")
    with st.container(horizontal=True, gap="small", key="opening"):
        with st.container(gap=None):
            st.markdown(f"**{question}** {first}")
            if not display_mode.is_projector():
                with st.container(horizontal=True, vertical_alignment="center", gap="xsmall", key="to_lesson"):
                    to_lesson()
        # A projector's sheet has no height for it.
        if not (display_mode.hides("clocks", "numbers") or display_mode.is_projector()):
            tell_story()


def tell_story() -> None:
    """Offer the story that ends at the one mass ratio at which both hands turn together."""
    told = {
        "stories": [[asdict(scene) for scene in story.story(start)] for start in story.STARTS],
        "pace": story.PACE,
        "stills": story.stills(),
        "marked": address.keep(FOUND) == "on",
    }
    words = {
        "ratio": "ε = m′/m = {ratio}",
        "there": _("In step: ε = {exactly}. So {number}.").format(exactly=cache.unit_ratio(), number=cache.taxicab()),
        "mark": _("in step"),
        "begin": _("Bring them into step"),
        "again": _("Again"),
        "stop": _("Stop"),
        "stills": _(
            "Both hands start together. After {periods} periods of the plain mass they stand like this:"
        ).format(periods=story.STILL_PERIODS),
        "hint": _("Watch how the hands part as m′ changes, and where they stay together"),
    }
    page.story("oscillator", "m_prime", UNIT_MASS_RATIO, told, words)


def to_lesson() -> None:
    """Lead a newcomer to the lesson; while the machine stands alone, keep the room for it."""
    if stages.alone():
        st.empty()
        return
    st.markdown(_("New to this?"), width="content")
    st.page_link(navigation.PAGES["lesson"].file, label=_("Take the lesson"), width="content")


def the_curve() -> None:
    """Draw the curve of Ω² with a ring at the present machine."""
    base = cache.curve()
    st.header(_("When is it in step with the plain mass?"), anchor=False)
    st.markdown(
        _(
            "The plain mass m on the spring k has the angular frequency √(k/m), the machine has Ω. They are in "
            "step where Ω²m/k = 1. This depends only on the mass ratio ε = m′/m."
        )
    )
    # What changes with the machine is said by the ring: so the figure is sent to a page only once.
    sees = _(
        "Ω²m/k over the mass ratio ε, falling from {light} for light rollers towards {heavy} for heavy ones: heavier "
        "rollers make the machine slower. It is {equal} at equal masses, and exactly 1 at one ratio only."
    )
    sees = sees.format(light=base.light, heavy=base.heavy, equal=cache.equal_masses_value())
    drawings.plot(cache.figure(theme.current()), "curve", sees)
    with st.container(key="click_curve"):
        st.caption(_("Click on the curve to build the machine with that mass ratio."))


def take_clicked(point: dict[str, float]) -> None:
    """Take the mass ratio of the clicked point: exactly that of a mark if one lies there, else with round masses."""
    base = cache.curve()
    marks = (base.equal.ratio, base.unit.ratio)
    mark = next((mark for mark in marks if math.isclose(point["x"], mark, rel_tol=0.02)), None)
    if mark is None:
        sidebar.take_ratio(point["x"], digits=3)
    else:
        sidebar.take_ratio(mark)


@st.fragment(key="steps")
def six_steps() -> None:
    """Draw the derivation in short, a line for each step; one that is open has symbols and the present numbers."""
    machine = sidebar.oscillator()
    numbers = None if display_mode.hides("numbers") else Numbers.of(machine)
    steps = cache.summary(numbers)
    shown = display_mode.is_projector()
    if shown:
        on_sheets(steps)
    else:
        for number, step in enumerate(steps, start=1):
            heading, key = f"{number}. {step.heading}", f"summary_{number}"
            with st.expander(heading, key=key, type="compact", on_change="rerun") as line:
                if line.open:
                    shown = True
                    stated = f"\n\n:small[{numbers_stated(numbers)}]" if numbers else ""
                    st.markdown(f"{step.reason}\n\n$$\n{step.equations}\n$${stated}")
    sidebar.follow("machine", *(["steps"] if shown else []))


def on_sheets(steps: list[cache.SummaryStep]) -> None:
    """Draw the steps on sheets of the projector: the first two share one, and long equations stand in two columns."""
    starts = (0, 2, 3, 4, 5)
    for first, end in zip(starts, (*starts[1:], len(steps)), strict=True):
        with sheet(f"step_{first + 1}", f"{first + 1}. {steps[first].heading}"):
            for number, step in enumerate(steps[first:end], start=first + 1):
                with st.container(horizontal=True, vertical_alignment="top", key=f"spread_{number}"):
                    st.markdown(f"### {number}. {step.heading}\n{step.reason}")
                    for part in step.parts or (step.equations,):
                        st.latex(part)


if __name__ == "__main__":
    show()
