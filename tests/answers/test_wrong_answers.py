"""Thousands of wrong answers, each with one spoiled coefficient or sign: every sentence of a verdict must be true.

The tests parse each sentence and compare it with the spoiled formula, at random points in fractions. They check a hint
at an altered machine independently: Ω² is the stiffness times an entry of M⁻¹. The suite uses a small
seeded sample. RAMANUJAN_DEEP=1 uses 5,000 answers to each question.
"""

import random
import re
from fractions import Fraction
from functools import cache, lru_cache

import pytest
import sympy as sp

from ramanujan.answers import QUESTIONS, judge, machines
from ramanujan.derivation import model
from tests.checks.answers import OMEGA, RATIO, RIGHT_RATIO
from tests.checks.expressions import (
    ACCELERATIONS,
    ENERGIES,
    EQUATIONS,
    QUOTIENTS,
    SYMBOLS,
    TYPED,
    Phi,
    Phid,
    R,
    X,
    Xd,
    k,
    m,
    mp,
    phi,
    phid,
    ratio,
)
from tests.settings import DEEP

COUNT = 5000 if DEEP else 16
SHOWN = dict(zip(SYMBOLS, ("m", "m′", "k", "R", "X", "X′", "φ", "φ′", "Φ", "Φ′"), strict=True))
half, quarter = sp.Rational(1, 2), sp.Rational(1, 4)

SHOWN |= dict(zip(ACCELERATIONS, ("X″", "φ″", "Φ″", "ε"), strict=True))


FACTORS = [2, half, 3, sp.Rational(1, 3), sp.Rational(3, 2), sp.Rational(7, 5), 4, quarter, 10, sp.Rational(8, 7)]


@cache
def spell_as_verdict(monomial: sp.Expr) -> str:
    """Return a product of names in the spelling of a verdict."""
    powers = monomial.as_powers_dict()
    return "".join(SHOWN[s] + {1: "", 2: "²", 3: "³"}[powers[s]] for s in SHOWN if s in powers)


@lru_cache(maxsize=4096)
def text_of(expression: sp.Expr) -> str:
    return str(expression.xreplace({s: sp.Symbol(name) for s, name in TYPED.items()}))


def spoiled_text(whole: sp.Expr, term: sp.Expr, ratio: sp.Expr, source: random.Random) -> str:
    """Return the text of a sum with one term multiplied by a ratio, directly or by a correction at the end."""
    if source.randrange(2):
        return f"{text_of(whole)} + ({text_of((ratio - 1) * term)})"
    terms = [text_of(each) for each in (ratio * term, *sp.Add.make_args(sp.expand(whole - term)))]
    source.shuffle(terms)
    return " + ".join(f"({text})" for text in terms)


def typed(text: str, source: random.Random) -> str:
    """Return a text in a random spelling."""
    return source.choice([text, text.replace("**", "^"), text.replace("*", "·").replace("··", "^")])


@cache
def points() -> tuple[dict[str, Fraction], ...]:
    source = random.Random(41)
    return tuple({name: Fraction(source.randrange(10, 10**4), 97) for name in TYPED.values()} for _ in range(2))


def value(expression: sp.Expr, point: dict[str, Fraction]) -> Fraction:
    result = expression.subs({s: sp.Rational(point[n].numerator, point[n].denominator) for s, n in TYPED.items()})
    return Fraction(int(result.p), int(result.q))


# The sentences of a verdict


@lru_cache(maxsize=4096)
def factor_of(text: str) -> sp.Expr:
    words = {"twice": 2, "half of": half, "three times": 3, "four times": 4}
    if text in words:
        return sp.sympify(words[text])
    text = text.removesuffix(" times").replace("−", "-").replace("m′", "mp")
    text = text.replace("²", "**2").replace("³", "**3")
    text = re.sub(r"(?<=[0-9mpkR)])(?=[Rkms])", "*", text)
    return sp.sympify(text, locals={"m": m, "mp": mp, "R": R, "k": k})


def hint_is_true(name: str, message: str, given: sp.Expr) -> bool:
    """Return whether a formula is the one that a hint describes."""
    also_half = message.endswith(" A factor ½ is missing as well.")
    for point in points():
        expected = _from_hint(name, message, point)
        if expected is None or value(given, point) != expected * (2 if also_half else 1):
            return False
    return True


def _from_hint(name: str, message: str, point: dict[str, Fraction]) -> Fraction | None:
    right = ENERGIES.get(name, sp.S.Zero)
    is_spring = name == "lagrangian" and message not in HINTED and "Lagrangian" not in message
    of_spring = is_spring and _from_hint("potential_energy", message, point)
    if of_spring:
        return value(right + ENERGIES["potential_energy"], point) - of_spring
    # Hints that one spoiled coefficient can cause. test_answers has examples of all others.
    of_formula = {
        "add the potential energy": lambda: right + 2 * ENERGIES["potential_energy"],
        "This is the kinetic energy alone": lambda: right + ENERGIES["potential_energy"],
        "subtract one energy": lambda: right - 2 * _rotation(name),
        "square a sum term by term": lambda: sum(
            t for t in sp.expand(right).args if len(t.free_symbols & {Xd, phid, Phid}) == 1
        ),
        "leave out the ½.": lambda: 2 * right,
        "energy of rotation is twice": lambda: right + _rotation(name),
    }
    for words, formula in of_formula.items():
        if words in message:
            return value(sp.sympify(formula()), point)
    if name == "potential_energy" and "the slab moves only as far" in message:
        return value(half * k * R**2 * phi**2, point)
    if name == "block_momentum" and "when you differentiate X′²" in message:
        return value(right - (3 * m + 2 * mp) * Xd / 2, point)
    machine = HINTED.get(message.removesuffix(" A factor ½ is missing as well."))
    if machine is None:
        return None
    at_point = {symbol: sp.Rational(str(point[name])) for symbol, name in SPELLED.items()}
    if name in ("lagrangian", "block_momentum"):
        lagrangian = machine.kinetic_energy - machine.potential_energy
        given = lagrangian if name == "lagrangian" else lagrangian.diff(model.VELOCITIES[0])
        return Fraction(str(given.subs(at_point)))
    if name.startswith("kinetic_energy_"):
        return Fraction(str(machine[name.removeprefix("kinetic_energy_")].kinetic_energy.subs(at_point)))
    return Fraction(str(by_the_inverse_matrix(machine, at_point)[name]))


HINTED = {altered.hint: altered.machine for altered in machines.list_altered_machines()}
SPELLED = dict(zip((*model.VELOCITIES, model.m, model.m_prime, model.k, model.R, *model.COORDINATES),
                   ("X'", "phi'", "Phi'", "m", "m'", "k", "R", "X", "phi", "Phi"), strict=True))  # fmt: skip


def by_the_inverse_matrix(machine: model.Machine, at_point: dict) -> dict[str, sp.Expr]:
    """Return question → right answer for a machine, from M⁻¹e_φ, the shape of the oscillating mode."""
    M = sp.hessian(machine.kinetic_energy, model.VELOCITIES).subs(at_point)
    stiffness = machine.potential_energy.diff(model.phi, 2).subs(at_point)
    if not any(M[2, :]):
        M[2, 2] = 1
    X, phi, Phi = M.LUsolve(sp.Matrix([0, 1, 0]))
    return {
        "block_coupling": X / phi,
        "top_coupling": Phi / phi,
        "phi_equation": M[1, 1] * 4 * at_point[model.k] * at_point[model.R] / stiffness,
        "natural_frequency_squared": stiffness * phi,
    }


def _rotation(name: str) -> sp.Expr:
    beta, mass, rate = {"hoop": (1, mp, phid), "cylinder": (half, mp, phid), "top": (half, m, Phid)}[
        name.split("_")[-1]
    ]
    return half * beta * mass * R**2 * rate**2


def difference_is_true(message: str, term: str, ratio: sp.Expr) -> bool:
    """Return whether a verdict names a term and describes its error correctly. Its coefficient is off by `ratio`."""
    of_term = rf"Your coefficient of {re.escape(term)}"
    if ratio.has(sp.sqrt(2)):
        return message.startswith("Your answer contains a root. The right one has none.")
    if ratio == 0:
        return f"The term with {term} is missing." in message
    match = re.search(rf"{of_term} is (.+?) the right one\.", message)
    if match:
        return factor_of(match[1]) / ratio == 1
    match = re.search(rf"{of_term} has the wrong sign\. Its size is (.+?) the right one\.", message)
    if match:
        return factor_of(match[1]) / ratio == -1
    return ratio == -1 and f"Your coefficient of {term} has the wrong sign." in message


def multiple_is_true(message: str, ratio: sp.Expr) -> bool:
    """Return whether a verdict states the correct ratio of the given answer to the right one."""
    match = re.search(r"Your answer is (.+?) the right one\.", message)
    if match:
        return factor_of(match[1]) / ratio == 1
    match = re.search(r"Your answer has the wrong sign\. Its size is (.+?) the right one\.", message)
    if match:
        return factor_of(match[1]) / ratio == -1
    return ratio == -1 and "Your answer has the wrong sign." in message


# Spoiled energies


def monomials(expression: sp.Expr, variables: tuple[sp.Symbol, ...]) -> dict[sp.Expr, sp.Expr]:
    polynomial = sp.Poly(expression, *variables)
    return {sp.prod(v**n for v, n in zip(variables, p, strict=True)): c for p, c in polynomial.terms()}


def spoiled_factor(source: random.Random, of_energy: bool) -> sp.Expr:
    kind = source.randrange(8 if of_energy else 5)
    if kind == 0:
        return sp.Integer(-1)
    if kind == 1:
        return sp.Integer(0)
    if kind <= 3:
        return source.choice([-1, 1]) * sp.sympify(source.choice(FACTORS))
    if kind == 4:
        return sp.Rational(source.randrange(1, 99), source.randrange(1, 99))
    return sp.sympify(source.choice([R, 1 / R, m / mp, mp / m, k, R**2, 2 * R, sp.sqrt(2), 3 * mp / m]))


@pytest.mark.parametrize("name", ENERGIES)
def test_an_altered_coefficient_and_an_extra_term_get_a_true_verdict(name: str) -> None:
    source = random.Random(name)
    variables = (m, mp, R) if name == "phi_equation" else (Xd, phid, Phid, X, phi, Phi)
    right = monomials(ENERGIES[name], variables)
    hints = 0
    for _ in range(COUNT):
        monomial = source.choice(list(right))
        ratio = spoiled_factor(source, of_energy=name != "phi_equation")
        if ratio == 1 or (ratio == 0 and len(right) == 1):
            continue
        term = right[monomial] * monomial
        text = typed(spoiled_text(ENERGIES[name], term, ratio, source), source)
        verdict = judge(name, text)
        assert verdict.kind == "wrong", text
        is_true = difference_is_true(verdict.message, spell_as_verdict(monomial), ratio)
        is_true_hint = not is_true and hint_is_true(name, verdict.message, ENERGIES[name] + (ratio - 1) * term)
        hints += is_true_hint
        assert is_true or is_true_hint, (text, verdict.message)
        assert "close to the exact value" not in verdict.message
    assert hints < COUNT
    for _ in range(COUNT // 4):
        extra = sp.prod(source.choices(variables, k=source.choice([1, 2, 2, 3])))
        if extra in right:
            continue
        coefficient = sp.sympify(source.choice(FACTORS)) * (1 if name == "phi_equation" else source.choice([m, mp, k]))
        given = ENERGIES[name] + source.choice([-1, 1]) * coefficient * extra
        verdict = judge(name, typed(text_of(given), source))
        assert verdict.kind == "wrong"
        sentence = f"Your answer contains a term with {spell_as_verdict(extra)}. The right answer has none."
        assert sentence in verdict.message or hint_is_true(name, verdict.message, given), (given, verdict.message)


# Spoiled equations


@pytest.mark.parametrize("name", EQUATIONS)
def test_an_equation_is_right_up_to_a_factor_and_an_altered_term_is_named(name: str) -> None:
    source = random.Random(name)
    variables = ACCELERATIONS[:3] if name == "block_equation" else (ratio,)
    right = monomials(EQUATIONS[name], variables)
    hints = 0
    for _ in range(COUNT):
        factor = source.choice([1, -1, 3, sp.Rational(-2, 7), *([m, -R] if name == "block_equation" else [])])
        whole = sp.expand(factor * EQUATIONS[name])
        moved = source.choice([sp.S.Zero, *sp.Add.make_args(whole)])
        verdict = judge(name, f"{text_of(whole - moved)} = {text_of(-moved)}")
        assert verdict.kind == "right" or "without" in verdict.message, (whole, verdict.message)
        monomial, off = source.choice(list(right)), spoiled_factor(source, of_energy=False)
        if off == 1:
            continue
        spoiled = whole + sp.expand(factor * (off - 1) * right[monomial] * monomial)
        verdict = judge(name, f"{text_of(spoiled - moved)} = {text_of(-moved)}")
        assert verdict.kind == "wrong", (spoiled, verdict.message)
        if monomial == 1:
            sentence = r"constant term is missing" if off == 0 else "constant term has the wrong sign"
            times = re.search(r"Your constant term is (.+?) the right one\.", verdict.message)
            is_true = factor_of(times[1]) == off if times else re.search(sentence, verdict.message) and off <= 0
        else:
            is_true = difference_is_true(verdict.message, spell_as_verdict(monomial), off)
        hints += not is_true
        assert is_true or "if " in verdict.message or "term with ε is missing" in verdict.message, (spoiled, verdict)
    assert hints < COUNT / 3


# Spoiled quotients


@pytest.mark.parametrize("name", QUOTIENTS)
def test_a_spoiled_fraction_is_wrong_and_its_verdict_is_true(name: str) -> None:
    source = random.Random(name)
    above, below = QUOTIENTS[name]
    for _ in range(COUNT):
        place = source.randrange(2)
        part = QUOTIENTS[name][place]
        term = source.choice(sp.Add.make_args(part))
        ratio = spoiled_factor(source, of_energy=False)
        if ratio == 1:
            continue
        texts = [text_of(sp.factor(each)) for each in (above, below)]
        texts[place] = spoiled_text(part, term, ratio, source)
        verdict = judge(name, typed(f"({texts[0]})/({texts[1]})", source))
        assert verdict.kind == "wrong"
        spoiled = [above, below]
        spoiled[place] = part + (ratio - 1) * term
        given = sp.cancel(spoiled[0] / spoiled[1])
        assert (
            verdict.message.startswith("This is not the right answer.")
            or multiple_is_true(verdict.message, sp.cancel(given * below / above))
            or hint_is_true(name, verdict.message, given)
            or letters_are_missing(verdict.message, given)
        ), (given, verdict.message)


def letters_are_missing(message: str, given: sp.Expr) -> bool:
    """Return whether an answer depends on none of the letters that a verdict calls missing."""
    match = re.match(r"Your answer does not depend on (.+?), but ", message)
    return bool(match) and given.free_symbols.isdisjoint(map(factor_of, match[1].split(" and ")))


# Spoiled numbers

BY_QUADRATIC = {
    "other root": (-1 - sp.sqrt(1729)) / 36,
    "b has the wrong sign": (1 + sp.sqrt(1729)) / 36,
    "divide by a": (sp.sqrt(1729) - 1) / 18,
    "leave out b in front": sp.sqrt(1729) / 36,
    "leave out b² under": (sp.sqrt(1728) - 1) / 36,
    "leave out the linear term": sp.sqrt(sp.Rational(24, 18)),
}


def same(left: sp.Expr, right: sp.Expr) -> bool:
    """Return whether two numbers agree to 40 digits."""
    return bool(abs((left - right).n(60)) < sp.Float(10, 60) ** -40)


def test_the_sentence_about_a_wrong_mass_ratio_is_true() -> None:
    source = random.Random(1729)
    for _ in range(COUNT):
        a, b = source.choice([1, 1, 2, -1]), source.choice([-1, -1, 1, -2, 0, -49, 5])
        n, c = source.choice([1729, 1729, source.randrange(1700, 1760), 1728, 33, 37]), source.choice([36, 36, 18, 72])
        text, given = f"({a}*√{n}+({b}))/{c}", (a * sp.sqrt(n) + b) / c
        verdict = judge(RATIO, text)
        if same(given, RIGHT_RATIO):
            assert verdict.kind in ("right", "unsimplified")
            continue
        assert verdict.kind == "wrong"
        assert _true_of_number(verdict.message, given), (text, verdict.message)


def _true_of_number(message: str, given: sp.Expr) -> bool:
    for words, number in BY_QUADRATIC.items():
        if words in message:
            return same(given, number)
    if message.startswith("This is not the right answer."):
        return True
    return multiple_is_true(message, sp.nsimplify(sp.radsimp(given / RIGHT_RATIO))) or hinted_ratio(message, given)


def hinted_ratio(message: str, given: sp.Expr) -> bool:
    """Return whether the machine of a hint has Ω² = k/m at the given mass ratio, to 12 digits."""
    if message not in HINTED:
        return False
    point = dict.fromkeys(SPELLED, sp.Integer(1)) | {model.m_prime: sp.Rational(str(given.n(30)))}
    return abs(float(by_the_inverse_matrix(HINTED[message], point)[OMEGA] - 1)) < 1e-12


def test_every_question_is_covered() -> None:
    assert {*ENERGIES, *EQUATIONS, *QUOTIENTS, RATIO} == set(QUESTIONS)
