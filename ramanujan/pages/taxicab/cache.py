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
    """Return, as LaTeX, the equations from Ω² to the mass ratio at which Ω² = k/m for the paper's machine."""
    steps = route("euler_lagrange")
    frequency = steps["ratio"].equations[-1]
    condition = steps["unit"].equations[-1]
    # Omit how the square is completed, and the second sum of cubes, which another section shows.
    *_completion, square, _second_sum, root = steps["root"].equations
    return tuple(map(latex, (frequency, condition, square, root)))


def discriminant_written_out() -> tuple[str, str]:
    """Return, as LaTeX, the paper's discriminant b² − 4ac, and the sum of two cubes with the terms b² and −4ac."""
    a, b, c = PAPER.quadratic
    with sp.evaluate(False):
        expanded = sp.Add(sp.Pow(b, 2), sp.Mul(4, a, -c))
    same_terms = [(x, y) for x, y in PAPER.cubes if x**3 == b**2]
    return sp.latex(expanded, mul_symbol="dot", order="none"), sums_of_cubes(same_terms)


@dataclass(frozen=True)
class Results:
    """The results for bodies and a target. The texts are LaTeX.

    Parameters
    ----------
    machine : the bodies and the target
    quadratic : the equation for the mass ratio
    root, ratio : its positive root, as a formula and as a number
    factors : the prime factors of the discriminant
    cubes : the discriminant as sums of two cubes
    square : the equation with a completed square
    """

    machine: BodyChoice
    quadratic: str
    root: str
    ratio: float
    factors: str
    cubes: str
    square: str


@st.cache_data(show_spinner=False, max_entries=512)
def results(left: str, right: str, top: str, p: int = 1, q: int = 1) -> Results:
    """Return the results for these bodies and the target Ω²m/k = p/q. Raise `ValueError` as `BodyChoice` does."""
    machine = BodyChoice(left, right, top, Fraction(p, q))
    a, b, c = machine.quadratic
    root = (sp.sqrt(machine.discriminant) - b) / (2 * a)
    return Results(
        machine=machine,
        quadratic=latex(equation(a * epsilon**2 + b * epsilon + c, sp.S.Zero)),
        root=format_with_decimal(root, 7),
        ratio=float(number_theory.positive_root_digits(a, b, c, 40)),
        factors=product_of_primes(machine.factorization),
        cubes=sums_of_cubes(machine.cubes),
        square=latex(equation((2 * a * epsilon + b) ** 2, sp.Integer(machine.discriminant))),
    )


@st.cache_resource(show_spinner=False)
def machines() -> tuple[BodyChoice, ...]:
    """Return all 40 machines at the unit frequency, and cache their factors and cubes."""
    return tuple(number_theory.machines())


def practical_machines() -> list[tuple[Fraction, Fraction, float]]:
    """Return machines for a workshop, whose mass ratios are the first convergents of the paper's ratio.

    Each machine is a tuple: its mass ratio, the exact error of its Ω²m/k, and a number of periods of the plain mass.
    After these periods the clock hands are one turn apart.
    """
    machines = []
    for ratio in number_theory.convergents(quotients(5)):
        error = number_theory.normalized_frequency_squared_exact(*PAPER.bodies, ratio) - 1
        # Equal to 1/|√(1 + error) − 1|, without the difference of two numbers close to 1.
        periods = (1 + (1 + error) ** 0.5) / abs(error)
        machines.append((ratio, error, periods))
    return machines


def quotients(terms: int = 12) -> list[int]:
    """Return the first terms of the continued fraction of the paper's mass ratio."""
    return number_theory.continued_fraction(*PAPER.quadratic, terms)


def curve(least: float, most: float) -> tuple[np.ndarray, np.ndarray]:
    """Return mass ratios and Ω²m/k of the paper's machine between two mass ratios."""
    ratios = np.geomspace(least, most, 121)
    return ratios, np.asarray(normalized_frequency_squared(ratios))


@st.cache_resource(show_spinner=False)
def norm_identity() -> str:
    """Return, as LaTeX, the discriminant for the target p/q as a norm x² + 3y². SymPy completes the square in q."""
    p, q = sp.symbols("p q", positive=True)
    numerator, denominator = sp.fraction(unit_frequency_condition().normalized_frequency_squared)
    a, b, c = sp.Poly(sp.expand(p * denominator - q * numerator), epsilon).all_coeffs()
    discriminant = b**2 - 4 * a * c
    leading, middle, _constant = sp.Poly(discriminant, q).all_coeffs()
    x = sp.sqrt(leading) * q + middle / (2 * sp.sqrt(leading))
    y = sp.sqrt(sp.expand((discriminant - x**2) / 3))
    # The order "rev-lex" writes the positive term of these sums first.
    x_latex = sp.latex(x, order="rev-lex")
    minus_c_latex = sp.latex(sp.expand(-c), order="rev-lex")
    expanded = rf"({sp.latex(b)})^2 + 4\cdot {sp.latex(a)}\,({minus_c_latex})"
    norm = rf"({x_latex})^2 + 3\,({sp.latex(y)})^2"
    lines = rf"&{expanded} \\ &\quad = {norm}"
    return rf"\begin{{aligned}}{lines}\end{{aligned}}"


@st.cache_resource(show_spinner=False)
def norm_multiplied_out() -> str:
    """Return, as LaTeX, (x + y√−3)(x − y√−3) = x² + 3y², multiplied out by SymPy."""
    x, y, root = sp.symbols(r"x y \sqrt{-3}")
    with sp.evaluate(False):
        number = sp.latex(x + y * root, order="none")
    conjugate = number.replace("+", "-")
    norm, _zero = _multiply((x, y), (x, -y))
    return rf"({number})\,({conjugate}) = {sp.latex(norm)}"


@st.cache_resource(show_spinner=False)
def product_of_norms() -> str:
    """Return, as LaTeX, the product of two norms as the norm of the product."""
    a, b, c, d = sp.symbols("a b c d")
    numbers = ((a, b), (c, d))
    norms = "".join(rf"\left({sp.latex(x**2 + 3 * y**2)}\right)" for x, y in numbers)
    x, y = map(sp.latex, _multiply(*numbers))
    return rf"{norms} = \left({x}\right)^2 + 3\left({y}\right)^2"


def _multiply(first: tuple[sp.Expr, sp.Expr], second: tuple[sp.Expr, sp.Expr]) -> tuple[sp.Expr, sp.Expr]:
    """Return the product of two numbers x + y√−3. Each number is the tuple (x, y)."""
    root = sp.Symbol("r")
    (a, b), (c, d) = first, second
    product = sp.expand((a + b * root) * (c + d * root))
    # The square of the root is −3.
    reduced = sp.Poly(sp.rem(product, root**2 + 3, root), root)
    return reduced.coeff_monomial(1), reduced.coeff_monomial(root)


def factored_cubes(number: int) -> str:
    """Return, as LaTeX, each sum of two cubes of a number as the product (x + y)(x² − xy + y²)."""
    equations = []
    for x, y in number_theory.sums_of_two_cubes(number):
        equations.append(rf"{sums_of_cubes([(x, y)])} = {x + y}\cdot{x * x - x * y + y * y}")
    return r",\ ".join(equations)


def as_norm(p: int, q: int) -> str:
    """Return, as LaTeX, the norm x² + 3y² of the target p/q, and its relation to the discriminant."""
    target = Fraction(p, q)
    x, y = number_theory.norm_coordinates(target)
    discriminant = BodyChoice(target=target).discriminant
    # If the coefficients of the quadratic have a common factor, the norm contains its square.
    common_factor = isqrt((x * x + 3 * y * y) // discriminant)
    right = f"{common_factor}^2 \\cdot {discriminant}" if common_factor > 1 else str(discriminant)
    base = f"({x})" if x < 0 else str(x)
    return f"{base}^2 + 3 \\cdot {y}^2 = {right}"


@dataclass(frozen=True)
class Tally:
    """A count of discriminants that are sums of two cubes, for one pair of lower rollers.

    Parameters
    ----------
    pair : the lower rollers
    machines : number of discriminants, one for each target and body on top
    sums : how many of them are a sum of two positive cubes
    taxicabs : how many are such a sum in two ways or more
    median : median of the discriminants
    """

    pair: tuple[str, str]
    machines: int
    sums: int
    taxicabs: int
    median: float


@st.cache_resource(show_spinner=False)
@responsive()
def tally(left: str, right: str) -> Tally:
    """Count the sums of two cubes among the discriminants of a pair of lower rollers, with every body on top.

    The targets are all p/q with p and q up to COUNTED_PART that the machine reaches with each of these bodies.
    """
    limit = min(number_theory.normalized_frequency_squared_exact(left, right, top, 0) for top in number_theory.BODIES)
    parts = range(1, COUNTED_PART + 1)
    targets = [Fraction(p, q) for p in parts for q in parts if gcd(p, q) == 1 and Fraction(p, q) < limit]
    discriminants = []
    for top in number_theory.BODIES:
        for target in targets:
            quadratic = number_theory.unit_quadratic(left, right, top, target)
            discriminants.append(number_theory.discriminant(*quadratic))
    ways = [len(number_theory.sums_of_two_cubes(number)) for number in discriminants]
    return Tally(
        pair=(left, right),
        machines=len(discriminants),
        sums=sum(count > 0 for count in ways),
        taxicabs=sum(count > 1 for count in ways),
        median=median(discriminants),
    )


def product_of_primes(factorization: Sequence[tuple[int, int]]) -> str:
    """Return a factorization as LaTeX. A first power has no exponent."""
    powers = (sp.Pow(prime, exponent, evaluate=exponent == 1) for prime, exponent in factorization)
    return sp.latex(sp.Mul(*powers, evaluate=False), mul_symbol="dot", order="none") if factorization else "1"


def sums_of_cubes(cubes: Sequence[tuple[int, int]]) -> str:
    """Return sums of two cubes as LaTeX, joined by equals signs; an empty text for none."""
    with sp.evaluate(False):
        sums = [sp.Add(sp.Pow(x, 3), sp.Pow(y, 3)) for x, y in cubes]
    return " = ".join(sp.latex(total, order="none") for total in sums)
