r"""Newton: draw the five bodies apart and write down every horizontal force between them.

    on a lower roller                    on slab and block                       on the top cylinder

        ___ → S                                                                      ___
       / | \      ↻ α                ← S, ← S  [  slab  ]/\/\/ ← k·2Rφ              / | \    ↻ α
       \_|_/    → a                                                                 \_|_/  → a
         → F                         k·2Rφ → | block |  ← F, ← F, ← F                 → F

    axes: forces, velocities and accelerations are positive to the RIGHT, angles and torques clockwise;
    X is the block's displacement to the LEFT, so a_block = −Ẍ

Thirteen equations for thirteen unknowns: five accelerations, three angular accelerations, five contact forces.

    rolling   a_roller ± R·α = a_other                  (+ at its top, − at its bottom)   5
    force     mass·a = Σ contact forces + spring        (positive to the right)           5
    torque    I·α    = Σ ±R·contact force               (positive clockwise)              3

Weights and normal forces are vertical, and their lines of action pass through the axes, so no equation contains them.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from ramanujan.derivation import model
from ramanujan.derivation.lagrangian import velocity_reason
from ramanujan.derivation.model import ACCELERATIONS, Body, Machine, R, equation, gather, k, machine, phi, t
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import ROUTES, Route, Step, compare_factors, insert, margin_text, solve_for, step
from ramanujan.text.names import PARTS
from ramanujan.text.translation import _

TOP, BOTTOM = 1, -1
X_ddot, phi_ddot, Phi_ddot = ACCELERATIONS


def _function_of_time(name: str) -> sp.Expr:
    return sp.Function(name)(t)


@dataclass(frozen=True)
class Contact:
    """A contact of a roller with another body, and its friction force.

    Parameters
    ----------
    roller, other : names of the two bodies
    side : TOP or BOTTOM of the roller
    force : ON the roller, to the right [N]; the other body gets the opposite force
    """

    roller: str
    other: str
    side: int
    force: sp.Expr

    @property
    def name(self) -> str:
        """The pair as one word, such as hoop_slab."""
        return f"{self.roller}_{self.other}"


CONTACTS = (
    Contact("hoop", "slab", TOP, _function_of_time("S_hoop")),
    Contact("cylinder", "slab", TOP, _function_of_time("S_cylinder")),
    Contact("hoop", "block", BOTTOM, _function_of_time("F_hoop")),
    Contact("cylinder", "block", BOTTOM, _function_of_time("F_cylinder")),
    Contact("top", "block", BOTTOM, _function_of_time("F_top")),
)


@dataclass(frozen=True)
class FreeBodies:
    """The bodies drawn apart: thirteen equations in three groups, and their solution: unknown → expression in φ."""

    rollers: tuple[Body, ...]
    forces: tuple[sp.Eq, ...]
    torques: tuple[sp.Eq, ...]
    rolling: tuple[sp.Eq, ...]
    solution: dict[sp.Expr, sp.Expr]


def acceleration(name: str) -> sp.Expr:
    """Return a body's acceleration relative to the ground, to the right [m/s²]."""
    return _function_of_time(f"a_{name}")


def angular_acceleration(name: str) -> sp.Expr:
    """Return a roller's angular acceleration, clockwise [rad/s²]."""
    return _function_of_time(f"alpha_{name}")


def solve_free_bodies(bodies: Machine) -> FreeBodies:
    """Return the balances of the five bodies, the five rolling constraints, and their solution.

    >>> len(solve_free_bodies(machine()).solution)
    13
    """
    rollers = tuple(body for body in bodies.bodies if body.angle != 0)
    forces = tuple(_force_balance(body, bodies) for body in bodies.bodies)
    torques = tuple(_torque_balance(body) for body in rollers)
    rolling = tuple(_rolling_constraint(contact) for contact in CONTACTS)
    unknowns = [
        *(acceleration(body.name) for body in bodies.bodies),
        *(angular_acceleration(body.name) for body in rollers),
        *(contact.force for contact in CONTACTS),
    ]
    solution = sp.solve(forces + torques + rolling, unknowns)
    factored = {unknown: sp.factor(solution[unknown]) for unknown in unknowns}
    return FreeBodies(rollers=rollers, forces=forces, torques=torques, rolling=rolling, solution=factored)


def contact_forces(bodies: Machine | None = None) -> dict[str, sp.Expr]:
    """Return the friction ON each roller, to the right, in terms of φ̈ [N].

    Keys are hoop_slab, cylinder_slab, hoop_block, cylinder_block, top_block. The opposite forces act on slab and block.

    >>> contact_forces()["top_block"]
    -2*R*m*(m + m_prime)*Derivative(varphi(t), (t, 2))/(7*m + 6*m_prime)
    """
    solution = solve_free_bodies(bodies or machine()).solution
    return {contact.name: _in_terms_of_phi(contact, solution) for contact in CONTACTS}


def named_forces(equations: Iterable[sp.Eq]) -> tuple[str, ...]:
    """Return the contacts whose friction the equations contain, and "spring" if they contain the spring's force, too.

    >>> from ramanujan.derivation import ROUTES
    >>> named_forces(ROUTES["newton"]["torques"].equations)
    ('hoop_slab', 'cylinder_slab', 'hoop_block', 'cylinder_block', 'top_block')
    """
    terms = sp.Tuple(*equations)
    contacts = tuple(contact.name for contact in CONTACTS if terms.has(contact.force))
    return (*contacts, "spring") if contacts and terms.has(k) else contacts


def spring_forces(bodies: Machine) -> dict[str, sp.Expr]:
    """Return the force of the spring ON slab and block, to the right, −∂U/∂x of each [N].

    >>> spring_forces(machine())["slab"]
    -2*R*k*varphi(t)
    """
    return {name: _spring_on(bodies[name], bodies) for name in ("slab", "block")}


@ROUTES.add("newton")
def build(bodies: Machine) -> Route:
    """Return the route: balances, rolling, solution, contact forces, Ω²."""
    free_bodies = solve_free_bodies(bodies)
    solved_phi_ddot = free_bodies.solution[angular_acceleration("hoop")]
    frequency = sp.factor(-solved_phi_ddot / phi)
    centres = {acceleration(body.name): body.displacement.diff(t, 2) for body in bodies.bodies}
    rotations = {angular_acceleration(body.name): body.angle.diff(t, 2) for body in free_bodies.rollers}
    friction = _solve_friction(free_bodies)
    balances = dict(zip((body.name for body in bodies.bodies), free_bodies.forces, strict=True))
    remaining = {name: balances[name] for name in ("block", "slab", "top")}
    in_coordinates = {}
    for name, balance in remaining.items():
        left, right = (gather(side.subs(friction).subs(centres | rotations)) for side in balance.args)
        in_coordinates[name] = equation(left, right)
    difference = {name: balance.lhs - balance.rhs for name, balance in in_coordinates.items()}
    without_spring = gather(-(difference["block"] + difference["slab"]))
    (Phi_ddot_from_X_ddot,) = sp.solve(difference["top"], Phi_ddot)
    without_Phi = gather(without_spring.subs(Phi_ddot, Phi_ddot_from_X_ddot))
    (X_ddot_from_phi_ddot,) = sp.solve(without_Phi, X_ddot)
    of_phi = gather(difference["slab"].subs(X_ddot, X_ddot_from_phi_ddot))
    steps = (
        _rolling_step(free_bodies),
        _forces_step(free_bodies),
        _torques_step(free_bodies),
        _accelerations_step(bodies, centres),
        _friction_step(friction),
        _three_step({*centres, *friction}, remaining, in_coordinates),
        _solution_step(Phi_ddot_from_X_ddot, X_ddot_from_phi_ddot, without_spring, without_Phi),
        _contact_step(free_bodies),
        _frequency_step(of_phi, solved_phi_ddot, frequency),
    )
    return Route(
        name="newton",
        title=_("Newton"),
        idea=_("a balance for each body; friction forces come out as well"),
        steps=steps,
        natural_frequency_squared=frequency,
        cells=CELLS,
    )


def _solve_friction(free_bodies: FreeBodies) -> dict[sp.Expr, sp.Expr]:
    """Return the friction forces in terms of the accelerations of the rollers."""
    lower_rollers = [acceleration("hoop"), acceleration("cylinder")]
    balances = [balance for balance in free_bodies.forces if balance.lhs.has(*lower_rollers)]
    solved = sp.solve((*balances, *free_bodies.torques), [contact.force for contact in CONTACTS])
    return {contact.force: sp.expand(solved[contact.force]) for contact in CONTACTS}


def _rolling_step(free_bodies: FreeBodies) -> Step:
    return step(
        "rolling",
        _("Write down the rolling conditions"),
        _(
            "No contact slips: where two bodies touch, their velocities along the surface are equal, and so are "
            "their accelerations. A roller whose centre has the acceleration $a$ has $a+R\\alpha$ at its top and "
            "$a-R\\alpha$ at its bottom."
        ),
        *free_bodies.rolling,
        *(equation(angular_acceleration(body.name), body.angle.diff(t, 2)) for body in free_bodies.rollers),
        operations=(
            *(margin_text(_("rolling without slipping")) for _contact in free_bodies.rolling),
            *(rf"\tfrac{{d^2}}{{dt^2}}{latex(body.angle)}" for body in free_bodies.rollers),
        ),
    )


def _forces_step(free_bodies: FreeBodies) -> Step:
    return step(
        "forces",
        _("Apply Newton’s second law to each body"),
        _(
            "Count horizontal forces positive to the right. The slab exerts the friction force $S$ on a roller, "
            "the block exerts $F$. By Newton’s third law the opposite forces act on slab and block. When the "
            "rollers have turned by $\\varphi$, the slab has moved by $2R\\varphi$ relative to the block. This "
            "compresses the spring, which pushes the two apart."
        ),
        *free_bodies.forces,
        operations=tuple(r"ma=\textstyle\sum F" for _body in free_bodies.forces),
    )


def _torques_step(free_bodies: FreeBodies) -> Step:
    return step(
        "torques",
        _("Apply the law of torques to each roller"),
        _(
            "Count torques about a roller’s axis positive clockwise. A force to the right at its top turns it "
            "clockwise, at its bottom anticlockwise. Weights and normal forces act along lines through the axis, "
            "so they have no torque."
        ),
        *free_bodies.torques,
        operations=tuple(r"I\alpha=\textstyle\sum\pm RF" for _body in free_bodies.torques),
    )


def _accelerations_step(bodies: Machine, centres: dict[sp.Expr, sp.Expr]) -> Step:
    return step(
        "accelerations",
        _("Express all accelerations by three"),
        _(
            "The block has the acceleration $-\\ddot X$. With the rolling conditions, the accelerations of all "
            "bodies follow from those of the three coordinates."
        ),
        *(equation(symbol, value) for symbol, value in centres.items()),
        operations=tuple(velocity_reason(body, "^2") for body in bodies.bodies),
    )


def _friction_step(friction: dict[sp.Expr, sp.Expr]) -> Step:
    return step(
        "friction",
        _("Find the friction forces"),
        _(
            "Divide the torques by $R$. Each lower roller then has two equations, one for $S+F$ and one for $S-F$: "
            "half their sum is $S$, and half their difference is $F$. The top cylinder has one force, which its "
            "torque determines."
        ),
        *(equation(force, value) for force, value in friction.items()),
        operations=tuple(map(_friction_operation, CONTACTS)),
    )


def _friction_operation(contact: Contact) -> str:
    if contact.roller == "top":
        return rf"\div \left({latex(contact.side * R)}\right)"
    return margin_text(_("half the sum") if contact.side == TOP else _("half the difference"))


def _three_step(known: set[sp.Expr], remaining: dict[str, sp.Eq], in_coordinates: dict[str, sp.Eq]) -> Step:
    operations = []
    for balance in remaining.values():
        inserted = balance.atoms(sp.Function) & known
        # An operation lists the letters of the inserted symbols, such as a and F.
        letters = sorted({str(symbol)[0] for symbol in inserted})
        operations.append(insert(*letters))
    return step(
        "three",
        _("Insert both into the three equations that are left"),
        _("Newton’s second law for block, slab and top cylinder has not been used yet."),
        *in_coordinates.values(),
        labels=tuple(rf"\text{{{PARTS[name]}}}" for name in in_coordinates),
        operations=tuple(operations),
    )


def _solution_step(
    Phi_ddot_from_X_ddot: sp.Expr, X_ddot_from_phi_ddot: sp.Expr, without_spring: sp.Expr, without_Phi: sp.Expr
) -> Step:
    return step(
        "solution",
        _("Eliminate the block and the top cylinder"),
        _(
            "Solve the equation of the top cylinder for $\\ddot\\Phi$. In the sum of the two others the spring "
            "cancels. Insert $\\ddot\\Phi$ into it and solve for $\\ddot X$."
        ),
        equation(Phi_ddot, Phi_ddot_from_X_ddot),
        equation(without_spring, sp.S.Zero),
        equation(without_Phi, sp.S.Zero),
        equation(X_ddot, sp.factor(X_ddot_from_phi_ddot)),
        equation(Phi_ddot, sp.factor(Phi_ddot_from_X_ddot.subs(X_ddot, X_ddot_from_phi_ddot))),
        underlined_terms=("", "left 1, left 2", "left 1", "", ""),
        operations=(
            solve_for(Phi_ddot),
            margin_text(_("add both")),
            insert(Phi_ddot),
            solve_for(X_ddot),
            insert(X_ddot),
        ),
    )


def _contact_step(free_bodies: FreeBodies) -> Step:
    return step(
        "contact",
        _("Look at the friction forces"),
        _(
            "Insert these accelerations into the friction forces. Each is proportional to $\\ddot\\varphi$, so all "
            "five are largest at the turning points of $\\varphi$."
        ),
        *(equation(contact.force, _in_terms_of_phi(contact, free_bodies.solution)) for contact in CONTACTS),
        operations=tuple(insert(X_ddot, Phi_ddot) for _contact in CONTACTS),
    )


def _frequency_step(of_phi: sp.Expr, solved_phi_ddot: sp.Expr, frequency: sp.Expr) -> Step:
    return step(
        "frequency",
        _("Read off the frequency"),
        _(
            "Insert $\\ddot X$ into the equation of the slab. This gives the equation of a harmonic oscillator, "
            "$\\ddot\\varphi+\\Omega^2\\varphi=0$."
        ),
        equation(of_phi, sp.S.Zero),
        equation(phi_ddot, solved_phi_ddot),
        equation(model.Omega_squared, frequency),
        underlined_terms=("left 1", "", ""),
        operations=(insert(X_ddot), solve_for(phi_ddot), compare_factors(phi)),
    )


def _force_balance(body: Body, bodies: Machine) -> sp.Eq:
    on_rollers = (contact.force for contact in CONTACTS if contact.roller == body.name)
    reactions = (-contact.force for contact in CONTACTS if contact.other == body.name)
    return equation(body.mass * acceleration(body.name), sp.Add(*on_rollers, *reactions, _spring_on(body, bodies)))


def _spring_on(body: Body, bodies: Machine) -> sp.Expr:
    """Return the spring's force −∂U/∂x_body: opposite to the deformation on the slab, along it on the block."""
    sign = {"slab": -1, "block": 1}.get(body.name, 0)
    return sign * k * bodies.deformation


def _torque_balance(body: Body) -> sp.Eq:
    torque = sp.Add(*(contact.side * R * contact.force for contact in CONTACTS if contact.roller == body.name))
    return equation(body.moment_of_inertia * angular_acceleration(body.name), torque)


def _rolling_constraint(contact: Contact) -> sp.Eq:
    at_contact = acceleration(contact.roller) + contact.side * R * angular_acceleration(contact.roller)
    return equation(at_contact, acceleration(contact.other))


def _in_terms_of_phi(contact: Contact, solution: dict[sp.Expr, sp.Expr]) -> sp.Expr:
    """Return the friction of a contact as a multiple of φ̈."""
    return sp.factor(solution[contact.force] / solution[angular_acceleration("hoop")]) * phi.diff(t, 2)


_FRICTION = _("Friction on the rollers, to the right: S from the slab, F from the block.")
CELLS = {
    "rolling": """\
a = dict(zip(("block", "hoop", "cylinder", "slab", "top"), sp.symbols("a_block a_hoop a_cylinder a_slab a_top")))
alpha = dict(zip(("hoop", "cylinder", "top"), sp.symbols("alpha_hoop alpha_cylinder alpha_top")))
rolling = [sp.Eq(a[name] - R * alpha[name], a["block"]) for name in alpha]
rolling += [sp.Eq(a[name] + R * alpha[name], a["slab"]) for name in ("hoop", "cylinder")]
rolling""",
    "forces": f"# {_FRICTION}\n"
    """\
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
"""The notebook: step key → plain SymPy that repeats the step."""
