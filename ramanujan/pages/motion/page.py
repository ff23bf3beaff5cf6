"""Page 3: the motion over time, its conserved quantities, its zero modes, and the required friction."""

from functools import partial

import numpy as np
import streamlit as st

from ramanujan.browser import components, stage
from ramanujan.contact import first_to_slip, largest_compression
from ramanujan.numerals import filled, fixed, quantity
from ramanujan.pages.motion import cache, plots
from ramanujan.pages.motion.files import sheet
from ramanujan.pages.motion.plots import Friction
from ramanujan.record import Record, table
from ramanujan.shell import address, display_mode, sidebar, stages, theme, widgets
from ramanujan.shell.display_mode import columns, slide
from ramanujan.shell.parameters import GLIDE, PARAMETERS, SPIN, Parameter
from ramanujan.translation import _

MU = Parameter("mu", "μ", _("Coefficient of static friction"), "", 0.01, 1.5, 0.2, 0.01, "%.2f")
FIGURES = {
    "displacements": _("Displacements"),
    "energy": _("Energy"),
    "momentum": _("Momentum"),
    "forces": _("Contact forces"),
}
FIGURE = address.Choice("figure", FIGURES, "displacements")
URL_PARAMETERS = (GLIDE, SPIN, MU, FIGURE)


def show() -> None:
    """Draw the page."""
    machine, compression = sidebar.oscillator(), sidebar.compression()
    with slide("machine", _("The machine")):
        question_column, verdict_column = columns("opening")
        with question_column:
            st.title(_("Motion"), anchor=False)
            st.markdown(
                _(
                    "What moves how far, where does the energy go, and which contact slips first? Give the machine an "
                    "initial velocity, or change the friction."
                )
            )
        picture, words = display_mode.picture_and_words(2)
        with picture:
            scene = st.container(key="without_dials")
        with words:
            sliders = [partial(widgets.page_slider, parameter) for parameter in (GLIDE, SPIN, MU)]
            glide, spin, mu = widgets.draw_in_columns(
                1 if display_mode.is_projector() else 3, *sliders, alignment="bottom"
            )
        setting = (machine, compression, glide, spin)
        motion = cache.record(*setting)
        largest = largest_compression(machine, mu, spacing=motion.spacing)
        friction = Friction(mu, largest, first_to_slip(machine, largest, motion.spacing))
        with scene:
            draw_machine(motion, friction)
            if not display_mode.is_projector():
                components.cursor("motion")
        with verdict_column, st.container(key="verdict"):
            draw_verdict(friction, compression)
    # In the projector view the time cursor is on every slide.
    if display_mode.is_projector():
        components.cursor("motion")
    draw_figures(motion, friction, setting)


def draw_machine(motion: Record, friction: Friction) -> None:
    """Draw the machine in motion, with a mark at each contact that slips."""
    slipping = friction.first if motion.compression > friction.largest else None
    stages.mount(
        stage.payload(motion.oscillator, motion.compression, initial=motion.initial, slipping=slipping),
        name="motion",
        layers=("forces",),
        dials=False,
        periods=cache.PERIODS,
    )


def draw_verdict(friction: Friction, compression: float) -> None:
    """Draw whether every contact rolls. The two texts have about the same length, so that nothing else moves."""
    if compression <= friction.largest:
        sentence = _(
            ":green[:material/check_circle: **Every contact rolls without slipping.**] With μ\u00a0=\u00a0{mu} this is "
            "true up to x₀\u00a0=\u00a0{largest:3↓ cm}. Beyond that, the contact between **{contact}** slips first."
        )
    else:
        sentence = _(
            ":red[:material/error: **The model no longer holds.**] With μ\u00a0=\u00a0{mu}, the contact between "
            "**{contact}** slips from x₀\u00a0=\u00a0{largest:3↑ cm} on. The picture still shows rolling."
        )
    # An alert of Streamlit would be a second live region, and the stage already announces the slipping contact.
    values = {"mu": fixed(friction.coefficient, 2), "largest": 100 * friction.largest}
    text = filled(sentence, **values, contact=cache.CONTACTS[friction.first])
    st.container(border=True, width="content").markdown(text)


def offer_pause(motion: Record) -> None:
    """Offer a button that pauses the motion at the instant at which a contact needs the most friction."""
    instant, contact = greatest_friction(motion)
    label = _("Pause at the greatest friction ({contact}, t\u00a0=\u00a0{time})").format(
        contact=cache.CONTACTS[contact], time=quantity(instant, "s", 3)
    )
    components.moment("motion", instant, label)


def greatest_friction(motion: Record) -> tuple[float, str]:
    """Return the instant in the first period at which a contact needs the most friction [s], and the contact."""
    is_first_period = motion.t <= motion.oscillator.period
    needed = {}
    for contact, normal in motion.normal_forces.items():
        needed[contact] = (np.abs(motion.forces[contact]) / normal)[is_first_period]
    first = max(needed, key=lambda contact: needed[contact].max())
    return float(motion.t[needed[first].argmax()]), first


def offer_files(motion: Record, mu: float) -> None:
    """Offer the record as a CSV file, and as a file for a spreadsheet."""
    settings = [(parameter.label, parameter.value) for parameter in (*PARAMETERS.values(), GLIDE, SPIN, MU)]
    widgets.download(
        _("Spreadsheet"),
        sheet(motion, mu, settings),
        "ramanujan motion spreadsheet.csv",
        "text/csv",
        icon=":material/table:",
        help=_("All numbers of this page, in SI units, as a file that a spreadsheet opens"),
    )
    widgets.download(
        _("CSV"),
        table(motion, mu),
        "ramanujan motion.csv",
        "text/csv",
        icon=":material/download:",
        help=_("All numbers of this page, in SI units, for programs: NumPy reads them back exactly"),
    )


def draw_figures(motion: Record, friction: Friction, setting: cache.ReleaseParameters) -> None:
    """Draw the figures of the open view, or in the projector view a slide for each view."""
    is_projector = display_mode.is_projector()
    draw_functions = {
        "displacements": plots.draw_displacements,
        "energy": plots.draw_energy,
        "momentum": plots.draw_momentum,
        "forces": plots.draw_contact_forces if is_projector else partial(plots.draw_forces, friction=friction),
    }
    if is_projector:
        containers = {view: slide(view, title) for view, title in FIGURES.items()}
    else:
        containers = {view: tab for view, tab in widgets.tabs(FIGURE).items() if tab.open}
    for view, container in containers.items():
        with container:
            if not is_projector:
                with st.container(horizontal=True):
                    offer_files(motion, friction.coefficient)
                    if view == "forces":
                        offer_pause(motion)
            draw_functions[view](motion, cache.figures(view, theme.current(), *setting))
            if view == "forces":
                plots.explain_forces(motion)
    if is_projector:
        with slide("friction", _("Friction needed")):
            plots.draw_required_friction(motion, friction)


if __name__ == "__main__":
    show()
