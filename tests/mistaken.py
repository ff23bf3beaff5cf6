"""A machine that can be built wrongly: each hint of the judge, followed to the letter, gives the formula it speaks of.

Nothing here calls the judge or its list of mistakes. A hint is read with a regular expression, one number of the
machine is changed as it says, and energies, mass matrix and Ω² are worked out again in fractions at a random point.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from copy import deepcopy
from fractions import Fraction

BODIES = {"the block": "block", "the hoop": "hoop", "the lower cylinder": "cylinder", "the slab": "slab"} | {
    "the top cylinder": "top"
}
GROUPS = {
    "the lower rollers": ("hoop", "cylinder"),
    "all rollers": ("hoop", "cylinder", "top"),
    "everything on the block": ("hoop", "cylinder", "slab", "top"),
}
SHAPES = {
    "a hoop": Fraction(1),
    "a spherical shell": Fraction(2, 3),
    "a solid cylinder": Fraction(1, 2),
    "a solid sphere": Fraction(2, 5),
}

Point = dict[str, Fraction]
Machine = dict[str, dict]


def right_machine(point: Point) -> Machine:
    """Return mass, shape factor β, displacement and angle of each body as factors of (X, φ, Φ) at a point."""
    m, roller, R = point["m"], point["m'"], point["R"]
    none = [Fraction(0)] * 3
    return {
        "block": {"mass": m, "beta": Fraction(0), "moves": [Fraction(-1), 0, 0], "turns": list(none)},
        "hoop": {"mass": roller, "beta": Fraction(1), "moves": [Fraction(-1), R, 0], "turns": [0, Fraction(1), 0]},
        "cylinder": {"mass": roller, "beta": Fraction(1, 2), "moves": [Fraction(-1), R, 0], "turns": [0, 1, 0]},
        "slab": {"mass": m, "beta": Fraction(0), "moves": [Fraction(-1), 2 * R, 0], "turns": list(none)},
        "top": {"mass": m, "beta": Fraction(1, 2), "moves": [Fraction(-1), 0, R], "turns": [0, 0, 1]},
    }


def built_as(hint: str, point: Point) -> Machine | None:
    """Return the machine that a hint describes, None if it speaks of no machine."""
    machine, right = right_machine(point), right_machine(point)
    R = point["R"]
    for pattern, change in _CHANGES.items():
        found = re.search(pattern, hint)
        if found:
            for name in _named(found[1]):
                change(machine[name], right, found, R, point)
            return machine
    return None


def _named(words: str) -> tuple[str, ...]:
    return GROUPS[words] if words in GROUPS else (BODIES[words],)


def _no_rotation(body, right, found, R, point):
    body["beta"] = Fraction(0)


def _inertia(body, right, found, R, point):
    body["beta"] = SHAPES[found[2]]


def _mass(body, right, found, R, point):
    body["mass"] = point[found[2].replace("′", "'")]


def _sign(body, right, found, R, point):
    body["moves"][0] *= -1


def _relative(body, right, found, R, point):
    body["moves"][0] = Fraction(0)


def _as_its_rollers(body, right, found, R, point):
    body["moves"] = deepcopy(right["hoop"]["moves"])


def _as_the_slab(body, right, found, R, point):
    body["moves"] = deepcopy(right["slab"]["moves"])


def _angle(body, right, found, R, point):
    for motion in (body["moves"], body["turns"]):
        motion[1], motion[2] = motion[2], motion[1]


def _from_the_ground(body, right, found, R, point):
    body["turns"] = [Fraction(factor) / R for factor in body["moves"]]


def _left_out(body, right, found, R, point):
    body["mass"] = Fraction(0)


_CHANGES: dict[str, Callable] = {
    r"if you leave out the rotation of (.+?)\. ": _no_rotation,
    r"if (.+) has the moment of inertia of (.+?)\. ": _inertia,
    r"if (.+) ha(?:s|ve) the mass (m′?)\. ": _mass,
    r"if you add X′ to the velocity of (.+) instead of subtracting it\. ": _sign,
    r"if you take the velocity of (.+) relative to the block\. ": _relative,
    r"if (the slab) moves only as far as the centres of its rollers\. ": _as_its_rollers,
    r"if you give (.+) the displacement of the slab\. ": _as_the_slab,
    r"if you use the angle [φΦ] for (.+?)\. ": _angle,
    r"if you divide the velocity of (.+) relative to the ground by R": _from_the_ground,
    r"if you leave out (the [a-z ]+)\. Which bodies": _left_out,
}


def kinetic_energy(body: dict, point: Point) -> Fraction:
    """Return ½mv² + ½βmR²ω² at a point."""
    rates = [point[name] for name in ("X'", "phi'", "Phi'")]
    speed, spin = (sum(f * rate for f, rate in zip(body[which], rates, strict=True)) for which in ("moves", "turns"))
    return body["mass"] * (speed**2 + body["beta"] * point["R"] ** 2 * spin**2) / 2


def eliminated(machine: Machine, point: Point) -> dict[str, Fraction]:
    """Return what is left of the equations of motion of a machine: the couplings, the φ equation, Ω²."""
    R, k = point["R"], point["k"]

    def entry(i: int, j: int) -> Fraction:
        return sum(
            b["mass"] * (b["moves"][i] * b["moves"][j] + b["beta"] * R**2 * b["turns"][i] * b["turns"][j])
            for b in machine.values()
        )

    stretch = machine["slab"]["moves"][1] - machine["block"]["moves"][1]
    stiffness = k * stretch**2
    a, b, c, d, e = entry(0, 0), entry(0, 2), entry(2, 2), entry(0, 1), entry(1, 2)
    # Ẍ and Φ̈ for φ̈ = 1; an empty Φ equation leaves Φ̈ at zero.
    if c == b == e == 0:
        block, top = -d / a, Fraction(0)
    else:
        block, top = (b * e - c * d) / (a * c - b * b), (b * d - a * e) / (a * c - b * b)
    return {
        "block_coupling": block,
        "top_coupling": top,
        "phi_equation": entry(1, 1) * 4 * k * R / stiffness if stiffness else None,
        "natural_frequency_squared": stiffness / (entry(1, 1) + entry(0, 1) * block + entry(1, 2) * top),
    }
