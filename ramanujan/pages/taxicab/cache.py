"""The caches of page 4: the unit condition as formulas, the 40 machines, and the results for other bodies.

The results come from `number_theory` (exact integers) and from the derivation. This module writes them as LaTeX.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, isqrt
from statistics import median

import numpy as np
import streamlit as st
import sympy as sp

from ramanujan import normalized_frequency_squared, number_theory
from ramanujan.derivation.model import epsilon, equation
from ramanujan.derivation.numbers import format_with_decimal, unit_frequency_condition
from ramanujan.derivation.printers import latex
from ramanujan.number_theory import BodyChoice
from ramanujan.shell.cache import responsive, route

LARGEST_PART = 1000
"""The largest p and q. Every discriminant in this range can be factored."""

COUNTED_PART = 20
"""The largest p and q of the targets in the count of discriminants."""


PAPER = BodyChoice()
"""The paper's machine."""


@st.cache_resource(show_spinner=False)
def unit_equations() -> tuple[str, ...]:
    """Return, as LaTeX, the equations from Ω² to the mass ratio at which the paper's machine is in step."""
    steps = route("euler_lagrange")
    frequency, condition = (steps[key].equations[-1] for key in ("ratio", "unit"))
    # The derivation contains the completed square, and the section on cubes contains the second sum.
    *_square_is_completed, square, _second_sum, root = steps["root"].equations
    return tuple(map(latex, (frequency, condition, square, root)))


def discriminant_written_out() -> tuple[str, str]:
    """Return, as LaTeX, the discriminant b² − 4ac of the paper's machine, and the sum of cubes with the same terms."""
    a, b, c = PAPER.quadratic
    with sp.evaluate(False):
        expanded = sp.Add(sp.Pow(b, 2), sp.Mul(4, a, -c))
    same_terms = [(x, y) for x, y in PAPER.cubes if x**3 == b**2]
    return sp.latex(expanded, mul_symbol="dot", order="none"), sums_of_cubes(same_terms)


@dataclass(frozen=True)
class Story:
    """The results for bodies and a target. Formulas are LaTeX; the mass ratio is also a number."""

    machine: BodyChoice
    quadratic: str
    root: str
    ratio: float
    factors: str
    cubes: str
    square: str


@st.cache_data(show_spinner=False, max_entries=512)
def story(left: str, right: str, top: str, p: int = 1, q: int = 1) -> Story:
    """Return the story of the machine with these bodies and the target Ω²m/k = p/q; ValueError as in `BodyChoice`."""
    machine = BodyChoice(left, right, top, Fraction(p, q))
    a, b, c = machine.quadratic
    root = (sp.sqrt(machine.discriminant) - b) / (2 * a)
    return Story(
        machine,
        latex(equation(a * epsilon**2 + b * epsilon + c, sp.S.Zero)),
        format_with_decimal(root, 7),
        float(number_theory.positive_root_digits(a, b, c, 40)),
        product_of_primes(machine.factorization),
        sums_of_cubes(machine.cubes),
        latex(equation((2 * a * epsilon + b) ** 2, sp.Integer(machine.discriminant))),
    )


@st.cache_resource(show_spinner=False)
def machines() -> tuple[BodyChoice, ...]:
    """Return all 40 machines at the unit frequency, and cache their factors and cubes."""
    return tuple(number_theory.machines())


def practical_machines() -> list[tuple[Fraction, Fraction, float]]:
    """Return the first convergents of the paper's mass ratio, as machines for a workshop.

    Each has its ratio, the exact error in Ω²m/k, and the number of periods until it is one turn off.
    """
    ratios = number_theory.convergents(quotients(5))
    errors = [number_theory.normalized_frequency_squared_exact(*PAPER.bodies, ratio) - 1 for ratio in ratios]
    # 1/|√(1 + δ) − 1|, without the difference of two numbers close to 1.
    return [(each, error, (1 + (1 + error) ** 0.5) / abs(error)) for each, error in zip(ratios, errors, strict=True)]


def quotients(terms: int = 12) -> list[int]:
    """Return the continued fraction of the paper's mass ratio."""
    return number_theory.continued_fraction(*PAPER.quadratic, terms)


def curve(least: float, most: float) -> tuple[np.ndarray, np.ndarray]:
    """Return mass ratios and Ω²m/k of the paper's machine between two mass ratios."""
    ratios = np.geomspace(least, most, 121)
    return ratios, np.asarray(normalized_frequency_squared(ratios))


@st.cache_resource(show_spinner=False)
def norm_identity() -> str:
    """Return, as LaTeX, the discriminant for the target p/q as a norm: the square is completed in q by SymPy."""
    p, q = sp.symbols("p q", positive=True)
    numerator, denominator = sp.fraction(unit_frequency_condition().normalized_frequency_squared)
    a, b, c = sp.Poly(sp.expand(p * denominator - q * numerator), epsilon).all_coeffs()
    leading, middle, _ = sp.Poly(b**2 - 4 * a * c, q).all_coeffs()
    root = sp.sqrt(leading)
    rest = middle / (2 * root)
    y = sp.sqrt(sp.expand((b**2 - 4 * a * c - (root * q + rest) ** 2) / 3))
    x = root * q + rest
    # Write the positive term of each sum first.
    b, x, minus_c = sp.latex(b), sp.latex(x, order="rev-lex"), sp.latex(sp.expand(-c), order="rev-lex")
    a, y = sp.latex(a), sp.latex(y)
    lines = rf"&({b})^2 + 4\cdot {a}\,({minus_c}) \\ &\quad = ({x})^2 + 3\,({y})^2"
    return rf"\begin{{aligned}}{lines}\end{{aligned}}"


@st.cache_resource(show_spinner=False)
def norm_multiplied_out() -> str:
    """Return, as LaTeX, (x + y√−3)(x − y√−3) = x² + 3y², multiplied out by SymPy."""
    x, y, root = sp.symbols(r"x y \sqrt{-3}")
    with sp.evaluate(False):
        plus = sp.latex(x + y * root, order="none")
    return rf"({plus})\,({plus.replace('+', '-')}) = {sp.latex(_times((x, y), (x, -y))[0])}"


@st.cache_resource(show_spinner=False)
def product_of_norms() -> str:
    """Return, as LaTeX, the product of two norms as the norm of the product."""
    a, b, c, d = sp.symbols("a b c d")
    left = ((a, b), (c, d))
    factors = "".join(rf"\left({sp.latex(x**2 + 3 * y**2)}\right)" for x, y in left)
    x, y = (sp.latex(part) for part in _times(*left))
    return rf"{factors} = \left({x}\right)^2 + 3\left({y}\right)^2"


def _times(one: tuple[sp.Expr, sp.Expr], other: tuple[sp.Expr, sp.Expr]) -> tuple[sp.Expr, sp.Expr]:
    """Return x and y of the product of two numbers x + y√−3."""
    root = sp.Symbol("r")
    product = sp.expand((one[0] + one[1] * root) * (other[0] + other[1] * root))
    rest = sp.Poly(sp.rem(product, root**2 + 3, root), root)
    return rest.coeff_monomial(1), rest.coeff_monomial(root)


def factored_cubes(number: int) -> str:
    """Return, as LaTeX, each sum of two cubes of a number as the product (x + y)(x² − xy + y²)."""
    sums = number_theory.sums_of_two_cubes(number)
    return r",\ ".join(rf"{sums_of_cubes([(x, y)])} = {x + y}\cdot{x * x - x * y + y * y}" for x, y in sums)


def as_norm(p: int, q: int) -> str:
    """Return, as LaTeX, the norm x² + 3y² of the target p/q, and its relation to the discriminant."""
    target = Fraction(p, q)
    x, y = number_theory.norm_form(target)
    number = BodyChoice(target=target).discriminant
    # If the coefficients of the quadratic have a common factor, the norm contains its square.
    shared = isqrt((x * x + 3 * y * y) // number)
    right = f"{shared}^2 \\cdot {number}" if shared > 1 else str(number)
    return f"{f'({x})' if x < 0 else x}^2 + 3 \\cdot {y}^2 = {right}"


@dataclass(frozen=True)
class Tally:
    """The number of discriminants that are sums of cubes for two lower rollers, many targets and all top bodies."""

    pair: tuple[str, str]
    machines: int
    sums: int
    taxicabs: int
    median: float


@st.cache_resource(show_spinner=False)
@responsive()
def tally(left: str, right: str) -> Tally:
    """Return the count for all targets p/q, p and q up to COUNTED_PART, that every top body can reach."""
    limit = min(number_theory.normalized_frequency_squared_exact(left, right, top, 0) for top in number_theory.BODIES)
    parts = range(1, COUNTED_PART + 1)
    targets = [Fraction(p, q) for p in parts for q in parts if gcd(p, q) == 1 and Fraction(p, q) < limit]
    numbers = [
        number_theory.discriminant(*number_theory.unit_quadratic(left, right, top, target))
        for top in number_theory.BODIES
        for target in targets
    ]
    ways = [len(number_theory.sums_of_two_cubes(number)) for number in numbers]
    return Tally((left, right), len(numbers), sum(map(bool, ways)), sum(way > 1 for way in ways), median(numbers))


def product_of_primes(factorization: Sequence[tuple[int, int]]) -> str:
    """Return a factorization as LaTeX. A first power has no exponent."""
    powers = (sp.Pow(prime, exponent, evaluate=exponent == 1) for prime, exponent in factorization)
    return sp.latex(sp.Mul(*powers, evaluate=False), mul_symbol="dot", order="none") if factorization else "1"


def sums_of_cubes(cubes: Sequence[tuple[int, int]]) -> str:
    """Return sums of two cubes as LaTeX, joined by equals signs; an empty text for none."""
    with sp.evaluate(False):
        sums = [sp.Add(sp.Pow(x, 3), sp.Pow(y, 3)) for x, y in cubes]
    return " = ".join(sp.latex(total, order="none") for total in sums)
