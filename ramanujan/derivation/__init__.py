"""Each route derives Ω² from the bodies and their rolling constraints, by SymPy.

`ROUTES` maps a name to a `Route`, which is derived at its first use and cached. Jupyter displays routes and steps as
Markdown.

>>> from ramanujan.derivation import ROUTES
>>> ROUTES["matrix"].natural_frequency_squared
8*k*(7*m + 6*m_prime)/(32*m**2 + 49*m*m_prime + 18*m_prime**2)
"""

from ramanujan.derivation.steps import ROUTES, Route, Step

# Each file adds its route to `ROUTES`, in the order in which a course would take them.
# isort: off
from ramanujan.derivation import euler_lagrange, hamilton, newton, energy_conservation, matrix
# isort: on
