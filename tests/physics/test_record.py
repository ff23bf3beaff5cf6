"""A record: its series are consistent."""

import numpy as np
import pytest

from ramanujan import Oscillator
from ramanujan.physics.record import record

MACHINE = Oscillator(1.3, 0.7, 25.0, 0.12)


def recorded(**options):
    """Return a record of MACHINE; the options replace the defaults."""
    defaults = {"glide": 0.05, "spin": -0.8, "spacing": 0.338, "periods": 2, "points": 179}
    return record(MACHINE, 0.08, **defaults | options)


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
