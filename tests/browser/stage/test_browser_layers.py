"""The marks of every layer of the stage, in direction and length, against the numeric core."""

import math
from collections.abc import Callable

import numpy as np
import pytest

from ramanujan import UNIT_MASS_RATIO, Oscillator
from ramanujan.browser import stage
from ramanujan.physics.contact import contact_forces
from ramanujan.physics.energy import energies
from ramanujan.physics.motion import ground_positions, ground_velocities, motion, relative_positions
from tests.checks.engines import ANY_ENGINE
from tests.checks.picture import ROLLERS, Picture, add_reactions, length, machines

PIXEL = 1.0
TIMES = (-0.3, 0.0, 0.22, 0.6, 2.85)
"""Periods after release."""

Pairs = dict[str, tuple[float, float]]
"""Name of a mark → its signed length [px] in the picture, and by the core."""


def arrows(layer: str, unit: str, values: Callable[[Picture], dict]) -> Callable[[Picture, dict], Pairs]:
    """Return the comparison for a layer of arrows with a scale arrow.

    Parameters
    ----------
    layer : id of the layer
    unit : unit of the scale arrow, with the words after it
    values : function that returns mark → value of the core in this unit, positive to the right
    """

    def compare(picture: Picture, drawn: dict) -> Pairs:
        lines, scale = drawn["layers"][layer]["lines"], drawn["layers"][layer]["scale"]
        assert scale, f"Add a reference arrow of {layer} to the group scales in stage.html."
        assert scale["text"], f"Write the value of the reference arrow of {layer} in layers.js."
        mantissa = scale["value"] / 10 ** math.floor(math.log10(scale["value"]) + 1e-9)
        assert round(mantissa, 9) in (1, 2, 5)
        assert scale["text"].partition("\u202f")[2] == unit
        per_unit = length(scale["arrow"]) / scale["value"]
        expected = values(picture)
        assert per_unit > 0
        assert lines.keys() == expected.keys(), f"The group .{layer} of stage.html lacks marks of MARKS, or has others."
        return {name: (length(lines[name]), float(value) * per_unit) for name, value in expected.items()}

    return compare


def displacements(picture: Picture, drawn: dict) -> Pairs:
    """Return the displacements relative to the ground, to scale."""
    moved = ground_positions(picture.machine, picture.q)
    lines = drawn["layers"]["displacements"]["lines"]
    assert lines.keys() == moved.keys()
    return {name: (length(lines[name]), float(x) * picture.pixels) for name, x in moved.items()}


def velocities(picture: Picture) -> dict[str, float]:
    return ground_velocities(picture.machine, picture.q_dot)


def friction(picture: Picture) -> dict[str, float]:
    """Return the friction on each roller, without the reactions on the other bodies."""
    on_rollers = contact_forces(picture.machine, picture.q)
    del on_rollers["spring"]
    return {f"{contact} {contact.split('_')[0]}": force for contact, force in on_rollers.items()}


def forces(picture: Picture) -> dict[str, float]:
    force = contact_forces(picture.machine, picture.q)
    spring = force.pop("spring")
    return add_reactions(force) | {"spring slab": spring, "spring block": -spring}


def bars(picture: Picture, drawn: dict) -> Pairs:
    """Return the bars of energy, whose total is ½kx₀²."""
    whole = picture.find("root.querySelector('.bar').getBoundingClientRect().width")
    total = picture.machine.k * picture.compression**2 / 2
    shares = dict.fromkeys(drawn["bars"], 0.0)
    for name, energy in energies(picture.machine, picture.q, picture.q_dot).items():
        shares[name.partition("_")[0]] += float(energy) / total
    assert drawn["shares"] == pytest.approx([100 * shares[name] for name in drawn["bars"]], abs=0.51), "percent"
    return {name: (share * whole, shares[name] * whole) for name, share in drawn["bars"].items()}


def traces(picture: Picture, drawn: dict) -> Pairs:
    """Return the path of the mark on each rim, relative to its roller's centre at q = 0."""
    R, pairs = picture.machine.radius, {}
    moved_now = ground_positions(picture.machine, picture.q)
    for name in ROLLERS:
        points = np.array(drawn["traces"][name])
        x, y = drawn["rollers"][name]["centre"]
        home = np.array([x - moved_now[name] * picture.pixels, y])
        for index in range(0, len(points), 17):
            t = index / (len(points) - 1) * picture.machine.period
            q, _q_dot = motion(picture.machine, picture.initial, t)
            angle = q[2] if name == "top" else q[1]
            along = ground_positions(picture.machine, q)[name] + R * math.sin(angle)
            right, down = points[index] - home
            pairs[f"{name} {index} along"] = right, along * picture.pixels
            pairs[f"{name} {index} upwards"] = -down, R * math.cos(angle) * picture.pixels
    return pairs


def coordinates(picture: Picture, drawn: dict) -> Pairs:
    """Return X, x₀, 2Rφ and R, and the radius to the mark on each rim.

    X counts to the left, and angles count clockwise: the arrow on the right side of a rim points down.
    """
    marks, pixels, R = drawn["marks"], picture.pixels, picture.machine.radius
    X, phi, Phi = picture.q
    way, released, radius = marks["X_value"], marks["x0_value"], marks["R_value"]
    slab = relative_positions(picture.machine, picture.q)["slab"]
    pairs = {
        "X": (way["start"][0] - way["end"][0] if way else 0.0, X * pixels),
        "x0": (released["end"][0] - released["start"][0], picture.compression * pixels),
        "slab": (length(marks["slab_value"] and marks["slab_value"]["arrow"]), slab * pixels),
        "R": (math.dist(radius["start"], radius["end"]), R * pixels),
    }
    left_edge = marks["X_sense"]["arrow"]["box"][0]
    assert left_edge < marks["X_sense"]["start"][0] - 3
    for name, angle in (("hoop", phi), ("cylinder", phi), ("top", Phi)):
        (x, y), sense = drawn["rollers"][name]["centre"], marks[f"{name}_sense"]
        assert marks[f"{name}_radius"]["start"] == pytest.approx([x, y], abs=PIXEL)
        assert sense["start"][0] > x
        lower_edge = sense["arrow"]["box"][3]
        assert lower_edge > sense["start"][1] + 2
        right, down = np.subtract(marks[f"{name}_radius"]["end"], marks[f"{name}_radius"]["start"])
        pairs[f"{name} along"] = right, R * math.sin(angle) * pixels
        pairs[f"{name} upwards"] = -down, R * math.cos(angle) * pixels
    return pairs


STRENGTH = "N: friction on the rollers"
MARKS: dict[str, Callable[[Picture, dict], Pairs]] = {
    "energy": bars,
    "displacements": displacements,
    "arrows": arrows("arrows", "m/s", velocities),
    "forces": arrows("forces", STRENGTH, friction),
    "traces": traces,
    "coordinates": coordinates,
}
"""Layer → comparison of its marks with the core."""


def wrong(pairs: Pairs, factor: float = 1.0) -> list[str]:
    """Return the marks with an error above a pixel, after a multiplication of all lengths by `factor`."""
    return [name for name, (drawn, expected) in pairs.items() if abs(factor * drawn - expected) > PIXEL]


LETTERS = {
    "hoop_slab": "Shoop",
    "cylinder_slab": "Scylinder",
    "hoop_block": "Fhoop",
    "cylinder_block": "Fcylinder",
    "top_block": "Ftop",
}
"""Contact → the letter of its force on the roller with its index, as in the equations of Newton's route."""
SPRING_LETTERS = {"slab": "−2kRφ", "block": "2kRφ"}
"""Body → the spring's force on it, as in the equations."""
LETTERED = """[...root.querySelectorAll(".forces [data-line]")].map((group) => {
  const text = group.querySelector("text"), { left, right } = text.getBoundingClientRect();
  return [group.dataset.line, text.style.visibility ? "" : text.textContent, (left + right) / 2,
    getComputedStyle(group).opacity === "1"];
})"""
"""For each force: its name, its visible letter, the letter's position, and whether it is drawn strongly."""


def check_letters(picture: Picture) -> None:
    """Check the letters of the forces beside equations: at the heads of arrows that agree with the core."""
    machine, compression, own = Oscillator(1.0, 2.0, 30.0), 0.08, ("hoop_slab", "top_block")
    data = stage.payload(machine, compression, forces=own)
    picture.show(machine, compression)
    picture.bare.put(lambda: stage.publish(data, name=picture.name))
    for periods in (0.1, 0.6):
        drawn = picture.at(periods)
        assert not wrong(arrows("forces", STRENGTH, forces)(picture, drawn))
        force = forces(picture)
        letters = picture.find(LETTERED)
        assert {name for name, *_ in letters} == force.keys()
        for name, letter, x, is_strong in letters:
            contact, body = name.split()
            on_roller = body == contact.split("_")[0]
            expected = SPRING_LETTERS[body] if contact == "spring" else LETTERS[contact]
            assert letter == (expected if on_roller or contact == "spring" else f"−{expected}")
            assert is_strong == (contact in own)
            tail, _y = drawn["forces"][name]["tail"]
            assert contact == "spring" or (x - tail) * force[name] > 0, name


def check_bodies_apart(picture: Picture) -> None:
    """Check that beside equations of forces the bodies are apart, and that each force is at its own body."""
    for radius in (0.05, 0.1, 0.2):
        machine = Oscillator(1.0, 2.0, 30.0, radius)
        picture.show(machine, 0.08)
        assert max(map(abs, gaps(picture.at(0.0)))) < PIXEL
        data = stage.payload(machine, 0.08, forces=("hoop_slab",))
        picture.bare.put(lambda data=data: stage.publish(data, name=picture.name))
        drawn = picture.at(0.0)
        gap = min(gaps(drawn))
        assert gap > 0.05 * picture.pixels
        for name, arrow in drawn["forces"].items():
            contact, body = name.split()
            if contact != "spring":
                roller, other = contact.split("_")
                (_x, y), R = drawn["rollers"][roller]["centre"], drawn["rollers"][roller]["radius"]
                rim = y - R if other == "slab" else y + R
                beyond = -gap if other == "slab" else gap
                surface = rim if body == roller else rim + beyond
                assert abs(arrow["tail"][1] - surface) < gap / 2, (radius, name)
    picture.show(machine, 0.08)
    assert max(map(abs, gaps(picture.at(0.0)))) < PIXEL


def gaps(drawn: dict) -> list[float]:
    """Return the vertical gaps between slab and lower rollers, and between the top roller and the block [px]."""
    rollers = drawn["rollers"]
    above_lower = [rollers[name]["centre"][1] - rollers[name]["radius"] - drawn["slab"][3] for name in ROLLERS[:2]]
    return [*above_lower, drawn["block"][1] - rollers["top"]["centre"][1] - rollers["top"]["radius"]]


def check_displacements_from_the_block(picture: Picture) -> None:
    """Check that a graph relative to the block has its displacements beside it, and a block at rest.

    A person may choose the other frame, which then remains until a graph with another frame.
    """
    machine, compression = Oscillator(1.0, 2.0, 30.0), 0.08
    picture.show(machine, compression)

    def show_from(frame: str) -> float:
        """Show a graph relative to this frame. Return the block's motion in the picture [pixels]."""
        data = stage.payload(machine, compression, views={"": {"from": frame}})
        picture.bare.put(lambda: stage.publish(data, name=picture.name))
        return picture.at(0.6)["block"][0] - picture.at(0.1)["block"][0]

    assert abs(show_from("block")) < PIXEL
    drawn = picture.at(0.6)
    lines = drawn["layers"]["displacements"]["lines"]
    for name, x in relative_positions(machine, picture.q).items():
        assert length(lines[name]) == pytest.approx(float(x) * picture.pixels, abs=PIXEL), name
    assert length(lines["block"]) == pytest.approx(0, abs=PIXEL)
    picture.find("root.querySelector('.viewpoint input').click()")
    assert abs(show_from("block")) > 2 * PIXEL
    assert abs(show_from("ground")) > 2 * PIXEL
    assert abs(show_from("block")) < PIXEL


UNPAINTED = """[...root.querySelectorAll("[data-line] .line, .scales [data-of] path")].filter((path) => {
  path.style.color = "var(--arrow, var(--ink))";
  const { color, stroke, fill } = getComputedStyle(path);
  return ![stroke, fill].includes(color);
}).map((path) => path.parentNode.dataset.of ?? path.parentNode.parentNode.classList[0])"""
"""Layers with a line or a reference arrow that has neither its body's colour nor that of the text."""


@ANY_ENGINE
def test_the_marks_of_every_layer_agree_with_the_core(bare):
    missing = stage.LAYERS.keys() - MARKS.keys()
    assert not missing, f"Add to MARKS how the core computes the marks of {sorted(missing)}."
    picture = Picture(bare())
    picture.layers(*stage.LAYERS)
    longest = dict.fromkeys(stage.LAYERS, 0.0)
    for machine, compression in [*machines(5), (Oscillator(1.0, UNIT_MASS_RATIO), 0.08)]:
        picture.show(machine, compression)
        for periods in TIMES:
            drawn = picture.at(periods)
            for layer in stage.LAYERS:
                pairs = MARKS[layer](picture, drawn)
                assert pairs
                assert not wrong(pairs), (layer, machine, periods, pairs)
                # Negative controls: the other direction, and three times the length.
                furthest = max(abs(expected) for _drawn, expected in pairs.values())
                longest[layer] = max(longest[layer], furthest)
                if furthest > 2 * PIXEL:
                    assert wrong(pairs, -1)
                    assert wrong(pairs, 3)
        released_forces = picture.at(0.0)["layers"]["forces"]["lines"].values()
        assert max(abs(length(arrow)) for arrow in released_forces) > machine.radius * picture.pixels
    assert min(longest.values()) > 20 * PIXEL, longest
    check_letters(picture)
    check_bodies_apart(picture)
    check_displacements_from_the_block(picture)
    unpainted = sorted(set(picture.find(UNPAINTED)))
    assert not unpainted, f"stage.css needs rules for the lines and reference arrows of {unpainted}."
