"""Page 4: why 1729. The algebra, two stacks of cubes, other targets, other bodies, the open question."""

import streamlit as st

from ramanujan.pages.taxicab import cache, other_bodies, other_targets
from ramanujan.pages.taxicab.cache import PAPER
from ramanujan.shell import sidebar, theme
from ramanujan.shell.display_mode import columns, slide
from ramanujan.shell.sections.cubes import draw_stacks
from ramanujan.text.translation import _

URL_PARAMETERS = (*other_bodies.URL_PARAMETERS, *other_targets.URL_PARAMETERS)


def show() -> None:
    """Draw the page."""
    draw_reason()
    other_targets.draw_other_target()
    other_bodies.draw_other_bodies()
    other_targets.draw_open_question()
    sidebar.set_dependent_fragments(*other_bodies.DEPENDENT_FRAGMENTS, *other_targets.DEPENDENT_FRAGMENTS)


def draw_reason() -> None:
    """Draw what the page shows and, beside it, the algebra that leads to the number, above its two stacks of cubes."""
    words, figure = columns("in_step")
    with slide("in_step", _("In step")), words:
        st.title(str(PAPER.discriminant), anchor=False)
        aim = _(
            "At exactly one mass ratio, the machine stays in step with a plain mass on the same spring. The equation "
            "for this ratio leads to the number {number}."
        )
        story = _(
            "G. H. Hardy found {number}, the number of his taxicab, rather dull. “No,” said Ramanujan: it is the "
            "smallest number that is a sum of two cubes in two different ways."
        )
        for sentence in (aim, story):
            st.markdown(sentence.format(number=PAPER.discriminant))
        st.header(_("When is the machine in step?"), anchor=False)
        st.markdown(
            _(
                "The machine has the angular frequency $\\Omega$, a plain mass $m$ on the same spring $k$ has "
                "$\\sqrt{{k/m}}$. They stay in step for ever if $\\Omega^2m/k=1$. Only the ratio $\\varepsilon=m'/m$ "
                "matters: the mass of a lower roller divided by the mass of the others."
            )
        )
        with st.skeleton(height=60):
            equation = cache.frequency_equation()
        st.latex(equation)
    with slide("cubes", _("Two stacks of cubes")), figure:
        st.markdown(_("If $\\Omega^2m/k=1$, the mass ratio $\\varepsilon$ solves a quadratic equation:"))
        equations, meaning = st.columns(2, gap="medium", vertical_alignment="center")
        with equations:
            colors = theme.colors()
            st.latex(cache.unit_equations(colors["primary"], colors["paper"]))
        with meaning:
            smaller, larger = PAPER.cubes[0]
            sentence = _(
                "The right side is the discriminant $b^2-4ac$ of the quadratic equation. Its two terms are cubes, "
                "${one}={x}^3$ and ${other}={y}^3$: the left stack. The right stack has as many unit cubes. Why the "
                "machine leads to a number of this kind is not known."
            )
            st.markdown(sentence.format(one=smaller**3, x=smaller, other=larger**3, y=larger))
        draw_stacks()


if __name__ == "__main__":
    show()
