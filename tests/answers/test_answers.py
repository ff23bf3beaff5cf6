"""The judge of a student's formula: right answers in any spelling, named mistakes, and no exceptions."""

import re
import sys
import time
from contextlib import suppress
from itertools import combinations

import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st

from ramanujan.answers import QUESTIONS, find_question, judge, machines, mistakes, questions
from ramanujan.answers.grammar import MAX_WEIGHT, parse, typeset
from ramanujan.answers.spelling import TEXTBOOK, UnreadableError
from ramanujan.answers.values import find_unit
from ramanujan.derivation.elimination import eliminate, phi_ddot
from ramanujan.derivation.model import Phi
from tests.checks.answers import (
    BLOCK,
    EQUATIONS,
    HOOP,
    HOSTILE,
    OMEGA,
    POTENTIAL,
    RATIO,
    RIGHT,
    RIGHT_RATIO,
    TOP,
    zero_on_the_right,
)
from tests.settings import DEEP

EXAMPLES = 20_000 if DEEP else 150


UNSIMPLIFIED = [
    (BLOCK, "½mX'² + R - R", "without R"),
    (BLOCK, "sqrt(m^2)X'^2/2", "shorter"),
    (TOP, "m/12 ((3R Phi' - 3X')^2 + 9/2 R^2 Phi'^2)*2/3", "shorter"),
    (OMEGA, "8kR(7m+6m')/(R(32m²+49mm'+18m'²))", "without R"),
    (RATIO, "m'/m*(√1729-1)/36/eps", "without m, m′ and ε"),
    (RATIO, "(√(1730+2√1729)-2)/36", "shorter"),
    (HOOP, "½m'v² + ½Iω²", "What is v in terms of X′ and φ′? What is ω? What is I?"),
    (HOOP, "½m'v² + ½Iw²", "What is v in terms of X′ and φ′? What is ω? What is I?"),
    (POTENTIAL, "½kx²", "What is x in terms of φ?"),
    ("unit_quadratic", "7ε = 24(1+ε)²/(7+6ε)", "multiply by the denominator"),
    ("unit_quadratic", "18m'² + mm' = 24m²", "without m and m′"),
    ("block_equation", "k(3m+2m')X'' = 2k(m+m')Rφ'' + kmRΦ''", "without k"),
]

# The examples of all hints are tested below.
WRONG = [
    (BLOCK, "½mX²", "depends on X, but the kinetic energy of the block does not depend on it."),
    (BLOCK, "½mX'²+m", "a constant term. The right answer has none."),
    (BLOCK, "0", "is zero"),
    (TOP, "½m(RΦ')²", "This is not the right answer. How fast"),
    (HOOP, "½ m' X'^3/φ'", "has the unit kg·m³/s²"),
    (POTENTIAL, "½k(2Rφ)²+½kX²", "X does not deform the spring"),
    (POTENTIAL, "0 + kR²φ²", "half of the right one"),
    (POTENTIAL, "k(1.41 R φ)²", "close to the exact value"),
    ("block_equation", "X'' = X''", "Both sides of your equation are equal"),
    ("block_equation", "(3m+2m')X'' - 2(m+m')Rφ'' - mRΦ'' = kX", "depends on k and X"),
    ("unit_quadratic", "ε = (√1729-1)/36", "gives ε a value"),
    ("unit_quadratic", "ε = 1", "gives ε a value"),
    ("unit_quadratic", "1.127 = ε", "gives ε a value"),
    ("unit_quadratic", "ε = 24", "term with ε² is missing"),
    ("unit_quadratic", "18ε² + √2*ε = 24", "contains a root"),
    ("block_equation", "-(3m+2m')X'' + 2(m+m')Rφ'' - mRΦ'' = 0", "coefficient of Φ″ has the wrong sign"),
    ("block_equation", "(3m+2m')X'' + mRΦ'' = 2(m+m')Rφ'' + mRΦ''", "The term with Φ″ is missing"),
    ("phi_equation", "R(8m+6m')/2", "other moments of inertia of the lower rollers"),
    ("block_coupling", "-6R(m+m')/(7m+6m')", "wrong sign"),
    (OMEGA, "k/(5m)", "does not depend on m′, but Ω² does"),
    # A natural mistake takes precedence over a confused body with the same result.
    ("top_coupling", "2/3", "Apart from a factor R, this is the acceleration of Φ divided by that of X"),
    ("top_coupling", "-4(m+m')/(7m+6m')", "has the wrong sign"),
    ("top_coupling", "R", "is a plain number"),
    ("unit_quadratic", "18ε²+97ε-24=0", "48ε keeps its sign"),
    (RATIO, "(√(97²+1728)-97)/36", "48ε keeps its sign"),
    ("block_momentum", "(3m+2m')X' - 2mRφ' - mRΦ'", "The term with m′Rφ′ is missing"),
    ("block_momentum", "(3m+2m')X' - 2(m'-m)Rφ' - mRΦ'", "coefficient of mRφ′ has the wrong sign"),
    (HOOP, "½m'X'² - m'RX'φ'", "The term with φ′² is missing. What is the kinetic energy of the hoop while the block"),
    (HOOP, "½m'v²", "leave out the rotation of the hoop"),
    (OMEGA, "2k/(3m+m')", "This is not the right answer. What is left"),
    (OMEGA, "√(R/R)", "plain number"),
    # Discriminants of machines with one body changed: two hoops 37, two cylinders 33. A hoop beside a cylinder without
    # spin has the same inertia as two cylinders.
    (RATIO, "(√33+1)/4", "other moments of inertia of the lower rollers"),
    (RATIO, "(41.58-1)/36", "close to the exact value"),
    (RATIO, "(√1729-1)/72", "half of the right one"),
    (RATIO, "m'/m", "m and m′, but the mass ratio does not depend on them"),
    (BLOCK, "m + R", "different units, kg and m"),
    (BLOCK, "m + 1", "a plain number to a term with the unit kg"),
    (BLOCK, "sqrt(m)", "has the unit kg^(1/2)"),
    (OMEGA, "k/m'*R", "the unit m/s², but Ω² has the unit 1/s²"),
]


@pytest.mark.parametrize(("name", "text"), [(name, text) for name, texts in RIGHT.items() for text in texts])
def test_right_answer_is_accepted_in_many_spellings(name, text):
    assert judge(name, text).kind == "right"


@pytest.mark.parametrize(("name", "text", "words"), UNSIMPLIFIED)
def test_unsimplified_answer_is_recognized(name, text, words):
    verdict = judge(name, text)
    assert verdict.kind == "unsimplified"
    assert words in verdict.message


@pytest.mark.parametrize(("name", "text", "words"), WRONG)
def test_wrong_answer_names_the_mistake(name, text, words):
    verdict = judge(name, text)
    assert verdict.kind == "wrong"
    assert words in verdict.message


CLOSE_TO_A_MISTAKE = [
    ("block_coupling", ("0.923R", "0.9231R", "0.92308R", "0.923077R"), "the answer for equal masses"),
    ("top_coupling", ("0.615", "0.6154", "0.61538", "0.615384615"), "the answer for equal masses"),
    (OMEGA, ("1.05k/m", "1.051k/m", "1.0505k/m", "1.050505k/m"), "the answer for equal masses"),
    (OMEGA, ("1.025√(k/m)", "1.02497√(k/m)", "1.0249466√(k/m)"), "Ω for equal masses"),
    (RATIO, ("1.1547", "1.15470", "1.154701", "1.1547005384"), "leave out the linear term"),
    (RATIO, ("2.254", "2.2545", "2.25451", "2.25451365"), "divide by a."),
    (RATIO, ("0.5", "3/5", "1.155", "1.2"), ""),
]


@pytest.mark.parametrize(("name", "texts", "words"), CLOSE_TO_A_MISTAKE)
def test_a_decimal_number_close_to_a_mistake_gets_one_reply_with_any_number_of_digits(name, texts, words):
    for text in texts:
        message = judge(name, text).message
        assert message.startswith("Your decimal number is close to this case.") == bool(words), (text, message)
        assert words in message


@settings(deadline=None, max_examples=60)
@given(st.decimals("0.5", "2", places=6), st.integers(1, 15))
def test_a_decimal_number_within_one_percent_of_the_right_one_is_close(far, places):
    right = RIGHT_RATIO.n(40)
    for number in (right, far):
        text = f"{sp.Float(str(number), 40):.{places}f}"
        is_close = abs(sp.Rational(text) / right - 1) < sp.Rational(1, 100)
        verdict = judge(RATIO, text)
        assert verdict.kind == "wrong"
        assert verdict.message.startswith("Your answer is close to the exact value.") == bool(is_close)


@pytest.mark.parametrize(
    ("name", "text"), [(HOOP, "0.5m'(Rφ'-X')² + 0.6m'R²φ'²"), (BLOCK, "0.49 mX'²"), (RATIO, "62/55")]
)
def test_only_a_close_decimal_number_is_called_close(name, text):
    assert "close" not in judge(name, text).message


@pytest.mark.parametrize("name", QUESTIONS)
def test_a_right_answer_to_one_question_is_wrong_for_the_others(name):
    """Negative control: no answer is right for all questions."""
    for other in set(QUESTIONS) - {name}:
        assert judge(other, zero_on_the_right(RIGHT[name][0])).kind == "wrong"


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_example_has_the_right_unit_and_is_not_the_answer(name):
    question = find_question(name)
    assert judge(name, question.example).kind == "wrong"
    example, right = (zero_on_the_right(text) for text in (question.example, RIGHT[name][0]))
    assert find_unit(parse(example)) == find_unit(parse(right))
    assert question.prompt().endswith("?")
    assert question.prompt().count("$") % 2 == 0


@pytest.mark.parametrize("name", ["", "Ω", None, ["a"], 3])
def test_an_unknown_question_is_refused(name):
    assert judge(name, "m").kind == "unreadable"


@pytest.mark.parametrize("text", [None, 3, b"m", ["m"], object(), float("nan"), "v", "ω²", "I/m"])
def test_non_text_and_unused_letters_are_unreadable(text):
    assert judge(OMEGA, text).kind == "unreadable"


@pytest.mark.parametrize("name", QUESTIONS)
def test_question_accepts_only_its_listed_letters_and_names_them(name):
    accepted_names = find_question(name).accepted_names
    for letter in (*accepted_names, *TEXTBOOK):
        assert (judge(name, letter).kind == "unreadable") == (letter not in accepted_names)
    message = judge(name, "y").message
    assert all(words in message for words in ("“y” is not known", *accepted_names))


def test_one_entry_adds_a_question(monkeypatch):
    """The README states this: mistakes and hints about bodies are optional."""
    new = questions.Question(
        name="top_momentum",
        quantity="the momentum of Φ",
        answer=lambda: eliminate(machines.right_machine()).momenta[Phi],
        prompt=lambda: "What is the momentum $p_\\Phi$?",
        example="2 m X' - m' R phi'",
        kind=questions.POLYNOMIAL,
        steps=("momenta",),
        next_question="Which terms of the Lagrangian contain Φ′?",
    )
    monkeypatch.setitem(questions._BY_NAME, "top_momentum", new)
    monkeypatch.setattr(sys.modules["ramanujan.answers.judge"], "QUESTIONS", (*QUESTIONS, "top_momentum"))
    assert judge("top_momentum", "(3/2)mR²Φ' - mRX'").kind == "right"
    assert "leave out R" in judge("top_momentum", "(3/2)mΦ' - mX'").message
    assert "twice the right one" in judge("top_momentum", "3mR²Φ' - 2mRX'").message
    assert questions.find_answer_equations("top_momentum")[-1].rhs == new.right


# Near misses, and other machines


@settings(deadline=None, max_examples=100)
@given(st.sampled_from(QUESTIONS), st.fractions(-9, 9, max_denominator=9), st.integers(0, 5))
def test_a_multiple_of_a_right_formula_is_wrong_but_a_multiple_of_a_right_equation_is_right(name, factor, spelling):
    text = zero_on_the_right(RIGHT[name][spelling % len(RIGHT[name])].strip("$"))
    verdict = judge(name, f"({factor})*({text})")
    is_right = factor != 0 if name in EQUATIONS else factor == 1
    assert (verdict.kind in ("right", "unsimplified")) == is_right


@settings(deadline=None, max_examples=60)
@given(st.sampled_from(sorted(RIGHT.keys() - EQUATIONS)), st.integers(1, 10**19), st.integers(1, 5))
def test_a_tiny_addition_is_not_overlooked(name, size, exponent):
    assert judge(name, f"({RIGHT[name][0]})*(1 + √2/{size})").kind == "wrong"
    # An answer with a root is compared to 50 digits, any other exactly.
    is_overlooked = name == RATIO and size**exponent > 10**45
    assert is_overlooked or judge(name, f"({RIGHT[name][0]})*(1 + 1/{size}^{exponent})").kind == "wrong"


@pytest.mark.parametrize(
    "altered", machines.list_altered_machines()[::7], ids=lambda each: f"{each.mistake.id} {each.group}"
)
def test_altered_machines_match_the_route_of_the_page(altered):
    """Compare SymPy's solution of the altered equations of motion with the judge's own."""
    yours = eliminate(altered.machine)
    for name, formula in (
        (OMEGA, yours.natural_frequency_squared),
        ("block_coupling", yours.X_ddot_from_phi_ddot / phi_ddot),
    ):
        question = find_question(name)
        assert question.are_equal(*map(question.read, (machines.solve(name, altered.machine), formula)))


HINTED = {
    "no_radius": "leave out R",
    "no_mixed_term": "square a sum term by term",
    "velocity_not_squared": "do not square the velocity",
    "no_half_of_energy": "leave out the ½. What is the kinetic",
    "no_half_of_translation": "leave out the ½ in the energy of translation",
    "rotation_twice": "the energy of rotation is twice the right one",
    "energies_subtracted": "subtract one energy from the other",
    "rotation_alone": "only the energy of rotation of the hoop",
    "no_half_of_spring": "leave out the ½. What is the potential",
    "deformation_not_squared": "do not square the deformation",
    "spring_to_ground": "the displacement of the slab relative to the ground",
    "block_added": "take 2Rφ + X for the deformation",
    "spring_to_centres": "the slab moves only as far as the centres",
    "potential_energy_added": "add the potential energy",
    "kinetic_energy_alone": "This is the kinetic energy alone",
    "other_momentum": "This is the momentum of Φ",
    "no_factor_2": "leave out the 2 when you differentiate X′²",
    "block_alone": "the momentum of the block alone",
    "momentum_is_zero": "the momentum of X is zero",
    "other_equation": "the equation of Φ",
    "centres_do_not_accelerate": "the centres of the lower rollers do not accelerate",
    "centres_at_rest": "the centres of the lower rollers stay at rest",
    "slab_at_rest": "the slab stays at rest",
    "rollers_turn_alike": "all rollers turn alike",
    "reciprocal_coupling": "This is the reciprocal of the right answer",
    "other_pair": "This is the acceleration of Φ divided by that of φ",
    "other_pair_and_radius": "Apart from a factor R, this is the acceleration of Φ divided by that of X",
    "after_insertion": "after the other two accelerations are inserted",
    "times_radius": "This is R times the right answer",
    "reciprocal_factor": "This is the reciprocal of the right answer",
    "equal_masses": "the answer for equal masses, m′ = m",
    "masses_interchanged": "m and m′ are interchanged",
    "no_top_in_block_equation": "leave the acceleration of Φ out of the X equation",
    "block_stands_still": "leave out the acceleration of X, as if the block stood still",
    "wrong_sign_inserted": "insert the acceleration of Φ with the wrong sign",
    "square_root_of_answer": "This is Ω.",
    "square_of_answer": "This is Ω⁴",
    "normalized": "Ω² in units of k/m",
    "plain_mass": "a plain mass m on the same spring",
    "block_and_slab": "the block and the slab alone, joined by the spring",
    "one_large_mass": "one mass as large as all bodies together",
    "equal_masses_normalized": "Ω² for equal masses, m′ = m, in units of k/m",
    "root_for_equal_masses": "This is Ω for equal masses",
    "reciprocal_frequency": "This is the reciprocal of the right answer",
    "other_root": "the other root of the quadratic",
    "sign_of_b": "b has the wrong sign",
    "inverse_ratio": "This is the ratio m/m′",
    "no_square_root": "leave out the square root",
    "no_linear_term": "leave out the linear term bε",
    "only_one_term_divided": "divide only one of the two terms by 2a",
    "divided_by_a": "divide by a.",
    "no_b": "leave out b in front of the root",
    "no_b_squared": "leave out b² under the root",
    "no_4_under_root": "leave out the factor 4 under the root",
    "no_term_in_ratio": "The term with ε is missing",
    "equation_of_inverse": "the equation for m/m′",
    "sides_added": "add the two sides of Ω²m/k = 1",
    "sign_kept": "48ε keeps its sign",
    "no_factor_of_numerator": "leave out the factor 8 of the numerator",
    "only_one_term_multiplied": "multiply only one term of a bracket",
    "no_rotation": "leave out the rotation of the hoop",
    "rolls_on_ground": "divide the velocity of the hoop relative to the ground by R",
    "other_mass": "give the mass m′ to the block",
    "sign_of_X": "add X′ to the velocity of the hoop",
    "relative_to_block": "the velocity of the hoop relative to the block",
    "slab_as_centres": "the slab moves only as far as the centres of its rollers",
    "roller_as_slab": "let the hoop move as far as the slab",
    "other_angle": "use the angle Φ for the hoop",
    "inertia_1": "the lower cylinder has the moment of inertia of a hoop",
    "inertia_1/2": "the hoop has the moment of inertia of a solid cylinder",
    "inertia_2/3": "the hoop has the moment of inertia of a spherical shell",
    "inertia_2/5": "the hoop has the moment of inertia of a solid sphere",
    "left_out": "leave out the top cylinder",
}
"""Mistake → the words of its hint that its example must satisfy."""


@pytest.mark.parametrize("id", [*mistakes.HINTS, *(mistake.id for mistake in machines.MISTAKES)])
def test_every_example_gets_its_hint(id):
    examples = [mistake.example for mistake in machines.MISTAKES if mistake.id == id] or [
        (name, slip.example) for name in QUESTIONS for slip in find_question(name).list_slips() if slip.id == id
    ]
    assert any(HINTED[id] in judge(name, text).message for name, text in examples)


def test_mistakes_about_bodies_change_the_machine_and_end_in_a_question():
    assert len({mistake.id for mistake in machines.MISTAKES}) == len(machines.MISTAKES)
    for altered in machines.list_altered_machines():
        assert altered.machine != machines.right_machine()
        assert re.fullmatch(r"[A-Z][^.?]*\. [A-Z][^.?]*\?", altered.hint)


@pytest.mark.parametrize("name", QUESTIONS)
def test_each_result_has_one_mistake(name):
    """No two mistakes of a kind have the same result. If two confusions of bodies have, the judge names neither."""
    question = find_question(name)
    for mistakes_with_results in (question.slips, question.body_mistakes):
        for (first_hint, first), (second_hint, second) in combinations(mistakes_with_results, 2):
            assert not question.are_equal(first, second), (first_hint, second_hint)
    answers = [
        (altered.mistake, question.find_answer_for(altered.machine)) for altered in machines.list_altered_machines()
    ]
    results = [(mistake, question.read(answer)) for mistake, answer in answers if answer not in (None, 0)]
    for hint, wrong in question.body_mistakes:
        kinds = {mistake.id for mistake, result in results if question.are_equal(wrong, result)}
        assert len(kinds) == 1 or "other moments of inertia" in hint, (hint, kinds)


# Arbitrary input


def judge_any_text(name, text):
    started = time.process_time()
    verdict = judge(name, text)
    with suppress(UnreadableError):
        assert typeset(text)
    # The limit is one second of processor time, including the derivation of the question.
    assert time.process_time() - started < 1
    assert verdict.kind in {"right", "unsimplified", "wrong", "unreadable"}
    # The longest message contains a unit, a name, three terms and a question.
    assert 0 < len(verdict.message) < 500
    # Of the typed text, only a name and a single character are shown, in quotation marks.
    unquoted = re.sub("“([A-Za-z_][\\w']*|.)”", "", verdict.message)
    assert not set(unquoted) & set("<>[]$\\`_*{}|#&!") - {"!"}
    return verdict.kind


@pytest.mark.parametrize("text", HOSTILE, ids=lambda text: ascii(text[:20]))
def test_hostile_text_gets_a_sentence(text):
    for name in QUESTIONS:
        assert judge_any_text(name, text) in ("wrong", "unreadable")


_PIECES = [
    *"+-*/^()²½√0123456789mkRε ",
    "m'",
    "X'",
    "phi",
    "φ'",
    "Φ'",
    "sqrt(",
    "(m",
    "1/",
    "\x00",
    "<b>",
    "\\frac{",
    "}{",
]
_WELL_FORMED = st.recursive(
    st.sampled_from(["m", "m'", "k", "R", "X'", "phi'", "Phi'", "phi", "eps", "2", "7.5", "99999999999999999999", "0"]),
    lambda inner: (
        st.tuples(inner, st.sampled_from("+-*/"), inner).map(lambda t: f"({t[0]}{t[1]}{t[2]})")
        | st.tuples(inner, st.sampled_from(["2", "12", "-3", "½", "0"])).map(lambda t: f"({t[0]})^({t[1]})")
        | inner.map(lambda t: f"√({t})")
    ),
    max_leaves=30,
)


@settings(deadline=None, max_examples=EXAMPLES)
@given(st.sampled_from(QUESTIONS), st.lists(st.sampled_from(_PIECES), max_size=30).map("".join) | st.text(max_size=40))
def test_random_tokens_get_a_verdict(name, text):
    judge_any_text(name, text)


@settings(deadline=None, max_examples=EXAMPLES)
@given(st.sampled_from(QUESTIONS), _WELL_FORMED)
@example(OMEGA, "(m+k)^" + str(MAX_WEIGHT))
def test_any_formula_gets_a_verdict(name, text):
    judge_any_text(name, text)


def test_no_hint_is_given_for_a_plain_number():
    """Negative control: the judge ignores altered machines that do not oscillate."""
    for name in set(QUESTIONS) - {RATIO, "top_coupling", *EQUATIONS}:
        for text in ("1", "√(1)", "√2/√2"):
            assert judge(name, text).message.startswith("Your answer is a plain number, but ")
