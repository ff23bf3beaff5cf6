"""Energies, momenta and places over the ground: against the matrices, independent sums and 50-digit arithmetic."""

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan import Oscillator
from ramanujan.energy import energies, momenta
from ramanujan.motion import (
    InitialState,
    ground_positions,
    ground_velocities,
    motion,
    relative_positions,
    relative_velocities,
    released,
)


def decimals(low, high):
    """Numbers to nine decimals: products of denormal numbers lose digits, which says nothing about the machine."""
    return st.floats(low, high).map(lambda value: round(value, 9))


MASS = st.floats(0.01, 100)
MACHINES = st.builds(Oscillator, m=MASS, m_prime=MASS, k=st.floats(0.1, 1e4), radius=st.floats(0.01, 2))
PUSH = decimals(-2, 2)
STARTS = st.builds(InitialState, X=PUSH, phi=PUSH, Phi=PUSH, X_dot=PUSH, phi_dot=PUSH, Phi_dot=PUSH)
BRIEFLY = settings(max_examples=60, deadline=None)

# A pushed machine, so that neither momentum is zero and both zero modes are excited.
PUSHED = InitialState(X=0.4, phi=0.3, Phi=-1.0, X_dot=0.2, phi_dot=-0.7, Phi_dot=1.5)
RATIOS = [1e-3, 0.5, 1.0, 1.1272568270162106, 30.0, 1e3]
FLAT = 1e-13
"""Momenta and energy are sums of about ten rounded terms; 1e-13 leaves a factor of a hundred over their ulps."""


def total_energy(oscillator, q, q_dot):
    return sum(energies(oscillator, q, q_dot).values())


def spread(values):
    return np.ptp(values)


def momentum_scales(oscillator, q_dot):
    """The sum of the sizes of the terms of p_X and of p_Φ, with which a momentum that is zero can be compared."""
    return (np.abs(oscillator.mass_matrix) @ np.abs(q_dot).max(axis=1))[[0, 2]]


@pytest.mark.parametrize("ratio", RATIOS)
@pytest.mark.parametrize("initial", [PUSHED, InitialState(phi=0.25)])
def test_energy_and_momenta_stay_constant_over_1000_periods(ratio, initial):
    oscillator = Oscillator(m=2.0, m_prime=2 * ratio, k=3.0, radius=0.3)
    t = np.linspace(0, 1000 * oscillator.period, 20011)
    q, q_dot = motion(oscillator, initial, t)
    energy = total_energy(oscillator, q, q_dot)
    assert spread(energy) <= FLAT * energy.min()
    conserved = momenta(oscillator, q_dot)
    for values, scale in zip((conserved["p_X"], conserved["p_Phi"]), momentum_scales(oscillator, q_dot), strict=True):
        assert spread(values) <= FLAT * scale


@pytest.mark.parametrize("wrong", [(-1, 1, 1), (1, -1, 1), (1, 1, -1)])
def test_a_wrong_sign_of_one_velocity_breaks_every_law_it_enters(wrong):
    oscillator = Oscillator(m=2.0, m_prime=1.5, k=3.0, radius=0.3)
    q, q_dot = motion(oscillator, PUSHED, np.linspace(0, oscillator.period, 101))
    q_dot = np.array(wrong)[:, None] * q_dot
    energy = total_energy(oscillator, q, q_dot)
    assert spread(energy) > 1e-3 * energy.max()
    conserved = momenta(oscillator, q_dot)
    assert spread(conserved["p_X"]) > 1e-3
    # φ̇ does not enter p_Φ, so its sign cannot break that law.
    assert (spread(conserved["p_Phi"]) > 1e-3) == (wrong[1] == 1)


@pytest.mark.parametrize("factor", [1 + 1e-9, 1 - 1e-9])
def test_the_flatness_would_show_an_error_of_a_billionth_in_the_frequency(factor):
    oscillator = Oscillator(m=2.0, m_prime=1.5, k=3.0, radius=0.3)
    q, q_dot = motion(oscillator, released(oscillator, 0.1), np.linspace(0, oscillator.period, 101))
    energy = total_energy(oscillator, q, factor * q_dot)
    assert spread(energy) > FLAT * energy.min()


@BRIEFLY
@given(MACHINES, STARTS, st.floats(-1e3, 1e3))
def test_the_bodies_add_up_to_the_matrices(oscillator, initial, t):
    q, q_dot = motion(oscillator, initial, t)
    quadratic = (q_dot @ oscillator.mass_matrix @ q_dot + q @ oscillator.stiffness_matrix @ q) / 2
    # The quadratic form cancels between its mixed terms, the sum of squares does not: compare on the former's scale.
    scale = np.abs(q_dot) @ np.abs(oscillator.mass_matrix) @ np.abs(q_dot) + quadratic
    assert abs(total_energy(oscillator, q, q_dot) - quadratic) <= 1e-14 * scale
    p_X, _, p_Phi = oscillator.mass_matrix @ q_dot
    found = momenta(oscillator, q_dot)
    scale_X, scale_Phi = momentum_scales(oscillator, q_dot[:, None])
    assert abs(found["p_X"] - p_X) <= 1e-14 * scale_X
    assert abs(found["p_Phi"] - p_Phi) <= 1e-14 * scale_Phi


def exact_state(oscillator, initial, t):
    """The state at t to 60 digits, from the mass matrix alone: q̈ = −M⁻¹Kq oscillates along M⁻¹e_φ only."""
    with mpmath.workdps(60):
        m, m_prime, k, R, time = map(mpmath.mpf, (oscillator.m, oscillator.m_prime, oscillator.k, oscillator.radius, t))
        mass = mpmath.matrix(
            [
                [3 * m + 2 * m_prime, -2 * (m + m_prime) * R, -m * R],
                [-2 * (m + m_prime) * R, (4 * m + 7 * m_prime / 2) * R**2, 0],
                [-m * R, 0, 3 * m * R**2 / 2],
            ]
        )
        column = mpmath.lu_solve(mass, mpmath.matrix([0, 1, 0]))
        omega = mpmath.sqrt(4 * k * R**2 * column[1])
        start = [mpmath.mpf(value) for value in (initial.X, initial.phi, initial.Phi)]
        speed = [mpmath.mpf(value) for value in (initial.X_dot, initial.phi_dot, initial.Phi_dot)]
        cosine, sine = mpmath.cos(omega * time), mpmath.sin(omega * time)
        phi = start[1] * cosine + speed[1] / omega * sine
        phi_dot = speed[1] * cosine - start[1] * omega * sine
        shape = [entry / column[1] for entry in column]
        drift = [v - c * speed[1] for v, c in zip(speed, shape, strict=True)]
        q = [x + d * time + c * (phi - start[1]) for x, d, c in zip(start, drift, shape, strict=True)]
        q_dot = [d + c * phi_dot for d, c in zip(drift, shape, strict=True)]
        return q, q_dot, omega


def exact_energies(oscillator, q, q_dot):
    """Each body's energy, with the velocities of the rolling bodies' rims added up from the ground."""
    with mpmath.workdps(60):
        m, m_prime, k, R = map(mpmath.mpf, (oscillator.m, oscillator.m_prime, oscillator.k, oscillator.radius))
        block = -q_dot[0]
        axis = block + R * q_dot[1]
        slab = axis + R * q_dot[1]
        top = block + R * q_dot[2]
        return {
            "block_translation": m * block**2 / 2,
            "hoop_translation": m_prime * axis**2 / 2,
            "hoop_rotation": m_prime * R**2 * q_dot[1] ** 2 / 2,
            "cylinder_translation": m_prime * axis**2 / 2,
            "cylinder_rotation": (m_prime * R**2 / 2) * q_dot[1] ** 2 / 2,
            "slab_translation": m * slab**2 / 2,
            "top_translation": m * top**2 / 2,
            "top_rotation": (m * R**2 / 2) * q_dot[2] ** 2 / 2,
            "spring": k * (2 * R * q[1]) ** 2 / 2,
        }


@pytest.mark.parametrize("ratio", RATIOS)
@pytest.mark.parametrize("periods", [0.3, 1000.7, 1e9 + 0.4, 1e12 + 0.1, 3e15, 9.9e17])
def test_phase_and_energies_stay_right_far_out(ratio, periods):
    oscillator = Oscillator(m=0.7, m_prime=0.7 * ratio, k=12.3, radius=0.11)
    t = periods * oscillator.period
    q, q_dot = motion(oscillator, PUSHED, t)
    exact_q, exact_q_dot, omega = exact_state(oscillator, PUSHED, t)
    with mpmath.workdps(60):
        phase = mpmath.atan2(-q_dot[1] / omega, q[1]) - mpmath.atan2(-exact_q_dot[1] / omega, exact_q[1])
        # Both angles lie in (−π, π]; a difference near a full turn is a small one.
        assert abs(mpmath.sin(phase)) < 1e-12
        assert mpmath.cos(phase) > 0
    exact = exact_energies(oscillator, exact_q, exact_q_dot)
    found = energies(oscillator, q, q_dot)
    assert found.keys() == exact.keys()
    total = float(sum(exact.values()))
    for name, value in exact.items():
        # A phase error of 1e-12 rad moves an energy by at most that share of the total.
        assert abs(found[name] - float(value)) < 1e-12 * total, name


@pytest.mark.parametrize("t", [1.001e18, -1e30, 1e300, [0.0, 1e308]])
def test_farther_out_the_time_is_refused(t):
    oscillator = Oscillator(k=1e3)
    with pytest.raises(ValueError, match=r"^t must not exceed 10¹⁸ periods"):
        motion(oscillator, PUSHED, t)


def test_the_plain_phase_would_fail_that_test():
    oscillator = Oscillator(m=0.7, m_prime=0.7, k=12.3, radius=0.11)
    t = (1e9 + 0.4) * oscillator.period
    exact_q, _, _ = exact_state(oscillator, released(oscillator, 0.2), t)
    naive = 0.2 / (2 * oscillator.radius) * np.cos(oscillator.natural_frequency * t)
    assert abs(naive - float(exact_q[1])) > 1e-9


@BRIEFLY
@given(MACHINES, decimals(-1, 1))
def test_released_at_rest_the_energy_is_the_springs_and_the_momenta_are_zero(oscillator, compression):
    q, q_dot = motion(oscillator, released(oscillator, compression), np.linspace(0, oscillator.period, 9))
    expected = oscillator.k * compression**2 / 2
    np.testing.assert_allclose(total_energy(oscillator, q, q_dot), expected, rtol=1e-14, atol=1e-300)
    for values, scale in zip(momenta(oscillator, q_dot).values(), momentum_scales(oscillator, q_dot), strict=True):
        assert np.all(np.abs(values) <= 1e-14 * scale)


@BRIEFLY
@given(MACHINES)
def test_the_center_of_mass_stands_still_after_a_release(oscillator):
    initial = released(oscillator, 0.2)
    t = np.linspace(0, oscillator.period, 33)
    mass = {"hoop": oscillator.m_prime, "cylinder": oscillator.m_prime}
    start = ground_positions(oscillator, motion(oscillator, initial, 0.0)[0])
    now = ground_positions(oscillator, motion(oscillator, initial, t)[0])
    moment = sum(mass.get(body, oscillator.m) * (now[body] - start[body]) for body in now)
    assert np.all(np.abs(moment) < 1e-14 * (5 * oscillator.m + 2 * oscillator.m_prime))


def test_ground_displacements_of_equal_masses_are_the_papers_shares():
    # ε = 1, A = 13 mm: block −12/13, lower axes 1/13, slab 14/13, top cylinder −4/13 of A(cos Ωt − 1).
    oscillator = Oscillator(radius=0.1)
    initial = released(oscillator, 0.026)
    half_swing = motion(oscillator, initial, oscillator.period / 2)[0] - motion(oscillator, initial, 0.0)[0]
    millimetres = {body: 1000 * float(x) for body, x in ground_positions(oscillator, half_swing).items()}
    assert millimetres == pytest.approx({"block": 24, "hoop": -2, "cylinder": -2, "slab": -28, "top": 8}, abs=1e-12)
    over_block = {body: 1000 * float(x) for body, x in relative_positions(oscillator, half_swing).items()}
    assert over_block == pytest.approx({"hoop": -26, "cylinder": -26, "slab": -52, "top": -16}, abs=1e-12)


@pytest.mark.parametrize(
    ("positions", "velocities"), [(ground_positions, ground_velocities), (relative_positions, relative_velocities)]
)
def test_velocities_are_the_time_derivatives_of_the_positions(positions, velocities):
    oscillator = Oscillator(m=2.0, m_prime=1.5, k=3.0, radius=0.3)
    t = np.linspace(0, oscillator.period, 41)
    h = 1e-4
    ahead, behind = (positions(oscillator, motion(oscillator, PUSHED, t + s)[0]) for s in (h, -h))
    for body, velocity in velocities(oscillator, motion(oscillator, PUSHED, t)[1]).items():
        # A central difference errs by h²/6 of a third derivative of order 1.
        np.testing.assert_allclose((ahead[body] - behind[body]) / (2 * h), velocity, atol=1e-8)


def test_any_shape_of_times_goes_through():
    oscillator = Oscillator()
    t = np.linspace(0, 5, 12).reshape(3, 4)
    q, q_dot = motion(oscillator, PUSHED, t)
    flat = energies(oscillator, *motion(oscillator, PUSHED, t.ravel()))
    for name, values in energies(oscillator, q, q_dot).items():
        assert values.shape == (3, 4)
        np.testing.assert_array_equal(values.ravel(), flat[name])
    assert total_energy(oscillator, q, q_dot).shape == (3, 4)
    assert momenta(oscillator, q_dot)["p_Phi"].shape == (3, 4)
    assert ground_positions(oscillator, q[:, 1, 2])["slab"] == ground_positions(oscillator, q)["slab"][1, 2]


@pytest.mark.parametrize("bad", [1.0, [1.0, 2.0], [[1.0], [np.nan], [0.0]], [np.inf, 0.0, 0.0], "state", None])
def test_a_bad_state_is_named(bad):
    oscillator = Oscillator()
    good = [0.0, 0.1, 0.0]
    for call in (ground_positions, relative_positions):
        with pytest.raises(ValueError, match=r"\bq must"):
            call(oscillator, bad)
    for call in (ground_velocities, relative_velocities, momenta):
        with pytest.raises(ValueError, match=r"\bq_dot must"):
            call(oscillator, bad)
    with pytest.raises(ValueError, match=r"\bq must"):
        energies(oscillator, bad, good)
    with pytest.raises(ValueError, match=r"\bq_dot must"):
        total_energy(oscillator, good, bad)
