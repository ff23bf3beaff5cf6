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
    Ω, T            natural frequency [rad/s], period [s];   Ω²m/k = 8(7 + 6ε)/(18ε² + 49ε + 32)
    M_x             effective mass k/Ω² [kg], the mass that the spring feels
    M, K            mass matrix, stiffness matrix

The core, `physics`, is eight files of plain floating-point arithmetic. An `Oscillator` has four parameters: m, m′, k
and R. An `InitialState` then determines the motion (q, q̇), which `motion` evaluates in closed form. Energies, momenta
and contact forces are functions of the state (q, q̇). A record contains all of them at equal time steps.

    file           equations of the paper                                      results
    frequency      (8) Ω²m/k at ε = 1, (12) Ω², (13) inverse, (14) ε*          Ω²m/k over ε, ε for a given Ω²m/k
    oscillator     (9) L = ½q̇ᵀMq̇ − ½qᵀKq, (10) Mq̈ + Kq = 0, (11) mode shape    Ω, T, M_x, M and K of a machine
    motion         x = 2Rφ, (1) velocities, (11) and (12) integrated           q(t), q̇(t), motion of each body
    energy         (1) ½mv², ½Iω², ½kx²; (10a), (10b) momenta                  energies by body, p_X, p_Φ
    contact        none; forces that enforce rolling without slipping          forces, friction, first slip
    record         none                                                        all of these on a time grid
    integrators    none                                                        step methods for x″ = a(x)
    validation     none                                                        checks of numbers and arrays

Example for a notebook:

    from ramanujan import Oscillator, motion, released

    machine = Oscillator(m=1, m_prime=1.127, k=10)
    q, q_dot = motion(machine, released(machine, 0.08), [0, 0.5, 1])

The other equations are steps of the package `derivation`; `.github/paper.md` lists all equations. `number_theory`
explains 1729, `accuracy` measures errors and costs, `lesson` asks, `answers` judges, `classroom` counts the votes of a
class, `figures` and `browser` draw, `pages` has one folder for each page, and all pages share `shell`. `standalone`
writes the first page as one file, and `server` acts before a page runs. All use the language of `text`.
"""

from ramanujan.physics.contact import (
    contact_forces,
    first_to_slip,
    largest_compression,
    normal_forces,
    required_friction,
    travel_amplitude,
)
from ramanujan.physics.energy import energies, momenta
from ramanujan.physics.frequency import UNIT_MASS_RATIO, mass_ratio_for, normalized_frequency_squared
from ramanujan.physics.integrators import METHODS, trajectory
from ramanujan.physics.motion import (
    InitialState,
    ground_positions,
    ground_velocities,
    motion,
    relative_positions,
    relative_velocities,
    released,
    with_initial_velocities,
)
from ramanujan.physics.oscillator import Oscillator, drawn_edges, drawn_spacing
