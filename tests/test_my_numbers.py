"""“My numbers” tell the truth: each side of each equation that a page or a file shows is read back from its LaTeX.

`tests.latex` reads it, and mpmath works out the derivation's equation itself with 60 digits; neither knows how numbers
are put into formulas. That the equations are true, step by step, is for test_line_by_line.
"""

import os
import random
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy as sp
from sympy.core.function import AppliedUndef

from ramanujan import UNIT_MASS_RATIO
from ramanujan.derivation import ROUTES, Step
from ramanujan.derivation.export import to_markdown
from ramanujan.derivation.nomenclature import nomenclature
from ramanujan.derivation.numbers import exact_values, stands_for_the_root
from ramanujan.derivation.printers import latex
from ramanujan.derivation.rows import row, rows
from ramanujan.derivation.symbols import (
    Omega_squared,
    epsilon,
    epsilon_star,
    k,
    m,
    m_prime,
    normalized_frequency_squared,
    t,
)
from ramanujan.pages.derivation import cache as page
from ramanujan.pages.oscillator import cache as first_page
from tests.latex import Formula, equations, formula, sides
from tests.reference import fraction

COUNT = int(os.environ.get("RAMANUJAN_MACHINES", "24"))
"""How many machines go through all equations; 200 take half a minute."""

WRITTEN = {normalized_frequency_squared: Omega_squared * m / k}
"""A symbol that stands for a quotient, as it is written."""


@cache
def machines(count: int) -> list[tuple[float, float, float]]:
    """Return machines on the sliders' steps, machines off them, extreme ones, and ε* for several m."""
    source = random.Random(1729)
    on_steps = [
        (source.randint(10, 100) / 20, source.randint(1, 1000) / 100, source.randint(2, 400) / 2) for _ in range(count)
    ]
    off_steps = [tuple(10 ** source.uniform(-3, 3) for _ in range(3)) for _ in range(count // 4)]
    equal = [(mass, mass, 7.0) for mass in (0.5, 1.0, 1.2345678)]
    at_root = [
        (mass, UNIT_MASS_RATIO * mass, stiffness) for mass, stiffness in ((1.0, 10.0), (3.7, 1.0), (1.2345678, 3.3))
    ]
    near_root = [(1.0, 1.127256827016210, 1.0), (1.0, 1.13, 1.0), (2.0, 2.254513654, 9.0)]
    return [*at_root, *equal, *near_root, (1.0, 5 / 6, 1.0), *off_steps, *on_steps][:count]


def digits(number: sp.Expr) -> mpmath.mpf:
    return mpmath.mpf(str(sp.N(number, 60)))


@cache
def meaning(side: sp.Basic) -> tuple[list[sp.Basic], Callable]:
    """All that is unknown in one side of an equation, and the side as a function of it."""
    unknown = [*side.atoms(sp.Derivative), *side.atoms(AppliedUndef), *side.free_symbols - {t}]
    worked_out = side.as_explicit() if isinstance(side, sp.MatrixExpr) else side
    return unknown, sp.lambdify(unknown, worked_out.doit(), "mpmath")


def says(line: str, equation: sp.Eq, values: dict[sp.Symbol, mpmath.mpf]) -> bool:
    """Tell whether each side of a row is that side of the equation, whatever is unknown, and its decimal is right."""
    left, right, decimal, is_exact = sides(line)
    close, exact = mpmath.mpf("1e-6" if r"\ldots" in line else "1e-40"), None
    for text, side in ((left, equation.lhs), (right, equation.rhs.xreplace(WRITTEN))):
        if isinstance(side, sp.MatrixSymbol | sp.Inverse):
            if text != latex(side):
                return False
            continue
        unknown, function = meaning(side.xreplace(WRITTEN))
        known = {each: digits(fraction(each)) for each in unknown} | values
        found = function(*(known[each] for each in unknown))
        exact = np.array(found.tolist() if isinstance(found, mpmath.matrix) else found, dtype=object)
        read = formula(text).value({latex(each): number for each, number in known.items()})
        if not np.all(np.abs(read - exact) <= close * np.abs(exact) + mpmath.mpf("1e-45")):
            return False
    tolerance = mpmath.mpf("1e-40" if is_exact else "1e-7")
    return not decimal or bool(abs(formula(decimal).value({}) - exact) <= abs(exact) * tolerance)


def shown(masses: tuple[float, float, float] | None) -> Iterator[tuple[str, Step, list[tuple]]]:
    """Yield route, step and, for each equation of the step, the row that shows it, itself, and what is put into it."""
    values = exact_values(*masses) if masses else None
    for name, route in ROUTES.items():
        for step in route.steps:
            found: list[tuple] = []

            def note(equation: sp.Eq, numbers: dict | None, label: str, found: list = found) -> None:
                in_digits = {symbol: digits(each) for symbol, each in (numbers or {}).items()}
                found.append((row(equation, numbers, label=label).latex, equation, in_digits))

            rows(step, values, note)
            yield name, step, found


# What is shown holds


def test_in_symbols_and_with_numbers_every_row_says_its_equation():
    for masses in (None, *machines(COUNT)):
        for name, step, found in shown(masses):
            for line, equation, values in found:
                assert says(line, equation, values), (masses, name, step.key, line)


def test_what_is_said_of_a_machine_alone_is_true():
    """The conditions on ε, which the machine that is shown does not meet, become statements about its own ratio."""
    for masses in machines(COUNT):
        values = exact_values(*masses)
        squared = ROUTES["newton"].natural_frequency_squared.subs(values)
        meant = {Omega_squared: squared, epsilon: values[m_prime] / values[m], epsilon_star: (sp.sqrt(1729) - 1) / 36}
        for key in ("ratio", "unit", "root"):
            for equation in ROUTES["euler_lagrange"][key].about(values).equations:
                left, right = (side.xreplace(WRITTEN).subs(meant | values) for side in equation.args)
                assert abs(sp.N(left - right, 60, chop=True)) < mpmath.mpf("1e-40"), (masses, equation)


def test_the_numbers_of_another_machine_are_noticed_in_every_step_that_has_any():
    """The negative control."""
    masses, other = (1.85, 0.86, 33.5), exact_values(1.85, 0.87, 33.6)
    spoiled = {symbol: digits(each) for symbol, each in other.items()}
    silent = {
        (name, step.key)
        for name, step, found in shown(masses)
        if all(values and says(line, equation, spoiled) for line, equation, values in found)
    }
    # Geometry and rolling contain no mass, and K has the same zero modes whatever k is.
    assert silent == {
        ("euler_lagrange", "velocities"),
        ("newton", "rolling"),
        ("newton", "accelerations"),
        ("matrix", "zero_modes"),
    }


@pytest.mark.parametrize("masses", machines(12))
def test_no_number_is_equated_to_another(masses):
    for name, step, found in shown(masses):
        for line, *_ in found:
            left, right, *_ = sides(line)
            # A determinant of numbers is worked out on the right, which is true or `says` would have said so.
            assert has_symbol(left) or has_symbol(right) or left.startswith(r"\left|"), (name, step.key, line)
    # Negative control: what was wrong once.
    assert not has_symbol(r"\frac{\sqrt{1729} - 1}{36}")
    assert not has_symbol("-5")
    assert has_symbol(r"\varepsilon")


def has_symbol(side: str) -> bool:
    words = ("frac", "sqrt", "left", "right", "begin", "end", "matrix", "ldots", "cdot")
    return bool(re.search(r"[A-Za-z]", re.sub("|".join(words), "", side)))


@pytest.mark.parametrize("masses", machines(9))
def test_the_pages_and_the_files_say_the_same(masses):
    """One truth: the rows, what page 2 shows, what page 1 and the files show with numbers."""
    for name, route in ROUTES.items():
        text = to_markdown(route, exact_values(*masses))
        displays = [page.step.__wrapped__(name, n, masses, None, None).equations for n in range(len(route.steps))]
        of_rows = [row.latex for step in route.steps for row in rows(step, exact_values(*masses))]
        # Many short equations stand in two columns on the page, so the order may differ.
        of_page = [line for display in displays for line in equations(display)]
        assert sorted(re.findall(r"\$\$\n(.*?)\n\$\$", text)) == sorted(of_page) == sorted(of_rows)
    six = [step.equations for step in first_page.summary.__wrapped__(masses)]
    for key, display in zip(first_page._SUMMARY, six, strict=True):
        # What page 2 has told for equal masses is told on page 1 for any.
        lines = [row.latex for row in rows(replace(ROUTES["euler_lagrange"][key], told=None), exact_values(*masses))]
        assert equations(display)[-len(lines) :] == lines


def test_other_roots_are_refused():
    for values in ((1, sp.sqrt(2) + sp.sqrt(3), 1), (1, sp.cbrt(2), 1), (sp.sqrt(2), 1, 1)):
        with pytest.raises(ValueError, match="values"):
            rows(ROUTES["matrix"]["spectrum"], dict(zip((m, m_prime, k), map(sp.sympify, values), strict=True)))


@pytest.mark.parametrize(("number", "entered"), [(0.86, "43/50"), (5 / 6, "5/6"), (1.2345678, "12345678/10000000")])
def test_a_number_is_the_one_that_a_person_has_entered(number, entered):
    assert set(exact_values(number, number, number).values()) == {sp.Rational(entered)}


# ε*


def test_the_float_nearest_to_the_root_is_read_as_the_root_and_its_neighbours_are_not():
    for mass in (0.5, 1.0, 3.7, 1.2345678):
        roller = UNIT_MASS_RATIO * mass
        assert stands_for_the_root(mass, roller)
        assert exact_values(mass, roller, 1.0)[m_prime].has(sp.sqrt(1729))
        for other in (roller * (1 + 1e-15), roller * (1 - 1e-15)):
            assert not stands_for_the_root(mass, other)
            assert exact_values(mass, other, 1.0)[m_prime].is_Rational


def test_in_step_is_claimed_only_of_the_root():
    step = ROUTES["euler_lagrange"]["root"]

    def lines(mass: float, roller: float) -> list[str]:
        return [row.latex for row in rows(step, exact_values(mass, roller, 10.0))]

    assert r"\frac{\Omega^{2}\,m}{k} = 1" in lines(1.0, UNIT_MASS_RATIO)
    assert r"\varepsilon - \varepsilon_{*} = 0" in lines(1.0, UNIT_MASS_RATIO)
    just_above = lines(1.0, 1.127256827016211)
    assert r"\frac{\Omega^{2}\,m}{k} = 0.99999999\ldots" in just_above
    assert any(line.startswith(r"\varepsilon - \varepsilon_{*} = 3.") and "10^{-16}" in line for line in just_above)
    assert lines(1.0, 1.0)[1:] == [
        r"\frac{\Omega^{2}\,m}{k} = \frac{104}{99} \approx 1.0505051",
        r"\varepsilon - \varepsilon_{*} = - \frac{\sqrt{1729} - 37}{36} \approx -0.12725683",
    ]


# Symbols


@pytest.mark.parametrize("name", ROUTES)
def test_every_symbol_of_a_route_is_in_its_list(name):
    listed = "\n".join(nomenclature(ROUTES[name]))
    for masses in (None, (1.85, 0.86, 33.5)):
        for step in ROUTES[name].steps:
            for shown_row in rows(step, exact_values(*masses) if masses else None):
                for side in sides(shown_row.latex)[:2]:
                    for symbol in Formula(side).names:
                        # Of a momentum, a mass matrix or a body’s quantity, the list has the letter.
                        plain = re.sub(r"\\d?dot\{(\\?\w+)\}", r"\1", symbol.removesuffix("^{-1}"))
                        plain = re.sub(r"\\text\{(block|hoop|cylinder|slab|top)\}", r"\\text{body}", plain)
                        plain = re.sub(r"\\omega_\{\d\}", r"\\omega", plain)
                        assert plain in listed.splitlines(), (step.key, symbol)
