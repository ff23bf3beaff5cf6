"""The exact number theory behind 1729: all arguments and results are integers or `Fraction`s.

    integers   factors, fields, sums of two cubes
    bodies     rolling bodies → the quadratic for the mass ratio ε = m′/m at which Ω²m/k = w; the 40 machines

For the paper's machine (hoop and cylinder below, cylinder on top) and w = 1 the quadratic is 18ε² + ε − 24 = 0, of
discriminant 1729 = 1³ + 12³ = 9³ + 10³.
"""

from ramanujan.number_theory.bodies import (
    BODIES,
    BodyChoice,
    machines,
    normalized_frequency_squared_exact,
    unit_quadratic,
)
from ramanujan.number_theory.integers import (
    discriminant,
    factorization,
    field_discriminant,
    smallest_taxicab,
    squarefree_part,
    sums_of_two_cubes,
)
