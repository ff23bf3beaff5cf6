"""Page 3: the motion over time, its conserved quantities, its zero modes, and the required friction."""

from collections.abc import Mapping
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from typing import Any

import streamlit as st

from ramanujan.browser import stage
from ramanujan.browser.components import cursor
from ramanujan.figures import EncodedFigure
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
# Figure or slide → the layers of the stage that show its quantity.
LAYERS = {
    "displacements": ("displacements",),
    "phase_plane": ("arrows",),
    "energy": ("energy",),
    "momentum": ("arrows",),
    "forces": ("forces",),
    "friction": ("forces",),
    "normal_forces": ("forces",),
}
# Frame of reference → the slide of its displacements.
SLIDES = {"ground": "displacements", "block": "displacements_2"}
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
            with st.container(key="motion_question"):
                st.markdown(_("What moves how far? Where does the energy go? Which contact slips first?"))
        picture, words = display_mode.picture_and_words(2)
        with picture:
            scene = st.container(key="without_dials")
        with words, st.container(key="settings"):
            contacts = st.container(key="friction_limit")
            with st.container(key="initial_velocities"):
                glide, spin = choose_initial_velocities()
    setting = (machine, compression, glide, spin)
    motion = cache.record(*setting)
    largest = largest_compression(machine, MU.in_si, spacing=motion.spacing)
    friction = Friction(MU.in_si, largest, first_to_slip(machine, largest, motion.spacing))
    with scene:
        draw_machine(motion, friction)
        cursor.mount("motion")
    with contacts:
        choose_friction(*describe_friction(friction, compression))
    with figure_column:
        draw_figures(motion, friction, setting)
        if not is_projector:
            offer_files(motion, friction.coefficient)


def choose_initial_velocities() -> tuple[float, float]:
    """Draw the sliders of the initial velocities, in a fold except in the projector view; return their values.

    The fold is open where the momenta are drawn, and if the address contains an initial velocity.
    """
    moves_momenta = address.current(FIGURE) == "momentum"
    line: AbstractContextManager[Any] = nullcontext()
    if not display_mode.is_projector():
        is_open = moves_momenta or any(parameter.value for parameter in (GLIDE, SPIN))
        title = _("Give the machine an initial velocity")
        line = display_mode.fold(f"velocities_{moves_momenta}", title, expanded=is_open)
    with line:
        left, right = st.columns(2)
        with left:
            glide = widgets.page_slider(GLIDE)
        with right:
            spin = widgets.page_slider(SPIN)
        if not display_mode.is_projector():
            plots.explain_zero_modes()
    return glide, spin


def choose_friction(verdict: str, sentence: str) -> None:
    """Draw the slider of μ with its verdict, which is the line of a fold except in the projector view."""
    if display_mode.is_projector():
        widgets.page_slider(MU)
        st.markdown(verdict)
        return
    # The verdict is seen in every view. The fold is open where the forces are drawn.
    is_open = address.current(FIGURE) == "forces"
    with display_mode.fold(f"contacts_{is_open}", verdict, expanded=is_open):
        widgets.page_slider(MU)
        st.markdown(sentence)


def draw_machine(motion: Record, friction: Friction) -> None:
    """Draw the machine in motion, without the plain mass, and with a mark at each contact that slips."""
    slipping = friction.first if motion.compression > friction.largest else None
    stages.mount(
        stage.payload(
            motion.oscillator,
            motion.compression,
            initial=motion.initial,
            slipping=slipping,
            views=stage_views(),
        ),
        name="motion",
        layers=LAYERS["displacements"],
        dials=False,
        periods=cache.PERIODS,
        hide=("plain",),
    )


def stage_views() -> dict[str, dict[str, Any]]:
    """Return what the stage shows beside the open figure, or beside each slide: the quantity of this figure."""
    if not display_mode.is_projector():
        figure = address.current(FIGURE)
        frame = address.current(PLANE) if figure == "displacements" else "ground"
        return {"": {"layers": LAYERS[figure], "from": frame}}
    frames = {SLIDES["block"]: "block", "phase_plane": address.current(PLANE)}
    layers = {**LAYERS, SLIDES["block"]: LAYERS["displacements"]}
    return {slide: {"layers": names, "from": frames.get(slide, "ground")} for slide, names in layers.items()}


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
    # The address keeps the frame of reference while another view is open.
    address.update(PLANE)
    if display_mode.is_projector():
        containers = dict.fromkeys(FIGURES, nullcontext())
    else:
        containers = {view: tab for view, tab in widgets.tabs(FIGURE).items() if tab.open}
    for view, container in containers.items():
        limit = (friction.first, friction.coefficient) if view == "forces" else None
        figures = cache.figures(view, theme.current(), *setting, limit)
        with container:
            if view == "displacements":
                draw_displacements(motion, figures, setting)
            elif view == "forces":
                draw_contact_forces(motion, figures, friction)
            else:
                draw = {"energy": plots.draw_energy, "momentum": plots.draw_momentum}[view]
                with slide(view, FIGURES[view], heading=FIGURES[view]):
                    draw(motion, *figures.values())


def draw_displacements(motion: Record, figures: Mapping[str, EncodedFigure], setting: cache.ReleaseParameters) -> None:
    """Draw the displacements relative to the chosen frame, on slides relative to both, and the phase plane."""
    heading = FIGURES["displacements"]
    if display_mode.is_projector():
        for frame, title in cache.FRAMES.items():
            name = SLIDES[frame]
            with slide(name, _("{figure}: {panel}").format(figure=heading, panel=title), heading=heading):
                plots.draw_displacements(motion, figures[title], name, frame)
    else:
        # One frame of reference at a time leaves room for large curves with their names.
        above = st.container()
        frame = choose_frame()
        with above:
            plots.draw_displacements(motion, figures[cache.FRAMES[frame]], "displacements", frame)
    draw_phase_plane(motion, setting)


def draw_contact_forces(motion: Record, figures: Mapping[str, EncodedFigure], friction: Friction) -> None:
    """Draw friction and the friction coefficients that it needs, and in a fold the normal forces."""
    with slide("forces", FIGURES["forces"], heading=FIGURES["forces"]):
        plots.draw_friction(motion, figures[cache.FRICTION], friction)
    with slide("friction", _("Friction needed"), heading=_("Friction needed")):
        plots.draw_required_friction(motion, friction)
    title = _("Normal forces: the weight of the slab shifts between its rollers")
    draw_normal_forces = partial(plots.draw_normal_forces, motion, figures[cache.NORMAL_FORCE])
    if display_mode.is_projector():
        with slide("normal_forces", title, heading=title):
            draw_normal_forces()
    else:
        folded("normal_forces", title, draw_normal_forces)


def choose_frame() -> str:
    """Draw the choice of the frame of reference, and return its name."""
    return widgets.segmented_control(PLANE, _("Frame of reference"), label_visibility="collapsed")


def draw_phase_plane(motion: Record, setting: cache.ReleaseParameters) -> None:
    """Draw the phase plane below its line, in the projector view on a slide with its frame."""
    if not display_mode.is_projector():
        figure = cache.phase_plane(address.current(PLANE), theme.current(), *setting)
        draw = partial(plots.draw_phase_plane, motion, address.current(PLANE), figure)
        title = _("Phase plane: velocity over displacement")
        folded("phase_plane", title, draw, plots.explain_phase_plane)
        return
    with slide("phase_plane", _("Phase plane"), heading=_("Phase plane")):
        frame = choose_frame()
        plots.draw_phase_plane(motion, frame, cache.phase_plane(frame, theme.current(), *setting))
        plots.explain_phase_plane()


if __name__ == "__main__":
    show()
