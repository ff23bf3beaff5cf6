"""The sections of page 4 on other target frequencies and on the paper's open question."""

from fractions import Fraction
from math import isqrt

import streamlit as st

from ramanujan import number_theory
from ramanujan.figures import taxicab as figures
from ramanujan.numerals import filled, number
from ramanujan.pages.taxicab import cache
from ramanujan.pages.taxicab.cache import PAPER
from ramanujan.pages.taxicab.other_bodies import describe_cubes, pair_name, roller_pairs
from ramanujan.shell import address, display_mode, drawings, sidebar, theme, widgets
from ramanujan.shell.display_mode import columns, slide
from ramanujan.translation import _, ngettext

P, Q = (address.Count(part, cache.LARGEST_PART) for part in ("p", "q"))
URL_PARAMETERS = (P, Q)
_LAST = "last_target"
"""Session state: p and q of the last target that a machine reaches."""
DEPENDENT_FRAGMENTS = ("unit_curve",)
"""Keys of the fragments that depend on the machine of the sidebar."""


def draw_other_target() -> None:
    """Draw the options for another target of the paper's machine, and describe the result."""
    title = _("Another frequency, another number: choose $\\Omega^2m/k=p/q$")
    is_other_target = (address.current(P), address.current(Q)) != (1, 1)
    with st.expander(title, expanded=is_other_target):
        with st.container(horizontal=True):
            p = widgets.count(P, _("p"), width=130)
            q = widgets.count(Q, _("q"), width=130)
        results = _current_results()
        target = results.machine.target
        if target != Fraction(p, q):
            most = number_theory.normalized_frequency_squared_exact(*PAPER.bodies, 0)
            sentence = _(
                "The target must be between 0 and {most}, the value for very light rollers. {p}/{q} is not, so "
                "{old_p}/{old_q} is shown."
            )
            st.warning(sentence.format(most=most, p=p, q=q, old_p=target.numerator, old_q=target.denominator))
        describe_target(results)


def _current_results() -> cache.Results:
    """Return the results for the selected target. If no machine reaches it, return those for the previous target."""
    try:
        results = cache.results(*PAPER.bodies, address.current(P), address.current(Q))
    except ValueError:
        return cache.results(*PAPER.bodies, *st.session_state.get(_LAST, (1, 1)))
    target = results.machine.target
    st.session_state[_LAST] = (target.numerator, target.denominator)
    return results


def describe_target(results: cache.Results) -> None:
    """Describe the results for the target."""
    target, discriminant = results.machine.target, results.machine.discriminant
    st.latex(results.quadratic)
    st.latex(rf"\varepsilon = {results.root}")
    sentences = [describe_cubes(results)]
    if isqrt(discriminant) ** 2 == discriminant:
        sentences.append(_("The discriminant is a square, so this $\\varepsilon$ is a fraction."))
    st.markdown(" ".join(sentences))
    st.latex(cache.as_norm(target.numerator, target.denominator))


@st.fragment(key="unit_curve")
def draw_curve() -> None:
    """Draw the paper's curve, the target on it, and the current machine, unless the link hides them."""
    if display_mode.hides("curve", "numbers"):
        return
    results, machine = _current_results(), sidebar.oscillator()
    target = results.machine.target
    present = machine.mass_ratio, machine.normalized_frequency_squared
    level, ratio = f"Ω²m/k = {target}", number(results.ratio, 10)
    # The curve contains the target and the current machine.
    least = min(results.ratio / 2, 0.9 * machine.mass_ratio)
    most = max(2 * results.ratio, 1.1 * machine.mass_ratio)
    figure = figures.draw_level_crossing(
        *cache.curve(least, most),
        level=float(target),
        level_label=_("in step: {level}").format(level=level) if target == 1 else level,
        root=results.ratio,
        root_label=f"<i>ε</i> = {ratio}",
        present=present,
        colors=theme.colors(),
    )
    alternative = _(
        "Ω²m/k of the paper’s machine falls as ε grows, so one mass ratio reaches the target {target}: ε = {root}. "
        "With your masses, ε = {present[0]:4}, it is {present[1]:7}."
    )
    drawings.plot(figure, "unit_curve", filled(alternative, target=target, root=ratio, present=present))


# ---- the open question


def draw_open_question() -> None:
    """Draw the open question: the known facts, a count that supports them, and the remaining coincidences."""
    with slide("reason", _("Is there a reason?")):
        st.header(_("Is there a reason?"), anchor=False)
        sentence = _(
            "**Known:** the machine’s bodies give {number} the form $x^2+3y^2$, and numbers of this form are often "
            "sums of two cubes. **Not known:** why {number} is such a sum in two ways, and the smallest number that "
            "is. **An answer would be** a property of the machine from which both sums follow. The paper leaves this "
            "open: it asks for “a number theoretic reason for the appearance of the number {number}”."
        )
        known, reason = columns("reason")
        with known:
            st.markdown(sentence.format(number=PAPER.discriminant))
        with reason:
            explain_form()
        explain_norm()
    with slide("norm", _("{number} as a norm").format(number=PAPER.discriminant)):
        describe_norm()
    pairs = roller_pairs()
    paper = pairs.index((PAPER.left, PAPER.right))
    with slide("counts", _("A count")):
        tallies = _count_cubes(pairs)
        words, figure = columns("counts")
        with words:
            st.markdown(
                _(
                    "**A count confirms it.** The paper’s lower rollers lead to sums of two cubes more often than any "
                    "others."
                )
            )
        with figure:
            draw_counts(tallies, paper)
    with slide("coincidences", _("What stays a coincidence")), words:
        name_coincidences(tallies[paper])


def explain_form() -> None:
    """Explain which bodies lead to a discriminant of the form x² + 3y²."""
    x, y = number_theory.norm_coordinates()
    sentence = _(
        "**Where the form comes from.** The discriminant of the paper’s machine is ${x}^2+3\\cdot{y}^2={number}$. A "
        "hoop and a cylinder as lower rollers always lead to the form $x^2+3y^2$, whatever rolls on top."
    )
    st.markdown(sentence.format(x=x, y=y, number=PAPER.discriminant))
    with st.expander(_("The same for any target, $\\Omega^2m/k=p/q$")):
        st.markdown(_("The discriminant of the paper’s machine is, up to a square factor:"))
        st.latex(cache.norm_identity())


def explain_norm() -> None:
    """Explain why the discriminant is a norm."""
    words, formula = columns("norm")
    with words:
        st.markdown(
            _(
                "**What the form means.** A number $x^2+3y^2$ is the *norm* of $x+y\\sqrt{{-3}}$: the product of this "
                "number and the same number with the other sign of the root."
            ).format()
        )
    with formula:
        st.latex(cache.norm_multiplied_out())
    words, formula = columns("product")
    with words:
        st.markdown(_("The norm of a product is the product of the norms, $N(\\alpha\\beta)=N(\\alpha)\\,N(\\beta)$:"))
    with formula:
        st.latex(cache.product_of_norms())


def describe_norm() -> None:
    """Explain the consequences of the norm for the paper's number."""
    ways = number_theory.represent_x2_plus_3y2(PAPER.discriminant)
    primes = [prime for prime, _power in PAPER.factorization]
    norms = {prime: number_theory.represent_x2_plus_3y2(prime)[0] for prime in primes}
    forms = "$ $= ".join(f"{a}^2+3\\cdot{b}^2" for a, b in reversed(ways))
    sentence = ngettext(
        "**What it says about {number}.** There is one way to write it in this form: ${written}$.",
        "**What it says about {number}.** There are {n:word} ways to write it in this form: ${written}$.",
        len(ways),
    )
    number, cubes = columns("ways")
    with number:
        st.markdown(filled(sentence, number=PAPER.discriminant, n=len(ways), written=forms))
    factors = "$, $".join(f"{prime}={a}^2+3\\cdot{b}^2" for prime, (a, b) in norms.items())
    remainder = ", ".join({str(prime % 3) for prime in primes})
    sentence = _(
        "Its prime factors are norms themselves: ${norms}$. Multiply these three, each with either sign of "
        "$\\sqrt{{-3}}$, and you get the {n:word} ways. The primes all leave the remainder {remainder} when divided by "
        "3. This is no accident: a square-free number of this form has no other prime factors, except 3."
    )
    with number:
        st.markdown(filled(sentence, norms=factors, n=len(ways), remainder=remainder))
    sentence = _(
        "**What it has to do with cubes.** They belong to the same arithmetic: in $x^3+y^3=(x+y)(x^2-xy+y^2)$ the "
        "second factor is such a norm, too. Here ${factored}$. So numbers of this form should be sums of two cubes "
        "more often than others."
    )
    with cubes:
        st.markdown(sentence.format(factored=cache.factored_cubes(PAPER.discriminant)))


def _count_cubes(pairs: list[tuple[str, str]]) -> list[cache.Tally]:
    """Return the count for each pair of lower rollers, and draw the progress."""
    progress, tallies = st.empty(), []
    for n, names in enumerate(pairs):
        progress.progress(n / len(pairs), _("Counting sums of two cubes …"))
        tallies.append(cache.tally(*names))
    progress.empty()
    return tallies


def draw_counts(tallies: list[cache.Tally], paper_index: int) -> None:
    """Draw the number of discriminants that are sums of two cubes, for each pair of lower rollers.

    Parameters
    ----------
    tallies : the counts of all pairs
    paper_index : index of the paper's pair
    """
    paper = tallies[paper_index]
    second = max((tally for tally in tallies if tally is not paper), key=lambda tally: tally.sums)
    smaller = [tally for tally in tallies if tally.median < paper.median]
    labels = [pair_name(*tally.pair) for tally in tallies]
    sums = [tally.sums for tally in tallies]
    template = _("{pair}: {sums}")
    list_of_sums = "; ".join(template.format(pair=label, sums=n) for label, n in zip(labels, sums, strict=True))
    alternative = _(
        "How many of {count} discriminants are sums of two positive cubes, by pair of lower rollers. The paper’s pair "
        "has the most. {sums}."
    )
    figure = figures.draw_cube_counts(labels, sums, paper_index, theme.colors())
    drawings.plot(figure, "counts", alternative.format(count=paper.machines, sums=list_of_sums))
    caption = _(
        "Counted for all targets p/q with p and q up to {most} that every machine reaches, and for each body on top: "
        "{paper.machines} discriminants for each pair of lower rollers. The paper’s pair, {pair}, gives {paper.sums} "
        "sums of two cubes; the next pair gives {second}. Small numbers are such sums more often, but this is not the "
        "reason here: half of this pair’s discriminants are below {paper.median:3↑}, and for {smaller:word} other "
        "pairs that limit is lower."
    )
    values = {"most": cache.COUNTED_PART, "pair": labels[paper_index], "second": second.sums, "smaller": len(smaller)}
    st.caption(filled(caption, paper=paper, **values))


def name_coincidences(paper: cache.Tally) -> None:
    """Name the remaining coincidences."""
    near = ", ".join(str(machine.discriminant) for machine in number_theory.one_change_away())
    sentence = _(
        "**What stays a coincidence.** The simplest target, 1, gives a number that is a sum of two cubes in *two* "
        "ways, even the smallest such number. Of the {count} discriminants, {taxicabs:alone} are sums of two cubes in "
        "two ways, and nothing known singles out the target 1. If you change any one body you get {near}, and none of "
        "these is such a sum. The norm explains the form of {number}, but not why it had to be {number}."
    )
    st.markdown(filled(sentence, count=paper.machines, taxicabs=paper.taxicabs, near=near, number=PAPER.discriminant))
