"""Page 4: why 1729. The algebra, two stacks of cubes, other targets, other bodies, the open question."""

import streamlit as st

from ramanujan.pages.taxicab import cache, other_bodies, other_targets
from ramanujan.pages.taxicab.cache import PAPER
from ramanujan.shell import sidebar, theme
from ramanujan.shell.display_mode import is_projector, slide
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
    """Draw the algebra from the machine in step to the number and, beside it, the number as two stacks of cubes."""
    with slide("in_step", _("In step")), st.container(key="in_step"):
        algebra, picture = st.columns([3, 4], gap="medium")
    with algebra:
        st.title(str(PAPER.discriminant), anchor=False)
        st.header(_("When is the machine in step?"), anchor=False)
        st.markdown(
            _(
                "The machine, with the angular frequency $\\Omega$, stays in step with a plain mass $m$ on the same "
                "spring $k$ if $\\Omega^2=k/m$. Only $\\varepsilon=m'/m$ matters: the mass of a lower roller divided "
                "by the mass of the others."
            )
        )
        colors = theme.colors()
        with st.skeleton(height=300):
            equations = cache.unit_equations(colors["primary"], colors["paper"])
        st.latex(equations)
    with picture:
        draw_stacks()
        story = _(
            "G. H. Hardy found {number}, the number of his taxicab, rather dull. “No,” said Ramanujan: it is the "
            "smallest number that is a sum of two positive cubes in two different ways."
        )
        st.markdown(story.format(number=PAPER.discriminant))
        if not is_projector():
            smaller, larger = PAPER.cubes[0]
            meaning = _(
                "The number is the discriminant $b^2-4ac$ of the quadratic equation, with $a={a}$, $b={b}$ and "
                "$c={c}$. Its two terms are cubes, ${one}={x}^3$ and ${other}={y}^3$: the left stack. The right stack "
                "has as many unit cubes."
            )
            a, b, c = PAPER.quadratic
            st.markdown(meaning.format(a=a, b=b, c=c, one=smaller**3, x=smaller, other=larger**3, y=larger))


if __name__ == "__main__":
    show()
