"""Page 4: why 1729. The exact mass ratio, two stacks of cubes, other bodies, other targets, the open question."""

from fractions import Fraction

import streamlit as st

from ramanujan import number_theory
from ramanujan.numerals import DECIMAL, in_latex, number
from ramanujan.pages.taxicab import cache, other_bodies, other_targets
from ramanujan.pages.taxicab.cache import PAPER
from ramanujan.shell import address, sidebar, widgets
from ramanujan.shell.display_mode import columns, folded, hides, picture_and_words, slide
from ramanujan.shell.sections.cubes import draw_stacks
from ramanujan.translation import _, ngettext

DIGITS = address.Count("digits", number_theory.integers.MOST_DIGITS, default=100)
URL_PARAMETERS = (*other_bodies.URL_PARAMETERS, *other_targets.URL_PARAMETERS, DIGITS)
FOLDED_PARAMETERS = ("k", "compression")


def show() -> None:
    """Draw the page."""
    draw_condition()
    title = _("The exact ratio to a thousand digits, and the fractions closest to it")
    folded("digits", title, draw_digits, expanded=address.current(DIGITS) != DIGITS.default)
    with slide("cubes", _("Two stacks of cubes")):
        draw_both_stacks()
    other_bodies.draw_other_bodies()
    other_targets.draw_open_question()
    sidebar.set_dependent_fragments(*other_bodies.DEPENDENT_FRAGMENTS, *other_targets.DEPENDENT_FRAGMENTS)


def draw_condition() -> None:
    """Draw the story of the taxicab, and the unit condition as algebra and on the curve. Other targets are folded."""
    condition = slide("in_step", _("In step"))
    curve = condition if hides("curve", "numbers") else slide("curve", _("The curve"))
    with condition:
        st.title(str(PAPER.discriminant), anchor=False)
    words, figure = columns("in_step")
    with condition, words:
        sentence = _(
            "G. H. Hardy found the number of his taxicab, {number}, rather dull. “No,” said Ramanujan: it is the "
            "smallest number that is a sum of two cubes in two different ways. Here the same number decides when two "
            "oscillators stay in step."
        )
        st.markdown(sentence.format(number=PAPER.discriminant))
        st.header(_("At which mass ratio is the machine exactly in step?"), anchor=False)
        st.markdown(
            _(
                "The machine has the angular frequency $\\Omega$, a plain mass $m$ on the same spring $k$ has "
                "$\\sqrt{{k/m}}$. They stay in step for ever if $\\Omega^2m/k=1$. Only the ratio $\\varepsilon=m'/m$ "
                "matters: the mass of a lower roller divided by the mass of the others."
            )
        )
    with curve, figure:
        other_targets.draw_curve()
    with condition, figure:
        with st.skeleton(height=243):
            equations = cache.unit_equations()
        for line in equations:
            st.latex(line)
    with curve:
        other_targets.draw_other_target()


def draw_digits() -> None:
    """Draw the exact ratio with any number of digits, and its fractions for the workshop."""
    decimals, fractions = columns("ratios")
    with decimals:
        box, code = picture_and_words(1)
        with box:
            count = widgets.count(DIGITS, _("Digits of ε after the decimal point"), step=10, width=330)
        digits = number_theory.positive_root_digits(*PAPER.quadratic, count)
        with code:
            st.code(digits.replace(".", DECIMAL), language=None, wrap_lines=True)
        sentence = _(
            "Computed with exact integers; the digits are cut off, not rounded. They never become periodic, because "
            "the square root of {number} is irrational."
        )
        st.caption(sentence.format(number=PAPER.discriminant))
    with fractions:
        first, *others = cache.quotients()
        sentence = _(
            "As a continued fraction, $\\varepsilon=[{first};{others},\\dots]$. Cut off after any term, it gives a "
            "fraction, and no other with such a small denominator is closer. A workshop could use these:"
        )
        st.markdown(sentence.format(first=first, others=", ".join(map(str, others))))
        widgets.table(table_of_ratios(), "ratios")


def table_of_ratios() -> list[tuple[str, ...]]:
    """Return the table of ratios for the workshop, as rows of Markdown."""
    rows: list[tuple[str, ...]] = [
        (_("ratio $\\varepsilon$"), _("error $\\Omega^2m/k-1$"), _("one full turn apart after"))
    ]
    for ratio, error, periods in cache.practical_machines():
        duration = ngettext("{n} period", "{n} periods", round(periods)).format(n=number(round(periods), 4))
        error_text = f"{error.numerator}/{error.denominator}\\approx{scientific(error)}"
        rows.append((f"${ratio.numerator}/{ratio.denominator}$", f"${{{error_text}}}$", duration))
    return rows


def scientific(value: Fraction) -> str:
    """Return a number as LaTeX in two digits and a power of ten."""
    mantissa, exponent = f"{float(value):+.1e}".split("e")
    return rf"{in_latex(mantissa)}\times10^{{{int(exponent)}}}"


def draw_both_stacks() -> None:
    """Draw the number as two stacks of cubes."""
    st.header(_("Two stacks of cubes"), anchor=False)
    sentence = _(
        "${number}={cubes}$. This page has tried 1, 2, 3, … in turn: **{smallest}** is the smallest number that is a "
        "sum of two *positive* cubes in two ways. Turn the stacks and count."
    )
    sums, smallest = cache.sums_of_cubes(PAPER.cubes), number_theory.smallest_taxicab()
    words, figure = columns("stacks")
    with words:
        st.markdown(sentence.format(number=PAPER.discriminant, cubes=sums, smallest=smallest))
    with figure:
        draw_stacks()
    expanded, same_terms = cache.discriminant_written_out()
    sentence = _(
        "One of the two sums can be read off the quadratic, term by term. Its discriminant $b^2-4ac$ is "
        "${expanded}={sum}$."
    )
    with words:
        st.markdown(sentence.format(expanded=expanded, sum=same_terms))


if __name__ == "__main__":
    show()
