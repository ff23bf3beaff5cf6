"""A record and its table: the series are consistent, and NumPy reads the same numbers from the CSV."""

import io
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan import Oscillator
from ramanujan.record import columns, record, table

MACHINE = Oscillator(1.3, 0.7, 25.0, 0.12)


def recorded(**options):
    """Return a record of MACHINE; the options replace the defaults."""
    defaults = {"glide": 0.05, "spin": -0.8, "spacing": 0.338, "periods": 2, "points": 179}
    return record(MACHINE, 0.08, **defaults | options)


def read(text):
    """Return the comments, the header and the numbers of a table. The first line contains the value of skiprows."""
    lines = text.splitlines()
    skipped = int(next(word for word in lines[0].split() if word.isdigit()))
    return lines[: skipped - 1], lines[skipped - 1], np.loadtxt(io.StringIO(text), delimiter=",", skiprows=skipped)


def test_numpy_reads_the_same_numbers_from_the_table():
    one_record = recorded()
    comments, header, numbers = read(table(one_record, 0.2))
    assert all(line.startswith("# ") for line in comments)
    expected = columns(one_record)
    assert header.split(",") == list(expected)
    assert np.array_equal(numbers, np.array(list(expected.values())).T)
    assert np.array_equal(numbers[:, 0], one_record.t)


def test_the_comments_contain_the_exact_parameters():
    one_record = recorded()
    comments = dict(line[2:].split(" = ") for line in read(table(one_record, 0.35))[0] if " = " in line)
    numbers = {name: float(value.split()[0]) for name, value in comments.items()}
    assert (numbers["m"], numbers["m_prime"], numbers["k"], numbers["R"]) == (1.3, 0.7, 25.0, 0.12)
    assert (numbers["compression"], numbers["mu"]) == (0.08, 0.35)
    assert (numbers["X_dot at release"], numbers["Phi_dot at release"]) == (-0.05, -0.8)
    assert comments["k"].endswith("N/m")
    assert numbers["Omega"] == MACHINE.natural_frequency


def test_every_velocity_is_the_derivative_of_its_displacement():
    one_record = recorded(points=4001)
    step = one_record.t[1]
    pairs = [
        (one_record.ground_positions, one_record.ground_velocities),
        (one_record.relative_positions, one_record.relative_velocities),
    ]
    for positions, velocities in pairs:
        for body, position in positions.items():
            slope = (position[2:] - position[:-2]) / (2 * step)
            # The relative error of the central difference is (Ωh)²/6 ≈ 2e-6.
            assert slope == pytest.approx(velocities[body][1:-1], abs=1e-5 * np.ptp(velocities[body]) + 1e-9)


def test_the_force_on_every_body_is_the_derivative_of_its_momentum():
    one_record = recorded(points=4001)
    forces, step = one_record.forces, one_record.t[1]
    on_body = {
        "slab": forces["spring"] - forces["hoop_slab"] - forces["cylinder_slab"],
        "hoop": forces["hoop_slab"] + forces["hoop_block"],
        "cylinder": forces["cylinder_slab"] + forces["cylinder_block"],
        "top": forces["top_block"],
    }
    on_body["block"] = -sum(on_body.values())
    largest = np.max(np.abs(forces["spring"]))
    for body, force in on_body.items():
        change = (one_record.body_momenta[body][2:] - one_record.body_momenta[body][:-2]) / (2 * step)
        assert change == pytest.approx(force[1:-1], abs=1e-5 * largest)


doubles = st.floats(allow_nan=False, allow_infinity=False)


@given(st.lists(doubles, min_size=5, max_size=5))
@settings(deadline=None, max_examples=60)
def test_all_doubles_are_read_back_exactly(values):
    one_record = replace(recorded(points=5), t=np.array(values))
    assert read(table(one_record, 0.2))[2][:, 0].tobytes() == one_record.t.tobytes()


def test_the_comment_contains_the_given_compression():
    # 2R · (x₀/2R) may differ from x₀ by rounding. The comment contains x₀ itself.
    one_record = replace(recorded(), compression=0.1)
    assert "# compression = 0.1 m" in table(one_record, 0.2)
