"""The animated scene: a Components v2 component that draws the machine and listens to the sliders.

This file holds what crosses from Python to the page (`payload`) and the mounting; words.py holds the texts, formulas.py
the physics, which SymPy prints to JavaScript. The page's side is stage.html, stage.css, and one JavaScript module for
each concern: motion, drawing and playback are pure; picture, layers and dial draw; parts hides, clock is time, words is
what is said, slab and thumb are the hand, toolbar the controls; stage wires them. No physics is written in JavaScript.

The stage itself is mounted with constant arguments, so that Streamlit sends it once in a session. After a change only a
small message (`page.publish`) is sent, which carries the numbers.

The contract, version 1. To the page, once:

    stage        the name under which its messages are published
    limits       compression: the least and the greatest that the slab can be dragged to [m]; where these are the
                 same, it cannot be dragged
    watch        key of a slider → {parameter, scale, step}: its value times scale is that parameter in SI units
    clock        stages with the same clock run and pause together
    layers       which of `LAYERS` are shown at first
    compact      only the picture and its label, without controls
    dials        whether the two clock hands, the gauge and the readouts are shown
    narrow       whether these are shown below the picture
    periods      after so many periods the motion begins again; left out: never
    label        the text under the picture
    kept         prefix of the names under which the address keeps what is seen
    tells        whether the stage tells the server what is seen of it, see `SEEN`

and by `page.publish`, at every change:

    version      1
    parameters   m, m_prime [kg], k [N/m], radius, compression [m], beta_hoop, beta_cylinder, beta_top
    initial      X, phi, Phi [m, rad, rad] and X_dot, phi_dot, Phi_dot at release; left out: released at rest
    samples      q = φ/φ₀ at equal steps, per_period of them in a period, drawn instead of the exact motion of a
                 machine that was released at rest; left out: exact
    computed     the same, drawn as an outline over the exact motion, with log, the evaluations and the turns that it
                 was off, as text, after each period, run, the number of the run, and pace, the seconds of a period
                 while a new run is shown for the first time; left out: none
    slipping     the contact that is marked, such as hoop_slab; left out: none
    hide         the parts that are hidden, see `PARTS`; left out: none

Other parts of the page communicate with a stage through the topics of the bus, which `ramanujan.browser.components`
lists.

The page answers nothing but `SEEN`, and that at the desk of a class alone: a slab that is let go moves its slider, see
thumb.js.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict
from typing import Any

from ramanujan.browser import components, modules
from ramanujan.browser.stage.formulas import SHAPE_FACTORS
from ramanujan.browser.stage.words import LAYERS
from ramanujan.motion import InitialState
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

VERSION = 1
PARTS = {
    "clocks": "the two clock hands, and every sign of how near the two frequencies are",
    "numbers": "Ω²m/k with its gauge, Ω, the period, shares of the energy, scales of arrows, and their consequences",
    "plain": "the plain mass",
    "motion": "the motion itself and what shows it: the machine stands still as it was released",
    **{name: f"{what}, with its tick box" for name, (_title, what) in LAYERS.items()},
}
"""Part of a stage that can be hidden → what it is. What is hidden is not on the page, nor in what is said of it."""
SEEN: Mapping[str, Any] = {"layers": "", "from": "", "speed": 1.0, "pace": 1.0, "turns": ""}
"""What is seen of the stages on a clock, by an example: layers, view and speed as the address has them; pace, how many
seconds of the machine pass in one of the beholder, 0 where it stands; turns, the periods since release of machine and
plain mass, for each stage on the clock."""


def payload(
    oscillator: Oscillator,
    compression: float,
    *,
    initial: InitialState | None = None,
    shape_factors: Mapping[str, float] = SHAPE_FACTORS,
    samples: Mapping[str, Any] | None = None,
    computed: Mapping[str, Any] | None = None,
    slipping: str | None = None,
) -> dict[str, Any]:
    """Return what is published at every change: the machine and its motion as plain numbers.

    Parameters
    ----------
    oscillator : the machine; m, m′ [kg], k [N/m], R [m]
    compression : x₀ [m]
    initial : the state at release; without it, at rest with the spring compressed by x₀
    shape_factors : β of the rollers hoop, cylinder, top; it sets how they look and how they move
    samples, computed : a computed motion, to draw instead of the exact one or as an outline over it
    slipping : the contact to mark, such as hoop_slab
    """
    shapes = {f"beta_{name}": float(shape_factors[name]) for name in SHAPE_FACTORS}
    optional = {"initial": initial and asdict(initial), "samples": samples, "computed": computed}
    optional |= {"slipping": slipping}
    return {
        "version": VERSION,
        "parameters": {**asdict(oscillator), "compression": compression, **shapes},
        **{name: value for name, value in optional.items() if value is not None},
    }


def mount(
    data: Mapping[str, Any] | None,
    *,
    key: str = "stage",
    on_seen: Callable[[dict[str, Any]], None] | None = None,
    hide: Iterable[str] = (),
    **options: Any,
) -> None:
    """Put a stage on the page.

    Parameters
    ----------
    data : the payload; None where `tell` brings it
    key : of the stage among the page's elements
    on_seen : called with a value like `SEEN` when a person has changed the view, and when the machine begins anew
    hide : the parts that are hidden, of `PARTS`; another run may hide others
    **options : as in `settings`
    """
    fixed = settings(key, **options)
    if on_seen:
        components.asks("stage/stage", key, {**fixed, "tells": True}, "seen", on_seen, SEEN)
    else:
        modules.component("stage/stage")(key=key, data=fixed)
    if data is not None:
        tell(data, key=key, name=fixed["stage"], hide=hide)


def settings(
    key: str,
    *,
    limits: tuple[float, float],
    watch: Mapping[str, Mapping[str, Any]],
    name: str | None = None,
    clock: str | None = None,
    layers: tuple[str, ...] = ("energy",),
    compact: bool = False,
    dials: bool = True,
    narrow: bool = False,
    periods: float | None = None,
    label: str | None = None,
    kept: str = "",
) -> dict[str, Any]:
    """Return the constant data of a stage.

    Parameters
    ----------
    key : of the stage among the page's elements
    limits : the range of x₀ that the slab can be dragged through [m]
    watch : slider key → parameter, scale and step, for following a drag without the server
    name : the stage's name on the page's bus, unique in the whole app; without it, the key
    clock : name of the clock, shared by stages that run together; without it, the stage has its own
    layers : shown at first, of `LAYERS`
    compact : only the picture and its label, without controls
    dials : show the two clock hands, the gauge and the readouts beside the picture
    narrow : show them below the picture
    periods : of the machine, after which its motion begins again; without it, never
    label : a few words under the picture, also its name for screen readers
    kept : prefix of the names under which the address keeps the view; one for each clock of a page
    """
    name = name or key
    return {
        "stage": name,
        "limits": {"compression": limits},
        "watch": watch,
        "clock": clock or name,
        "layers": layers,
        "compact": compact,
        "dials": dials,
        "narrow": narrow,
        "periods": periods,
        "label": label,
        "kept": kept,
    }


def tell(
    data: Mapping[str, Any],
    *,
    key: str = "stage",
    name: str | None = None,
    hide: Iterable[str] = (),
    more: Mapping[str, Any] | None = None,
) -> None:
    """Tell a stage which machine it shows.

    Parameters
    ----------
    data : the payload
    key, name, hide : as in `mount`
    more : topics of the page's bus that are told with it
    """
    if unknown := set(hidden := sorted(hide)).difference(PARTS):
        sentence = _("hide must be among {known}, and {unknown} is not")
        raise ValueError(sentence.format(known=", ".join(PARTS), unknown=", ".join(sorted(unknown))))
    components.publish(
        f"{key}_published", {f"machine/{name or key}": {**data, "hide": hidden} if hidden else data, **(more or {})}
    )
