r"""Ramanujan's oscillator: a machine whose frequency is √(k/m) exactly when m′/m = (√1729 − 1)/36.

                                          ___
                                         / | \   top cylinder  m, R, angle Φ
                                         \_|_/
                          k        ____________________
        [====== slab  m =====]/\/\/|                   |
           ___          ___        |                   |
          / | \        / | \       |                   |      every contact rolls without slipping,
          \___/        \_|_/       |                   |      the floor is frictionless
      _____________________________|      block  m     |
     |   hoop m′, R   cylinder m′, R                   |
     |________________angle φ__________________________|
    ‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾‾   floor,   X ←

    q = (X, φ, Φ)   generalized coordinates: the block's displacement, counted to the LEFT; the angle of both lower
                    rollers and that of the top cylinder, clockwise, so that they roll to the RIGHT over the block
    m, m′, k, R     masses [kg], stiffness [N/m], radius [m];   ε = m′/m is the mass ratio
    2Rφ             deformation of the spring, positive in compression;   x₀ its value at release
    Ω               natural frequency [rad/s];   Ω²m/k = 8(7 + 6ε)/(18ε² + 49ε + 32)

A notebook needs this package alone:

    from ramanujan import Oscillator, motion, released

    machine = Oscillator(m=1, m_prime=1.127, k=10)
    q, q_dot = motion(machine, released(machine, 0.08), [0, 0.5, 1])

One motion with everything known of it, and as CSV: `ramanujan.record`.

Reading order: `oscillator` and `frequency` (the numbers), `motion` (time), `energy` and `contact` (what it carries),
`derivation` (where the formulas come from), `number_theory` (why 1729), `integrators` and `accuracy` (what computing
costs), `figures` and `browser` (how it looks), `pages` (one folder each), `shell` (what all pages share). `validation`
says which arguments are accepted, and `rounding` how results keep their digits.
"""

from ramanujan.contact import (
    contact_forces,
    first_to_slip,
    largest_compression,
    normal_forces,
    required_friction,
    travel_amplitude,
)
from ramanujan.energy import energies, momenta
from ramanujan.frequency import UNIT_MASS_RATIO, mass_ratio_for, normalized_frequency_squared
from ramanujan.integrators import METHODS, trajectory
from ramanujan.motion import (
    InitialState,
    ground_positions,
    ground_velocities,
    motion,
    relative_positions,
    relative_velocities,
    released,
    with_initial_velocities,
)
from ramanujan.oscillator import Oscillator, drawn_spacing
