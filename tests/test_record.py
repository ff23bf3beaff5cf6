"""A recorded motion and its table: every series against an independent route, and the way through a file and back."""

import io
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan import Oscillator
from ramanujan.record import columns, record, table

MACHINE = Oscillator(1.3, 0.7, 25.0, 0.12)


def taken(**more):
    setting = {"glide": 0.05, "spin": -0.8, "spacing": 0.338, "periods": 2, "points": 179} | more
    return record(MACHINE, 0.08, **setting)


def read(text):
    """The comments, the header and the numbers, as numpy's own reader gets them by the first line's advice."""
    lines = text.splitlines()
    skipped = int(next(word for word in lines[0].split() if word.isdigit()))
    return lines[: skipped - 1], lines[skipped - 1], np.loadtxt(io.StringIO(text), delimiter=",", skiprows=skipped)


def test_the_table_comes_back_from_numpy_bit_for_bit():
    motion = taken()
    comments, header, numbers = read(table(motion, 0.2))
    assert all(line.startswith("# ") for line in comments)
    expected = columns(motion)
    assert header.split(",") == list(expected)
    assert np.array_equal(numbers, np.array(list(expected.values())).T)
    assert np.array_equal(numbers[:, 0], motion.t)


def test_the_comments_hold_the_parameters_exactly():
    motion = taken()
    comments = dict(line[2:].split(" = ") for line in read(table(motion, 0.35))[0] if " = " in line)
    numbers = {name: float(value.split()[0]) for name, value in comments.items()}
    assert (numbers["m"], numbers["m_prime"], numbers["k"], numbers["R"]) == (1.3, 0.7, 25.0, 0.12)
    assert (numbers["compression"], numbers["mu"]) == (0.08, 0.35)
    assert (numbers["X_dot at release"], numbers["Phi_dot at release"]) == (-0.05, -0.8)
    assert comments["k"].endswith("N/m")
    assert numbers["Omega"] == MACHINE.natural_frequency


def test_every_velocity_is_the_slope_of_its_displacement():
    motion = taken(points=4001)
    step = motion.t[1]
    pairs = [
        (motion.ground_positions, motion.ground_velocities),
        (motion.relative_positions, motion.relative_velocities),
    ]
    for places, velocities in pairs:
        for body, place in places.items():
            slope = (place[2:] - place[:-2]) / (2 * step)
            # The central difference is wrong by (Ωh)²/6 ≈ 2e-6 of the amplitude of the velocity.
            assert slope == pytest.approx(velocities[body][1:-1], abs=1e-5 * np.ptp(velocities[body]) + 1e-9)


def test_every_force_is_what_changes_a_momentum():
    motion = taken(points=4001)
    forces, step = motion.forces, motion.t[1]
    on_body = {
        "slab": forces["spring"] - forces["hoop_slab"] - forces["cylinder_slab"],
        "hoop": forces["hoop_slab"] + forces["hoop_block"],
        "cylinder": forces["cylinder_slab"] + forces["cylinder_block"],
        "top": forces["top_block"],
    }
    on_body["block"] = -sum(on_body.values())
    largest = np.max(np.abs(forces["spring"]))
    for body, force in on_body.items():
        change = (motion.body_momenta[body][2:] - motion.body_momenta[body][:-2]) / (2 * step)
        assert change == pytest.approx(force[1:-1], abs=1e-5 * largest)


doubles = st.floats(allow_nan=False, allow_infinity=False)


@given(st.lists(doubles, min_size=5, max_size=5))
@settings(deadline=None, max_examples=60)
def test_any_doubles_survive_the_table(values):
    motion = replace(taken(points=5), t=np.array(values))
    assert read(table(motion, 0.2))[2][:, 0].tobytes() == motion.t.tobytes()


def test_a_record_keeps_the_compression_that_was_asked_for():
    # 2R · (x₀/2R) need not give x₀ back; the comment must.
    motion = replace(taken(), compression=0.1)
    assert "# compression = 0.1 m" in table(motion, 0.2)
