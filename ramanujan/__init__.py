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

Reading order: `oscillator` (the numbers), `motion` (time), `energy` and `contact` (what it carries), `derivation`
(where the formulas come from), `number_theory` (why 1729), `integrators` and `accuracy` (what computing costs),
`figures` and `stage` (how it looks), `scenes` (the pages).
"""

from ramanujan.oscillator import UNIT_MASS_RATIO, Oscillator, mass_ratio_for, normalized_frequency_squared

__all__ = ["UNIT_MASS_RATIO", "Oscillator", "mass_ratio_for", "normalized_frequency_squared"]
