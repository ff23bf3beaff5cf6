"""The section of page 4 on other bodies: options, the chosen machine, its numbers, and all forty machines."""

from base64 import b64encode
from collections.abc import Mapping
from fractions import Fraction

import streamlit as st

from ramanujan import number_theory
from ramanujan.browser import stage
from ramanujan.browser.components import pick
from ramanujan.figures import taxicab_page as figures
from ramanujan.number_theory import BODIES, BodyChoice
from ramanujan.pages.taxicab import cache
from ramanujan.shell import address, display_mode, drawings, sidebar, stages, theme, widgets
from ramanujan.shell.display_mode import slide
from ramanujan.shell.sections.places import PAPER_BODIES, PLACE_WORDS, PLACES
from ramanujan.text.names import SHAPES
from ramanujan.text.numerals import filled, in_latex
from ramanujan.text.translation import _, ngettext

WORDS = SHAPES | {"shell": _("shell")}
"""Body → its name, short enough for a cell of the grid."""
URL_PARAMETERS = tuple(address.Choice(place, WORDS, body) for place, body in PAPER_BODIES.items())
STAGE = "stage_bodies"
"""Key of the stage."""
DEPENDENT_FRAGMENTS = ("bodies_machine", "bodies_numbers")
"""Keys of the fragments that depend on the machine of the sidebar."""


def draw_other_bodies() -> None:
    """Draw options, stage, numbers and the table of all machines."""
    with slide("bodies", _("Other bodies")):
        chosen = [address.current(key) for key in URL_PARAMETERS]
        results = cache.results(*chosen)
        with st.container(key="bodies"):
            words, number = st.container(key="bodies_words"), st.container(key="discriminant")
        with words:
            explain_bodies()
        # Near the clock, so that both are seen at the same time.
        with number:
            draw_discriminant(results)
        draw_options()
        stages.mount(None, key=STAGE, layers=())
        publish_machine(chosen)
    with slide("forty", _("All machines")):
        st.header(_("All machines"), anchor=False)
        with st.container(key="forty"):
            table, words = st.columns([1, 1], gap="medium")
        with table:
            draw_all_machines(results.machine)
        with words:
            describe_machine(results)


def explain_bodies() -> None:
    """Draw the bodies, and explain what distinguishes them."""
    st.header(_("Other bodies, other numbers"), anchor=False)
    st.markdown(
        _(
            "Does 1729 come from the machine or from these bodies? Try others. A body of mass $M$ and radius $R$ "
            "has the moment of inertia $I=\\beta MR^2$; the farther out its mass, the larger its shape factor "
            "$\\beta$."
        )
    )
    st.html(bodies_html(theme.colors()["block"]))


def draw_options() -> None:
    """Draw the options in one row."""
    with st.container(key="choices_bodies"):
        columns = st.columns(3, gap="small")
    for column, parameter in zip(columns, URL_PARAMETERS, strict=True):
        with column:
            widgets.segmented_control(parameter, PLACE_WORDS[parameter.name])


def bring_into_step() -> None:
    """Callback: set the mass ratio at which the machine with the chosen bodies is in step, and release both hands."""
    results = cache.results(*(address.current(key) for key in URL_PARAMETERS))
    sidebar.request_ratio(results.ratio)
    stages.release()


def draw_discriminant(results: cache.Results) -> None:
    """Draw the number that replaces 1729, its sums of two cubes, and the mass ratio that leads to it."""
    st.html(f"<strong>{results.machine.discriminant}</strong>")
    st.markdown(f"$={results.cubes}$" if results.cubes else _("no sum of two cubes"))
    st.markdown(_("in step at $\\varepsilon={ratio}$").format(ratio=in_latex(f"{results.ratio:.7g}")))
    st.button(_("Set this mass ratio"), key="own_ratio", on_click=bring_into_step)


@st.fragment(key="bodies_machine")
def publish_machine(chosen: list[str]) -> None:
    """Publish the machine to the stage and the boxes of the sliders. A slider reruns this fragment without the page."""
    left, right, top = (float(BODIES[body]) for body in chosen)
    stages.publish(
        stage.payload(
            sidebar.oscillator(), sidebar.compression(), shape_factors={"hoop": left, "cylinder": right, "top": top}
        ),
        key=STAGE,
        more=sidebar.collect_box_messages(),
    )


def describe_machine(results: cache.Results) -> None:
    """Describe the machine with the chosen bodies."""
    machine = results.machine
    st.markdown(f"**{machine_name(machine)}**")
    st.latex(cache.aligned(results.quadratic, rf"\varepsilon = {results.root}", results.square))
    st.markdown(describe_cubes(results))
    describe_current_masses(machine)
    with st.expander(_("Does the number depend on how the ratio is written?")):
        sentence = _(
            "If $\\varepsilon$ is multiplied by a fraction, its new equation has another discriminant. The two differ "
            "only by a square factor. What all of them share is called the *field discriminant*; here it is "
            "**{field}**."
        )
        st.markdown(sentence.format(field=machine.field_discriminant))
    st.button(_("Back to the paper’s bodies"), key="paper_bodies", on_click=choose_bodies, args=(PAPER_BODIES,))


def choose_bodies(bodies: Mapping[str, str]) -> None:
    """Callback: choose a body for each place, and bring the machine into step."""
    st.session_state.update(bodies)
    bring_into_step()


@st.fragment(key="bodies_numbers")
def describe_current_masses(machine: BodyChoice) -> None:
    """State the frequency of the machine with these bodies and the masses of the sidebar."""
    if display_mode.hides("numbers"):
        return
    oscillator = sidebar.oscillator()
    ratio = Fraction(oscillator.m_prime) / Fraction(oscillator.m)
    value = number_theory.normalized_frequency_squared_exact(*machine.bodies, ratio)
    st.markdown(
        _("With your masses, $\\varepsilon={ratio}$, it has $\\Omega^2m/k={value}$.").format(
            ratio=in_latex(f"{oscillator.mass_ratio:.5g}"), value=in_latex(f"{float(value):.6g}")
        )
    )


def describe_cubes(results: cache.Results) -> str:
    """Factor a discriminant, and state whether it is a sum of two cubes."""
    ways = len(results.machine.cubes)
    sentence = _("The discriminant {number} is not a sum of two positive cubes.")
    if ways:
        sentence = ngettext(
            "The discriminant {number} is a sum of two positive cubes in one way: ${cubes}$.",
            "The discriminant {number} is a sum of two positive cubes **in {n} ways**: ${cubes}$.",
            ways,
        )
    discriminant = str(results.machine.discriminant)
    factors = "" if results.factors == discriminant else f" $={results.factors}$"
    return filled(sentence, number=f"**{discriminant}**{factors}", cubes=results.cubes, n=ways)


def draw_all_machines(chosen: BodyChoice) -> None:
    """Draw the discriminants of all machines in one figure: a row for each pair, a column for each body on top."""
    machines, columns = cache.machines(), list(BODIES)
    # The machines are in the order of the figure, row by row.
    pairs = [(machine.left, machine.right) for machine in machines[:: len(columns)]]
    left, right = sorted((chosen.left, chosen.right), key=columns.index)
    cell = pairs.index((left, right)), columns.index(chosen.top)
    best = max(machines, key=lambda machine: len(machine.cubes))
    one, other = (machine.discriminant for machine in machines if len(machine.cubes) == 1)
    facts = {"count": len(machines), "best": best.discriminant, "one": one, "other": other}
    sentence = _(
        "The discriminants of {count} machines for $\\Omega^2=k/m$: only **{best}** is a sum of two positive cubes in "
        "two ways; {one} and {other} are such a sum in one way. Choose any to build its machine."
    )
    st.markdown(sentence.format(**facts))
    drawings.plot(
        figures.draw_machine_grid(
            [_("{left} + {right}").format(left=WORDS[left], right=WORDS[right]) for left, right in pairs],
            [WORDS[body] for body in columns],
            [machine.discriminant for machine in machines],
            [len(machine.cubes) for machine in machines],
            cell,
            theme.colors() | {"on_hoop": "#1D2430"},
        ),
        "machines",
        _(
            "The discriminants of all {count} machines, ten pairs of lower rollers, each with four bodies on top. "
            "Only {best} is a sum of two positive cubes in two ways; {one} and {other} are such a sum in one way. "
            "Marked: {chosen} ({name})."
        ).format(**facts, chosen=chosen.discriminant, name=machine_name(chosen)),
    )
    pick.mount("machines", select_clicked_machine)


def select_clicked_machine(point: dict[str, float]) -> None:
    """Callback: choose the bodies of the clicked machine."""
    row, column = int(point["y"]), int(point["x"])
    index = len(BODIES) * row + column
    # Ignore a message with a point outside of the figure.
    if index < len(cache.machines()):
        machine = cache.machines()[index]
        choose_bodies(dict(zip(PLACES, machine.bodies, strict=True)))


def machine_name(machine: BodyChoice) -> str:
    """Return the names of the bodies."""
    return _("Lower rollers: {left} and {right}; on\u00a0top: {top}").format(
        **{place: WORDS[body] for place, body in zip(PLACES, machine.bodies, strict=True)}
    )


def bodies_html(color: str) -> str:
    """Return all bodies with their names and shape factors β, as HTML."""
    figures = [
        f'<figure style="margin:0;min-width:98px;display:flex;gap:.4rem;align-items:center"><img width="38" height="38"'
        f' alt="" src="{_drawing_url(body, color)}"><figcaption>{WORDS[body]} <br>β = {beta}</figcaption></figure>'
        for body, beta in BODIES.items()
    ]
    row = "<div style='display:flex;flex-wrap:wrap;gap:.6rem 1rem'>{}</div>"
    # On a narrow screen a row of two pairs wraps into two rows.
    return row.format(row.format("".join(figures[:2])) + row.format("".join(figures[2:])))


def _drawing_url(body: str, color: str) -> str:
    """Return the drawing of a body as a data URL."""
    ink = f'stroke="{color}" fill="none"'
    drawings = {
        "hoop": f'<circle cx="24" cy="24" r="19" stroke-width="5" {ink}/>',
        "shell": f'<circle cx="24" cy="24" r="20" stroke-width="2.5" stroke="{color}" fill="{color}" '
        f'fill-opacity=".15"/><ellipse cx="24" cy="24" rx="20" ry="7" stroke-width="1.5" {ink}/>'
        f'<ellipse cx="24" cy="24" rx="7" ry="20" stroke-width="1.5" {ink}/>',
        "cylinder": f'<g fill="{color}"><g opacity=".5"><circle cx="29" cy="19" r="15"/>'
        '<path d="M8.4 18.4 18.4 8.4 39.6 29.6 29.6 39.6z"/></g><circle cx="19" cy="29" r="15"/></g>',
        "sphere": f'<circle cx="24" cy="24" r="21" fill="{color}"/>'
        '<circle cx="18" cy="17" r="7" fill="#fff" fill-opacity=".4"/>'
        '<circle cx="16" cy="15" r="3" fill="#fff" fill-opacity=".6"/>',
    }
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 48 48">{drawings[body]}</svg>'
    return f"data:image/svg+xml;base64,{b64encode(svg.encode()).decode()}"
