"""The animated scene: a Components v2 component that draws the machine and follows the sliders.

This file defines the data sent to the page (`settings`, `payload`) and mounts the component. words.py contains the
texts, and formulas.py the physics, printed to JavaScript by SymPy. The browser's side consists of stage.html, stage.css
and JavaScript modules:

    motion, drawing, playback     pure functions and state
    picture, layers, dial         drawing
    parts                         hiding of parts
    clock                         the animation loop
    words                         sentences for the reader
    slab, live_values             input by pointer, keys and sliders
    follow                        a second, small picture of a stage
    keeper, save                  the view in the address; the picture as a file
    coordinates, terms, svg       coordinates of the picture; terms of a formula; elements of a picture
    listen, tones                 both oscillations as sound
    toolbar                       the controls
    stage                         the connection of all these

No physics is written in JavaScript.

The stage is mounted with constant arguments, so Streamlit sends it once per session. After a change only a small
message with the numbers is sent (`publish`).

Constant data, sent once:

    stage           name of the stage; its topics on the bus contain it
    limits          compression: smallest and largest x₀ of a drag [m]; equal limits fix the slab
                    radius: the largest radius of the machines beside this one, which have one scale [m], or null
    watch           slider key → {parameter, scale, step}; value times scale is the parameter in SI units
    clock           name of the clock; stages with the same clock run and pause together
    layers          the members of `LAYERS` that are shown until a person chooses others
    compact         whether only the picture and its label are shown, without controls
    dials           whether the two clock hands, their drift and the readouts are shown
    narrow          whether these are below the picture
    periods         number of periods in the graphs: the motion repeats after these, and both machines move as since one
                    release. Default: the motion never repeats, and at a change of the machine both hands go on from
                    where they are
    rest_after      number of periods of the plain mass after which the motion pauses by itself; a person may play on
    label           text under the picture
    address_prefix  prefix of the stage's names in the address
    sends_view      whether the stage sends its view to the server, see `VIEW`

The message, published at every change; all but the first entry are optional:

    parameters   m, m_prime [kg], k [N/m], radius, compression [m], beta_hoop, beta_cylinder, beta_top
    initial      X, phi, Phi [m, rad, rad] and X_dot, phi_dot, Phi_dot at release; default: released at rest
    samples      q = φ/φ₀ at equal steps, per_period of them in a period, and the energies there in multiples of that
                 at release; they replace the exact motion of a machine released at rest
    most_energy  the energy of a full bar of energies, in multiples of that at release, which then has a mark; default:
                 the bar is always full
    computed     samples drawn as an outline over the exact motion, with these items:
                 run_name, the method and its steps per period;
                 evaluations, their number after each period, as text;
                 turns, the phase error after each period [turns];
                 within, the largest allowed error [turns];
                 run, the number of the run;
                 screen_period, the duration of a plain-mass period on the screen [s] while a new run is first shown
    slipping     the contact to mark, such as hoop_slab
    forces       the contacts, or spring, whose forces are drawn strongly; all forces have letters, and the bodies are
                 drawn apart
    held         true pauses a moving machine at its release; the next message without it plays this machine again
    velocities   whether the velocities are drawn without their scale, with or without their layer
    hide         the hidden parts, members of `PARTS`
    views        name of a slide, or "" in the normal view → {layers, from}, which are valid while it is shown: layers
                 replace those of the constant data, and the machine is seen from "ground" or "block"
    releases     a number; another number sets both hands to the start

Other parts of the page communicate with a stage through the topics of the bus, listed in
`ramanujan.browser.topics`. The stage sends only its view to the server, and only at the desk of a class. A drag of
the slab moves the slider, which sends its own value (live_values.js).
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict
from typing import Any

from ramanujan.browser import modules, mounting, topics
from ramanujan.browser.stage.formulas import SHAPE_FACTORS
from ramanujan.browser.stage.words import GONE_LAYERS, LAYERS
from ramanujan.physics.motion import InitialState
from ramanujan.physics.oscillator import Oscillator

PARTS = {
    "clocks": "the two clock hands, and every text that depends on how near the two frequencies are",
    "hands": "all of these except the button Listen, for a task by ear",
    "numbers": "Ω²m/k, Ω, the period, shares of the energy, scales of arrows, and texts with them",
    "plain": "the plain mass",
    "motion": "the motion and everything that shows it; the machine stays at rest in the position of its release",
    **{name: f"{what}, with its tick box" for name, (_title, what) in LAYERS.items()},
}
"""Part of a stage that can be hidden → its description. A hidden part is neither on the page nor in its sentences."""
VIEW: Mapping[str, Any] = {"layers": "", "from": "", "speed": 1.0, "rates": "", "turns": ""}
"""An example of the view that a stage sends to the server.

layers, from, speed
    layers, reference frame and speed, in the notation of the address
turns, rates
    turns of the hands of the machine and of the plain mass since the start, for each stage on the clock; and turns per
    second on the screen, 0 while the clock is paused
"""


def payload(
    oscillator: Oscillator,
    compression: float,
    *,
    initial: InitialState | None = None,
    shape_factors: Mapping[str, float] = SHAPE_FACTORS,
    samples: Mapping[str, Any] | None = None,
    computed: Mapping[str, Any] | None = None,
    slipping: str | None = None,
    forces: tuple[str, ...] | None = None,
    held: bool | None = None,
    most_energy: float | None = None,
    velocities: bool | None = None,
    views: Mapping[str, Mapping[str, Any]] | None = None,
) -> dict[str, Any]:
    """Return the message published at every change, without `hide` and `releases`.

    The machine and its motion are plain numbers. `publish` adds `hide`, and `shell/stages.py` adds `releases`.

    Parameters
    ----------
    oscillator : the machine; m, m′ [kg], k [N/m], R [m]
    compression : x₀ [m]
    initial : the state at release; default: at rest with the spring compressed by x₀
    shape_factors : β of the rollers hoop, cylinder, top; it determines their look and their motion
    most_energy : the energy of a full bar of energies, in multiples of that at release; default: the present energy
    samples, computed : a computed motion; `samples` replaces the exact one, `computed` is an outline over it
    slipping : the contact to mark, such as hoop_slab
    forces : the contacts, or "spring", whose forces are drawn strongly; the others are drawn faintly. All forces then
        have letters, with or without the layer of forces. The bodies are drawn apart, each with its own forces.
    held : whether to pause a moving machine at its release, where forces are greatest
    velocities : whether the velocities are drawn without their scale, with or without their layer
    views : slide, or "" in the normal view → its layers, until a person chooses others, and its frame of reference
    """
    shapes = {f"beta_{name}": float(shape_factors[name]) for name in SHAPE_FACTORS}
    optional: dict[str, Any] = {
        "initial": initial and asdict(initial),
        "samples": samples,
        "computed": computed,
        "slipping": slipping,
        "forces": forces,
        "held": held,
        "most_energy": most_energy,
        "velocities": velocities,
        "views": views,
    }
    return {
        "parameters": {**asdict(oscillator), "compression": compression, **shapes},
        **{name: value for name, value in optional.items() if value is not None},
    }


def mount(
    data: Mapping[str, Any] | None,
    *,
    key: str = "stage",
    on_view: Callable[[dict[str, Any]], None] | None = None,
    hide: Iterable[str] = (),
    **options: Any,
) -> None:
    """Put a stage on the page.

    Parameters
    ----------
    data : the payload; None if it is published later
    key : Streamlit's key of the stage, and its name on the bus unless the options contain a name
    on_view : called with a value like `VIEW` when a person has changed the view, and when the machine is released again
    hide : the hidden parts, members of `PARTS`; they may differ in the next run
    **options : as in `settings`
    """
    constants = settings(key, **options)
    if on_view:
        constants["sends_view"] = True
        mounting.mount("stage/stage", key, constants, event="view", on_value=on_view, type_example=VIEW)
    else:
        modules.component("stage/stage")(key=key, data=constants)
    if data is not None:
        publish(data, key=key, name=constants["stage"], hide=hide)


def mount_small(key: str, *, follows: str, limits: tuple[float, float]) -> None:
    """Put a second, small picture of a stage on the page, without controls.

    Parameters
    ----------
    key : Streamlit's key of the picture
    follows : name of the stage
    limits : as in `settings`
    """
    modules.component("stage/stage")(key=key, data={"follows": follows, "limits": {"compression": limits}})


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
    rest_after: float | None = None,
    label: str | None = None,
    largest_radius: float | None = None,
    address_prefix: str = "",
) -> dict[str, Any]:
    """Return the constant data of a stage.

    Parameters
    ----------
    key : Streamlit's key of the stage
    limits : range of x₀ for dragging the slab [m]
    watch : slider key → parameter, scale and step; the page follows these sliders without the server
    name : name of the stage on the bus, unique in the app; default: the key
    clock : name of the clock, shared by stages that run together; default: a clock for this stage
    layers : members of `LAYERS` that are shown until a person chooses others
    compact : show only the picture and its label, without controls
    dials : show the two clock hands, their drift and the readouts beside the picture
    narrow : show these below the picture
    periods : number of periods of the graphs, after which the motion repeats; default: never
    rest_after : number of periods of the plain mass after which the motion pauses by itself; default: never
    label : a few words under the picture, also its name for screen readers
    largest_radius : the largest radius of the machines beside this one, which have one scale [m]
    address_prefix : prefix of the stage's names in the address; one for each clock of a page
    """
    name = name or key
    return {
        "stage": name,
        "limits": {"compression": limits, "radius": largest_radius},
        "watch": watch,
        "clock": clock or name,
        "layers": layers,
        "compact": compact,
        "dials": dials,
        "narrow": narrow,
        "periods": periods,
        "rest_after": rest_after,
        "label": label,
        "address_prefix": address_prefix,
    }


def publish(
    data: Mapping[str, Any],
    *,
    key: str = "stage",
    name: str | None = None,
    hide: Iterable[str] = (),
    more: Mapping[str, Any] | None = None,
) -> None:
    """Publish the machine that a stage shows.

    Parameters
    ----------
    data : the payload
    key, name, hide : as in `mount`
    more : further topics of the bus and their values
    """
    hidden = sorted(hide)
    message = {**data, "hide": hidden} if hidden else data
    topics.publish(key, {f"machine/{name or key}": message, **(more or {})})
