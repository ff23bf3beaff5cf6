"""The section of page 2 on the three normal modes and their conserved quantities."""

import streamlit as st

from ramanujan.browser import stage
from ramanujan.derivation.numbers import Numbers
from ramanujan.pages.derivation import cache
from ramanujan.physics.motion import InitialState
from ramanujan.shell import sidebar, stages
from ramanujan.shell.display_mode import columns, is_projector
from ramanujan.text.translation import _

MODES = stages.url_parameters("modes_")
"""The URL parameters for the view of the three machines."""


def draw_modes(numbers: Numbers | None) -> None:
    """Draw the three modes in three columns."""
    st.header(_("Three normal modes, one of which oscillates"), anchor=False)
    words, formulas = columns("modes")
    zero_modes = _(
        "A mode that does not deform the spring has $\\omega=0$. It is called a zero mode, and it conserves a momentum."
    )
    with words:
        if is_projector():
            st.markdown(zero_modes)
        else:
            shape_and_frequency = _(
                "The mode shape $v$ lists the amplitudes of $X$, $\\varphi$ and $\\Phi$ in proportion, and $\\omega$ "
                "is the mode’s angular frequency."
            )
            st.markdown(f"{shape_and_frequency} {zero_modes}")
    shapes, momenta = cache.spectrum(numbers)
    if not is_projector():
        with formulas:
            st.latex(momenta)
    modes = (
        (
            "swing",
            _("The machine oscillates"),
            _("Here $\\omega=\\Omega$, and all three coordinates oscillate with this one frequency."),
            _("A machine released at rest keeps $p_X=p_\\Phi=0$, so it moves in this mode alone."),
        ),
        (
            "glide",
            _("The whole machine glides"),
            _("$\\omega=0$. No force depends on the position of the machine on the floor, so $p_X$ is conserved."),
            _("$-p_X$ is the momentum of the whole machine, positive to the right."),
        ),
        (
            "roll",
            _("The top cylinder rolls freely"),
            _("$\\omega=0$. No force depends on the angle of the top cylinder, so $p_\\Phi$ is conserved."),
            _("It is the angular momentum of the top cylinder about its line of contact with the block."),
        ),
    )
    for column, (key, title, finding, detail), shape in zip(st.columns(3), modes, shapes, strict=True):
        with column:
            stages.mount(
                None, key=f"mode_{key}", clock="modes", layers=(), compact=True, label=title, address_prefix="modes_"
            )
            st.latex(shape)
            # A slide has no room for both sentences below large machines.
            st.markdown(finding if is_projector() else f"{finding} {detail}")
    publish_machine()


@st.fragment(key="modes")
def publish_machine() -> None:
    """Publish the machine to the three stages. A slider reruns only this fragment of the section."""
    machine, compression = sidebar.oscillator(), sidebar.compression()
    # A speed that the eye can follow: half of x₀ in the time of one period.
    speed = compression / 2 / machine.period
    starts = {"swing": None, "glide": InitialState(X_dot=speed), "roll": InitialState(Phi_dot=speed / machine.radius)}
    for key, initial in starts.items():
        stages.publish(stage.payload(machine, compression, initial=initial), key=f"mode_{key}")
