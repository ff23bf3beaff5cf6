"""Every numeric function from 1e-308 to 1e308, against mpmath: an ordinary double comes out right, the rest is refused.

The truth is the derivation's, printed to functions of mpmath and worked out with 60 digits or more; no formula of the
core takes part. Set RAMANUJAN_DEEP=1 for a hundred times as many machines.
"""

import itertools
import math
import os
import sys
from contextlib import suppress
from functools import cache

import mpmath
import numpy as np
import pytest

from ramanujan import (
    InitialState,
    Oscillator,
    contact_forces,
    energies,
    first_to_slip,
    ground_positions,
    ground_velocities,
    largest_compression,
    momenta,
    motion,
    normal_forces,
    relative_positions,
    relative_velocities,
    required_friction,
    travel_amplitude,
    with_initial_velocities,
)
from ramanujan.derivation.model import machine as derived_machine
from ramanujan.energy import body_momenta
from tests.test_one_physics import derived, evaluated

MANY = 100 if os.environ.get("RAMANUJAN_DEEP") else 1
mp = mpmath.mp.clone()
mp.dps = 60
SMALLEST, LARGEST = sys.float_info.min, sys.float_info.max
CONTACTS = ["hoop_slab", "cylinder_slab", "hoop_block", "cylinder_block", "top_block"]


def sizes(rng, count):
    """Positive doubles of every size, subnormal ones among them, with all their digits."""
    decades = rng.choice([3.0, 30.0, 150.0, 308.0]) if count else 0.0
    return [float(min(10.0 ** rng.uniform(-decades, decades) * rng.uniform(0.5, 1), LARGEST)) for _ in range(count)]


def machines(seed, count):
    rng = np.random.default_rng(seed)
    for _ in range(count):
        yield Oscillator(*sizes(rng, 4)), rng
    for m, m_prime, k in itertools.product((5e-324, 1e-310, 1.0, LARGEST), repeat=3):
        yield Oscillator(m, m_prime, k, 0.1), rng


def exact(value):
    return mp.mpf(float(value))


def in_range(truths):
    return all(value == 0 or SMALLEST <= abs(value) <= LARGEST for value in truths)


def check(call, truths, ulps, scales=None):
    """Call a function with its arguments; hold each value to its truth, to some ulps of the scale or of the truth.

    The call may be refused only if a truth or a scale is not an ordinary double. Return whether it was not.
    """
    truths = list(truths)
    scales = list(scales or truths)
    function, *arguments = call
    found = None
    with suppress(ValueError):
        found = function(*arguments)
    if found is None:
        assert not in_range([*truths, *scales]), (call, truths)
        return False
    values = [float(value) for value in np.ravel(list(found.values()) if isinstance(found, dict) else found)]
    assert len(values) == len(truths)
    for value, truth, scale in zip(values, truths, scales, strict=True):
        assert math.isfinite(value)
        error = abs(exact(value) - truth)
        # Below the normal numbers a result has fewer digits: half of the smallest double, a few times.
        assert error <= ulps * abs(scale) * mp.mpf(2) ** -52 + 4 * mp.mpf(5e-324), (value, truth)
    return True


@cache
def expressions():
    return derived(derived_machine())


def true(group, machine, *state):
    """What the derivation says of a machine in a state, with all digits that are asked for."""
    return [mp.mpf(evaluated(each, machine, *state, digits=mp.dps)) for each in expressions()[group].values()]


def truth_of(machine):
    """m, m′, k, R, Ω² and the mode shape (κR, 1, λ)."""
    shape, squared = true("mode shape", machine), true("frequency squared", machine)
    assert max(squared) - min(squared) <= mp.mpf(10) ** -50 * squared[0]
    return *map(exact, (machine.m, machine.m_prime, machine.k, machine.radius)), squared[0], *shape


def check_nearest(machine, name, truths):
    """A machine's numbers are the doubles nearest to the truths; they may be refused only if one is not ordinary."""
    values = None
    with suppress(ValueError):
        values = np.ravel(getattr(machine, name)).tolist()
    if values is None:
        assert not in_range(truths), (machine, name)
        return False
    for value, truth in zip(values, truths, strict=True):
        assert abs(exact(value) - truth) <= mp.mpf(math.ulp(value)) * (0.5 + mp.mpf(10) ** -50), (name, value, truth)
    return True


@pytest.mark.parametrize("seed", range(4))
def test_the_numbers_of_a_machine(seed):
    ordinary = 0
    mp.dps = 700  # M′ may be 1e-600 of the whole mass
    for machine, _ in machines(seed, 50 * MANY):
        m, mp_, k, R, omega_squared, *shape = truth_of(machine)
        ordinary += check_nearest(machine, "natural_frequency_squared", [omega_squared])
        check_nearest(machine, "natural_frequency", [mp.sqrt(omega_squared)])
        check_nearest(machine, "period", [2 * mp.pi / mp.sqrt(omega_squared)])
        check_nearest(machine, "effective_mass", [k / omega_squared])
        check_nearest(machine, "mass_ratio", [mp_ / m])
        if check_nearest(machine, "normalized_frequency_squared", [omega_squared * m / k]):
            assert machine.normalized_frequency_squared <= 7 / 4
        check_nearest(machine, "block_coupling", [shape[0] / R])
        check_nearest(machine, "mode_shape", shape)
        check_nearest(machine, "mass_matrix", true("mass matrix", machine))
        check_nearest(machine, "stiffness_matrix", true("stiffness matrix", machine))
    mp.dps = 60
    # Negative control: many of these machines do have a frequency.
    assert ordinary > 25 * MANY


@pytest.mark.parametrize("seed", range(2))
def test_the_contacts(seed):
    ordinary = 0
    mp.dps = 1400
    for machine, rng in itertools.islice(machines(100 + seed, 15 * MANY), 15 * MANY + 40):
        m, mp_, k, R = map(exact, (machine.m, machine.m_prime, machine.k, machine.radius))
        phi, g, mu = sizes(rng, 3)
        q = [rng.normal(), phi, rng.normal()]
        forces, pull = true("forces", machine, q), 2 * k * R * exact(phi)
        unit = dict(zip(CONTACTS, (force / pull for force in forces), strict=False))
        ordinary += check((contact_forces, machine, q), forces, 3)
        distance, weight = max(4 * R * exact(phi), 2 * R) * mp.mpf("1.01"), m * exact(g)
        if SMALLEST < distance < LARGEST / 2:
            distance = exact(float(distance))
            shift = R * exact(phi) / distance
            loads = [weight * (mp.mpf(1) / 2 - shift), weight * (mp.mpf(1) / 2 + shift)]
            loads += [load + mp_ * exact(g) for load in loads] + [weight]
            check((normal_forces, machine, q, g, float(distance)), loads, 6)
        for spacing in (mp.inf, distance):
            if spacing < mp.inf and not SMALLEST < spacing < LARGEST / 2:
                continue
            x = 2 * R * exact(phi)
            if not SMALLEST < x < LARGEST:
                continue
            x = exact(float(x))
            least = (1 - x / spacing) / 2
            carried = [weight * least] * 2 + [weight * least + mp_ * exact(g)] * 2 + [weight]
            needed = [k * x * abs(unit[name]) / load for name, load in zip(CONTACTS, carried, strict=True)]
            place = float(spacing)
            check((required_friction, machine, float(x), g, place), needed, 0.51)
            found = first_to_slip(machine, float(x), place)
            assert needed[CONTACTS.index(found)] >= max(needed) * (1 - mp.mpf(10) ** -50)
            bare = [weight / 2] * 2 + [weight / 2 + mp_ * exact(g)] * 2 + [weight]
            shifted = [exact(mu) * weight / 2 / spacing] * 4 + [0]
            bounds = [
                exact(mu) * load / (k * abs(unit[name]) + lost)
                for name, load, lost in zip(CONTACTS, bare, shifted, strict=True)
            ]
            if check((largest_compression, machine, mu, g, place), [min(bounds)], 1):
                largest = largest_compression(machine, mu, g, place)
                # Rounded down: it does not slip at this very compression.
                assert exact(largest) <= min(bounds)
    mp.dps = 60
    assert ordinary > 5 * MANY


def states(rng, machine):
    """A state of any size, with a time in any number of periods."""
    decades = rng.choice([2.0, 20.0, 200.0])
    fields = rng.choice([-1, 1], 6) * 10.0 ** rng.uniform(-decades, decades, 6) * (rng.uniform(size=6) < 0.7)
    return InitialState(*fields.tolist())


@pytest.mark.parametrize("seed", range(3))
def test_the_motion(seed):
    ordinary = 0
    mp.dps = 700
    for machine, rng in machines(200 + seed, 40 * MANY):
        _, _, _, R, omega_squared, *shape = truth_of(machine)
        omega = mp.sqrt(omega_squared)
        if not SMALLEST < omega < LARGEST:
            continue
        initial = states(rng, machine)
        t = float(10.0 ** rng.uniform(-30, 18) / omega) * float(rng.choice([-1, 1]))
        if not math.isfinite(t):
            continue
        # Up to 1e15 periods the phase is right to the last digit, and to 1e-12 rad where times end.
        ulps = 12 if abs(t) * omega < 1e15 else 5000
        start, rate = (
            [exact(getattr(initial, f"{name}{dot}")) for name in ("X", "phi", "Phi")] for dot in ("", "_dot")
        )
        cosine, sine = mp.cos(omega * exact(t)), mp.sin(omega * exact(t))
        # As far as the phase is known to 1e-15 rad: what that changes belongs to the scale.
        swing, push = start[1] * (cosine - 1), rate[1] / omega * sine
        unsure = mp.mpf(min(1, omega * abs(t)))
        reach = abs(start[1]) * unsure**2 + abs(rate[1]) / omega * unsure
        speed = abs(start[1]) * omega * unsure + abs(rate[1]) * unsure**2
        q, q_dot, scales, rates = [], [], [], []
        for i, share in enumerate(shape):
            drift = (rate[i] - share * rate[1]) * exact(t)
            q.append(start[i] + drift + share * (swing + push))
            scales.append(abs(start[i]) + abs(drift) + share * reach)
            q_dot.append(rate[i] + share * (rate[1] * (cosine - 1) - start[1] * omega * sine))
            rates.append(abs(rate[i]) + share * speed)
        ordinary += check((motion, machine, initial, t), q + q_dot, ulps, scales + rates)
        amplitude = R * mp.hypot(start[1], rate[1] / omega)
        check((travel_amplitude, machine, initial), [amplitude], 0.51)
    mp.dps = 60
    assert ordinary > 30 * MANY


def test_a_short_time_after_release_the_block_keeps_its_digits():
    machine = Oscillator(1.3, 0.7, 25.0, 0.12)
    for t in 10.0 ** np.arange(-150.0, 0.0, 7.0):
        *_, omega_squared, block, _, top = truth_of(machine)
        initial = with_initial_velocities(machine, 0.08)
        mp.dps = 400
        fallen = exact(initial.phi) * (mp.cos(mp.sqrt(omega_squared) * exact(t)) - 1)
        mp.dps = 60
        X, _, Phi = motion(machine, initial, t)[0]
        assert abs(exact(X) / (block * fallen) - 1) < 2e-15
        assert abs(exact(Phi) / (top * fallen) - 1) < 2e-15


@pytest.mark.parametrize("seed", range(2))
def test_energies_momenta_and_positions(seed):
    """With X against all others no term takes digits from another: that is the scale."""
    ordinary = 0
    for machine, rng in machines(300 + seed, 60 * MANY):
        decades = rng.choice([2.0, 50.0, 150.0])
        state = [rng.choice([-1, 1], 3) * 10.0 ** rng.uniform(-decades, decades, 3) for _ in range(2)]
        (q, q_dot), apart = state, [abs(each) * [-1, 1, 1] for each in state]

        def hold(function, group, ulps, *given, machine=machine, state=state, apart=apart):
            truths, scales = (true(group, machine, *each) for each in (state, apart))
            return check((function, machine, *given), truths, ulps, scales)

        hold(ground_positions, "places", 2, q)
        hold(relative_positions, "places on the block", 2, q)
        turning = [exact(machine.radius) * exact(each) for each in (2 * q[1], *q_dot[1:])]
        sizes_ = [*turning, *true("velocities", machine, *apart), *true("momenta of bodies", machine, *apart)]
        if in_range(sizes_):
            hold(ground_velocities, "velocities", 2, q_dot)
            hold(relative_velocities, "velocities on the block", 2, q_dot)
            hold(body_momenta, "momenta of bodies", 4, q_dot)
            hold(momenta, "momenta", 8, q_dot)
            ordinary += hold(energies, "energies", 8, q, q_dot)
    assert ordinary > 15 * MANY
