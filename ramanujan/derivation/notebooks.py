"""The code that all notebooks share: plain SymPy that starts from the bodies.

The app does not run this code, and the code contains no result. Each notebook consists of `BODIES` and the cells of its
route. `CHECK` then compares its Ω² with the root of det(K − ω²M) = 0. A notebook with the numbers of a machine also
computes its distance from Ω² = k/m (`DISTANCE`) and its Ω² (`FREQUENCY`).
"""

from ramanujan.text.names import PARTS
from ramanujan.text.translation import _

_SIGNS = _(
    "Displacements relative to the ground are positive to the right, X is positive to the left, angles are clockwise."
)

BODIES = f"""\
import sympy as sp

m, m_prime, k, R = sp.symbols("m m' k R", positive=True)
t = sp.Symbol("t")
X, phi, Phi = (sp.Function(name)(t) for name in ("X", "varphi", "Phi"))
q = (X, phi, Phi)
q_dot = tuple(x.diff(t) for x in q)

# {_SIGNS}
x_block = -X
x_roller = x_block + R * phi
x_slab = x_roller + R * phi
x_top = x_block + R * Phi


def kinetic_energy(mass, x, inertia=0, angle=sp.S.Zero):
    return mass * x.diff(t) ** 2 / 2 + inertia * angle.diff(t) ** 2 / 2


T = (
    kinetic_energy(m, x_block)
    + kinetic_energy(m_prime, x_roller, m_prime * R**2, phi)  # {PARTS["hoop"]}
    + kinetic_energy(m_prime, x_roller, m_prime * R**2 / 2, phi)  # {PARTS["cylinder"]}
    + kinetic_energy(m, x_slab)
    + kinetic_energy(m, x_top, m * R**2 / 2, Phi)
)
U = k * (x_slab - x_block) ** 2 / 2
L = sp.expand(T - U)
L"""

CHECK = """\
M, K, omega_squared = sp.hessian(T, q_dot), sp.hessian(U, q), sp.Symbol("omega^2")
roots = sp.roots((K - omega_squared * M).det(), omega_squared)
(independent,) = (root for root in roots if root != 0)
assert sp.cancel(Omega_squared - independent) == 0
Omega_squared"""

DISTANCE = """\
ratio = sp.Symbol("varepsilon", positive=True)
in_units_of_k_over_m = sp.factor(Omega_squared.subs(m_prime, ratio * m) * m / k)
(root,) = sp.solve(in_units_of_k_over_m - 1, ratio)
present = sp.radsimp((m_prime / m).subs(values))
distance = sp.radsimp(sp.expand(present - root))
{
    "ratio": present,
    "Omega^2 m/k": sp.radsimp(in_units_of_k_over_m.subs(ratio, present)),
    "distance from the root": (distance, distance.n(8)),
}"""

FREQUENCY = "sp.radsimp(Omega_squared.subs(values))"
