"""Page 3: the motion over time, what it conserves, its zero modes, and the friction that it needs."""

from __future__ import annotations

import numpy as np
import streamlit as st

from ramanujan import page, stage
from ramanujan.contact import first_to_slip, largest_compression, required_friction
from ramanujan.derivation.printers import latex
from ramanujan.derivation.symbols import MOMENTA
from ramanujan.figures.motion import friction_bars
from ramanujan.record import Record, table
from ramanujan.scenes import controls, links, look, view
from ramanujan.scenes.cached import motion as cached
from ramanujan.scenes.controls import Control

GLIDE = Control("glide", "−Ẋ₀", "Push of the whole machine", "cm/s", -20.0, 20.0, 0.0, 0.5, "%.1f", "", 0.01)
SPIN = Control("spin", "Φ̇₀", "Push of the top cylinder", "rad/s", -3.0, 3.0, 0.0, 0.1, "%.1f", "")
MU = Control("mu", "μ", "Static friction", "", 0.01, 1.5, 0.2, 0.01, "%.2f", "")


def chart(figure: object, name: str, alt: str) -> None:
    """Put a figure on the page, with Plotly's own legend, hover, zoom and PNG export."""
    image = {"filename": f"ramanujan {name}", "scale": 2}
    config = {"displaylogo": False, "toImageButtonOptions": image}
    st.plotly_chart(figure, key=f"figure_{name}", theme=None, config=config, alt=alt)


def note(text: str) -> None:
    """Put small print under a figure, in full contrast."""
    st.markdown(f":small[{text}]")


def verdict(mu: float, largest: float, first: str, compression: float) -> None:
    """Say whether every contact rolls, in two sentences of about the same length."""
    contact = cached.CONTACTS[first]
    # No alert of Streamlit's: that would be a second live region, and the stage already says which contact slips.
    box = st.container(border=True)
    if compression <= largest:
        box.markdown(
            f":green[:material/check_circle: **Every contact rolls.**] With μ = {mu:.2f} you can release the machine "
            f"from up to x₀ = {100 * largest:.3g} cm; beyond, **{contact}** slips first."
        )
    else:
        box.markdown(
            f":red[:material/error: **The model no longer holds.**] With μ = {mu:.2f}, **{contact}** slips from "
            f"x₀ = {100 * largest:.3g} cm on; the picture just rolls on."
        )


def greatest_friction(motion: Record) -> tuple[float, str]:
    """Return when within the first period a contact needs the most friction [s], and which contact that is."""
    first_period = motion.t <= motion.oscillator.period
    needed = {
        name: (np.abs(motion.forces[name]) / normal)[first_period] for name, normal in motion.normal_forces.items()
    }
    first = max(needed, key=lambda name: needed[name].max())
    return float(motion.t[needed[first].argmax()]), first


def show_displacements(motion: Record, figures: tuple) -> None:
    """Displacements over time beside the phase plane, and what the two pushes do."""
    swing = {
        body: 100 * abs(motion.over_ground[body] - motion.over_ground[body][0]).max()
        for body in cached.NAMES
        if body != "spring"
    }
    time, plane = st.columns([3, 2])
    with time:
        far = ", ".join(f"{cached.NAMES[body]} {way:.3g} cm" for body, way in swing.items())
        chart(figures[0], "displacements", f"Displacements over time. Farthest from the start over the ground: {far}.")
    with plane:
        chart(
            figures[1],
            "phase plane",
            f"Phase plane: the slab runs round a closed ellipse over the block, "
            f"±{100 * abs(motion.over_block['slab']).max():.3g} cm by "
            f"±{100 * abs(motion.velocity_over_block['slab']).max():.3g} cm/s.",
        )
    end = motion.t[-1]
    block, top = ((x[-1] - x[0]) / end * 100 for x in (motion.over_ground["block"], motion.over_block["top"]))
    note(
        f"Each push starts one of the two **zero modes**, motions that no spring pulls back. Push the machine: all of "
        f"it glides, every line over the ground tilts alike and nothing changes over the block. Push the top cylinder: "
        f"it alone rolls on. After whole periods only this drift is left: block {block:.3g} cm/s over the ground, top "
        f"cylinder {top:.3g} cm/s over the block."
    )


def show_energy(motion: Record, figures: tuple) -> None:
    """The energies, stacked."""
    total = motion.total_energy
    spread = max(float(abs(total - total[0]).max() / total[0]), np.finfo(float).eps)
    greatest = max(motion.energies, key=lambda key: motion.energies[key][1:].max())
    chart(
        figures[0],
        "energy",
        f"Energies by body and kind, stacked: their sum stays at {1e3 * total[0]:.4g} mJ. The largest share at any one "
        f"time is that of {cached.NAMES[greatest.partition('_')[0]]}.",
    )
    note(
        f"Plain areas are travel over the ground, hatched ones turning. The sum is {1e3 * total[0]:.4g} mJ at every "
        f"instant drawn, to {spread:.0e} of itself; at release "
        f"{1e3 * motion.energies['spring'][0]:.4g} mJ of it sit in the spring, and your pushes add the rest."
    )


def show_momentum(motion: Record, figures: tuple) -> None:
    """Momenta of the bodies, and the two conserved ones."""
    p_X, p_Phi = (float(motion.momenta[name][0]) for name in ("p_X", "p_Phi"))
    of_X, _, of_Phi = map(latex, MOMENTA)
    chart(
        figures[0],
        "momentum",
        f"Momentum of each body over time, and two flat lines: all bodies together {-p_X:.3g} kg m/s, "
        f"p_Φ/R {p_Phi / motion.oscillator.radius:.3g} kg m/s.",
    )
    note(
        f"The bodies pass momentum to and fro; two sums stay flat, because neither X nor Φ stands in the Lagrangian: "
        f"${of_X}$, that of the whole machine (X counts to the left, hence the minus sign), and ${of_Phi}$, the top "
        f"cylinder’s angular momentum about the line where it touches the block. Push the machine and see both move."
    )


def show_forces(motion: Record, figures: tuple, mu: float, largest: float) -> None:
    """Contact forces over time beside the friction that each contact needs."""
    needed = required_friction(motion.oscillator, motion.compression, spacing=motion.spacing)
    colors = look.colors()
    time, bars = st.columns([3, 2])
    strongest = {name: float(abs(force).max()) for name, force in motion.forces.items()}
    said = ", ".join(f"{cached.CONTACTS[name]} {strongest[name]:.3g} N" for name in cached.CONTACTS)
    with time:
        chart(figures[0], "contact forces", f"Contact forces over time. Strongest friction: {said}.")
    with bars:
        chart(
            friction_bars(
                {cached.CONTACTS[name]: value for name, value in needed.items()},
                [cached.contact_color(name, colors) for name in needed],
                friction_coefficient=mu,
                colors=colors,
            ),
            "friction needed",
            f"Friction needed, against μ = {mu:.2f}: "
            + ", ".join(f"{cached.CONTACTS[name]} {value:.3g}" for name, value in needed.items()),
        )
        st.metric("Largest compression without slip", f"{100 * largest:.3g} cm")
    note(
        f"Forces act on the roller, right positive. A contact rolls while its friction stays below μ times its normal "
        f"force; the bars show the worst instant. The slab’s load shifts between the rollers, whose axes stand "
        f"{100 * motion.spacing:.3g} cm apart as drawn. No push changes a contact force: along the zero modes nothing "
        f"accelerates."
    )


machine, compression = controls.oscillator(), controls.compression()
st.title("Motion", anchor=False)
controls.complain(links.complaints([GLIDE.in_links, SPIN.in_links, MU.in_links, links.one_of("figure", cached.VIEWS)]))
scene = st.container(key="without_dials")
glide, spin, mu = (column for column in st.columns(3, gap="medium"))
with glide:
    glide = controls.page_slider(GLIDE)
with spin:
    spin = controls.page_slider(SPIN)
with mu:
    mu = controls.page_slider(MU)

setting = (machine.m, machine.m_prime, machine.k, machine.radius, compression, glide, spin)
motion = cached.record(*setting)
largest = largest_compression(machine, mu, spacing=motion.spacing)
first = first_to_slip(machine, largest, motion.spacing)
with scene:
    stage.mount(
        stage.payload(machine, compression, initial=motion.initial, slipping=None if compression <= largest else first),
        limits=controls.limits("compression"),
        watch=controls.WATCH,
        name="motion",
        layers=("forces",),
        dials=False,
        hide=view.on_stage(),
        periods=cached.PERIODS,
        on_released=controls.set_compression,
    )
with st.container(key="verdict"):
    verdict(mu, largest, first, compression)
instant, contact = greatest_friction(motion)
page.feed(
    "moment_feed",
    {
        "moment/motion": {
            "time": instant,
            "label": f"Freeze at the greatest friction: {cached.CONTACTS[contact]}, t = {instant:.2f} s",
        }
    },
)
page.moment("motion")

marker, download = st.columns([5, 1], vertical_alignment="center")
with marker:
    page.cursor("motion")
download.download_button(
    "CSV",
    lambda: table(motion, mu),
    "ramanujan motion.csv",
    "text/csv",
    icon=":material/download:",
    help="Everything that this page shows, in SI units",
    on_click="ignore",
    width="stretch",
)
shows = (show_displacements, show_energy, show_momentum, show_forces)
for tab, name, show in zip(
    st.tabs(list(cached.VIEWS), key="figure", bind="query-params"), cached.VIEWS, shows, strict=True
):
    if tab.open:
        with tab:
            more = (mu, largest) if show is show_forces else ()
            show(motion, cached.figures(name, look.theme(), *setting), *more)
