"""Page 2: five routes from the machine to Ω², its three modes, and a place to try the formulas oneself."""

from __future__ import annotations

import string
from dataclasses import dataclass
from functools import cached_property, partial

import streamlit as st

from ramanujan import Oscillator, page, stage
from ramanujan.derivation import ROUTES
from ramanujan.derivation.answers import QUESTIONS
from ramanujan.derivation.parser import MAX_LENGTH
from ramanujan.derivation.shares import PARTS
from ramanujan.motion import InitialState
from ramanujan.scenes import complaints, controls, links, look, stages, view, widgets
from ramanujan.scenes.cached import derivation as cached
from ramanujan.words import _

LONGEST_ROUTE = 99
ROUTE = links.Choice(
    "route",
    tuple(ROUTES),
    "euler_lagrange",
    old={
        "Euler–Lagrange": "euler_lagrange",
        "Hamilton": "hamilton",
        "Newton": "newton",
        "Energy": "energy",
        "Matrix": "matrix",
    },
)
VIEW = links.Choice("show", ("lecture", "reading"), "lecture", old={"Lecture": "lecture", "Reading": "reading"})
VALUES = links.Choice("values", ("symbols", "numbers"), "symbols", old={"Symbols": "symbols", "My numbers": "numbers"})
BODY = links.Choice("body", tuple(PARTS), old={"lower cylinder": "cylinder", "top cylinder": "top"})
QUESTION = links.Choice(
    "question",
    tuple(QUESTIONS),
    next(iter(QUESTIONS)),
    old={
        "The kinetic energy of the block": "kinetic_energy_block",
        "The kinetic energy of the hoop": "kinetic_energy_hoop",
        "The kinetic energy of the lower cylinder": "kinetic_energy_cylinder",
        "The kinetic energy of the slab": "kinetic_energy_slab",
        "The kinetic energy of the top cylinder": "kinetic_energy_top",
        "The potential energy": "potential_energy",
        "The factor of the acceleration": "phi_equation",
        "The factor of the block’s acceleration": "block_coupling",
        "The factor of the top cylinder’s acceleration": "top_coupling",
        "Ω²": "natural_frequency_squared",
        "The mass ratio": "unit_mass_ratio",
    },
)
STEP = links.Count("step", LONGEST_ROUTE)
KEYS = (ROUTE, VIEW, VALUES, STEP, BODY, QUESTION)

VIEW_WORDS = {"lecture": _("One step"), "reading": _("All steps")}
VALUES_WORDS = {"symbols": _("Symbols"), "numbers": _("Numbers")}
FILES = {
    "latex": ("LaTeX", "tex", "application/x-tex"),
    "markdown": ("Markdown", "md", "text/markdown"),
    "notebook": (_("Notebook"), "ipynb", "application/x-ipynb+json"),
}
VERDICTS = {
    "right": (st.success, ":material/check_circle:"),
    "unsimplified": (st.info, ":material/compress:"),
    "wrong": (st.warning, ":material/lightbulb:"),
    "unreadable": (st.error, ":material/help:"),
}


@dataclass(frozen=True)
class Setting:
    """What a person has set: the machine, its release, and how the route is shown."""

    machine: Oscillator
    compression: float
    route: str
    is_lecture: bool
    in_numbers: bool

    @property
    def present(self) -> tuple[float, float, float]:
        """m, m′ [kg] and k [N/m]."""
        return self.machine.m, self.machine.m_prime, self.machine.k

    @property
    def masses(self) -> cached.Masses:
        """The numbers to show, or None for symbols."""
        return self.present if self.in_numbers else None

    @cached_property
    def steps(self) -> int:
        """The number of steps of the route."""
        return len(cached.route(self.route).steps)


def show() -> None:
    """Draw the page."""
    dress()
    st.title(_("Five ways to one frequency"), anchor=False)
    setting = choose()
    choose_body_beside_machine(setting)
    part = links.held(BODY)
    the_steps(setting, part)
    explain(setting)
    take_home(setting)
    compare(setting.present)
    three_modes(setting)
    margin()
    try_it()
    page.give_back("route", "show", "values", "body")


# ---- what is shown, and how


def choose() -> Setting:
    """Draw the choice of the route and of how it is shown."""
    with st.container(horizontal=True, key="choices"):
        hidden = {"label_visibility": "collapsed"}
        titles = cached.titles()
        route = widgets.chips(ROUTE, _("Route"), titles, wrap=True, on_change=start_over, **hidden)
        how = widgets.chips(VIEW, _("How to show the steps"), VIEW_WORDS, **hidden)
        values = "symbols"
        if not view.hides("numbers"):
            values = widgets.chips(VALUES, _("Symbols or numbers"), VALUES_WORDS, **hidden)
    machine, compression = controls.oscillator(), controls.compression()
    return Setting(machine, compression, route, how == "lecture", values == "numbers")


def choose_body_beside_machine(setting: Setting) -> None:
    """Draw the choice of a body, what turns the steps, and beside them the machine in motion."""
    # One who reads keeps the machine and the choice of a body in view; in a lecture they take no room from the step.
    with st.container(key="lectured" if setting.is_lecture else "reading"):
        choice, picture = st.columns([3, 1], vertical_alignment="center")
    with choice:
        with st.container(horizontal=True, vertical_alignment="center", key="bodies"):
            st.markdown(_("Highlight the terms of"), width="content")
            label = _("Whose terms to highlight")
            widgets.pills(BODY, label, PARTS, label_visibility="collapsed", wrap=True)
        if setting.is_lecture:
            turn_pages(setting.route, [step.heading for step in cached.route(setting.route).steps])
    with picture:
        stages.mount(
            stage.payload(setting.machine, setting.compression, lit=links.held(BODY)),
            key="beside",
            clock="beside",
            layers=("coordinates",),
            compact=True,
        )


def start_over() -> None:
    """Begin the route that was chosen at its first step."""
    st.session_state[STEP.name] = 1


def turned(route: str, step: int) -> None:
    """Keep in the address where the page has turned to; a message about another route comes too late."""
    if route == links.held(ROUTE):
        st.session_state[STEP.name] = step


@st.fragment
def turn_pages(route: str, headings: list[str]) -> None:
    """Draw what turns the pages of a lecture; a turn reruns nothing else."""
    links.keep(STEP)
    page.steps(route, headings, turned)


# ---- the steps


def the_steps(setting: Setting, part: str | None) -> None:
    """Draw the steps of the route; of a lecture the page shows one."""
    if links.held(STEP) > setting.steps:
        complaints.complain(links.Count(STEP.name, setting.steps).complaint())
        start_over()
    links.keep(STEP)
    if not setting.is_lecture:
        for number in range(1, setting.steps + 1):
            draw(setting, number, part)
        return
    # Until the page decides which step is seen, it is the one of the address.
    now = links.held(STEP)
    others = f".st-key-lecture [class*=st-key-step_]:not(.st-key-step_{now})"
    st.markdown(f"<style>{others}{{display:none}}</style>", unsafe_allow_html=True)
    with st.container(border=True, key="lecture"):
        for number in range(1, setting.steps + 1):
            with st.container(key=f"step_{number}"):
                draw(setting, number, part)


def draw(setting: Setting, number: int, part: str | None) -> None:
    """Draw a step, counted from 1."""
    ink = look.colors()[f"{part}_ink"] if part else None
    step = cached.step(setting.route, number - 1, setting.masses, part, ink)
    st.markdown(f"## {number}. {step.heading}\n\n{step.reason}")
    if step.by_body:
        st.latex(step.by_body)
    st.latex(step.equations)


def explain(setting: Setting) -> None:
    """Say whose numbers the steps show, and what their symbols mean."""
    if setting.masses:
        st.markdown(f":small[{cached.numbers_stated(setting.masses)}]")
    st.markdown(f":small[{cached.symbols(setting.route)}]")


def take_home(setting: Setting) -> None:
    """Offer the route as files; each is written when it is asked for."""
    with st.container(horizontal=True, vertical_alignment="center", key="files"):
        st.markdown(_("Download this route:"), width="content")
        for kind, (label, suffix, mime) in FILES.items():
            st.download_button(
                label,
                partial(cached.document, setting.route, setting.masses, kind),
                f"ramanujan-{setting.route}{'-numbers' if setting.masses else ''}.{suffix}",
                mime,
                key=f"file_{kind}",
                on_click="ignore",
                icon=":material/download:",
            )


# ---- what all routes have in common


def compare(present: tuple[float, float, float]) -> None:
    """Draw the table in which all routes meet."""
    st.header(_("All routes give the same frequency"), anchor=False)
    rows = [
        (result.title, str(result.steps), f"$\\displaystyle {result.symbols}$", f"$\\Omega^2 {result.numbers}$")
        for result in cached.results(present)
    ]
    titles = (_("Route"), _("Steps"), _("$\\Omega^2$ in symbols"), _("$\\Omega^2$ with your numbers"))
    columns = 3 if view.hides("numbers") else 4
    with st.container(key="results"):
        st.markdown("\n".join(f"| {' | '.join(row[:columns])} |" for row in (titles, ("---",) * 4, *rows)))
    if cached.all_agree():
        st.markdown(_(":material/check: SymPy has checked that the difference between any two results is exactly 0."))


def three_modes(setting: Setting) -> None:
    """Draw the three modes side by side, each moving by itself."""
    machine, compression = setting.machine, setting.compression
    st.header(_("Three normal modes, one of them oscillates"), anchor=False)
    st.markdown(
        _(
            "The mode shape $v$ lists how far $X$, $\\varphi$ and $\\Phi$ move together, and $\\Lambda$ is the mode’s "
            "squared angular frequency. A mode that does not deform the spring has $\\Lambda=0$. It is called a zero "
            "mode, and it conserves a momentum."
        )
    )
    spectrum = cached.spectrum(setting.masses)
    # Slow enough to watch: half of x₀ in the time of one period.
    speed = compression / 2 / machine.period
    shown = (
        (
            "swing",
            None,
            _("The machine oscillates"),
            _(
                "Here $\\Lambda=\\Omega^2$, and all three coordinates oscillate with this one frequency. A machine "
                "released at rest keeps $p_X=p_\\Phi=0$, so it moves in this mode alone."
            ),
            spectrum.oscillating,
        ),
        (
            "glide",
            InitialState(X_dot=speed),
            _("The whole machine glides"),
            _("$\\Lambda=0$. No force depends on the position of the machine on the floor, so $p_X$ is conserved."),
            spectrum.glide,
        ),
        (
            "roll",
            InitialState(Phi_dot=speed / machine.radius),
            _("The top cylinder rolls freely"),
            _("$\\Lambda=0$. No force depends on the angle of the top cylinder, so $p_\\Phi$ is conserved."),
            spectrum.free_rolling,
        ),
    )
    for column, (key, initial, title, words, shape) in zip(st.columns(3), shown, strict=True):
        with column:
            stages.mount(
                stage.payload(machine, compression, initial=initial),
                key=f"mode_{key}",
                clock="modes",
                layers=(),
                compact=True,
                label=title,
            )
            st.markdown(words)
            st.latex(shape)
    st.latex(spectrum.momenta)


def margin() -> None:
    """Draw the notes on the paper; they are checked when someone wants to read them."""
    notes = st.expander(_("Notes on the paper: a few lines to correct"), key="margin", on_change="rerun")
    if not notes.open:
        return
    with notes, st.spinner(_("Checking each line …")):
        st.markdown(_("The paper’s main result is right. SymPy has checked each of these notes on its details."))
        for note in cached.notes():
            mark = _(":green[:material/check: checked]") if note.holds else _(":red[:material/close: not confirmed]")
            st.markdown(
                _("**{where}** {mark}\\\nThe paper has: {printed}\\\nBetter: {correct}\\\n:small[{note}]").format(
                    where=note.where, mark=mark, printed=note.printed, correct=note.correct, note=note.note
                )
            )


# ---- a place to try


def try_it() -> None:
    """Ask for a formula, and say whether it is right or what is missing."""
    st.header(_("Try it yourself"), anchor=False)
    asked = cached.questions()
    titles = {name: question.quantity[:1].upper() + question.quantity[1:] for name, question in asked.items()}
    key = widgets.menu(QUESTION, _("What do you want to work out?"), titles)
    question = asked[key]
    st.markdown(question.prompt)
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
        verdict, read = cached.verdict(key, text), cached.as_read(text)
        box, icon = VERDICTS[verdict.kind]
        if read:
            st.latex(read)
        box(plain(verdict.message), icon=icon)
    with st.spinner(_("Deriving the answer …"), show_time=False):
        cached.prepare(key)


def plain(text: str) -> str:
    """Return text such that Markdown shows it as it is."""
    return "".join(f"\\{character}" if character in string.punctuation else character for character in text)


def dress() -> None:
    """Give the bodies' names their colours, formulas a box to scroll in, and each step of a lecture the same room."""
    colors = look.colors()
    # A shadow would hide the ring that Streamlit draws around the focus.
    bodies = "".join(
        f".st-key-body button:nth-of-type({place}){{background-image:linear-gradient({colors[body]},{colors[body]});"
        "background-size:100% 4px;background-position:0 100%;background-repeat:no-repeat}"
        for place, body in enumerate(PARTS, start=1)
    )
    st.markdown(
        f"<style>{bodies}"
        ".st-key-results{overflow-x:auto}.st-key-results table{width:max-content}"
        ".st-key-lecture{min-height:23rem}"
        f".st-key-reading{{background:{colors['paper']};padding:.25rem 0}}"
        "</style>",
        unsafe_allow_html=True,
    )


if __name__ == "__main__":
    show()
