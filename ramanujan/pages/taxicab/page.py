"""Page 4: why 1729. The algebra, two stacks of cubes, other targets, other bodies, the open question."""

import streamlit as st

from ramanujan.pages.taxicab import cache, other_bodies, other_targets
from ramanujan.pages.taxicab.cache import PAPER
from ramanujan.shell import sidebar
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
    """Draw the story of the number, and beside it the algebra that leads to it, above its two stacks of cubes."""
    words, figure = columns("in_step")
    with slide("in_step", _("In step")), words:
        st.title(str(PAPER.discriminant), anchor=False)
        sentence = _(
            "G. H. Hardy found the number of his taxicab, {number}, rather dull. “No,” said Ramanujan: it is the "
            "smallest number that is a sum of two cubes in two different ways. Here the same number decides when "
            "two oscillators stay in step."
        )
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
        st.latex(cache.unit_equations())
        draw_stacks()


if __name__ == "__main__":
    show()
