"""The code of each route's notebook: plain SymPy that starts from the bodies and works out every step again.

Nothing here is run by the app and no result is written down; a cell belongs to the step of the same key. Each notebook
opens with `BODIES` and closes with `CHECK`, which compares its Ω² with the root of det(K − ΛM) = 0.
"""

from __future__ import annotations

BODIES = """\
import sympy as sp

m, m_prime, k, R = sp.symbols("m m' k R", positive=True)
t = sp.Symbol("t")
X, phi, Phi = (sp.Function(name)(t) for name in ("X", "varphi", "Phi"))
q = (X, phi, Phi)
q_dot = tuple(x.diff(t) for x in q)

# Displacements over the ground, to the right; X is counted to the left, the angles clockwise.
x_block = -X
x_roller = x_block + R * phi
x_slab = x_roller + R * phi
x_top = x_block + R * Phi


def kinetic_energy(mass, x, inertia=0, angle=sp.S.Zero):
    return mass * x.diff(t) ** 2 / 2 + inertia * angle.diff(t) ** 2 / 2


T = (
    kinetic_energy(m, x_block)
    + kinetic_energy(m_prime, x_roller, m_prime * R**2, phi)  # hoop
    + kinetic_energy(m_prime, x_roller, m_prime * R**2 / 2, phi)  # cylinder
    + kinetic_energy(m, x_slab)
    + kinetic_energy(m, x_top, m * R**2 / 2, Phi)
)
U = k * (x_slab - x_block) ** 2 / 2
L = sp.expand(T - U)
L"""

CHECK = """\
M, K, Lambda = sp.hessian(T, q_dot), sp.hessian(U, q), sp.Symbol("Lambda")
roots = sp.roots((K - Lambda * M).det(), Lambda)
(independent,) = (root for root in roots if root != 0)
assert sp.simplify(Omega_squared - independent) == 0
Omega_squared"""

_EULER_LAGRANGE = {
    "motion": """\
def euler_lagrange(lagrangian, x):
    return sp.expand(lagrangian.diff(x.diff(t)).diff(t) - lagrangian.diff(x))


motion = {x: euler_lagrange(L, x) for x in q}
[sp.Eq(left, 0) for left in motion.values()]""",
    "elimination": """\
X_ddot, phi_ddot, Phi_ddot = (x.diff(t, 2) for x in q)
coupled = sp.solve([motion[X], motion[Phi]], [X_ddot, Phi_ddot])
coupled""",
    "frequency": """\
remaining = sp.expand(motion[phi].subs(X_ddot, coupled[X_ddot]))
Omega_squared = sp.factor(remaining.coeff(phi) / remaining.coeff(phi_ddot))
Omega_squared""",
    "ratio": """\
epsilon = sp.Symbol("varepsilon", positive=True)
normalized = sp.factor(Omega_squared.subs(m_prime, epsilon * m) * m / k)
normalized""",
    "unit": """\
numerator, denominator = sp.fraction(sp.together(normalized))
quadratic = sp.Poly(denominator - numerator, epsilon).primitive()[1]
sp.Eq(quadratic.as_expr(), 0)""",
    "root": """\
(unit_ratio,) = (root for root in sp.solve(quadratic.as_expr(), epsilon) if root.is_positive)
assert sp.radsimp(normalized.subs(epsilon, unit_ratio)) == 1
unit_ratio, quadratic.discriminant()""",
}

_HAMILTON = {
    "momenta": """\
p_X, p_phi, p_Phi = p = sp.symbols("p_X p_varphi p_Phi")
momenta = [L.diff(v) for v in q_dot]
momenta""",
    "velocities": """\
velocities = sp.solve([symbol - value for symbol, value in zip(p, momenta)], q_dot, dict=True)[0]
velocities""",
    "hamiltonian": """\
H = sp.factor(sum(symbol * v for symbol, v in zip(p, q_dot)).subs(velocities) - L.subs(velocities))
H""",
    "motion": """\
p_dot = {symbol: -sp.cancel(H.diff(x)) for symbol, x in zip(p, q)}
assert p_dot[p_X] == p_dot[p_Phi] == 0
phi_dot = sp.factor(H.diff(p_phi))
p_dot, phi_dot""",
    "reduction": """\
M_e = sp.factor(1 / (R**2 * H.diff(p_phi, 2)))
shift = sp.factor(phi_dot.subs(p_phi, 0) * M_e * R**2)
H_0 = sp.cancel(H - (p_phi + shift) ** 2 / (2 * M_e * R**2) - U.doit())
assert not H_0.has(p_phi, phi)
M_e, shift, sp.factor(H_0)""",
    "frequency": """\
phi_ddot = sum(phi_dot.diff(symbol) * p_dot[symbol] for symbol in p)
Omega_squared = sp.factor(-phi_ddot / phi)
Omega_squared""",
}

_NEWTON = {
    "forces": """\
a = dict(zip(("block", "hoop", "cylinder", "slab", "top"), sp.symbols("a_block a_hoop a_cylinder a_slab a_top")))
alpha = dict(zip(("hoop", "cylinder", "top"), sp.symbols("alpha_hoop alpha_cylinder alpha_top")))
# Forces on the rollers, to the right: S from the slab, F from the block.
S = dict(zip(("hoop", "cylinder"), sp.symbols("S_hoop S_cylinder")))
F = dict(zip(("hoop", "cylinder", "top"), sp.symbols("F_hoop F_cylinder F_top")))
spring = k * sp.expand(x_slab - x_block)
forces = [
    sp.Eq(m * a["block"], spring - sum(F.values())),
    sp.Eq(m_prime * a["hoop"], S["hoop"] + F["hoop"]),
    sp.Eq(m_prime * a["cylinder"], S["cylinder"] + F["cylinder"]),
    sp.Eq(m * a["slab"], -spring - sum(S.values())),
    sp.Eq(m * a["top"], F["top"]),
]
forces""",
    "torques": """\
torques = [
    sp.Eq(m_prime * R**2 * alpha["hoop"], R * (S["hoop"] - F["hoop"])),
    sp.Eq(m_prime * R**2 / 2 * alpha["cylinder"], R * (S["cylinder"] - F["cylinder"])),
    sp.Eq(m * R**2 / 2 * alpha["top"], -R * F["top"]),
]
torques""",
    "rolling": """\
rolling = [sp.Eq(a[name] - R * alpha[name], a["block"]) for name in F]
rolling += [sp.Eq(a[name] + R * alpha[name], a["slab"]) for name in S]
rolling""",
    "solution": """\
equations = forces + torques + rolling
unknowns = [*a.values(), *alpha.values(), *S.values(), *F.values()]
assert len(equations) == len(unknowns) == 13
solution = sp.solve(equations, unknowns, dict=True)[0]
{symbol: sp.factor(solution[symbol]) for symbol in [*a.values(), *alpha.values()]}""",
    "contact": """\
phi_ddot = phi.diff(t, 2)
{force: sp.factor(solution[force] / solution[alpha["hoop"]]) * phi_ddot for force in [*S.values(), *F.values()]}""",
    "frequency": """\
assert sp.simplify(solution[alpha["hoop"]] - solution[alpha["cylinder"]]) == 0
Omega_squared = sp.factor(-solution[alpha["hoop"]] / phi)
Omega_squared""",
}

_ENERGY = {
    "quotient": """\
xi, eta = sp.symbols("xi eta", real=True)
shares = {X.diff(t): xi * R * phi.diff(t), Phi.diff(t): eta * phi.diff(t)}
inertia = sp.cancel(2 * T.subs(shares) / (R * phi.diff(t)) ** 2)
stiffness = sp.cancel(2 * U / (R * phi) ** 2)
inertia, stiffness""",
    "least": """\
least = sp.solve([inertia.diff(xi), inertia.diff(eta)], [xi, eta], dict=True)[0]
assert sp.hessian(inertia, (xi, eta)).is_positive_definite
least""",
    "frequency": """\
M_e = sp.factor(inertia.subs(least))
Omega_squared = sp.factor(stiffness / M_e)
Omega_squared""",
    "spring_mass": """\
M_x = sp.apart(M_e / 4, m_prime)
assert sp.simplify(k / M_x - Omega_squared) == 0
M_x""",
    "bound": """\
clamped = sp.factor(stiffness / inertia.subs({xi: 0, eta: 0}))
assert sp.factor(Omega_squared - clamped).is_positive
clamped""",
}

_MATRIX = {
    "matrices": """\
mass_matrix, stiffness_matrix = sp.hessian(T, q_dot).applyfunc(sp.factor), sp.hessian(U, q)
mass_matrix, stiffness_matrix""",
    "determinant": """\
Lambda = sp.Symbol("Lambda")
determinant = sp.factor((stiffness_matrix - Lambda * mass_matrix).det())
sp.Eq(determinant, 0)""",
    "spectrum": """\
spectrum = sp.roots(determinant, Lambda)
assert spectrum[sp.S.Zero] == 2
spectrum""",
    "zero_modes": """\
stiffness_matrix.nullspace()""",
    "shortcut": """\
assert stiffness_matrix.rank() == 1
inverse = mass_matrix.inv().applyfunc(sp.factor)
Omega_squared = sp.factor(stiffness_matrix[1, 1] * inverse[1, 1])
inverse, Omega_squared""",
    "mode_shape": """\
mode_shape = (inverse[:, 1] / inverse[1, 1]).applyfunc(sp.factor)
residual = (stiffness_matrix - Omega_squared * mass_matrix) * mode_shape
assert residual.applyfunc(sp.simplify).is_zero_matrix
mode_shape""",
}

CELLS = {
    "euler_lagrange": _EULER_LAGRANGE,
    "hamilton": _HAMILTON,
    "newton": _NEWTON,
    "energy": _ENERGY,
    "matrix": _MATRIX,
}
"""Route name → step key → code."""
