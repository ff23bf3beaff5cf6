"""Page 3: the motion over time, its conserved quantities, its zero modes, and the required friction."""

from contextlib import AbstractContextManager, nullcontext
from functools import partial
from typing import Any

import streamlit as st

from ramanujan.browser import stage
from ramanujan.browser.components import cursor
from ramanujan.pages.motion import cache, plots
from ramanujan.pages.motion.files import sheet
from ramanujan.pages.motion.plots import Friction
from ramanujan.physics.contact import first_to_slip, largest_compression
from ramanujan.physics.record import Record
from ramanujan.shell import address, display_mode, sidebar, stages, theme, widgets
from ramanujan.shell.display_mode import columns, folded, slide
from ramanujan.shell.parameters import GLIDE, PARAMETERS, SPIN, Parameter
from ramanujan.text.numerals import filled, fixed
from ramanujan.text.translation import _

MU = Parameter("mu", "μ", _("Coefficient of static friction"), "", 0.01, 1.5, 0.1, 0.01, "%.2f")
FIGURES = {
    "displacements": _("Displacements"),
    "energy": _("Energy"),
    "momentum": _("Momentum"),
    "forces": _("Contact forces"),
}
FIGURE = address.Choice("figure", FIGURES, "displacements")
PLANE = address.Choice("plane", cache.FRAMES, "ground")
URL_PARAMETERS = (GLIDE, SPIN, MU, FIGURE, PLANE)


def show() -> None:
    """Draw the page: machine and settings beside the figures, and below them the record as a file."""
    machine, compression = sidebar.oscillator(), sidebar.compression()
    is_projector = display_mode.is_projector()
    machine_column, figure_column = columns("machine", has_slides=True)
    with machine_column:
        st.title(_("Motion"), anchor=False)
        if not is_projector:
            st.markdown(_("What moves how far? Where does the energy go? Which contact slips first?"))
        picture, words = display_mode.picture_and_words(2)
        with picture:
            scene = st.container(key="without_dials")
        with words:
            with choose_initial_velocities():
                glide, spin = widgets.page_slider(GLIDE), widgets.page_slider(SPIN)
                if not is_projector:
                    plots.explain_zero_modes()
            contacts = st.container()
    setting = (machine, compression, glide, spin)
    motion = cache.record(*setting)
    largest = largest_compression(machine, MU.in_si, spacing=motion.spacing)
    friction = Friction(MU.in_si, largest, first_to_slip(machine, largest, motion.spacing))
    with scene:
        draw_machine(motion, friction)
        cursor.mount("motion")
    if not is_projector:
        # The line of the fold is the verdict, in every view. It is open where the forces are drawn.
        is_open = address.current(FIGURE) == "forces"
        heading, sentence = describe_friction(friction, compression)
        with contacts, display_mode.fold(f"contacts_{is_open}", heading, expanded=is_open):
            widgets.page_slider(MU)
            st.markdown(sentence)
    with figure_column:
        draw_figures(motion, friction, setting)
        if not is_projector:
            offer_files(motion, friction.coefficient)


def choose_initial_velocities() -> AbstractContextManager[Any]:
    """Return the fold of the initial velocities, open if the address contains one; no fold in the projector view."""
    if display_mode.is_projector():
        return nullcontext()
    is_open = any(parameter.value for parameter in (GLIDE, SPIN))
    title = _("Give the machine an initial velocity")
    return display_mode.fold("velocities", title, expanded=is_open)


def draw_machine(motion: Record, friction: Friction) -> None:
    """Draw the machine in motion, without the plain mass, and with a mark at each contact that slips."""
    slipping = friction.first if motion.compression > friction.largest else None
    stages.mount(
        stage.payload(motion.oscillator, motion.compression, initial=motion.initial, slipping=slipping),
        name="motion",
        layers=("forces",),
        dials=False,
        periods=cache.PERIODS,
        hide=("plain",),
    )


def describe_friction(friction: Friction, compression: float) -> tuple[str, str]:
    """Return whether every contact rolls, and up to which compression."""
    # An alert of Streamlit would be a second live region, and the stage already announces the slipping contact.
    if compression <= friction.largest:
        heading = _(":green[:material/check_circle: **Every contact rolls without slipping.**]")
        sentence = _(
            "With μ\u00a0=\u00a0{mu} this is true up to the compression x₀\u00a0=\u00a0{largest:3↓ cm}. Beyond that, "
            "the contact between **{contact}** slips first."
        )
    else:
        heading = _(":red[:material/error: **The model no longer holds.**]")
        sentence = _(
            "With μ\u00a0=\u00a0{mu}, the contact between **{contact}** slips from the compression "
            "x₀\u00a0=\u00a0{largest:3↑ cm} on. The picture still shows rolling."
        )
    values = {"mu": fixed(friction.coefficient, 2), "largest": 100 * friction.largest}
    return heading, filled(sentence, **values, contact=cache.CONTACTS[friction.first])


def offer_files(motion: Record, mu: float) -> None:
    """Offer the record as a CSV file, beside a sentence on its contents."""
    settings = [(parameter.label, parameter.value) for parameter in (*PARAMETERS.values(), GLIDE, SPIN, MU)]
    with st.container(horizontal=True, vertical_alignment="center"):
        icon = ":material/table:"
        widgets.download(_("CSV"), sheet(motion, mu, settings), "ramanujan motion.csv", "text/csv", icon=icon)
        st.caption(_("All numbers of this page, in SI units, as a file that a spreadsheet opens, and NumPy, too"))


def draw_figures(motion: Record, friction: Friction, setting: cache.ReleaseParameters) -> None:
    """Draw the figures of the open view, or in the projector view a slide for each figure."""
    draw_functions = {
        "displacements": plots.draw_displacements,
        "energy": plots.draw_energy,
        "momentum": plots.draw_momentum,
        "forces": plots.draw_contact_forces,
    }
    is_projector = display_mode.is_projector()
    # The address keeps the frame of reference while another view is open.
    address.update(PLANE)
    if is_projector:
        containers = dict.fromkeys(FIGURES, nullcontext())
    else:
        containers = {view: tab for view, tab in widgets.tabs(FIGURE).items() if tab.open}
    for view, container in containers.items():
        has_frames = view == "displacements"
        figures = cache.figures(view, theme.current(), *setting, is_split=is_projector or has_frames)
        with container:
            if has_frames and not is_projector:
                # One frame of reference at a time leaves room for large curves with their names.
                title = cache.FRAMES[choose_frame()]
                figures = {title: figures[title]}
            for number, (panels, figure) in enumerate(figures.items(), start=1):
                name = view if number == 1 else f"{view}_{number}"
                title = _("{figure}: {panel}").format(figure=FIGURES[view], panel=panels)
                with slide(name, title if len(figures) > 1 else FIGURES[view], heading=FIGURES[view]):
                    draw_functions[view](motion, figure, name)
            if has_frames:
                draw_phase_plane(motion, setting)
            if view == "forces":
                with slide("friction", _("Friction needed"), heading=_("Friction needed")):
                    plots.draw_required_friction(motion, friction)
                    if is_projector:
                        widgets.page_slider(MU)
                        st.markdown(describe_friction(friction, motion.compression)[0])


def choose_frame() -> str:
    """Draw the choice of the frame of reference, and return its name."""
    return widgets.segmented_control(PLANE, _("Frame of reference"), label_visibility="collapsed")


def draw_phase_plane(motion: Record, setting: cache.ReleaseParameters) -> None:
    """Draw the phase plane below its line, in the projector view on a slide with its frame."""
    if not display_mode.is_projector():
        figure = cache.phase_plane(address.current(PLANE), theme.current(), *setting)
        draw = partial(plots.draw_phase_plane, motion, address.current(PLANE), figure)
        title = _("Phase plane: the velocity of each body over its displacement")
        folded("phase_plane", title, draw, plots.explain_phase_plane)
        return
    with slide("phase_plane", _("Phase plane"), heading=_("Phase plane")):
        frame = choose_frame()
        plots.draw_phase_plane(motion, frame, cache.phase_plane(frame, theme.current(), *setting))
        plots.explain_phase_plane()


if __name__ == "__main__":
    show()
