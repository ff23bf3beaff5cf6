"""Page 4: why 1729. The exact mass ratio, two stacks of cubes, other bodies, other targets, the open question."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

import streamlit as st

from ramanujan import UNIT_MASS_RATIO, number_theory, stage
from ramanujan.figures.taxicab import level_crossing
from ramanujan.number_theory import BODIES, BodyChoice
from ramanujan.scenes import controls, emblems, links, look, view
from ramanujan.scenes.cached import taxicab as cached

PLACES = {"left": "Left roller", "right": "Right roller", "top": "Body on top"}
PAPER = dict(zip(PLACES, BodyChoice().bodies, strict=True))
STILL = {"displayModeBar": False, "scrollZoom": False}
LAST_TARGET = "last_target"
MOST_DIGITS = number_theory.integers.MOST_DIGITS
LINK = [
    *(links.one_of(place, BODIES) for place in PLACES),
    *(links.count(part, cached.LARGEST_PART) for part in ("p", "q")),
    links.count("digits", MOST_DIGITS),
]


def take_clicked() -> None:
    """Put the bodies of the machine that was clicked into their places; a second click on it brings them back."""
    points = st.session_state["machines"].selection.points
    if points:
        st.session_state["clicked"] = points[0]["point_index"]
    if (clicked := st.session_state.get("clicked")) is not None:
        st.session_state.update(zip(PLACES, cached.machines()[clicked].bodies, strict=True))


def take_paper() -> None:
    """Put the paper's bodies back."""
    st.session_state.update(PAPER)


def scientific(value: Fraction) -> str:
    """Return a number as LaTeX in two digits and a power of ten."""
    mantissa, exponent = f"{float(value):+.1e}".split("e")
    return rf"{mantissa}\times10^{{{int(exponent)}}}"


def name(machine: BodyChoice) -> str:
    """Return the bodies in words."""
    return f"{machine.left} and {machine.right} below, {machine.top} on top"


facts, colors, oscillator = cached.condition(), look.colors(), controls.oscillator()
# On the curves stands the present machine, with its numbers.
shows_curves = not (view.hides("curve") or view.hides("numbers"))


def exactly_in_step() -> None:
    """The unit condition on the curve and as algebra."""
    st.subheader("When is the machine exactly in step?", anchor=False)
    picture, algebra = st.columns([3, 2], gap="medium")
    with algebra:
        st.markdown(
            "Beside a plain mass $m$ on the same spring $k$, the machine keeps step for ever if $\\Omega^2m/k=1$. "
            "Only the mass ratio $\\varepsilon=m'/m$ counts, rollers to the rest:"
        )
        for line in facts.equations:
            st.latex(line)
    if not shows_curves:
        return
    with picture:
        ratios, values = cached.curve(0.01, 30.0)
        st.plotly_chart(
            level_crossing(
                ratios,
                values,
                level=1.0,
                level_label="Ω² = k/m",
                root=UNIT_MASS_RATIO,
                root_label=f"<b>in step</b><br>ε = {UNIT_MASS_RATIO:.9f}…",
                present=(oscillator.mass_ratio, oscillator.normalized_frequency_squared),
                colors=colors,
            ),
            key="unit_curve",
            theme=None,
            config=STILL,
            alt=f"Ω²m/k of the paper’s machine falls with ε and is 1 at ε = {UNIT_MASS_RATIO:.9f}; with your masses, "
            f"ε = {oscillator.mass_ratio:.4g}, it is {oscillator.normalized_frequency_squared:.6g}.",
        )


@st.fragment
def digits_and_fractions() -> None:
    """The exact ratio in any number of digits, and as fractions for the workshop."""
    decimals, fractions = st.columns([2, 3], gap="medium")
    with decimals:
        count = st.number_input(
            "Digits of ε after the point", 1, MOST_DIGITS, 100, step=10, key="digits", bind="query-params", width=260
        )
        st.code(
            number_theory.positive_root_digits(*BodyChoice().quadratic, count),
            language=None,
            wrap_lines=True,
            height=190 if count > 200 else "content",
        )
        st.caption("Exact integer arithmetic; cut off, not rounded. The digits never repeat: √ of a non-square.")
    with fractions:
        first, *others = cached.quotients()
        st.markdown(
            f"As a continued fraction $\\varepsilon=[{first};{', '.join(map(str, others))},\\dots]$. Cut it off, and "
            "no fraction with a smaller denominator is closer; weigh your rollers by one of these:"
        )
        rows = "\n".join(
            f"| ${entry.ratio.numerator}/{entry.ratio.denominator}$ "
            f"| ${entry.error.numerator}/{entry.error.denominator}\\approx{scientific(entry.error)}$ "
            f"| {entry.periods:,.0f} periods |"
            for entry in cached.practical_machines()
        )
        st.markdown(f"| $\\varepsilon$ | error $\\Omega^2m/k-1$ | a full turn off after |\n|--|--|--|\n{rows}")


@st.fragment
def two_stacks() -> None:
    """The number as two stacks of cubes."""
    st.subheader("Two stacks of cubes", anchor=False)
    st.markdown(
        f"${facts.number}={facts.cubes_latex}$. We tried 1, 2, 3, … in turn: **{facts.smallest_taxicab}** is the "
        "smallest number that is a sum of two *positive* cubes in two ways. Turn the stacks and count."
    )
    with st.container(horizontal=True, vertical_alignment="bottom"):
        apart = st.toggle("Pull the layers apart", key="apart")
        turn = st.slider("Turn", 0, 360, 305, 5, format="%d°", key="turn", width=260)
    widest = max(map(sum, facts.cubes))
    for column, cubes in zip(st.columns(len(facts.cubes)), facts.cubes, strict=True):
        sides = sorted(cubes, reverse=True)
        words = " + ".join(f"{side}³" for side in sorted(cubes))
        volumes = " + ".join(f"{side**3}" for side in sorted(cubes))
        with column:
            st.plotly_chart(
                cached.cube_stack(sides, widest=widest, apart=apart, turn=turn, colors=colors),
                key=f"cubes_{sides[0]}",
                theme=None,
                config=STILL,
                alt=f"Two cubes of unit cubes, {sides[0]} and {sides[1]} along each edge: "
                f"{words} = {volumes} = {facts.number} unit cubes.",
            )
            st.markdown(f"{volumes} = **{facts.number}**", text_alignment="center")
    st.markdown(
        f"One of the stacks stands in the quadratic itself, term by term: its discriminant $b^2-4ac$ is "
        f"${facts.expanded}={facts.term_by_term}$."
    )


def other_bodies() -> None:
    """Choosers, stage, numbers and the table of all machines."""
    st.subheader("Other bodies, other numbers", anchor=False)
    st.markdown(
        "Is it the machine or these bodies? Put others in. A body of mass $M$ resists spinning with $I=\\beta MR^2$; "
        "the further out its mass, the larger $\\beta$."
    )
    # Set out like the machine: the body on top stands above, to the right.
    pictures, above = st.columns(2, vertical_alignment="center")
    pictures.html(emblems.legend(colors["block"]))
    for column, (place, words) in zip((*st.columns(2), above), PLACES.items(), strict=True):
        column.segmented_control(
            words, list(BODIES), default=PAPER[place], required=True, key=place, bind="query-params"
        )
    chosen = [st.session_state[place] for place in PLACES]
    story = cached.story(*chosen)
    left, right, top = (float(BODIES[body]) for body in chosen)
    stage.mount(
        stage.payload(
            oscillator,
            controls.compression(),
            shape_factors={"hoop": left, "cylinder": right, "top": top},
            unity=f"1 ↔ √{story.machine.discriminant}",
        ),
        limits=controls.limits("compression"),
        watch=controls.WATCH,
        key="stage_bodies",
        layers=(),
        hide=view.on_stage(),
        on_released=controls.set_compression,
    )
    table, words = st.columns([1, 1], gap="medium")
    with words:
        told(story)
    with table:
        forty_machines(story.machine)


def told(story: cached.Story) -> None:
    """Say what the chosen bodies lead to."""
    machine = story.machine
    st.markdown(f"**{name(machine).capitalize()}**")
    st.latex(story.quadratic)
    st.latex(rf"\varepsilon = {story.root} \approx {story.ratio:.6f}")
    st.latex(story.square)
    number = machine.discriminant
    factors = "" if story.factors == str(number) else f"$={story.factors}$"
    if machine.cubes:
        cubes = f"a sum of two positive cubes, ${story.cubes}$"
        cubes = f"{cubes}, **in {len(machine.cubes)} ways**" if len(machine.cubes) > 1 else cubes
    else:
        cubes = "no sum of two positive cubes"
    st.markdown(
        f"The discriminant **{number}** {factors} is {cubes}. The field $\\mathbb{{Q}}(\\varepsilon)$ has the "
        f"discriminant **{machine.field_discriminant}**"
        + (
            ": the same number, so no other scale for $\\varepsilon$ could hide it."
            if machine.field_discriminant == number
            else ", what is left of it whatever scale you measure $\\varepsilon$ in."
        )
    )
    if not view.hides("numbers"):
        present = number_theory.normalized_frequency_squared_exact(
            *machine.bodies, Fraction(oscillator.m_prime) / Fraction(oscillator.m)
        )
        st.markdown(
            f"With your masses, $\\varepsilon={oscillator.mass_ratio:.5g}$, it has $\\Omega^2m/k={float(present):.6g}$."
        )
    with st.container(horizontal=True):
        st.button("Give it its own ratio", key="own_ratio", on_click=controls.take_ratio, args=(story.ratio,))
        st.button("The paper’s bodies", key="paper_bodies", on_click=take_paper)


def forty_machines(chosen: BodyChoice) -> None:
    """All machines in one figure."""
    machines = cached.machines()
    columns = list(BODIES)
    rows = [machines[n : n + len(columns)] for n in range(0, len(machines), len(columns))]
    pair = sorted(chosen.bodies[:2], key=columns.index)
    labels = [f"{row[0].left} + {row[0].right}" for row in rows]
    place = labels.index(" + ".join(pair)), columns.index(chosen.top)
    best = max(machines, key=lambda machine: len(machine.cubes))
    others = [machine.discriminant for machine in machines if len(machine.cubes) == 1]
    st.plotly_chart(
        cached.machine_grid(
            labels,
            columns,
            [[machine.discriminant for machine in row] for row in rows],
            [[len(machine.cubes) for machine in row] for row in rows],
            place,
            colors | {"on_hoop": "#1D2430"},
        ),
        key="machines",
        on_select=take_clicked,
        selection_mode="points",
        theme=None,
        config=STILL,
        alt=f"The discriminants of all {len(machines)} machines, ten pairs of lower rollers by four bodies on top. "
        f"Only {best.discriminant}, {name(best)}, is a sum of two positive cubes in two ways; "
        f"{' and '.join(map(str, others))} are so in one. Marked: {chosen.discriminant}, {name(chosen)}.",
    )
    st.caption(
        f"The discriminants of all {len(machines)} machines, for Ω² = k/m. Filled: a sum of two positive cubes, "
        f"{best.discriminant} in two ways, {' and '.join(map(str, others))} in one. Click on a machine to build it."
    )


def another_frequency() -> None:
    """The paper's bodies with another target."""
    st.subheader("Another frequency, another number", anchor=False)
    picture, words = st.columns([3, 2], gap="medium")
    with words:
        st.markdown("Back to the paper’s bodies: ask for $\\Omega^2m/k=p/q$ instead of 1.")
        with st.container(horizontal=True):
            most = cached.LARGEST_PART
            p = st.number_input("p", 1, most, 1, key="p", bind="query-params", width=130)
            q = st.number_input("q", 1, most, 1, key="q", bind="query-params", width=130)
        good = st.session_state.setdefault(LAST_TARGET, (1, 1))
        try:
            story = cached.story(*PAPER.values(), p, q)
            st.session_state[LAST_TARGET] = good = (p, q)
        except ValueError as problem:
            story = cached.story(*PAPER.values(), *good)
            st.warning(f"The {problem}; {p}/{q} does not. Shown is {good[0]}/{good[1]}.")
        target = story.machine.target
        st.latex(story.quadratic)
        st.latex(rf"\varepsilon = {story.root} \approx {story.ratio:.6g}")
        number = story.machine.discriminant
        square = isqrt(number) ** 2 == number
        cubes = f"a sum of cubes, ${story.cubes}$" if story.cubes else "no sum of two positive cubes"
        factors = "" if story.factors == str(number) else f"$={story.factors}$"
        st.markdown(
            f"Discriminant **{number}** {factors}: {cubes}"
            + ("; a square, so this $\\varepsilon$ is a fraction." if square else ".")
        )
        st.latex(cached.as_norm(target.numerator, target.denominator))
    if not shows_curves:
        return
    with picture:
        ratios, values = cached.curve(min(0.01, story.ratio / 3), max(30.0, 3 * story.ratio))
        st.plotly_chart(
            level_crossing(
                ratios,
                values,
                level=float(target),
                level_label=f"Ω²m/k = {target}",
                root=story.ratio,
                root_label=f"ε = {story.ratio:.6g}",
                present=(oscillator.mass_ratio, oscillator.normalized_frequency_squared),
                colors=colors,
            ),
            key="target_curve",
            theme=None,
            config=STILL,
            alt=f"Ω²m/k of the paper’s machine falls with ε and is {target} at ε = {story.ratio:.6g}.",
        )


def open_question() -> None:
    """What has a reason, what was measured, and what stays a coincidence."""
    number = facts.number
    st.subheader("Is there a reason?", anchor=False)
    st.markdown(
        "The paper ends with a question: is there “a number theoretic reason for the appearance of the number "
        f"{number}”? This much can be said."
    )
    x, y = number_theory.norm_form()
    ways = number_theory.represent_x2_plus_3y2(number)
    written = " = ".join(f"{x}^2+3\\cdot{y}^2" for x, y in reversed(ways))
    primes = [prime for prime, _ in BodyChoice().factorization]
    rests = {prime % 3 for prime in primes}
    st.markdown("**What has a reason.** For the target $p/q$ the paper’s bodies have the discriminant")
    st.latex(cached.norm_identity())
    st.markdown(
        "up to a common square factor: always of the form $x^2+3y^2$, a *norm* of the numbers $x+y\\sqrt{-3}$. A hoop "
        "and a cylinder below are enough for that, whatever rolls on top. "
        f"For $p=q=1$ it is ${x}^2+3\\cdot{y}^2={number}$ (one of {len(ways)} ways: ${written}$). "
        f"So it is no accident that its primes, ${', '.join(map(str, primes))}$, all leave the remainder "
        f"{', '.join(map(str, rests))} on division by 3: a square-free number of this form has no others, but for 3. "
        "Cubes live in the same arithmetic: in $x^3+y^3=(x+y)(x^2-xy+y^2)$ the second factor is such a norm, too. "
        "The two should meet more often than chance has it. They do:"
    )
    progress = st.empty()
    pairs = [machine.bodies[:2] for machine in cached.machines()[:: len(BODIES)]]
    tallies = []
    for n, pair in enumerate(pairs):
        progress.progress(n / len(pairs), "Counting sums of two cubes …")
        tallies.append(cached.tally(*pair))
    progress.empty()
    at = pairs.index(BodyChoice().bodies[:2])
    paper = tallies[at]
    second = max((tally for tally in tallies if tally is not paper), key=lambda tally: tally.sums)
    smaller = [tally for tally in tallies if tally.median < paper.median]
    st.plotly_chart(
        cached.cube_counts([" + ".join(pair) for pair in pairs], [tally.sums for tally in tallies], at, colors),
        key="counts",
        theme=None,
        config=STILL,
        alt="Discriminants that are sums of two positive cubes, by pair of lower rollers: "
        + ", ".join(f"{' and '.join(tally.pair)} {tally.sums}" for tally in tallies)
        + f", each of {paper.machines}.",
    )
    st.caption(
        f"Counted here: all targets p/q up to p, q = {cached.COUNTED_PART} that every machine reaches, with each body "
        f"on top, {paper.machines} discriminants for each pair of rollers. {' and '.join(paper.pair).capitalize()} "
        f"have {paper.sums} sums of two cubes, the next pair {second.sums}. Small numbers are such sums more often, "
        f"but that is not it: {len(smaller)} other pairs have the smaller discriminants (by median)."
    )
    near = ", ".join(str(machine.discriminant) for machine in number_theory.one_change_away())
    st.markdown(
        f"**What stays a coincidence.** That the plainest target of all, 1, gives a sum of two cubes in *two* ways, "
        f"and the smallest there is. Of the {paper.machines} discriminants, {paper.taxicabs} are sums of two cubes in "
        f"two ways; nothing known singles out $p=q=1$. Change any one body and you get {near}: none of them is. A norm "
        f"says why {number} looks as it does, not why it had to be {number}."
    )


st.title(str(facts.number), anchor=False)
st.markdown(
    f"G. H. Hardy found the number of his taxicab, {facts.number}, rather dull. “No,” said Ramanujan, it is the "
    "smallest number that is a sum of two cubes in two different ways. Here it decides when a machine swings in time."
)
controls.complain(links.complaints(LINK))
exactly_in_step()
digits_and_fractions()
two_stacks()
other_bodies()
another_frequency()
open_question()
