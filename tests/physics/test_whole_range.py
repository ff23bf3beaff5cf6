"""The numeric core, compared with the derivation in 60-digit arithmetic: frequencies, motion, energies, contacts."""

import math
import sys
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy as sp

import ramanujan as core
from ramanujan.derivation.model import machine as derived_machine
from ramanujan.physics.energy import body_momenta
from tests.checks.derived import CONTACTS, derived, evaluated

mp = mpmath.mp.clone()
mp.dps = 60


@cache
def expressions():
    bodies = derived_machine()
    return derived(bodies) | {"loads": normal_forces(bodies)}


def normal_forces(bodies):
    """Return the normal force at every contact, from the balances of vertical forces and of the slab's moments.

    L is the distance between the axes of the lower rollers. For φ = 0 the middle of the slab is midway between them.
    """
    L, g, on_hoop, on_cylinder = sp.symbols("L g N_hoop N_cylinder", positive=True)
    shift = bodies["slab"].displacement - bodies["hoop"].displacement
    vertical_forces = on_hoop + on_cylinder - bodies["slab"].mass * g
    moments = on_hoop * (L / 2 + shift) - on_cylinder * (L / 2 - shift)
    loads = sp.solve((vertical_forces, moments), (on_hoop, on_cylinder))
    weights = {name: bodies[name].mass * g for name in ("hoop", "cylinder", "top")}
    # The block also carries the weight of the roller.
    return {
        "hoop_slab": loads[on_hoop],
        "cylinder_slab": loads[on_cylinder],
        "hoop_block": loads[on_hoop] + weights["hoop"],
        "cylinder_block": loads[on_cylinder] + weights["cylinder"],
        "top_block": weights["top"],
    }


def true_values(group, machine, *state, **others):
    """Return the values of a group of expressions of the derivation, with 60 digits."""
    values = []
    for expression in expressions()[group].values():
        values.append(mp.mpf(evaluated(expression, machine, *state, digits=mp.dps, **others)))
    return values


def machines(count, decades, seed=43):
    """Return random machines with parameters between 10^−decades and 10^decades."""
    rng = np.random.default_rng(seed)
    return [core.Oscillator(*(10.0 ** rng.uniform(-decades, decades, 4)).tolist()) for _ in range(count)]


WORST_FREQUENCY = (1.760409489788429, 4812.295307773484, 0.4405939338726505)
"""m, m′ and k of the greatest known error of Ω², 5.04 ulp."""


def test_every_frequency_within_6_ulp_or_an_error():
    rng = np.random.default_rng(1729)
    normal, refused = 0, 0
    for m, m_prime, k in (WORST_FREQUENCY, *(10.0 ** rng.uniform(-300, 300, (864, 3))).tolist()):
        ratios = [mp.mpf(m_prime) / m, mp.mpf(k) / m]
        # The constructor raises for some of these parameters, so the exact values are computed for a stand-in.
        stand_in = type("Machine", (), {"m": m, "m_prime": m_prime, "k": k, "radius": 1.0})()
        squared = true_values("frequency squared", stand_in)[0]
        if all(sys.float_info.min < value < sys.float_info.max for value in (*ratios, squared)):
            machine = core.Oscillator(m, m_prime, k)
            for value, truth in (
                (machine.natural_frequency_squared, squared),
                (machine.natural_frequency, mp.sqrt(squared)),
                (machine.period, 2 * mp.pi / mp.sqrt(squared)),
                (machine.effective_mass, k / squared),
            ):
                assert abs(value - truth) <= 6 * math.ulp(value)
            normal += 1
        elif any(value < mp.mpf(10) ** -325 or value > mp.mpf(10) ** 309 for value in (*ratios, squared)):
            with pytest.raises(ValueError, match=r"m_prime/m = .* must be finite positive numbers for Oscillator\(m="):
                core.Oscillator(m, m_prime, k)
            refused += 1
    assert min(normal, refused) > 200


QUANTITIES = {
    "mass matrix": lambda machine, _q, _v: machine.mass_matrix,
    "stiffness matrix": lambda machine, _q, _v: machine.stiffness_matrix,
    "mode shape": lambda machine, _q, _v: machine.mode_shape,
    "places": lambda machine, q, _v: [*core.ground_positions(machine, q).values()],
    "places on the block": lambda machine, q, _v: [*core.relative_positions(machine, q).values()],
    "velocities": lambda machine, _q, v: [*core.ground_velocities(machine, v).values()],
    "velocities on the block": lambda machine, _q, v: [*core.relative_velocities(machine, v).values()],
    "energies": lambda machine, q, v: [*core.energies(machine, q, v).values()],
    "momenta": lambda machine, _q, v: [*core.momenta(machine, v).values()],
    "momenta of bodies": lambda machine, _q, v: [*body_momenta(machine, v).values()],
    "forces": lambda machine, q, _v: [*core.contact_forces(machine, q).values()],
}
"""Group of the derivation → a function of machine, q and q̇ that returns the core's values, in the group's order."""


@pytest.mark.parametrize("group", QUANTITIES)
def test_every_quantity_of_a_state(group):
    rng = np.random.default_rng(7)
    for machine in machines(30, 3):
        q, v = 10.0 ** rng.uniform(-3, 3, (2, 3)) * rng.choice([-1, 1], (2, 3))
        # With these signs all terms of a sum have the same sign. The result is the scale of the rounding errors.
        apart = [abs(each) * [-1, 1, 1] for each in (q, v)]
        values = np.ravel(QUANTITIES[group](machine, q, v))
        for value, truth, scale in zip(
            values, true_values(group, machine, q, v), true_values(group, machine, *apart), strict=True
        ):
            assert abs(value - truth) <= 1e-14 * abs(scale)


@pytest.mark.parametrize(("periods", "error"), [(1, 1e-14), (1e3, 1e-11), (1e6, 1e-8)])
def test_the_state_at_any_time(periods, error):
    rng = np.random.default_rng(11)
    for machine in machines(30, 3):
        start, rate = rng.normal(size=(2, 3)) * [[0.1, 0.4, 2.0]] * [[1.0], [machine.natural_frequency]]
        check_state(machine, start.tolist(), rate.tolist(), periods * machine.period * rng.uniform(0.1, 1), error)


def test_a_long_drift_is_rounded_in_its_own_last_digits():
    # After 1,283 s the top cylinder has turned by 3,851 rad, and the oscillation has an amplitude of 0.01 rad.
    machine = core.Oscillator(3.2290255, 0.5887649, 48.196273, 0.2)
    check_state(machine, [0.0, 0.0062 / 0.4, 0.0], [0.0, 0.0, -3.0], 1283.56, 1e-11)


def check_state(machine, start, rate, t, error):
    """Compare the state at the time t with the exact one. `error` is relative to the amplitude."""
    shape, squared = true_values("mode shape", machine), true_values("frequency squared", machine)[0]
    omega = mp.sqrt(squared)
    cosine, sine = mp.cos(omega * t), mp.sin(omega * t)
    swing = start[1] * (cosine - 1) + rate[1] / omega * sine
    change = rate[1] * (cosine - 1) - start[1] * omega * sine
    amplitude = mp.hypot(start[1], rate[1] / omega)
    state = core.motion(machine, core.InitialState(*start, *rate), t)
    for i, (q, q_dot) in enumerate(zip(*state, strict=True)):
        drift = (rate[i] - shape[i] * rate[1]) * mp.mpf(t)
        scale = shape[i] * amplitude
        rounding = 1e-15 * (abs(start[i]) + (abs(rate[i]) + shape[i] * abs(rate[1])) * t)
        assert abs(q - (start[i] + drift + shape[i] * swing)) <= error * scale + rounding
        assert abs(q_dot - (rate[i] + shape[i] * change)) <= (error * scale * omega + 1e-15 * abs(rate[i]))


def test_the_motion_conserves_energy_and_both_momenta():
    for machine in machines(30, 2):
        speed = machine.natural_frequency
        initial = core.InitialState(0.1, 0.4, -2.0, 0.1 * speed * machine.radius, 0.3 * speed, -speed)
        q, q_dot = core.motion(machine, initial, np.linspace(0, 3 * machine.period, 301))
        energy = np.sum([*core.energies(machine, q, q_dot).values()], axis=0)
        assert np.ptp(energy) <= 1e-12 * energy[0]
        terms = np.abs(machine.mass_matrix)[:, :, None] * np.abs(q_dot)
        for momentum, scale in zip(core.momenta(machine, q_dot).values(), terms.sum(axis=1)[[0, 2]], strict=True):
            assert np.ptp(momentum) <= 1e-12 * scale.max()


@pytest.mark.parametrize("t", 10.0 ** np.arange(-150, 0, 21))
def test_shortly_after_a_release_the_block_has_full_precision(t):
    machine = core.Oscillator(1.3, 0.7, 25.0, 0.12)
    shape, squared = true_values("mode shape", machine), true_values("frequency squared", machine)[0]
    initial = core.released(machine, 0.08)
    X, _phi, Phi = core.motion(machine, initial, float(t))[0]
    with mp.workdps(400):
        fallen = initial.phi * (mp.cos(mp.sqrt(squared) * float(t)) - 1)
    assert abs(X / (shape[0] * fallen) - 1) < 4e-15
    assert abs(Phi / (shape[2] * fallen) - 1) < 4e-15


def test_loads_and_required_friction():
    rng = np.random.default_rng(5)
    for machine in machines(30, 3):
        A, g = machine.radius * rng.uniform(0.1, 2), rng.uniform(1, 20)
        spacing = 2 * max(A, machine.radius) * rng.uniform(1.2, 4)
        needed = dict.fromkeys(CONTACTS, mp.mpf(0))
        for phi in (A / machine.radius, -A / machine.radius):
            q = (0.0, phi, 0.0)
            loads = dict(zip(CONTACTS, true_values("loads", machine, q, L=spacing, g=g), strict=True))
            for name, load in core.normal_forces(machine, q, g, spacing).items():
                assert abs(load - loads[name]) <= 1e-13 * (machine.m + machine.m_prime) * g
            for name, force in zip(CONTACTS, true_values("forces", machine, q), strict=False):
                needed[name] = max(needed[name], abs(force) / loads[name])
        for name, value in core.required_friction(machine, 2 * A, g, spacing).items():
            assert abs(value / needed[name] - 1) <= 1e-13


@pytest.mark.parametrize("shape", [(), (5,), (2, 3), (0,)])
@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.int64])
def test_times_of_any_shape_and_type(shape, dtype):
    t = np.arange(np.prod(shape), dtype=dtype).reshape(shape)
    t.flags.writeable = False
    machine, initial = core.Oscillator(), core.InitialState(0.4, 0.3, -1.0, 0.2, -0.7, 1.5)
    q, q_dot = core.motion(machine, initial, t)
    assert q.shape == q_dot.shape == (3, *shape)
    assert np.array_equal(np.ravel(core.motion(machine, initial, 0.0)), [0.4, 0.3, -1.0, 0.2, -0.7, 1.5])
    for index in np.ndindex(*shape):
        # `math.sin` for a single time and `np.sin` for an array may differ in the last digit.
        single = core.motion(machine, initial, float(t[index]))
        assert np.allclose(np.concatenate([q, q_dot])[:, *index], np.concatenate(single), rtol=0, atol=1e-15)
