"""The sections of page 4 on other target frequencies and on the paper's open question."""

from fractions import Fraction
from math import isqrt

import streamlit as st

from ramanujan.figures import taxicab_page as figures
from ramanujan.pages.taxicab import cache
from ramanujan.pages.taxicab.cache import PAPER
from ramanujan.pages.taxicab.other_bodies import describe_cubes
from ramanujan.shell import address, display_mode, drawings, sidebar, theme, widgets
from ramanujan.shell.display_mode import columns, picture_and_words, slide
from ramanujan.text.numerals import filled, number
from ramanujan.text.translation import _

P, Q = (address.Count(part, cache.LARGEST_PART, default) for part, default in (("p", 3), ("q", 16)))
URL_PARAMETERS = (P, Q)
_LAST = "last_target"
"""Session state: p and q of the last target that a machine reaches."""
DEPENDENT_FRAGMENTS = ("unit_curve",)
"""Keys of the fragments that depend on the machine of the sidebar."""
DISCRIMINANT = r"(48q-7p)^2+3\,(4p)^2"
"""The discriminant of the paper's machine for the target p/q, times a square, as LaTeX."""


def draw_other_target() -> None:
    """Draw the options for another target of the paper's machine, and the result in words and on the curve."""
    with slide("curve", _("Another frequency")):
        words, figure = columns("target")
        picture_column, words_column = picture_and_words(2)
        with words, words_column:
            st.header(_("Another frequency, another number"), anchor=False)
            st.markdown(_("Choose another target, $\\Omega^2m/k=p/q$."))
            with st.container(horizontal=True):
                p = widgets.count(P, _("p"), width=170)
                q = widgets.count(Q, _("q"), width=170)
            results = _current_results()
            target = results.machine.target
            if target != Fraction(p, q):
                sentence = _(
                    "The target must be between 0 and {most}, the value for very light rollers. {p}/{q} is not, so "
                    "{old_p}/{old_q} is shown."
                )
                old_p, old_q = target.numerator, target.denominator
                st.warning(sentence.format(most=cache.UPPER_LIMIT, p=p, q=q, old_p=old_p, old_q=old_q))
            describe_target(results)
        with figure, picture_column:
            draw_curve()


def _current_results() -> cache.Results:
    """Return the results for the selected target. If no machine reaches it, return those for the previous target."""
    try:
        results = cache.results(*PAPER.bodies, address.current(P), address.current(Q))
    except ValueError:
        return cache.results(*PAPER.bodies, *st.session_state.get(_LAST, (P.default, Q.default)))
    target = results.machine.target
    st.session_state[_LAST] = (target.numerator, target.denominator)
    return results


def describe_target(results: cache.Results) -> None:
    """Describe the results for the target. The equations for the target 1 are above."""
    discriminant = results.machine.discriminant
    if results.machine == PAPER:
        st.latex(rf"\varepsilon = {results.root}")
        return
    st.latex(results.quadratic)
    st.latex(rf"\varepsilon = {results.root}")
    sentences = [describe_cubes(results)]
    if isqrt(discriminant) ** 2 == discriminant:
        sentences.append(_("The discriminant is a square, so this $\\varepsilon$ is a fraction."))
    st.markdown(" ".join(sentences))
    st.markdown(_describe_rarity())


def _describe_rarity() -> str:
    """Name the simple targets whose discriminant is a sum of two cubes."""
    targets = cache.small_targets()
    # TRANSLATORS: {n} counts the sums of two cubes that are equal to the number of this target.
    several = _("{target} (in {n} ways)")
    names = []
    for machine in targets:
        ways = len(machine.cubes)
        if ways:
            names.append(several.format(target=machine.target, n=ways) if ways > 1 else str(machine.target))
    sentence = _(
        "Such sums are rare: of the {count} targets with $p$ and $q$ up to {most}, only these lead to one: {names}."
    )
    return sentence.format(count=len(targets), most=cache.SMALL_PART, names=", ".join(names))


@st.fragment(key="unit_curve")
def draw_curve() -> None:
    """Draw the paper's curve, the target on it, and the current machine, unless the link hides them."""
    if display_mode.hides("curve", "numbers"):
        return
    results, machine = _current_results(), sidebar.oscillator()
    target = results.machine.target
    present = machine.mass_ratio, machine.normalized_frequency_squared
    level, ratio = f"Ω²m/k = {target}", number(results.ratio, 7)
    # The curve contains the target and the current machine, and beside the target there is room for its label.
    most = max(2 * results.ratio, 1.1 * machine.mass_ratio)
    figure = figures.draw_level_crossing(
        *cache.curve(most),
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


def draw_open_question() -> None:
    """Draw the paper's open question: what is known, what is not, and what stays a coincidence.

    The tests of this page prove the formula and count the numbers in these sentences.
    """
    with slide("reason", _("Is there a reason?")):
        words, figure = columns("reason")
        picture_column, words_column = picture_and_words(2)
        with words, words_column:
            st.header(_("Is there a reason?"), anchor=False)
            st.markdown(
                _(
                    "**Known.** With a hoop and a cylinder below, the number is always a square plus three times a "
                    "square: $1729=41^2+3\\cdot4^2$. Such numbers are often sums of two cubes."
                )
            )
            st.markdown(
                _(
                    "**Not known.** Why is 1729 such a sum in two ways, and even the smallest such number? The paper "
                    "asks for “a number theoretic reason”. None is known."
                )
            )
            st.markdown(
                _(
                    "**A coincidence?** The simplest target, 1, gives this number. If you change any one body, no sum "
                    "of two cubes is left."
                )
            )
            if not display_mode.is_projector():
                with st.expander(_("Known in detail")):
                    _describe_known_form()
        with figure, picture_column:
            st.markdown(_("Only at the marked points are $x$ and $y$ whole numbers."))
            alternative = _("The curve x³ + y³ = {number}. It passes through the points of the sums {sums}.")
            sums = ", ".join(f"{x}³ + {y}³" for x, y in PAPER.cubes)
            drawings.plot(
                figures.draw_sums_of_cubes(PAPER.discriminant, PAPER.cubes, theme.colors()),
                "sums",
                alternative.format(number=PAPER.discriminant, sums=sums),
            )


def _describe_known_form() -> None:
    """Describe the form of the discriminant, and relate it to sums of two cubes."""
    st.markdown(_("For the paper’s machine and $\\Omega^2m/k=p/q$ the discriminant is, up to a square factor:"))
    st.latex(DISCRIMINANT)
    st.markdown(
        _(
            "The target 1 gives the first of the four ways to write 1729 in this form: $41^2+3\\cdot4^2$ "
            "$=31^2+3\\cdot16^2$ $=23^2+3\\cdot20^2$ $=1^2+3\\cdot24^2$."
        )
    )
    st.markdown(
        _(
            "In $x^3+y^3=(x+y)(x^2-xy+y^2)$, the last factor has the same form. Over many targets, these rollers lead "
            "to 22 sums of two cubes, any other pair to at most 12."
        )
    )
