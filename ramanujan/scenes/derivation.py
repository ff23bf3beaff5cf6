"""Page 2: five routes from the machine to Ω², its three modes, and a place to try the formulas oneself."""

from __future__ import annotations

import string
from functools import partial

import streamlit as st

from ramanujan import page, stage
from ramanujan.derivation.parser import MAX_LENGTH
from ramanujan.derivation.shares import PARTS
from ramanujan.motion import InitialState
from ramanujan.scenes import controls, links, look, view
from ramanujan.scenes.cached import derivation as cached

VIEWS = ("Lecture", "Reading")
VALUES = ("Symbols", "My numbers")
FILES = {
    "latex": ("LaTeX", "tex", "application/x-tex"),
    "markdown": ("Markdown", "md", "text/markdown"),
    "notebook": ("Notebook", "ipynb", "application/x-ipynb+json"),
}
VERDICTS = {
    "right": (st.success, ":material/check_circle:"),
    "unsimplified": (st.info, ":material/compress:"),
    "wrong": (st.warning, ":material/lightbulb:"),
    "unreadable": (st.error, ":material/help:"),
}


def choose_route() -> None:
    """Draw the choice of the route and of how it is shown."""
    with st.container(horizontal=True, gap="medium", key="choices"):
        st.segmented_control(
            "Route",
            titles,
            format_func=titles.get,
            default="euler_lagrange",
            required=True,
            key="route",
            bind="query-params",
            label_visibility="collapsed",
            wrap=True,
            on_change=start_over,
        )
        shown = (("show", "How to show it", VIEWS), ("values", "Symbols or numbers", VALUES))
        for key, label, options in shown[:1] if view.hides("numbers") else shown:
            st.segmented_control(
                label,
                options,
                default=options[0],
                required=True,
                key=key,
                bind="query-params",
                label_visibility="collapsed",
            )


def choose_body() -> None:
    """Draw the choice of the body whose terms are told apart."""
    with st.container(horizontal=True, vertical_alignment="center", key="bodies"):
        st.markdown("Whose terms?", width="content")
        st.pills(
            "Whose terms?",
            PARTS,
            format_func=PARTS.get,
            key="body",
            bind="query-params",
            label_visibility="collapsed",
            wrap=True,
        )


def start_over() -> None:
    """Begin the route that was chosen at its first step."""
    st.query_params.pop("step", None)


def turned(route: str, step: int) -> None:
    """Keep in the address where the page has turned to; a message about another route comes too late."""
    if route == st.session_state["route"]:
        st.query_params["step"] = str(step)


@st.fragment
def turn_pages(route: str, headings: list[str]) -> None:
    """Draw what turns the pages of a lecture; a turn reruns nothing else."""
    page.steps(route, headings, turned)


def lecture(count: int) -> None:
    """Draw all steps; the page shows one of them."""
    step = st.query_params.get("step", "1")
    now = step if links.count("step", count).fits(step) else "1"
    # Until the page decides which step is seen, it is the one of the address.
    others = f".st-key-lecture [class*=st-key-step_]:not(.st-key-step_{now})"
    st.markdown(f"<style>{others}{{display:none}}</style>", unsafe_allow_html=True)
    with st.container(border=True, key="lecture"):
        for number in range(1, count + 1):
            with st.container(key=f"step_{number}"):
                draw(number)


def beside() -> None:
    """Draw the machine in motion, with the chosen body lit."""
    stage.mount(
        stage.payload(machine, compression, lit=st.session_state["body"]),
        hide=view.on_stage(),
        limits=controls.limits("compression"),
        watch=controls.WATCH,
        key="beside",
        clock="beside",
        layers=("coordinates",),
        compact=True,
    )


def draw(number: int) -> None:
    """Draw a step, counted from 1."""
    step = cached.step(name, number - 1, masses, part, ink)
    st.markdown(f"### {number}. {step.heading}\n\n{step.reason}")
    if step.by_body:
        st.latex(step.by_body)
    st.latex(step.equations)


def dress() -> None:
    """Give the bodies' names their colours, formulas a box to scroll in, and each step of a lecture the same room."""
    bodies = "".join(
        f".st-key-body button:nth-of-type({place}){{box-shadow:inset 0 -4px {colors[body]}}}"
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


def take_home() -> None:
    """Offer the route as files; each is written when it is asked for."""
    with st.container(horizontal=True, vertical_alignment="center", key="files"):
        st.markdown("Take this route home:", width="content")
        for kind, (label, suffix, mime) in FILES.items():
            st.download_button(
                label,
                partial(cached.document, name, masses, kind),
                f"ramanujan-{name}{'-numbers' if masses else ''}.{suffix}",
                mime,
                key=f"file_{kind}",
                on_click="ignore",
                icon=":material/download:",
            )


def compare() -> None:
    """Draw the table in which all routes meet."""
    st.subheader("Five routes, one frequency", anchor=False)
    rows = [
        [result.title, f"{result.steps} steps", f"$\\displaystyle {result.symbols}$", f"$\\Omega^2 {result.numbers}$"]
        for result in cached.results(present)
    ]
    table = [["Route", "Length", "$\\Omega^2$", "with your numbers"], ["---"] * 4, *rows]
    columns = 3 if view.hides("numbers") else 4
    with st.container(key="results"):
        st.markdown("\n".join(f"| {' | '.join(row[:columns])} |" for row in table))
    if cached.all_agree():
        st.markdown(":material/check: Worked out by SymPy: the difference between any two of them is exactly 0.")


def modes() -> None:
    """Draw the three modes side by side, each moving by itself."""
    st.subheader("Three modes, one of them swings", anchor=False)
    # Slow enough to watch: half of x₀ in the time of one swing.
    speed = compression / 2 / machine.period
    st.markdown(
        "$v$ lists how far $X$, $\\varphi$ and $\\Phi$ move together in a mode. Where nothing pushes back, the "
        "frequency is zero, and to each such mode belongs a momentum that stays as it is."
    )
    spectrum = cached.spectrum(masses)
    shown = (
        (
            "swing",
            None,
            "The machine swings",
            "Its squared frequency is $\\Lambda=\\Omega^2$, shared by all three coordinates. Released at rest, the "
            "machine keeps $p_X=p_\\Phi=0$ and only swings.",
            spectrum.oscillating,
        ),
        (
            "glide",
            InitialState(X_dot=speed),
            "The machine glides",
            "$\\Lambda=0$. No force depends on where the machine stands, so $p_X$ is conserved.",
            spectrum.glide,
        ),
        (
            "roll",
            InitialState(Phi_dot=speed / machine.radius),
            "The top cylinder rolls freely",
            "$\\Lambda=0$. No force depends on how far it has turned, so $p_\\Phi$ is conserved.",
            spectrum.free_rolling,
        ),
    )
    for column, (key, initial, title, words, shape) in zip(st.columns(3), shown, strict=True):
        with column:
            stage.mount(
                stage.payload(machine, compression, initial=initial),
                hide=view.on_stage(),
                limits=controls.limits("compression"),
                watch=controls.WATCH,
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
    notes = st.expander("In the margin of the paper: what its last section means", key="margin", on_change="rerun")
    if not notes.open:
        return
    with notes, st.spinner("Checking each line …"):
        st.markdown("The paper’s main result is right. A few of its lines deserve a note; SymPy has checked each one.")
        for note in cached.notes():
            mark = ":green[:material/check: checked]" if note.holds else ":red[:material/close: not confirmed]"
            st.markdown(
                f"**{note.where}** {mark}  \nprinted: {note.printed}  \nbetter: {note.correct}  \n:small[{note.note}]"
            )


def try_it() -> None:
    """Ask for a formula, and say whether it is right or what is missing."""
    st.subheader("Try it yourself", anchor=False)
    asked = cached.questions()
    quantities = (each.quantity.capitalize() for each in asked.values())
    controls.complain(links.complaints([links.one_of("question", quantities, "none of those below")]))
    key = st.selectbox(
        "What do you want to work out?",
        asked,
        format_func=lambda name: asked[name].quantity.capitalize(),
        key="question",
        bind="query-params",
    )
    question = asked[key]
    st.markdown(f"{question.prompt}  \n:small[You may use] {' '.join(f'`{each}`' for each in question.names)}")
    with st.form("answer", border=False):
        text = st.text_input(
            "Your formula",
            key=f"answer_{key}",
            placeholder=f"typed like this: {question.example}",
            max_chars=2 * MAX_LENGTH,
        )
        st.form_submit_button("Check", type="primary")
    if text:
        verdict, read = cached.verdict(key, text), cached.as_read(text)
        box, icon = VERDICTS[verdict.kind]
        if read:
            st.latex(read)
        box(plain(verdict.message), icon=icon)
    with st.spinner("Deriving the answer …", show_time=False):
        cached.prepare(key)


def plain(text: str) -> str:
    """Return text such that Markdown shows it as it is."""
    return "".join(f"\\{character}" if character in string.punctuation else character for character in text)


machine, compression = controls.oscillator(), controls.compression()
titles, colors = cached.titles(), look.colors()

dress()
st.title("Five ways to one frequency", anchor=False)
choices = {"route": titles.values(), "show": VIEWS, "values": VALUES, "body": PARTS.values()}
controls.complain(links.complaints(links.one_of(key, offered) for key, offered in choices.items()))
choose_route()
name, is_lecture = st.session_state["route"], st.session_state["show"] == VIEWS[0]
count = len(cached.route(name).steps)
controls.complain(links.complaints([links.count("step", count)]))
# One who reads keeps the machine and the choice of a body in view; in a lecture they take no room from the step.
with st.container(key="lectured" if is_lecture else "reading"):
    controls_column, picture_column = st.columns([3, 1], vertical_alignment="center")
with controls_column:
    choose_body()
    if is_lecture:
        turn_pages(name, [step.heading for step in cached.route(name).steps])
with picture_column:
    beside()
part = st.session_state["body"]
present = (machine.m, machine.m_prime, machine.k)
masses = present if not view.hides("numbers") and st.session_state["values"] == VALUES[1] else None
ink = colors[f"{part}_ink"] if part else None
if is_lecture:
    lecture(count)
else:
    for number in range(1, count + 1):
        draw(number)
if masses:
    st.markdown(f":small[{cached.numbers_stated(masses)}]")
st.markdown(f":small[{cached.symbols(name)}]")
take_home()
compare()
modes()
margin()
try_it()
page.give_back("route", "show", "values", "body")
