"""Every numeric function from 1e-308 to 1e308, against mpmath: an ordinary double comes out right, the rest is refused.

The truth is computed with 60 digits from the mass matrix of the paper and from Newton's thirteen equations; no formula
of the core takes part. Set RAMANUJAN_DEEP=1 for a hundred times as many machines.
"""

import itertools
import math
import os
import sys
from contextlib import suppress

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
    largest_compression,
    momenta,
    motion,
    normal_forces,
    required_friction,
    travel_amplitude,
    with_initial_velocities,
)
from ramanujan.derivation.symbols import machine as derived_machine
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


def truth_of(machine):
    """m, m′, k, R, M, Ω², Ω and the mode shape (κR, 1, λ)."""
    m, mp_, k, R = map(exact, (machine.m, machine.m_prime, machine.k, machine.radius))
    # In metres, with Rφ and RΦ for the angles: R drops out, and the system is well scaled by m or m′.
    big = max(m, mp_)
    mass = mp.matrix(
        [
            [(3 * m + 2 * mp_) / big, -2 * (m + mp_) / big, -m / big],
            [-2 * (m + mp_) / big, (4 * m + mp_ * 7 / 2) / big, 0],
            [-m / big, 0, m * 3 / 2 / big],
        ]
    )
    cofactor = mass[0, 0] * mass[2, 2] - mass[0, 2] * mass[2, 0]
    determinant = mass[1, 1] * cofactor - mass[0, 1] * mass[1, 0] * mass[2, 2]
    omega_squared = 4 * k / big * cofactor / determinant
    # The first and third rows of (K − Ω²M)(X, Rφ, RΦ) = 0.
    kappa = (-mass[0, 1] * mass[2, 2]) / cofactor
    lambda_ = -mass[2, 0] * kappa / mass[2, 2]
    return m, mp_, k, R, omega_squared, kappa, lambda_


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
        m, mp_, k, R, omega_squared, kappa, lambda_ = truth_of(machine)
        ordinary += check_nearest(machine, "natural_frequency_squared", [omega_squared])
        check_nearest(machine, "natural_frequency", [mp.sqrt(omega_squared)])
        check_nearest(machine, "period", [2 * mp.pi / mp.sqrt(omega_squared)])
        check_nearest(machine, "effective_mass", [k / omega_squared])
        check_nearest(machine, "mass_ratio", [mp_ / m])
        if check_nearest(machine, "normalized_frequency_squared", [omega_squared * m / k]):
            assert machine.normalized_frequency_squared <= 7 / 4
        check_nearest(machine, "block_coupling", [kappa])
        check_nearest(machine, "mode_shape", [kappa * R, 1, lambda_])
        matrix = [3 * m + 2 * mp_, -2 * (m + mp_) * R, -m * R]
        matrix += [-2 * (m + mp_) * R, (4 * m + mp_ * 7 / 2) * R**2, 0, -m * R, 0, m * R**2 * 3 / 2]
        check_nearest(machine, "mass_matrix", matrix)
        check_nearest(machine, "stiffness_matrix", [0] * 4 + [4 * k * R**2] + [0] * 4)
    mp.dps = 60
    # Negative control: many of these machines do have a frequency.
    assert ordinary > 25 * MANY


def newton(m, mp_):
    """The five contact forces for a unit force of the spring on block and slab, from Newton's thirteen equations.

    Accelerations relative to the ground of block b, hoop h, cylinder c, slab s and top cylinder t; Rα of the three
    rolling bodies; forces on the rollers. All count to the right, angles clockwise. A force to the right at the top of
    a body turns it clockwise, at its foot the other way.
    """
    b, h, c, s, t, spin_h, spin_c, spin_t, hs, cs, hb, cb, tb = range(13)
    rows = [
        ({b: m, hb: 1, cb: 1, tb: 1}, 1),
        ({h: mp_, hs: -1, hb: -1}, 0),
        ({c: mp_, cs: -1, cb: -1}, 0),
        ({s: m, hs: 1, cs: 1}, -1),
        ({t: m, tb: -1}, 0),
        ({spin_h: mp_, hs: -1, hb: 1}, 0),
        ({spin_c: mp_ / 2, cs: -1, cb: 1}, 0),
        ({spin_t: m / 2, tb: 1}, 0),
        ({h: 1, spin_h: -1, b: -1}, 0),
        ({c: 1, spin_c: -1, b: -1}, 0),
        ({h: 1, spin_h: 1, s: -1}, 0),
        ({c: 1, spin_c: 1, s: -1}, 0),
        ({t: 1, spin_t: -1, b: -1}, 0),
    ]
    matrix, right = mp.matrix(13, 13), mp.matrix(13, 1)
    for row, (terms, value) in enumerate(rows):
        right[row] = value
        for column, entry in terms.items():
            matrix[row, column] = entry
    return dict(zip(CONTACTS, list(mp.lu_solve(matrix, right))[8:], strict=True))


@pytest.mark.parametrize("seed", range(2))
def test_the_contacts(seed):
    ordinary = 0
    mp.dps = 1400
    for machine, rng in itertools.islice(machines(100 + seed, 15 * MANY), 15 * MANY + 40):
        m, mp_, k, R = map(exact, (machine.m, machine.m_prime, machine.k, machine.radius))
        phi, g, mu = sizes(rng, 3)
        unit = newton(m / max(m, mp_), mp_ / max(m, mp_))
        q = [rng.normal(), phi, rng.normal()]
        pull = 2 * k * R * exact(phi)
        ordinary += check((contact_forces, machine, q), [pull * unit[name] for name in CONTACTS] + [-pull], 3)
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
        _, _, _, R, omega_squared, kappa, lambda_ = truth_of(machine)
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
        for i, shape in enumerate((kappa * R, mp.mpf(1), lambda_)):
            drift = (rate[i] - shape * rate[1]) * exact(t)
            q.append(start[i] + drift + shape * (swing + push))
            scales.append(abs(start[i]) + abs(drift) + shape * reach)
            q_dot.append(rate[i] + shape * (rate[1] * (cosine - 1) - start[1] * omega * sine))
            rates.append(abs(rate[i]) + shape * speed)
        ordinary += check((motion, machine, initial, t), q + q_dot, ulps, scales + rates)
        amplitude = R * mp.hypot(start[1], rate[1] / omega)
        check((travel_amplitude, machine, initial), [amplitude], 0.51)
    mp.dps = 60
    assert ordinary > 30 * MANY


def test_a_short_time_after_release_the_block_keeps_its_digits():
    machine = Oscillator(1.3, 0.7, 25.0, 0.12)
    for t in 10.0 ** np.arange(-150.0, 0.0, 7.0):
        _, _, _, R, omega_squared, kappa, lambda_ = truth_of(machine)
        initial = with_initial_velocities(machine, 0.08)
        mp.dps = 400
        fallen = exact(initial.phi) * (mp.cos(mp.sqrt(omega_squared) * exact(t)) - 1)
        mp.dps = 60
        X, _, Phi = motion(machine, initial, t)[0]
        assert abs(exact(X) / (kappa * R * fallen) - 1) < 2e-15
        assert abs(exact(Phi) / (lambda_ * fallen) - 1) < 2e-15


@pytest.mark.parametrize("seed", range(2))
def test_energies_momenta_and_positions(seed):
    """Against the derivation, printed to mpmath; with X against all others no term takes digits from another."""
    expressions, ordinary = derived(derived_machine()), 0
    for machine, rng in machines(300 + seed, 60 * MANY):
        decades = rng.choice([2.0, 50.0, 150.0])
        state = [rng.choice([-1, 1], 3) * 10.0 ** rng.uniform(-decades, decades, 3) for _ in range(2)]
        (q, q_dot), apart = state, [abs(each) * [-1, 1, 1] for each in state]

        def truths(group, state, machine=machine):
            return [evaluated(expression, machine, *state) for expression in expressions[group].values()]

        def hold(call, group, ulps, truths=truths, state=state, apart=apart):
            return check(call, truths(group, state), ulps, truths(group, apart))

        hold((ground_positions, machine, q), "places", 2)
        turning = [exact(machine.radius) * exact(each) for each in (2 * q[1], *q_dot[1:])]
        if in_range([*turning, *truths("velocities", apart), *truths("momenta of bodies", apart)]):
            ordinary += hold((energies, machine, q, q_dot), "energies", 8)
            hold((momenta, machine, q_dot), "momenta", 8)
    assert ordinary > 15 * MANY
