"""Page 2: five routes from the machine to Ω², its three modes, and a place to try the formulas oneself."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, partial

import streamlit as st
from streamlit.delta_generator import DeltaGenerator

from ramanujan import Oscillator
from ramanujan.browser import page, stage
from ramanujan.derivation import ROUTES
from ramanujan.derivation.shares import PARTS
from ramanujan.pages.derivation import cache
from ramanujan.pages.derivation.modes import three_modes
from ramanujan.pages.derivation.tryout import QUESTION, try_it
from ramanujan.shell import address, display_mode, messages, sidebar, stages, theme, widgets
from ramanujan.shell.display_mode import sheet
from ramanujan.translation import _

LONGEST_ROUTE = 99
ROUTE = address.Choice("route", tuple(ROUTES), "euler_lagrange")
VIEW = address.Choice("show", ("lecture", "reading"), "lecture")
VALUES = address.Choice("values", ("symbols", "numbers"), "symbols")
BODY = address.Choice("body", tuple(PARTS))
STEP = address.Count("step", LONGEST_ROUTE)
URL_PARAMETERS = (ROUTE, VIEW, VALUES, STEP, BODY, QUESTION)

VIEW_WORDS = {"lecture": _("One step"), "reading": _("All steps")}
VALUES_WORDS = {"symbols": _("Symbols"), "numbers": _("Numbers")}
FILES = {
    "latex": ("LaTeX", "tex", "application/x-tex"),
    "markdown": ("Markdown", "md", "text/markdown"),
    "notebook": (_("Notebook"), "ipynb", "application/x-ipynb+json"),
}


@dataclass(frozen=True)
class Setting:
    """What a person has set: the machine, and how the route is shown."""

    machine: Oscillator
    route: str
    is_lecture: bool
    in_numbers: bool

    @property
    def present(self) -> tuple[float, float, float]:
        """m, m′ [kg] and k [N/m]."""
        return self.machine.m, self.machine.m_prime, self.machine.k

    @property
    def masses(self) -> cache.Masses:
        """The numbers to show, or None for symbols."""
        return self.present if self.in_numbers else None

    @cached_property
    def steps(self) -> int:
        """The number of steps of the route."""
        return len(cache.route(self.route).steps)


def show() -> None:
    """Draw the page."""
    dress()
    setting = the_route()
    with sheet("results", _("The results")):
        compare()
    with sheet("modes", _("The modes")):
        three_modes(setting.masses)
    if not display_mode.is_projector():
        margin()
    with sheet("try", _("Try it yourself")):
        try_it()
    page.give_back("route", "show", "values", "body")
    if not setting.in_numbers:
        sidebar.follow("beside", "results", "modes")


# ---- what is shown, and how


def the_route() -> Setting:
    """Draw the choices and the steps; on a projector a lecture is one sheet, and who reads has one for each step."""
    with sheet("machine", _("The machine")):
        st.title(_("Five ways to one frequency"), anchor=False)
        setting = choose()
        turner = choose_body_beside_machine(setting)
    part = address.held(BODY)
    if setting.is_lecture:
        lecture = sheet("lecture", _("The steps"))
        with lecture if display_mode.is_projector() else turner:
            turn_pages(setting.route, [step.heading for step in cache.route(setting.route).steps])
        with lecture:
            the_steps(setting, part)
    else:
        the_steps(setting, part)
    if not display_mode.is_projector():
        explain(setting)
        take_home(setting)
    return setting


def choose() -> Setting:
    """Draw the choice of the route and of how it is shown."""
    with st.container(horizontal=True, key="choices"):
        hidden = {"label_visibility": "collapsed"}
        titles = cache.titles()
        route = widgets.chips(ROUTE, _("Route"), titles, wrap=True, on_change=start_over, **hidden)
        how = widgets.chips(VIEW, _("How to show the steps"), VIEW_WORDS, **hidden)
        values = "symbols"
        if not display_mode.hides("numbers"):
            values = widgets.chips(VALUES, _("Symbols or numbers"), VALUES_WORDS, **hidden)
    return Setting(sidebar.oscillator(), route, how == "lecture", values == "numbers")


def choose_body_beside_machine(setting: Setting) -> DeltaGenerator:
    """Draw the choice of a body, and beside it the machine in motion; return the place below the choice."""
    # One who reads keeps the machine and the choice of a body in view; in a lecture they take no room from the step.
    with st.container(key="lectured" if setting.is_lecture else "reading"):
        shares = [1, 2] if display_mode.is_projector() else [3, 1]
        choice, picture = st.columns(shares, vertical_alignment="center")
    with choice, st.container(horizontal=True, vertical_alignment="center", key="bodies"):
        st.markdown(_("Highlight the terms of"), width="content")
        label = _("Whose terms to highlight")
        widgets.pills(BODY, label, PARTS, label_visibility="collapsed", wrap=True)
    with picture:
        stages.mount(None, key="beside", clock="beside", layers=("coordinates",), compact=True)
        tell_beside()
    return choice


@st.fragment(key="beside")
def tell_beside() -> None:
    """Tell the machine beside the steps, and the sliders' boxes, what is set."""
    stages.tell(
        stage.payload(sidebar.oscillator(), sidebar.compression(), lit=address.held(BODY)),
        key="beside",
        more=sidebar.followed(),
    )


def start_over() -> None:
    """Begin the route that was chosen at its first step."""
    st.session_state[STEP.name] = 1


def turned(route: str, step: int) -> None:
    """Keep in the address where the page has turned to; a message about another route comes too late."""
    if route == address.held(ROUTE):
        st.session_state[STEP.name] = step


@st.fragment
def turn_pages(route: str, headings: list[str]) -> None:
    """Draw what turns the pages of a lecture; a turn reruns nothing else."""
    address.keep(STEP)
    page.steps(route, headings, turned)


# ---- the steps


def the_steps(setting: Setting, part: str | None) -> None:
    """Draw the steps of the route; of a lecture the page shows one."""
    if address.held(STEP) > setting.steps:
        messages.warn(address.Count(STEP.name, setting.steps).message())
        start_over()
    address.keep(STEP)
    if not setting.is_lecture:
        for number in range(1, setting.steps + 1):
            with sheet(f"step_{number}", f"{number}. {cache.route(setting.route).steps[number - 1].heading}"):
                draw(setting, number, part)
        return
    # Until the page decides which step is seen, it is the one of the address.
    now = address.held(STEP)
    others = f".st-key-lecture [class*=st-key-step_]:not(.st-key-step_{now})"
    st.html(f"<style>{others}{{display:none}}</style>")
    # The steps that are hidden leave no gaps.
    with st.container(border=True, key="lecture", gap=None):
        for number in range(1, setting.steps + 1):
            with st.container(key=f"step_{number}"):
                draw(setting, number, part)


def draw(setting: Setting, number: int, part: str | None) -> None:
    """Draw a step, counted from 1."""
    ink = theme.colors()[f"{part}_ink"] if part else None
    step = cache.step(setting.route, number - 1, setting.masses, part, ink)
    st.markdown(f"## {number}. {step.heading}\n\n{step.reason}")
    if step.by_body:
        st.latex(step.by_body)
    if step.equations:
        st.latex(step.equations)


def explain(setting: Setting) -> None:
    """Say whose numbers the steps show, and what their symbols mean."""
    if setting.masses:
        st.markdown(f":small[{cache.numbers_stated(setting.masses)}]")
    st.markdown(f":small[{cache.symbols(setting.route)}]")


def take_home(setting: Setting) -> None:
    """Offer the route as files; each is written when it is asked for."""
    with st.container(horizontal=True, vertical_alignment="center", key="files"):
        st.markdown(_("Download this route:"), width="content")
        for kind, (label, suffix, mime) in FILES.items():
            st.download_button(
                label,
                partial(cache.document, setting.route, setting.masses, kind),
                f"ramanujan-{setting.route}{'-numbers' if setting.masses else ''}.{suffix}",
                mime,
                key=f"file_{kind}",
                on_click="ignore",
                icon=":material/download:",
            )


# ---- what all routes have in common


@st.fragment(key="results")
def compare() -> None:
    """Draw the table in which all routes meet."""
    machine = sidebar.oscillator()
    present = machine.m, machine.m_prime, machine.k
    st.header(_("All routes give the same frequency"), anchor=False)
    rows = [
        (result.title, str(result.steps), f"$\\displaystyle {result.symbols}$", f"$\\Omega^2 {result.numbers}$")
        for result in cache.results(present)
    ]
    titles = (_("Route"), _("Steps"), _("$\\Omega^2$ in symbols"), _("$\\Omega^2$ with your numbers"))
    columns = 3 if display_mode.hides("numbers") else 4
    with st.container(key="results"):
        st.markdown("\n".join(f"| {' | '.join(row[:columns])} |" for row in (titles, ("---",) * 4, *rows)))
    if cache.all_agree():
        st.markdown(_(":material/check: SymPy has checked that the difference between any two results is exactly 0."))


def margin() -> None:
    """Draw the notes on the paper; they are checked when someone wants to read them."""
    notes = st.expander(_("Notes on the paper: a few lines to correct"), key="margin", on_change="rerun")
    if not notes.open:
        return
    with notes, st.spinner(_("Checking each line …")):
        st.markdown(_("The paper’s main result is right. SymPy has checked each of these notes on its details."))
        for note in cache.notes():
            mark = _(":green[:material/check: checked]") if note.holds else _(":red[:material/close: not confirmed]")
            st.markdown(
                _("**{where}** {mark}\\\nThe paper has: {printed}\\\nBetter: {correct}\\\n:small[{note}]").format(
                    where=note.where, mark=mark, printed=note.printed, correct=note.correct, note=note.note
                )
            )


def dress() -> None:
    """Give the bodies' names their colours, formulas a box to scroll in, and each step of a lecture the same room."""
    colors = theme.colors()
    # A shadow would hide the ring that Streamlit draws around the focus.
    bodies = "".join(
        f".st-key-body button:nth-of-type({place}){{background-image:linear-gradient({colors[body]},{colors[body]});"
        "background-size:100% 4px;background-position:0 100%;background-repeat:no-repeat}"
        for place, body in enumerate(PARTS, start=1)
    )
    st.html(
        f"<style>{bodies}"
        ".st-key-results{overflow:auto hidden}.st-key-results table{width:max-content}"
        ".st-key-lecture{min-height:23rem}"
        f".st-key-reading{{background:{colors['paper']};padding:.25rem 0}}"
        "</style>"
    )


if __name__ == "__main__":
    show()
