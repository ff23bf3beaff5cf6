"""The judge of a student's formula: right answers in any spelling, named mistakes, and no exceptions."""

import os
import re
import sys
import time
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import combinations

import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st

from ramanujan.answers import QUESTIONS, find_question, judge, machines, mistakes, questions
from ramanujan.answers.grammar import MAX_WEIGHT, parse, typeset
from ramanujan.answers.spelling import TEXTBOOK, UnreadableError
from ramanujan.answers.values import agree, find_unit
from ramanujan.derivation.elimination import eliminate, phi_ddot
from ramanujan.derivation.model import Phi, k, m

OMEGA, RATIO, POTENTIAL = "natural_frequency_squared", "unit_mass_ratio", "potential_energy"
BLOCK, HOOP, CYLINDER, SLAB, TOP = (f"kinetic_energy_{body}" for body in ("block", "hoop", "cylinder", "slab", "top"))
EQUATIONS = ("block_equation", "unit_quadratic")
RIGHT_RATIO = (sp.sqrt(1729) - 1) / 36
EXAMPLES = 20_000 if os.environ.get("RAMANUJAN_DEEP") else 150

RIGHT = {
    BLOCK: ["½mX'²", "0.5 m Ẋ²", "½ m (-X')²", "mX'X'/2"],
    HOOP: [
        "½m'(Rφ'-X')² + ½m'R²φ'²",
        "m'(2R²φ'² - 2RX'φ' + X'²)/2",
        r"\frac12 m'\left(R\,\dot{\varphi}-\dot X\right)^{2} + \tfrac{1}{2}m^{\prime} R^2\dot\varphi^2",
    ],
    CYLINDER: ["½m'(Rφ'-X')² + ¼m'R²φ'²", "1/2 m' (R phi' - X')^2 + 1/2*1/2 m' R^2 phi'^2"],
    SLAB: ["½m(2Rφ'-X')²", "m/2*(X' - 2R phi')^2", "2mR²φ'² - 2mRφ'X' + ½mX'²"],
    TOP: ["½m(RΦ'-X')² + ¼mR²Φ'²", "m(3R²Phi'^2 - 4R Phi' X' + 2X'^2)/4"],
    POTENTIAL: ["2kR²φ²", "½k(2Rφ)²", "2 k (R phi)^2"],
    "lagrangian": [
        "½mX'² + ½m'(Rφ'-X')² + ½m'R²φ'² + ½m'(Rφ'-X')² + ¼m'R²φ'² + ½m(2Rφ'-X')² + ½m(RΦ'-X')² + ¼mR²Φ'² - 2kR²φ²",
        "½(3m+2m')X'² + ¼(8m+7m')R²φ'² + ¾mR²Φ'² - 2(m+m')RX'φ' - mRX'Φ' - 2kR²φ²",
    ],
    "block_momentum": ["(3m+2m')X' - 2(m+m')Rφ' - mRΦ'", "3mX' + 2m'X' - 2mRφ' - 2m'Rφ' - mRΦ'"],
    "block_equation": [
        "(3m+2m')X'' - 2(m+m')Rφ'' - mRΦ'' = 0",
        "(3m+2m')Ẍ = 2(m+m')Rφ̈ + mRΦ̈",
        "2(m+m')R d²φ/dt² - (3m+2m')d²X/dt² + mR d²Φ/dt²",
    ],
    "phi_equation": ["R(8m+7m')/2", "4mR + 7/2 m'R", "R(4m + 3.5m')", "(8m+7m')R 0.5", "R(4m + 3,5m')"],
    "block_coupling": ["6R(m+m')/(7m+6m')", "6R(1+ε)/(7+6ε)", "R(6m+6m')/(6m'+7m)"],
    "top_coupling": ["4(m+m')/(7m+6m')", "4(1+eps)/(7+6eps)"],
    OMEGA: [
        "8k(7m+6m')/(32m²+49mm'+18m'²)",
        "(56km+48km')/(18m'^2+49m m'+32m^2)",
        "(k/m) 8(7+6ε)/(18ε²+49ε+32)",
        r"\frac{8k(7m+6m')}{32m^2+49mm'+18m'^2}",
        r"$\frac{8\,k\,\left(7\,m + 6\,m'\right)}{32\,m^{2} + 49\,m\,m' + 18\,{m'}^{2}}$",
    ],
    "unit_quadratic": ["18ε²+ε-24=0", "18 eps^2 + eps = 24", "48 - 2ε = 36ε²", "(36ε+1)² = 1729"],
    RATIO: [
        "(sqrt(1729) - 1)/36",
        "48/(1+√1729)",
        "-(1-√1729)/36",
        r"\frac{\sqrt{1729}-1}{36}",
        "(√6916-2)/72",
    ],
}

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
    (TOP, "½m(RΦ')²", "The term with X′² is missing"),
    (HOOP, "½ m' X'^3/φ'", "has the unit kg·m³/s²"),
    (HOOP, "½ m' X'^2 φ'/Φ'", "below a fraction line"),
    (POTENTIAL, "½k(2Rφ)²+½kX²", "X does not deform the spring"),
    (POTENTIAL, "0 + kR²φ²", "half of the right one"),
    (POTENTIAL, "k(1.41 R φ)²", "exact number agrees"),
    ("block_equation", "X'' = X''", "Both sides of your equation are equal"),
    ("block_equation", "(3m+2m')X'' - 2(m+m')Rφ'' - mRΦ'' = kX", "depends on k and X"),
    ("unit_quadratic", "ε = (√1729-1)/36", "gives ε a value"),
    ("unit_quadratic", "ε = 1", "gives ε a value"),
    ("unit_quadratic", "1.127 = ε", "gives ε a value"),
    ("unit_quadratic", "ε = 24", "term with ε² is missing"),
    ("unit_quadratic", "18ε² + √2*ε = 24", "contains a root"),
    ("unit_quadratic", "18ε² + ε - 24 = 18ε²", "the terms with ε² cancel. Which sign"),
    ("block_coupling", "R(7m+6m')/(6(m+m'))", "Apart from the factor R², this is the reciprocal"),
    ("block_coupling", "-(7m+6m')/(6R(m+m'))", "Apart from the factor −1, this is the reciprocal"),
    (OMEGA, "(32m²+49mm'+18m'²)/(8(7m+6m'))", "Apart from the factor k, this is the reciprocal"),
    (
        "block_momentum",
        "-(3m+2m')X' + 2(m+m')Rφ' - mRΦ'",
        "by −1. Then only one term differs. Your coefficient of Φ′ should be negative",
    ),
    (
        "lagrangian",
        f"-({RIGHT['lagrangian'][1]} + 4kR²φ²)",
        "by −1. Then only one term differs. Your coefficient of φ² should be negative",
    ),
    ("block_equation", "-(3m+2m')X'' + 2(m+m')Rφ'' - mRΦ'' = 0", "coefficient of Φ″ should be positive"),
    ("block_equation", "(3m+2m')X'' + mRΦ'' = 2(m+m')Rφ'' + mRΦ''", "the terms with Φ″ cancel. Which sign"),
    ("lagrangian", RIGHT["lagrangian"][0].replace("+ ¼mR²Φ'²", "- ½mR²Φ'²"), "the terms with Φ′² cancel. Which sign"),
    ("phi_equation", "R(8m+7m'-7m')/2", "the terms with m′R cancel. Which sign"),
    ("block_coupling", "6R(m+m'-m')/(7m+6m')", "the terms with m′R in the numerator cancel"),
    ("phi_equation", "R(8m+6m')/2", "other moments of inertia of the lower rollers"),
    ("block_coupling", "-6R(m+m')/(7m+6m')", "wrong sign"),
    (OMEGA, "k/(5m)", "does not depend on m′, but Ω² does"),
    (OMEGA, "1.05 k/m", "equal masses"),
    ("block_coupling", "0.923 R", "equal masses"),
    ("top_coupling", "0.615", "equal masses"),
    # A natural mistake takes precedence over a confused body with the same result.
    ("top_coupling", "2/3", "Apart from a factor R, this is the acceleration of Φ divided by that of X"),
    ("top_coupling", "-4(m+m')/(7m+6m')", "has the wrong sign"),
    ("top_coupling", "R", "is a plain number"),
    ("top_coupling", "4/7", "right for m′ = 0"),
    ("top_coupling", "4m/(7m+6m')", "term with m′ in the numerator is missing"),
    ("unit_quadratic", "18ε²+97ε-24=0", "48ε keeps its sign"),
    (RATIO, "(√(97²+1728)-97)/36", "48ε keeps its sign"),
    ("block_equation", "(2m+3m')X'' = 2(m+m')Rφ'' + mRΦ''", "coefficient of X″ m and m′ are interchanged"),
    ("block_momentum", "(3m+2m')X' - 2mRφ' - mRΦ'", "The term with m′Rφ′ is missing"),
    ("block_momentum", "(3m+2m')X' - 2(m'-m)Rφ' - mRΦ'", "coefficient of mRφ′ should be negative"),
    ("block_momentum", "(3m+m')X' - (2m+m')Rφ' - mRΦ'", "coefficient of m′X′ is half of the right one"),
    (HOOP, "½m'(Rφ'-X')² - ½m'R²φ'²", "the terms with φ′² cancel. Which sign"),
    (HOOP, "½m'X'² - m'RX'φ'", "The term with φ′² is missing"),
    (HOOP, "½m'v²", "leave out the rotation of the hoop"),
    (OMEGA, "7k/(4m)", "right for m′ = 0"),
    # For m = 0 the mass ratio is infinite, so this answer is not right then.
    (OMEGA, "8k(7m+6m')/(32m²+49mm'+18m'²) + eps k m'/(m m'+m'²) + k m/m'²", "wrong even for equal masses"),
    (OMEGA, "2k/(3m+m')", "wrong even for equal masses"),
    (OMEGA, "√(R/R)", "plain number"),
    # Discriminants of machines with one body changed: two hoops 37, two cylinders 33. A hoop beside a cylinder without
    # spin has the same inertia as two cylinders.
    (RATIO, "(√33+1)/4", "other moments of inertia of the lower rollers"),
    (RATIO, "(√(49²-4*18*32)-49)/36", "A ratio of two masses is positive. Which"),
    (RATIO, "1.2", "off by one unit"),
    (RATIO, "(√1730-1)/36", "without the root is right"),
    (RATIO, "(41.58-1)/36", "exact number agrees"),
    (RATIO, "9/8", "With ε = 1.125 you get Ω² = 1.00085 k/m"),
    (RATIO, "62/55", "Ω² and k/m differ by"),
    (RATIO, "-2", "positive"),
    (RATIO, "m'/m", "m and m′, but the mass ratio does not depend on them"),
    (BLOCK, "m + R", "different units, kg and m"),
    (BLOCK, "m + 1", "a plain number to a term with the unit kg"),
    (BLOCK, "sqrt(m)", "has the unit kg^(1/2)"),
    (OMEGA, "k/m'*R", "the unit m/s², but Ω² has the unit 1/s²"),
]

HOSTILE = [
    "__import__('os')",
    "9**9**9",
    "(" * 10**6,
    "\x00",
    "1e999999",
    "9" * 10**5,
    "-" * 299 + "m",
    "√" * 20 + "m",
    "sqrt(m-m-1)",
    "0^-1",
    "1/(m-m)",
    "1/(√2*√2-2)",
    "m\u0301",
    "\ud800",
    "<script>alert(1)</script>",
    "[a](javascript:b)",
    "/".join("(m^12+k)" for _ in range(9)),
    "(m+k+R+m'+1)^12*(m+k+R+m'+2)^12/99999999999999999999",
    "√(m+" * 20 + "k" + ")" * 20,
    "k/(m/m)^(-2)",
    "^".join("1" * 150),
    "1/(" + "+".join(f"√{n}" for n in (2, 3, 5, 7, 11, 13, 17, 19)) + ")",
    "√(99999999999999999989*99999999999999999971)",
    "(X+X'+phi+phi'+Phi+Phi'+m+m'+k+R)^4/(X+X'+phi+phi'+Phi+Phi'+m+m'+k+2R)^4",
    "".join(f"+1/(m+{n})" for n in range(30)),
    r"\frac" * 60,
    "(m+k+R+m')^4*99999999999999999999^12 = eps",
    "=" * 300,
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


@settings(deadline=None, max_examples=60)
@given(st.integers(1, 15), st.integers(-3, 3))
def test_a_decimal_is_accepted_if_rounded_correctly(places, off):
    typed = Fraction(round(Fraction(str(RIGHT_RATIO.n(40))) * 10**places) + off, 10**places)
    message = judge(RATIO, f"{sp.Rational(typed).n(30):.{places}f}").message
    assert ("exact number agrees" in message) == (off == 0)
    distance = abs(typed - Fraction(str(RIGHT_RATIO.n(40)))) * 10**places
    assert ("off by one unit" in message) == (off != 0 and distance <= Fraction(3, 2))


@pytest.mark.parametrize(
    ("name", "text"), [(HOOP, "0.5m'(Rφ'-X')² + 0.6m'R²φ'²"), (BLOCK, "0.49 mX'²"), (RATIO, "62/55")]
)
def test_only_a_decimal_number_near_its_last_digit_is_called_rounded(name, text):
    assert not re.search("exact number|agrees|digit", judge(name, text).message)


def zero_on_the_right(text: str) -> str:
    """Return a formula, or the left side of an equation minus its right side."""
    left, equals, right = text.partition("=")
    return f"{left} - ({right})" if equals else text


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
@given(st.sampled_from(sorted(RIGHT.keys() - EQUATIONS)), st.integers(1, 10**19), st.sampled_from(["", "*√2"]))
def test_a_tiny_addition_is_not_overlooked(name, size, root):
    text = RIGHT[name][0]
    assert judge(name, f"({text})*(1 + 1/{size}{root})").kind == "wrong"
    assert judge(name, f"({text})*(1 + 1/{size}^5{root})").kind == "wrong"


@pytest.mark.parametrize(
    "altered", machines.list_altered_machines()[::7], ids=lambda each: f"{each.mistake.id} {each.group}"
)
def test_altered_machines_match_the_route_of_the_page(altered):
    """Compare SymPy's solution of the altered equations of motion with the judge's numerical one."""
    yours = eliminate(altered.machine)
    for name, formula in (
        (OMEGA, yours.natural_frequency_squared),
        ("block_coupling", yours.X_ddot_from_phi_ddot / phi_ddot),
    ):
        assert agree(*map(find_question(name).evaluate, (machines.solve(name, altered.machine), formula)))


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


def gets_its_hint(id: str) -> bool:
    """Return whether the example of a mistake gets its hint, in the words of `HINTED`."""
    examples = [mistake.example for mistake in machines.MISTAKES if mistake.id == id] or [
        (name, slip.example) for name in QUESTIONS for slip in find_question(name).list_slips() if slip.id == id
    ]
    return any(HINTED[id] in judge(name, text).message for name, text in examples)


@pytest.mark.parametrize("id", [*mistakes.HINTS, *(mistake.id for mistake in machines.MISTAKES)])
def test_every_example_gets_its_hint(id):
    assert gets_its_hint(id)


def test_negative_control_false_hints_fail(monkeypatch):
    """Negative control: a result that does not fit the hint, and a hint in other words."""
    with monkeypatch.context() as patched:
        false = mistakes.Slip("plain_mass", mistakes.HINTS["plain_mass"], "k/m", (k / (3 * m),))
        patched.setitem(questions._BY_NAME, OMEGA, replace(find_question(OMEGA), find_slips=lambda _right: [false]))
        assert not gets_its_hint("plain_mass")
    monkeypatch.setitem(mistakes.HINTS, "plain_mass", "This is Ω² of a mass 2m on the same spring. Which bodies move?")
    monkeypatch.setitem(questions._BY_NAME, OMEGA, replace(find_question(OMEGA)))
    assert not gets_its_hint("plain_mass")


def test_mistakes_about_bodies_change_the_machine_and_end_in_a_question():
    assert len({mistake.id for mistake in machines.MISTAKES}) == len(machines.MISTAKES)
    for altered in machines.list_altered_machines():
        assert altered.machine != machines.right_machine()
        assert re.fullmatch(r"[A-Z][^.?]*\. [A-Z][^.?]*\?", altered.hint)


@pytest.mark.parametrize("name", QUESTIONS)
def test_each_result_has_one_mistake(name):
    """No two mistakes of a kind have the same result. If two confusions of bodies have, the judge names neither."""
    question = find_question(name)
    for mistakes_with_values in (question.values_of_slips, question.values_of_body_mistakes):
        for (first_hint, first), (second_hint, second) in combinations(mistakes_with_values, 2):
            assert not agree(first, second), (first_hint, second_hint)
    results = [
        (altered.mistake, question.find_answer_for(altered.machine)) for altered in machines.list_altered_machines()
    ]
    with_values = [(mistake, question.evaluate(result)) for mistake, result in results if result not in (None, 0)]
    for hint, values in question.values_of_body_mistakes:
        kinds = {mistake.id for mistake, wrong_values in with_values if agree(values, wrong_values)}
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
