"""The questions, each with its prompt, right answer, mistakes, hints and the derivation step with the answer.

Right answers come from the bodies and their elimination. Hints and steps come from the route of Euler and Lagrange. A
new question is one entry of `_ALL`; its slips are optional and belong in `mistakes`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property, partial

import sympy as sp

from ramanujan.answers import machines, mistakes
from ramanujan.answers.machines import AlteredMachine
from ramanujan.answers.mistakes import Slip, Slips, eliminate_right_machine
from ramanujan.answers.spelling import MOTION, SYMBOLS, TEXTBOOK
from ramanujan.answers.terms import NAMES, remove_factor
from ramanujan.answers.typed_formulas import leaves, length
from ramanujan.answers.values import Formula, Mistakes
from ramanujan.derivation import ROUTES, Step, model
from ramanujan.derivation.elimination import Phi_ddot, X_ddot, phi_ddot
from ramanujan.derivation.model import Machine, R, X, epsilon, m, m_prime, phi, t
from ramanujan.derivation.numbers import unit_frequency_condition
from ramanujan.derivation.printers import latex
from ramanujan.text.names import BODIES
from ramanujan.text.translation import _

POLYNOMIAL, QUOTIENT, NUMBER, EQUATION = "polynomial", "quotient", "number", "equation"
"""How an answer is compared: term by term, as a whole, as a number, or term by term up to a common factor."""


@dataclass(frozen=True)
class Question:
    """A question about the derivation.

    Parameters
    ----------
    name : the name in `QUESTIONS`
    quantity : the requested quantity, in a few words of plain text
    answer : derives the right answer
    prompt : returns one or two sentences, Markdown with $…$
    example : a wrong formula in the notation of the answer, to show how to type
    kind : POLYNOMIAL, QUOTIENT, NUMBER or EQUATION
    steps : keys of the steps in the route of Euler and Lagrange that explain the answer; the last step contains it
    next_question : the lecturer's next question after a wrong answer
    find_slips : function (right answer) → its slips
    find_answer_for : function (altered machine) → the answer that follows from it
    next_questions_of_terms : product of names, as shown → the next question about the coefficient of this product
    letters : letter of the textbook → its meaning here, and a question about the meaning
    variables : the variables of the answer as a polynomial
    accepts_any_form : whether an unsimplified form is right, too; for an equation it always is
    symbol : the name of the answer in the prompt, if no step of the route defines it
    """

    name: str
    quantity: str
    answer: Callable[[], sp.Expr]
    prompt: Callable[[], str]
    example: str
    kind: str
    steps: tuple[str, ...]
    next_question: str
    find_slips: Callable[[sp.Expr], Slips] = lambda _right: iter(())
    find_answer_for: Callable[[Machine], sp.Expr | None] = lambda _machine: None
    next_questions_of_terms: Mapping[str, str] = field(default_factory=dict)
    letters: Mapping[sp.Symbol, tuple[sp.Expr, str]] = field(default_factory=dict)
    variables: tuple[str, ...] = NAMES
    accepts_any_form: bool = False
    symbol: sp.Symbol | None = None

    @cached_property
    def right(self) -> sp.Expr:
        """The right answer."""
        return self.answer()

    @property
    def is_about_one_body(self) -> bool:
        """Whether the question is about one body."""
        return any(self.name == f"kinetic_energy_{body}" for body in BODIES)

    @property
    def names(self) -> tuple[str, ...]:
        """The typed names that the answer may contain.

        An answer with both masses may also contain ε for m′/m. A polynomial or an equation in the motion may not.
        """
        allowed = leaves(self.right)
        if {m, m_prime} <= allowed and self.variables == NAMES:
            allowed |= {epsilon}
        return tuple(name for name, symbol in SYMBOLS.items() if symbol in allowed)

    @property
    def accepted_names(self) -> tuple[str, ...]:
        """The typed names and textbook letters that the answer may contain."""
        return (*self.names, *(letter.name for letter in self.letters))

    @property
    def hints(self) -> tuple[str, ...]:
        """The lecturer's next question, then the reasons of the steps, Markdown with $…$; none contains the answer."""
        return (self.next_question, *(_find_step(key).reason for key in self.steps))

    def read(self, expression: sp.Expr) -> Formula:
        """Return an answer as a formula, in terms of ε only if the right answer contains ε.

        An equation loses its factor without the variables, so equal equations become equal formulas.

        Raises
        ------
        UnreadableError, ArithmeticError : under the conditions of `Formula`.
        """
        formula = Formula(expression, is_in_ratio=epsilon in leaves(self.right))
        if self.kind == EQUATION and formula.fraction:
            formula.fraction = remove_factor(formula.fraction, self.variables)
        return formula

    @cached_property
    def right_formula(self) -> Formula:
        """The right answer as a formula."""
        return self.read(self.right)

    def are_equal(self, one: Formula, other: Formula) -> bool:
        """Return whether two answers are the same; an equation with a root equals no other."""
        if self.kind == EQUATION:
            return one.fraction is not None and one.fraction == other.fraction
        return one.equals(other)

    def list_slips(self) -> list[Slip]:
        """Return all slips, including those without effect on the answer."""
        slips = list(self.find_slips(self.right))
        if R in leaves(self.right):
            slips.insert(0, mistakes.find_radius_slip(self.right))
        return slips

    @cached_property
    def slips(self) -> Mistakes:
        """Hint and result of each slip that changes the answer."""
        slips = []
        for slip in self.list_slips():
            for result in dict.fromkeys(slip.results):
                wrong = self._read_mistake(result)
                if wrong:
                    slips.append((slip.hint, wrong))
        return tuple(slips)

    @cached_property
    def body_mistakes(self) -> Mistakes:
        """Pairs of a hint and a result for the mistakes in bodies, one pair for all mistakes with the same result.

        Mistakes with the same result are omitted if they have no common hint.
        """
        groups: list[tuple[Formula, list[AlteredMachine]]] = []
        for altered in machines.list_altered_machines():
            wrong = self._read_mistake(self.find_answer_for(altered.machine))
            if wrong:
                self._add_to_group(groups, wrong, altered)
        hints = [(machines.find_common_hint(group), wrong) for wrong, group in groups]
        return tuple((hint, wrong) for hint, wrong in hints if hint)

    def _add_to_group(
        self, groups: list[tuple[Formula, list[AlteredMachine]]], wrong: Formula, altered: AlteredMachine
    ) -> None:
        """Add an altered machine to the group with the same result, or to a new group."""
        for result, group in groups:
            if self.are_equal(result, wrong):
                group.append(altered)
                return
        groups.append((wrong, [altered]))

    def _read_mistake(self, result: sp.Expr | None) -> Formula | None:
        """Return a wrong answer as a formula; None if it does not exist, is zero, or is right after all."""
        if result is None:
            return None
        try:
            wrong = self.read(result)
            return None if wrong.is_zero or self.are_equal(wrong, self.right_formula) else wrong
        except ArithmeticError:
            return None

    @cached_property
    def longest_form(self) -> int:
        """The length of the longest form that counts as simplified."""
        numerator, denominator = sp.fraction(sp.together(self.right))
        forms = (
            self.right,
            sp.factor(self.right),
            sp.expand(self.right, frac=True),
            sp.expand(numerator) / denominator,
        )
        return max(map(length, forms))


def find_question(name: str) -> Question:
    """Return the question with this name."""
    return _BY_NAME[name]


def find_answer_equations(name: str) -> tuple[sp.Eq, ...]:
    """Return the equations of the step with the answer to a question; one of them is the answer itself."""
    named = find_question(name)
    last_step = named.steps[-1]
    equations = tuple(_find_body_equations(named)) if last_step == "energies" else _find_step(last_step).equations
    if any(named.right in equation.args for equation in equations):
        return equations
    return (*equations, model.equation(named.symbol or equations[-1].lhs, named.right))


def _find_body_equations(question: Question) -> list[sp.Eq]:
    """Return the equations about one body, or about the spring, from steps with an equation for every body."""
    _quantity, _bar, body = question.name.rpartition("_")
    names = {f"{letter}_{body}" for letter in "vIT"}
    if "potential" in question.name:
        names |= {"x", "U"}
    equations = [equation for key in question.steps for equation in _find_step(key).equations]
    return [equation for equation in equations if str(equation.lhs) in names]


def _find_step(key: str) -> Step:
    return ROUTES["euler_lagrange"][key]


# The questions


def _make_body_question(name: str) -> Question:
    body, body_name = machines.right_machine()[name], BODIES[name].in_sentence
    # The block has no rate: its velocity contains only X′.
    rate = {"block": "", "top": "Φ′"}.get(name, "φ′")
    templates = {
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        "X′²": _("What is the kinetic energy of {body} while only the block moves, with {rate} = 0?"),
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        f"X′{rate}": _("What is the mixed term when you square the velocity of {body}?"),
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        f"{rate}²": _("What is the kinetic energy of {body} while the block is at rest, with X′ = 0?"),
    }
    next_question = (
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        _("How fast does {body} move relative to the ground, and how fast does it rotate?")
        if body.angle != 0
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        else _("How fast does {body} move relative to the ground?")
    )
    hints = {}
    if rate:
        hints = {term: template.format(body=body_name, rate=rate) for term, template in templates.items()}
    speed = _("What is v in terms of X′ and {rate}?") if rate else _("What is v in terms of X′?")
    letters = {TEXTBOOK["v"]: (body.velocity, speed.format(rate=rate))}
    if body.angle != 0:
        letters[TEXTBOOK["I"]] = body.moment_of_inertia, _("What is I?")
        letters[TEXTBOOK["omega"]] = body.angle.diff(t), _("What is ω?")
    return Question(
        name=f"kinetic_energy_{name}",
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        quantity=_("the kinetic energy of {body}").format(body=body_name),
        answer=lambda: body.kinetic_energy,
        # TRANSLATORS: {body} is the block, the hoop, the lower cylinder, the slab or the top cylinder.
        prompt=lambda: _("What is the kinetic energy of {body} relative to the ground?").format(body=body_name),
        example="3/5 m' (X' + 3 R phi')^2",
        kind=POLYNOMIAL,
        steps=("velocities", "energies") if body.angle == 0 else ("velocities", "inertia", "energies"),
        next_question=next_question.format(body=body_name),
        find_slips=lambda _right: mistakes.find_energy_slips(name),
        find_answer_for=lambda machine: machine[name].kinetic_energy,
        next_questions_of_terms=hints,
        letters=letters,
        variables=MOTION,
    )


def _make_coupling_question(name: str, quantity: str, acceleration: sp.Expr, equation: str) -> Question:
    return Question(
        name=name,
        quantity=quantity,
        answer=lambda: mistakes.find_factor_of_acceleration(equation),
        prompt=lambda: _("The equations of motion of $X$ and $\\Phi$ give {relation}. What is $c$?").format(
            relation=f"${latex(acceleration)}=c\\,{latex(phi_ddot)}$"
        ),
        example="R (2m + m')/(5m)" if acceleration == X_ddot else "(2m + m')/(5m)",
        kind=QUOTIENT,
        steps=("motion", "elimination"),
        next_question=_("What do the equations of motion of X and Φ say about the three accelerations?"),
        find_slips=partial(mistakes.find_coupling_slips, name),
        find_answer_for=partial(machines.solve, name),
        symbol=sp.Symbol("c"),
    )


def _write_equation_prompt() -> str:
    equation = eliminate_right_machine().motion[phi]
    # The question asks for the factor of φ̈, so the letter a replaces it.
    with_letter = equation - equation.coeff(phi_ddot) * phi_ddot + sp.Symbol("a") * phi_ddot
    prompt = _("The equation of motion of {coordinate} is {equation}. What is $a$?")
    return prompt.format(coordinate=f"${latex(phi)}$", equation=f"${latex(with_letter)}=0$")


def _compute_first_row(machine: Machine, states: tuple[sp.Expr, ...]) -> sp.Expr:
    """Return the first row of the mass matrix of a machine times velocities or accelerations."""
    return sp.Add(*map(sp.Mul, machines.mass_matrix(machine)[0], states))


def _derive_block_equation(machine: Machine) -> sp.Expr | None:
    """Return the equation of motion of X, None for an equation with one term, which states only that it is zero."""
    equation = _compute_first_row(machine, model.ACCELERATIONS)
    return equation if equation.is_Add else None


_ALL = (
    *map(_make_body_question, BODIES),
    Question(
        name="potential_energy",
        quantity=_("the potential energy"),
        answer=lambda: machines.right_machine().potential_energy,
        prompt=lambda: _(
            "What is the potential energy of the spring when the lower rollers have turned by {angle}?"
        ).format(angle=f"${latex(phi)}$"),
        example="k (R phi)^2 / 5",
        kind=POLYNOMIAL,
        steps=("inertia", "energies"),
        next_question=_("How far is the spring compressed when the lower rollers have turned by φ?"),
        find_slips=lambda _right: mistakes.find_spring_slips(),
        letters={TEXTBOOK["x"]: (machines.right_machine().deformation, _("What is x in terms of φ?"))},
        variables=MOTION,
    ),
    Question(
        name="lagrangian",
        quantity=_("the Lagrangian"),
        answer=lambda: eliminate_right_machine().lagrangian,
        prompt=lambda: _("What is the Lagrangian of the whole machine?"),
        example="m' X'^2 - k (R phi)^2",
        kind=POLYNOMIAL,
        steps=("energies", "sum", "lagrangian"),
        next_question=_("What are the kinetic energies of the five bodies, and what is the potential energy?"),
        find_slips=mistakes.find_lagrangian_slips,
        find_answer_for=lambda machine: machine.kinetic_energy - machine.potential_energy,
        variables=MOTION,
        accepts_any_form=True,
    ),
    Question(
        name="block_momentum",
        quantity=_("the momentum of X"),
        answer=lambda: eliminate_right_machine().momenta[X],
        prompt=lambda: _("What is the momentum {momentum}, written with the velocities?").format(
            momentum=f"${latex(model.MOMENTA[0])}=\\partial\\mathcal L/\\partial\\dot X$"
        ),
        example="2 m X' - m' R phi'",
        kind=POLYNOMIAL,
        steps=("momenta",),
        next_question=_("Which terms of the Lagrangian contain X′?"),
        find_slips=mistakes.find_momentum_slips,
        find_answer_for=lambda machine: _compute_first_row(machine, model.VELOCITIES),
        variables=MOTION,
    ),
    Question(
        name="block_equation",
        quantity=_("the equation of motion of X"),
        answer=lambda: eliminate_right_machine().motion[X],
        prompt=lambda: _("What is the equation of motion of {coordinate}?").format(coordinate=f"${latex(X)}$"),
        example="2 m X'' = m' R phi''",
        kind=EQUATION,
        steps=("rates", "motion"),
        next_question=_("What is the momentum of X, and what does Lagrange’s equation say about its derivative?"),
        find_slips=mistakes.find_block_equation_slips,
        find_answer_for=_derive_block_equation,
        variables=MOTION,
    ),
    Question(
        name="phi_equation",
        quantity=_("the factor of the acceleration"),
        answer=lambda: eliminate_right_machine().motion[phi].coeff(phi_ddot),
        prompt=_write_equation_prompt,
        example="R (2m + m')/5",
        kind=POLYNOMIAL,
        steps=("rates", "motion"),
        next_question=_("Which kinetic energies contain φ′², and with which factors?"),
        find_slips=mistakes.find_phi_equation_slips,
        find_answer_for=partial(machines.solve, "phi_equation"),
        symbol=sp.Symbol("a"),
    ),
    _make_coupling_question(
        "block_coupling", _("the factor in the block’s acceleration"), X_ddot, "X_ddot_from_phi_ddot"
    ),
    _make_coupling_question(
        "top_coupling", _("the factor in the top cylinder’s acceleration"), Phi_ddot, "Phi_ddot_from_phi_ddot"
    ),
    Question(
        name="natural_frequency_squared",
        quantity="Ω²",
        answer=lambda: eliminate_right_machine().natural_frequency_squared,
        prompt=lambda: _("What is $\\Omega^2$, the square of the natural frequency?"),
        example="2k/(3m + m')",
        kind=QUOTIENT,
        steps=("elimination", "insertion", "frequency"),
        next_question=_("What is left of the equation of motion of φ when you insert the other two accelerations?"),
        find_slips=mistakes.find_frequency_slips,
        find_answer_for=partial(machines.solve, "natural_frequency_squared"),
    ),
    Question(
        name="unit_quadratic",
        quantity=_("the quadratic equation"),
        answer=lambda: unit_frequency_condition().quadratic.as_expr(),
        prompt=lambda: _("Which quadratic equation for {ratio} follows from $\\Omega^2=k/m$?").format(
            ratio=f"${latex(epsilon)}=m'/m$"
        ),
        example="5 eps^2 + eps = 3",
        kind=EQUATION,
        steps=("ratio", "unit"),
        next_question=_("What is Ω² in units of k/m, written with ε?"),
        find_slips=mistakes.find_quadratic_slips,
        find_answer_for=partial(machines.solve, "unit_quadratic"),
        variables=("eps",),
    ),
    Question(
        name="unit_mass_ratio",
        quantity=_("the mass ratio"),
        answer=lambda: unit_frequency_condition().root,
        prompt=lambda: _("For which mass ratio {ratio} is $\\Omega^2=k/m$ exactly?").format(
            ratio=f"${latex(epsilon)}=m'/m$"
        ),
        example="(sqrt(5) - 1)/2",
        kind=NUMBER,
        steps=("unit", "root"),
        next_question=_("Which quadratic equation for ε follows from Ω² = k/m?"),
        find_slips=lambda _right: mistakes.find_mass_ratio_slips(),
        find_answer_for=partial(machines.solve, "unit_mass_ratio"),
    ),
)
_BY_NAME = {question.name: question for question in _ALL}

QUESTIONS: tuple[str, ...] = tuple(_BY_NAME)
"""The names of the questions, in the order of the derivation."""
