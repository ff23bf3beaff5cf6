"""The questions: prompt, right answer, mistakes, hints, and the step that shows the answer.

Right answers come from the bodies and their elimination; hints and steps come from the route of Euler and Lagrange. A
new question is one entry of `_ALL`; its own slips are optional, in `mistakes`.
"""

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property, partial

import sympy as sp
from sympy.polys.fields import FracElement

from ramanujan.answers import machines, mistakes
from ramanujan.answers.formulas import leaves, length, without_signs
from ramanujan.answers.machines import CALLED, Altered
from ramanujan.answers.mistakes import Slip, Slips, elimination
from ramanujan.answers.spelling import MOTION, SYMBOLS, TEXTBOOK
from ramanujan.answers.terms import NAMES, Compared, exact
from ramanujan.answers.values import Mistakes, Values, agree, at_points, up_to_a_factor
from ramanujan.derivation import ROUTES, Step, model
from ramanujan.derivation.elimination import Phi_ddot, X_ddot, phi_ddot
from ramanujan.derivation.model import Machine, R, X, epsilon, m, m_prime, machine, phi, t
from ramanujan.derivation.numbers import unit_frequency_condition
from ramanujan.derivation.printers import latex
from ramanujan.translation import _

POLYNOMIAL, QUOTIENT, NUMBER, EQUATION = "polynomial", "quotient", "number", "equation"
"""How an answer is compared: term by term, as one fraction, as a number, or term by term up to a common factor."""


@dataclass(frozen=True)
class Question:
    """A question, how its answer is derived, compared, spoiled by mistakes, and led to.

    Parameters
    ----------
    name : the name in `QUESTIONS`
    quantity : the quantity asked for, in a few words of plain text
    answer : derives the right answer
    prompt : returns one or two sentences, Markdown with $…$
    example : a formula that shows how to type; it is not the answer
    kind : POLYNOMIAL, QUOTIENT, NUMBER or EQUATION
    steps : keys of steps in the route of Euler and Lagrange that say how it is done; the last one has the answer
    leads_on : the question that a lecturer would ask next
    mistakes : takes the answer, returns its slips
    of_machine : takes a machine with wrong bodies, returns the answer for it
    of_terms : product of names, as shown → the next question about its coefficient
    letters : letters of the textbook → what each stands for here, and the question about it
    variables : the names in whose products the answer is written term by term
    any_form : whether a right answer need not be simplified; that of an equation never does
    symbol : what the prompt calls the answer, where no step of the route names it
    """

    name: str
    quantity: str
    answer: Callable[[], sp.Expr]
    prompt: Callable[[], str]
    example: str
    kind: str
    steps: tuple[str, ...]
    leads_on: str
    mistakes: Callable[[sp.Expr], Slips] = lambda _right: iter(())
    of_machine: Callable[[Machine], sp.Expr | None] = lambda _machine: None
    of_terms: Mapping[str, str] = field(default_factory=dict)
    letters: Mapping[sp.Symbol, tuple[sp.Expr, str]] = field(default_factory=dict)
    variables: tuple[str, ...] = NAMES
    any_form: bool = False
    symbol: sp.Symbol | None = None

    @cached_property
    def right(self) -> sp.Expr:
        """The right answer."""
        return self.answer()

    @property
    def of_one_body(self) -> bool:
        """Whether the question is about one body."""
        return any(self.name == f"kinetic_energy_{body}" for body in CALLED)

    @property
    def names(self) -> tuple[str, ...]:
        """The names that the answer may contain, as typed; ε may stand for m′/m where both masses do."""
        allowed = leaves(self.right)
        if {m, m_prime} <= allowed and self.variables == NAMES:
            allowed |= {epsilon}
        return tuple(name for name, symbol in SYMBOLS.items() if symbol in allowed)

    @property
    def accepted(self) -> tuple[str, ...]:
        """The names and the textbook’s letters that the answer may contain, as typed."""
        return (*self.names, *(letter.name for letter in self.letters))

    @property
    def hints(self) -> tuple[str, ...]:
        """From the next question to ask to how it is done, Markdown with $…$; none contains the answer."""
        return (self.leads_on, *(_step(key).reason for key in self.steps))

    def values(self, formula: sp.Expr) -> Values:
        """Return the values by which a formula is compared with the answer; of an equation a common factor cancels.

        Raises
        ------
        ArithmeticError : as `values.at_points` does.
        """
        return up_to_a_factor(formula, self.variables) if self.kind == EQUATION else at_points(formula)

    def terms(self, formula: sp.Expr) -> FracElement:
        """Return a formula in lowest terms, in the names of the answer.

        Raises
        ------
        terms.NotComparableError : as `terms.exact` does.
        """
        return exact(formula, of_ratio=epsilon in leaves(self.right))

    @cached_property
    def right_values(self) -> Values:
        """The values of the right answer."""
        return self.values(self.right)

    @cached_property
    def right_terms(self) -> FracElement:
        """The right answer in lowest terms; only if it has no root."""
        return self.terms(self.right)

    def compared(self, formula: sp.Expr) -> Compared:
        """Return an answer and the right one, ready for a comparison term by term.

        Raises
        ------
        terms.NotComparableError : as `terms.exact` does.
        """
        return Compared(self.terms(formula), self.right_terms, self.terms(without_signs(formula)))

    def all_slips(self) -> list[Slip]:
        """Return the slips; some may have no effect on the answer."""
        slips = [*self.mistakes(self.right)]
        return [mistakes.no_radius(self.right), *slips] if R in leaves(self.right) else slips

    @cached_property
    def slips(self) -> Mistakes:
        """Hint and values of each slip that changes the answer."""
        results = ((slip.hint, result) for slip in self.all_slips() for result in dict.fromkeys(slip.results))
        slips = [(hint, self._values_of_mistake(result)) for hint, result in results]
        return tuple((hint, values) for hint, values in slips if values)

    @cached_property
    def altered(self) -> Mistakes:
        """Hint and values of each machine with wrong bodies, if no other mistake about bodies has the same values."""
        found: list[tuple[Values, list[Altered]]] = []
        for each in machines.altered():
            if values := self._values_of_mistake(self.of_machine(each.machine)):
                same = next((same for known, same in found if agree(known, values)), None)
                if same is None:
                    found.append((values, [each]))
                else:
                    same.append(each)
        return tuple((hint, values) for values, same in found if (hint := machines.named(same)))

    def _values_of_mistake(self, result: sp.Expr | None) -> Values | None:
        """Return the values of what a mistake gives; None if that is nothing, zero or the right answer."""
        with suppress(ArithmeticError):
            values = result and self.values(result)
            if values and any(values) and not agree(values, self.right_values):
                return values
        return None

    @cached_property
    def longest_form(self) -> int:
        """The length of the longest form that counts as simplified."""
        numerator, denominator = sp.fraction(sp.together(self.right))
        factored, expanded = sp.factor(self.right), sp.expand(self.right, frac=True)
        return max(map(length, (self.right, factored, expanded, sp.expand(numerator) / denominator)))


def question(name: str) -> Question:
    """Return the question of that name."""
    return _ASKED[name]


def shown_step(name: str) -> tuple[sp.Eq, ...]:
    """Return the equations of the step that leads to the answer of a question; one of them states the answer."""
    it = question(name)
    # Each of these steps has a line for every body. Only the lines about the body of the question are shown.
    own = {f"{letter}_{name.rpartition('_')[2]}" for letter in "vIT"} | ({"x", "U"} if "potential" in name else set())
    several = it.steps[-1] == "energies"
    lines = [e for key in it.steps[0 if several else -1 :] for e in _step(key).equations]
    shown = [e for e in lines if not several or str(e.lhs) in own]
    if any(it.right in e.args for e in shown):
        return tuple(shown)
    return (*shown, model.equation(it.symbol or shown[-1].lhs, it.right))


def _step(key: str) -> Step:
    return ROUTES["euler_lagrange"][key]


# The questions


def _body_question(name: str) -> Question:
    body, called = machine()[name], CALLED[name]
    rate = {"block": "", "top": "Φ′"}.get(name, "φ′")
    hints = {
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        "X′²": _("What is the kinetic energy of {body} while only the block moves, with {rate} = 0?"),
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        f"X′{rate}": _("What is the mixed term when you square the velocity of {body}?"),
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        f"{rate}²": _("What is the kinetic energy of {body} while the block is at rest, with X′ = 0?"),
    }
    leads_on = (
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        _("How fast does {body} move relative to the ground, and how fast does it rotate?")
        if body.angle != 0
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        else _("How fast does {body} move relative to the ground?")
    )
    speed = _("What is v in terms of X′ and {rate}?") if rate else _("What is v in terms of X′?")
    letters = {TEXTBOOK["v"]: (body.velocity, speed.format(rate=rate))}
    if body.angle != 0:
        letters[TEXTBOOK["I"]] = body.moment_of_inertia, _("What is I?")
        letters[TEXTBOOK["omega"]] = body.angle.diff(t), _("What is ω?")
    return Question(
        f"kinetic_energy_{name}",
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        _("the kinetic energy of {body}").format(body=called),
        lambda: body.kinetic_energy,
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        lambda: _("What is the kinetic energy of {body} relative to the ground?").format(body=called),
        "3/5 m' (X' + 3 R phi')^2",
        POLYNOMIAL,
        ("velocities", "energies") if body.angle == 0 else ("velocities", "inertia", "energies"),
        leads_on.format(body=called),
        mistakes=lambda _right: mistakes.energy(name),
        of_machine=lambda bodies: bodies[name].kinetic_energy,
        of_terms={term: hint.format(body=called, rate=rate) for term, hint in hints.items()} if rate else {},
        letters=letters,
        variables=MOTION,
    )


def _coupling_question(name: str, quantity: str, acceleration: sp.Expr, equation: str) -> Question:
    return Question(
        name,
        quantity,
        lambda: mistakes.answer_of(equation),
        lambda: _("The equations of motion of $X$ and $\\Phi$ give {relation}. What is $c$?").format(
            relation=f"${latex(acceleration)}=c\\,{latex(phi_ddot)}$"
        ),
        "R (2m + m')/(5m)" if acceleration == X_ddot else "(2m + m')/(5m)",
        QUOTIENT,
        ("motion", "elimination"),
        _("What do the equations of motion of X and Φ say about the three accelerations?"),
        mistakes=partial(mistakes.coupling, name),
        of_machine=partial(machines.answer, name),
        symbol=sp.Symbol("c"),
    )


def _equation_prompt() -> str:
    equation = elimination().motion[phi]
    written = equation - equation.coeff(phi_ddot) * phi_ddot + sp.Symbol("a") * phi_ddot
    prompt = _("The equation of motion of {coordinate} is {equation}. What is $a$?")
    return prompt.format(coordinate=f"${latex(phi)}$", equation=f"${latex(written)}=0$")


def _first_row(bodies: Machine, states: tuple[sp.Expr, ...]) -> sp.Expr:
    """Return the first row of the mass matrix of a machine times velocities, or times accelerations."""
    return sp.Add(*map(sp.Mul, machines.mass_matrix(bodies)[0], states))


_ALL = (
    *map(_body_question, CALLED),
    Question(
        "potential_energy",
        _("the potential energy"),
        lambda: machine().potential_energy,
        lambda: _("What is the potential energy of the spring when the lower rollers have turned by {angle}?").format(
            angle=f"${latex(phi)}$"
        ),
        "k (R phi)^2 / 5",
        POLYNOMIAL,
        ("inertia", "energies"),
        _("How far is the spring compressed when the lower rollers have turned by φ?"),
        mistakes=lambda _right: mistakes.spring(),
        letters={TEXTBOOK["x"]: (machine().deformation, _("What is x in terms of φ?"))},
        variables=MOTION,
    ),
    Question(
        "lagrangian",
        _("the Lagrangian"),
        lambda: elimination().lagrangian,
        lambda: _("What is the Lagrangian of the whole machine?"),
        "m' X'^2 - k (R phi)^2",
        POLYNOMIAL,
        ("energies", "sum", "lagrangian"),
        _("What are the kinetic energies of the five bodies, and what is the potential energy?"),
        mistakes=mistakes.lagrangian,
        of_machine=lambda bodies: bodies.kinetic_energy - bodies.potential_energy,
        variables=MOTION,
        any_form=True,
    ),
    Question(
        "block_momentum",
        _("the momentum of X"),
        lambda: elimination().momenta[X],
        lambda: _("What is the momentum {momentum}, written with the velocities?").format(
            momentum=f"${latex(model.MOMENTA[0])}=\\partial\\mathcal L/\\partial\\dot X$"
        ),
        "2 m X' - m' R phi'",
        POLYNOMIAL,
        ("momenta",),
        _("Which terms of the Lagrangian contain X′?"),
        mistakes=mistakes.momentum,
        of_machine=lambda bodies: _first_row(bodies, model.VELOCITIES),
        variables=MOTION,
    ),
    Question(
        "block_equation",
        _("the equation of motion of X"),
        lambda: elimination().motion[X],
        lambda: _("What is the equation of motion of {coordinate}?").format(coordinate=f"${latex(X)}$"),
        "2 m X'' = m' R phi''",
        EQUATION,
        ("rates", "motion"),
        _("What is the momentum of X, and what does Lagrange’s equation say about its derivative?"),
        mistakes=mistakes.block_equation,
        # An equation with one term says no more than that this term is zero.
        of_machine=lambda bodies: row if (row := _first_row(bodies, model.ACCELERATIONS)).is_Add else None,
        variables=MOTION,
    ),
    Question(
        "phi_equation",
        _("the factor of the acceleration"),
        lambda: elimination().motion[phi].coeff(phi_ddot),
        _equation_prompt,
        "R (2m + m')/5",
        POLYNOMIAL,
        ("rates", "motion"),
        _("Which kinetic energies contain φ′², and with which factors?"),
        mistakes=mistakes.equation,
        of_machine=partial(machines.answer, "phi_equation"),
        symbol=sp.Symbol("a"),
    ),
    _coupling_question("block_coupling", _("the factor in the block’s acceleration"), X_ddot, "X_from_phi"),
    _coupling_question("top_coupling", _("the factor in the top cylinder’s acceleration"), Phi_ddot, "Phi_from_phi"),
    Question(
        "natural_frequency_squared",
        "Ω²",
        lambda: elimination().natural_frequency_squared,
        lambda: _("What is $\\Omega^2$, the square of the natural frequency?"),
        "2k/(3m + m')",
        QUOTIENT,
        ("elimination", "insertion", "frequency"),
        _("What is left of the equation of motion of φ when you insert the other two accelerations?"),
        mistakes=mistakes.frequency,
        of_machine=partial(machines.answer, "natural_frequency_squared"),
    ),
    Question(
        "unit_quadratic",
        _("the quadratic equation"),
        lambda: unit_frequency_condition().quadratic.as_expr(),
        lambda: _("Which quadratic equation for {ratio} follows from $\\Omega^2=k/m$?").format(
            ratio=f"${latex(epsilon)}=m'/m$"
        ),
        "5 eps^2 + eps = 3",
        EQUATION,
        ("ratio", "unit"),
        _("What is Ω² in units of k/m, written with ε?"),
        mistakes=mistakes.quadratic,
        of_machine=partial(machines.answer, "unit_quadratic"),
        variables=("eps",),
    ),
    Question(
        "unit_mass_ratio",
        _("the mass ratio"),
        lambda: unit_frequency_condition().root,
        lambda: _("For which mass ratio {ratio} is $\\Omega^2=k/m$ exactly?").format(ratio=f"${latex(epsilon)}=m'/m$"),
        "(sqrt(5) - 1)/2",
        NUMBER,
        ("unit", "root"),
        _("Which quadratic equation for ε follows from Ω² = k/m?"),
        mistakes=lambda _right: mistakes.ratio(),
        of_machine=partial(machines.answer, "unit_mass_ratio"),
    ),
)
_ASKED = {each.name: each for each in _ALL}

QUESTIONS: tuple[str, ...] = tuple(_ASKED)
"""The names of the questions, in the order of the derivation."""
