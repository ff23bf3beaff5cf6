"""Page 2: the routes from the machine to Ω², its three modes, and questions with typed formulas."""

from dataclasses import dataclass, replace
from typing import Any

import streamlit as st

from ramanujan import UNIT_MASS_RATIO
from ramanujan.answers import QUESTIONS, find_question
from ramanujan.browser import stage
from ramanujan.browser.components import keys, turn
from ramanujan.browser.containers import container
from ramanujan.derivation import ROUTES, Route, Step
from ramanujan.derivation.newton import named_forces
from ramanujan.derivation.nomenclature import DOTS
from ramanujan.derivation.numbers import Numbers, state_numbers
from ramanujan.derivation.remarks import REMARKS
from ramanujan.pages.derivation import cache
from ramanujan.pages.derivation.normal_modes import MODES, draw_modes
from ramanujan.shell import address, display_mode, menu, messages, sidebar, stages, theme, widgets
from ramanujan.shell.display_mode import columns, slide
from ramanujan.shell.pending_updates import set_widgets
from ramanujan.shell.sections.cubes import draw_stacks
from ramanujan.shell.sections.typed_answer import QUESTION, draw_chosen, draw_section
from ramanujan.shell.shared_cache import symbols
from ramanujan.text.names import PARTS
from ramanujan.text.translation import _

# Largest number of a step in the address.
LONGEST_ROUTE = 99
ROUTE = address.Choice("route", tuple(ROUTES), "euler_lagrange")
VIEW = address.Choice("show", {"lecture": _("One step"), "reading": _("All steps")}, "lecture")
# TRANSLATORS: a choice: equations are shown in symbols or with numbers.
VALUES = address.Choice("values", {"symbols": _("Symbols"), "numbers": _("Numbers")}, "symbols")
MASSES = address.Choice("masses", {"any": _("Any masses"), "equal": _("Equal masses, m′ = m")}, "any")
STEP = address.Count("step", LONGEST_ROUTE)
URL_PARAMETERS = (ROUTE, VIEW, VALUES, MASSES, STEP, QUESTION, *MODES)

# Height of a step in a lecture [px], as in page.css.
_STEP_HEIGHT = 368

# The keys of the steps about velocities: their arrows would distract at any other step.
VELOCITIES = {"velocities", "momenta", "inversion", "least", "mode_shape"}
# The keys of the steps that answer a question of the section “Try it yourself”.
ASKED = {find_question(name).steps[-1] for name in QUESTIONS}
# Kind of a file → its label, the end of its name, and its media type.
FILES = {
    "latex": ("LaTeX", "tex", "application/x-tex"),
    "notebook": (_("Notebook"), "ipynb", "application/x-ipynb+json"),
}


@dataclass(frozen=True)
class Setting:
    """The values of the display options: one step at a time or all, any masses or m′ = m, numbers or symbols."""

    route: str
    is_lecture: bool
    equal_masses: bool
    numbers: Numbers | None

    @property
    def steps(self) -> tuple[Step, ...]:
        """The steps of the route."""
        return cache.route(self.route, self.equal_masses).steps


def show() -> None:
    """Draw the page, or only the open question."""
    question = address.update(QUESTION)
    if question:
        with slide("try", _("Try it yourself")):
            draw_chosen(question)
        # Also write the parameters of parts that are hidden now.
        address.update(*URL_PARAMETERS)
        return
    setting = draw_route()
    with slide("results", _("The results")):
        compare_routes()
    with slide("modes", _("The modes")):
        draw_modes(current_numbers() if setting.numbers else None)
    if not display_mode.is_projector():
        draw_notes_on_paper()
    with slide("try", _("Try it yourself")):
        draw_section()
    keys.return_focus("route", "show", "values", "masses")
    if not setting.numbers:
        sidebar.set_dependent_fragments("beside", "results", "modes")


# ---- display options


def draw_route() -> Setting:
    """Draw the options, the steps and the machine. In the projector view they share one slide."""
    setting = read_setting()
    with slide("lecture", _("The steps")):
        with st.container(horizontal=True, vertical_alignment="center", key="head"):
            st.title(_("Many ways to one frequency"), anchor=False, width="content")
            head = st.container(horizontal=True, vertical_alignment="center", key="choices")
        # Above machine and steps, because a warning between them would push the machine away.
        if address.current(STEP) > len(setting.steps):
            messages.warn(address.Count(STEP.name, len(setting.steps)).message())
            select_first_step()
        with container("route", "lecture" if setting.is_lecture else "reading"):
            picture, steps = st.container(), st.container()
        with picture:
            stages.mount(None, key="beside", clock="beside", layers=("coordinates",), compact=True)
            goal = st.container(key="goal")
        # The first visitor of a server waits for all routes, because the options contain their names.
        with steps, st.skeleton(height=_STEP_HEIGHT):
            cache.all_routes()
        if not display_mode.is_projector():
            with goal:
                draw_goal()
        with head:
            draw_options()
            turn_pages(setting)
        with steps:
            draw_steps(setting)
    if not display_mode.is_projector():
        explain_symbols(setting)
        offer_files(setting)
    return setting


def draw_goal() -> None:
    """Draw the result of all routes. turn.js hides it beside the later steps of a lecture."""
    st.markdown(
        _(
            "Released at rest, the machine oscillates with one angular frequency, $\\Omega$. Choose a route from the "
            "five bodies to this formula, and follow it step by step."
        )
    )
    st.latex(cache.result(None)[0])


def read_setting() -> Setting:
    """Return the values of the options. The projector view shows one step at a time."""
    is_lecture = address.current(VIEW) == "lecture" or display_mode.is_projector()
    equal_masses = address.current(MASSES) == "equal"
    numbers = current_numbers() if uses_sidebar() else None
    if numbers and equal_masses:
        numbers = numbers.with_equal_masses
    return Setting(address.current(ROUTE), is_lecture, equal_masses, numbers)


def uses_sidebar() -> bool:
    """Return whether the equations contain the numbers of the sliders; equations in symbols hold for any numbers."""
    return address.current(VALUES) == "numbers" and not display_mode.hides("numbers")


def current_numbers() -> Numbers:
    """Return the current masses and spring constant."""
    return Numbers.of(sidebar.oscillator())


def draw_options() -> None:
    """Draw the options. All but the route are in a popover."""
    hidden: dict[str, Any] = {"label_visibility": "collapsed"}
    titles = {name: cache.route(name).title for name in ROUTE.options}
    widgets.selectbox(ROUTE, _("Route"), titles, on_change=select_first_step, **hidden)
    with st.popover(_("Show"), icon=":material/tune:", key="more"):
        if not display_mode.is_projector():
            widgets.segmented_control(VIEW, _("How to show the steps"), **hidden)
        if not display_mode.hides("numbers"):
            widgets.segmented_control(VALUES, _("Symbols or numbers"), **hidden)
        widgets.segmented_control(MASSES, _("For which masses"), on_change=keep_step_in_range, **hidden)


def select_route(name: str) -> None:
    """Callback: select a route and its first step."""
    set_widgets({ROUTE.name: name})
    select_first_step()


def select_first_step() -> None:
    """Callback: select the first step of the new route."""
    st.session_state[STEP.name] = 1


def keep_step_in_range() -> None:
    """Callback: keep the current step for other masses, or select the last step if there are fewer steps."""
    steps = cache.route(address.current(ROUTE), address.current(MASSES) == "equal").steps
    st.session_state[STEP.name] = min(address.current(STEP), len(steps))


def select_step(route: str, step: int) -> None:
    """Callback: store the selected step. Ignore a late message about another route."""
    if route == address.current(ROUTE):
        st.session_state[STEP.name] = step


# “beside” is the machine beside the steps, which follows the sliders.
@st.fragment(key="beside")
def turn_pages(setting: Setting) -> None:
    """Draw the pager of a lecture, and publish the machine to the stage and the boxes of the sliders.

    A turned page reruns only this fragment. The last step is about the machine in step, so the stage shows it.
    """
    address.update(STEP)
    machine = sidebar.oscillator()
    steps = shown_steps = setting.steps
    if setting.is_lecture:
        headings = [step.heading for step in steps]
        turn.mount_lecture(setting.route, headings, select_step, has_onward_link=steps[-1].key == "root")
        current_step = steps[min(address.current(STEP), len(steps)) - 1]
        shown_steps = (current_step,)
        if current_step.key == "root":
            machine = replace(machine, m_prime=UNIT_MASS_RATIO * machine.m)
    forces = named_forces(equation for step in shown_steps for equation in step.equations)
    velocities = any(step.key in VELOCITIES for step in shown_steps) or None
    # A lecturer draws the forces at one moment. In motion they vanish twice a period.
    held = bool(forces and setting.is_lecture) or None
    payload = stage.payload(machine, sidebar.compression(), forces=forces or None, held=held, velocities=velocities)
    stages.publish(payload, key="beside", more=sidebar.collect_box_messages())


# ---- the steps


def draw_steps(setting: Setting) -> None:
    """Draw the steps of the route. The page of a lecture shows one of them."""
    steps = len(setting.steps)
    address.update(STEP)
    if not setting.is_lecture:
        for number in range(1, steps + 1):
            draw_step(setting, number)
        return
    # The hidden steps leave no gaps. page.css hides them, and turn.js shows one.
    with st.container(key="lecture", gap=None):
        for number in range(1, steps + 1):
            with container("step", str(number)):
                draw_step(setting, number)


def draw_step(setting: Setting, number: int) -> None:
    """Draw a step, counted from 1."""
    colors = theme.colors()
    inks = (*((part, colors[f"{part}_ink"]) for part in PARTS), ("cube", colors["primary"]))
    heading, reason, wide, narrow = cache.step(
        setting.route,
        number - 1,
        setting.numbers,
        inks,
        equal_masses=setting.equal_masses,
        wide=display_mode.is_projector(),
    )
    step = setting.steps[number - 1]
    is_last = step.key == "root"
    if is_last:
        with st.container(key="figure"):
            draw_stacks()
    st.markdown(f"## {number}. {heading}\n\n{reason}")
    widgets.equations(f"{setting.route}_{number}", wide, narrow)
    if setting.is_lecture and not display_mode.is_projector() and named_forces(step.equations):
        with container("click", f"forces_{number}"):
            hint = _(
                "The bodies are drawn apart, each with the forces on it. At the release the forces are greatest. Play "
                "shows them change."
            )
            st.caption(hint)
    if step.key in ASKED and setting.is_lecture and not display_mode.is_projector():
        with st.container(key=f"try_link_{number}"):
            st.markdown(_("Would you like to work out a result on your own? [Try it yourself](#try)."))
    if is_last:
        onward = menu.PAGES["taxicab"]
        with st.container(key="onward"):
            st.page_link(onward.file, label=_("Why 1729? Go on to its page"), icon=f":material/{onward.icon}:")


def explain_symbols(setting: Setting) -> None:
    """Name the masses that the steps use, and explain the symbols."""
    if setting.numbers:
        st.caption(state_numbers(setting.numbers))
    meanings = "\n".join(f"- {meaning}" for meaning in symbols(setting.route))
    with st.expander(_("What the symbols of this route mean"), key="meanings"), container("list", "meanings"):
        st.caption(f"{meanings}\n\n{DOTS}")


@st.fragment
def offer_files(setting: Setting) -> None:
    """Offer the route as files, which are written when the popover opens."""
    name = f"ramanujan-{setting.route}-numbers" if setting.numbers else f"ramanujan-{setting.route}"
    with st.popover(_("Download this route"), icon=":material/download:", key="files", on_change="rerun") as files:
        for kind, (label, suffix, mime) in FILES.items():
            content = ""
            if files.open:
                content = cache.document(setting.route, setting.numbers, kind, equal_masses=setting.equal_masses)
            widgets.download(label, content, f"{name}.{suffix}", mime, key=f"file_{kind}", disabled=not files.open)


# ---- comparison of the routes


@st.fragment(key="results")
def compare_routes() -> None:
    """Draw the common result of all routes, and a line for each route."""
    st.header(_("All routes give the same frequency"), anchor=False)
    numbers = None if display_mode.hides("numbers") else current_numbers()
    lines = cache.result(numbers)
    if not display_mode.is_projector():
        # The formula is at the top of the page.
        lines = lines[1:]
    result, routes = columns("results")
    with result:
        with st.container(horizontal=True):
            for line in lines:
                st.latex(line)
        if numbers and not display_mode.is_projector():
            st.caption(state_numbers(numbers))
        st.markdown(_("SymPy has checked that the difference between any two results is exactly 0."))
    with routes:
        for route in cache.all_routes():
            draw_link_to_route(route)


def draw_link_to_route(route: Route) -> None:
    """Draw a button that selects a route, with a check mark if its result agrees, beside the idea of the route."""
    link, idea = st.columns([2, 3], vertical_alignment="center")
    with link:
        is_chosen = st.button(
            _("{route}, {n} steps").format(route=route.title, n=len(route.steps)),
            key=f"select_{route.name}",
            type="tertiary",
            icon=":material/check:" if cache.agrees(route.name) else ":material/close:",
            on_click=select_route,
            args=(route.name,),
        )
    idea.markdown(route.idea)
    if is_chosen:
        st.rerun()


def draw_notes_on_paper() -> None:
    """Draw the notes on the paper."""
    with st.expander(_("Notes on the paper: a few lines to correct"), key="margin"):
        st.markdown(_("The paper’s main result is right. SymPy has checked each of these notes on its details."))
        for remark in REMARKS:
            st.markdown(
                _("**{where}**\\\nThe paper has: {printed}\\\nBetter: {correct}\\\n{note}").format(
                    where=remark.where, printed=remark.printed, correct=remark.correct, note=remark.note
                )
            )


if __name__ == "__main__":
    show()
