"""The caches of page 4: the unit condition as formulas, the 40 machines, and the results for other bodies.

The results come from `number_theory` (exact integers) and from the derivation. This module writes them as LaTeX.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache

import numpy as np
import streamlit as st
import sympy as sp

from ramanujan import normalized_frequency_squared, number_theory
from ramanujan.derivation.model import epsilon, equation
from ramanujan.derivation.numbers import format_with_decimal
from ramanujan.derivation.order import in_order
from ramanujan.derivation.printers import latex
from ramanujan.derivation.steps import margin_text
from ramanujan.number_theory import BodyChoice
from ramanujan.shell.shared_cache import route
from ramanujan.text.translation import _

LARGEST_PART = 1000
"""The largest p and q. Every discriminant in this range can be factored."""

SMALL_PART = 20
"""The largest p and q of the targets that are searched for sums of two cubes."""

PAPER = BodyChoice()
"""The paper's machine."""

UPPER_LIMIT = number_theory.normalized_frequency_squared_exact(*PAPER.bodies, 0)
"""Ω²m/k of the paper's machine for very light rollers. Its targets are below this."""


@cache
def unit_equations(ink: str, paper: str) -> str:
    """Return, as LaTeX, the way from Ω² = k/m of the paper's machine to the completed square of a quadratic equation,
    with the operations between the equations. The value of the discriminant has the colour `paper` on `ink`.
    """
    ratio, unit, root = (route("euler_lagrange")[key] for key in ("ratio", "unit", "root"))
    in_step, quadratic = ratio.equations[-1], unit.equations[-1]
    *_completion, square, _second_sum, _root = root.equations
    a, b, c = PAPER.quadratic
    with sp.evaluate(False):
        discriminant = sp.Add(sp.Pow(b, 2), sp.Mul(4, a, -c))
    written_out = f"{latex(square.lhs)} = {sp.latex(discriminant, mul_symbol='dot', order='none')}"
    value = rf"\colorbox{{{ink}}}{{\textcolor{{{paper}}}{{\textbf{{{square.rhs}}}}}}}"
    return aligned(
        f"{latex(in_step)} = 1",
        _operation(rf"\times({latex(sp.fraction(in_step.rhs)[1])})", unit.operations[-1]),
        latex(quadratic),
        _operation(rf"{root.operations[1]}=4\cdot{a}", margin_text(_("complete the square"))),
        written_out,
        f"= {b**2} + {-4 * a * c} = {value}",
    )


def _operation(*parts: str) -> str:
    """Return an operation between two equations. It begins left of their equals signs, to fit into a narrow column.

    It has no width: with a negative space instead, WebKit computes a wrong width of the formula.
    """
    operation = r"\small\downarrow\;" + r",\;".join(parts)
    return rf"\mathllap{{\mathrlap{{{operation}}}\kern6em}}&"


def aligned(*equations: str) -> str:
    """Return LaTeX equations below each other, aligned at their equals signs. An operation has its own place."""
    lines = r" \\[.6em] ".join(line if "&" in line else line.replace("=", "&=", 1) for line in equations)
    return rf"\begin{{aligned}}{lines}\end{{aligned}}"


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
    square_root = sp.sqrt(machine.discriminant)
    root = (square_root - b) / (2 * a)
    root_text = format_with_decimal(root, 7)
    if not square_root.is_Pow:
        # A square factor has left the root. It goes back, so that the discriminant is seen.
        reduced, approximately, decimal = root_text.partition(r" \approx ")
        unreduced = sp.Symbol(rf"\sqrt{{{machine.discriminant}}}")
        value = approximately + decimal if decimal else f" = {reduced}"
        root_text = rf"\frac{{{latex(unreduced - b)}}}{{{2 * a}}}{value}"
    return Results(
        machine=machine,
        quadratic=latex(equation(a * epsilon**2 + b * epsilon + c, sp.S.Zero)),
        root=root_text,
        ratio=float(root.evalf(40)),
        factors=product_of_primes(machine.factorization),
        cubes=sums_of_cubes(machine.cubes),
        square=latex(equation(in_order(2 * a * epsilon, sp.Integer(b)) ** 2, sp.Integer(machine.discriminant))),
    )


@cache
def machines() -> tuple[BodyChoice, ...]:
    """Return all 40 machines at the unit frequency, and cache their factors and cubes."""
    return tuple(number_theory.machines())


@cache
def small_targets() -> tuple[BodyChoice, ...]:
    """Return the paper's machine with each target p/q that it reaches, p and q up to `SMALL_PART`, in order."""
    parts = range(1, SMALL_PART + 1)
    targets = {Fraction(p, q) for p in parts for q in parts}
    return tuple(replace(PAPER, target=target) for target in sorted(targets) if target < UPPER_LIMIT)


def curve(most: float) -> tuple[np.ndarray, np.ndarray]:
    """Return mass ratios and Ω²m/k of the paper's machine from nearly 0 to a mass ratio."""
    ratios = np.geomspace(most / 1000, most, 121)
    return ratios, np.asarray(normalized_frequency_squared(ratios))


def product_of_primes(factorization: Sequence[tuple[int, int]]) -> str:
    """Return a factorization as LaTeX. A first power has no exponent."""
    powers = (sp.Pow(prime, exponent, evaluate=exponent == 1) for prime, exponent in factorization)
    return sp.latex(sp.Mul(*powers, evaluate=False), mul_symbol="dot", order="none") if factorization else "1"


def sums_of_cubes(cubes: Sequence[tuple[int, int]]) -> str:
    """Return sums of two cubes as LaTeX, joined by equals signs; an empty text for none."""
    with sp.evaluate(False):
        sums = [sp.Add(sp.Pow(x, 3), sp.Pow(y, 3)) for x, y in cubes]
    return " = ".join(sp.latex(total, order="none") for total in sums)
