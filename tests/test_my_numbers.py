"""“My numbers” tell the truth: each equation that a page or a file shows is read back and holds along the exact motion.

The LaTeX is read and evaluated by `tests.latex`, the motion comes from `tests.motion_by_hand`; neither knows how the
derivation puts numbers into its formulas.
"""

import os
import random
import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cache, lru_cache

import mpmath
import pytest
import sympy as sp

from ramanujan import UNIT_MASS_RATIO
from ramanujan.derivation import ROUTES, Step
from ramanujan.derivation.export import to_markdown
from ramanujan.derivation.nomenclature import nomenclature
from ramanujan.derivation.numbers import exact_values, stands_for_the_root
from ramanujan.derivation.rows import rows
from ramanujan.derivation.symbols import k, m, m_prime
from ramanujan.pages.derivation import cache as page
from ramanujan.pages.oscillator import cache as first_page
from tests.latex import Formula, equations, holds, sides
from tests.motion_by_hand import quantities

START = {
    name: mpmath.mpf(n) / 7
    for name, n in zip(("X", "phi", "Phi", "X_dot", "phi_dot", "Phi_dot"), (3, -5, 2, 11, 4, -9), strict=True)
}
"""A moment of a motion in which every mode takes part."""

COUNT = int(os.environ.get("RAMANUJAN_MACHINES", "24"))
"""How many machines go through all equations; 200 take half a minute."""

UNIT_RATIO = (mpmath.sqrt(1729) - 1) / 36


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


@lru_cache(maxsize=8)
def along_the_motion(mass: str, roller: str, stiffness: str, in_mode: bool) -> dict[str, object]:
    """Return what each symbol is for a machine along its exact motion; a roller mass ε* stands for ε*m itself."""
    m, k = mpmath.mpf(mass), mpmath.mpf(stiffness)
    m_prime = UNIT_RATIO * m if roller == "ε*" else mpmath.mpf(roller)
    machine = {"m": m, "m_prime": m_prime, "k": k, "R": mpmath.mpf(3) / 8}
    return quantities(machine, START, UNIT_RATIO, in_mode=in_mode)


def entered(value: float) -> str:
    """Return what a person has entered who sees this number: a decimal, or 5/6 where it is the float of that."""
    sixths = Fraction(value).limit_denominator(6)
    return str(sixths) if float(sixths) == value else repr(value)


def meanings(masses: tuple[float, float, float], step: Step, name: str) -> dict[str, object]:
    """Return what each symbol means in a step, for the present machine or, if the step is about that, for m′ = m.

    The energy route is about the oscillating mode alone, the others about any motion.
    """
    mass, roller, stiffness = map(entered, masses)
    if step.case is not None:
        roller = mass
    elif stands_for_the_root(*masses[:2]):
        roller = "ε*"
    return along_the_motion(mass, roller, stiffness, name == "energy")


def shown(masses: tuple[float, float, float] | None) -> Iterator[tuple[str, Step, list[str]]]:
    """Yield route, step and equations as the page shows them with numbers; its cache is left out."""
    for name, route in ROUTES.items():
        for number, step in enumerate(route.steps):
            yield name, step, equations(page.step.__wrapped__(name, number, masses, None, None).equations)


# What is shown holds


def test_in_symbols_every_equation_holds_along_the_exact_motion_of_the_machine_in_step():
    """At ε* alone the conditions hold too; what is about equal masses is tried with equal masses."""
    for name, step, lines in shown(None):
        values = meanings((1.85, 1.85 * UNIT_MASS_RATIO, 33.5), step, name)
        for line in lines:
            assert holds(line, values), (name, step.key, line)


def test_every_equation_of_every_route_holds_along_the_exact_motion():
    for masses in machines(COUNT):
        for name, step, lines in shown(masses):
            values = meanings(masses, step, name)
            for line in lines:
                assert holds(line, values), (masses, name, step.key, line)


def test_a_spoiled_machine_is_noticed_in_every_step_with_numbers():
    """The negative control: equations of one machine, the motion of another."""
    masses = (1.85, 0.86, 33.5)
    spoiled = along_the_motion("1.85", "0.87", "33.6", False), along_the_motion("1.85", "0.87", "33.6", True)
    silent = {
        (name, step.key)
        for name, step, lines in shown(masses)
        if all(holds(line, spoiled[name == "energy"]) for line in lines)
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
    for name, step, lines in shown(masses):
        for line in lines:
            left, right, *_ = sides(line)
            # A determinant of numbers is worked out on the right, which is true or `holds` would have said so.
            assert has_symbol(left) or has_symbol(right) or left.startswith(r"\left|"), (name, step.key, line)


def has_symbol(side: str) -> bool:
    words = ("frac", "sqrt", "left", "right", "begin", "end", "matrix", "ldots", "cdot")
    return bool(re.search(r"[A-Za-z]", re.sub("|".join(words), "", side)))


def test_the_check_for_symbols_sees_what_was_wrong():
    assert not has_symbol(r"\frac{\sqrt{1729} - 1}{36}")
    assert not has_symbol("-5")
    assert has_symbol(r"\varepsilon")
    equal = along_the_motion("1.0", "1.0", "1.0", False)
    for wrong in (r"1 = \frac{\sqrt{1729} - 1}{36}", "-5 = 0", "1369 = 1729", r"\varepsilon = 1.13", r"m = 1.1\ldots"):
        assert not holds(wrong, equal)


@pytest.mark.parametrize("masses", machines(9))
def test_the_first_page_and_the_files_say_the_same(masses):
    """One truth: what page 1 and the files show with numbers is what page 2 shows."""
    on_page = {}
    for name, step, lines in shown(masses):
        on_page.setdefault(name, []).append((step.key, lines))
    for name, route in ROUTES.items():
        text = to_markdown(route, exact_values(*masses))
        # Many short equations stand in two columns on the page, so the order may differ.
        of_page = [line for _, lines in on_page[name] for line in lines]
        assert sorted(re.findall(r"\$\$\n(.*?)\n\$\$", text)) == sorted(of_page)
    six = [step.equations for step in first_page.summary.__wrapped__(masses)]
    for key, display in zip(first_page._SUMMARY, six, strict=True):
        # What page 2 has told for equal masses is told on page 1 for any.
        lines = [row.latex for row in rows(replace(ROUTES["euler_lagrange"][key], told=None), exact_values(*masses))]
        assert equations(display)[-len(lines) :] == lines


def test_other_roots_are_refused():
    for values in ((1, sp.sqrt(2) + sp.sqrt(3), 1), (1, sp.cbrt(2), 1), (sp.sqrt(2), 1, 1)):
        with pytest.raises(ValueError, match="values"):
            rows(ROUTES["matrix"]["spectrum"], dict(zip((m, m_prime, k), map(sp.sympify, values), strict=True)))


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
            for row in rows(step, exact_values(*masses) if masses else None):
                for side in sides(row.latex)[:2]:
                    for symbol in Formula(side).names:
                        # Of a momentum, a mass matrix or a body’s quantity, the list has the letter.
                        plain = re.sub(r"\\d?dot\{(\\?\w+)\}", r"\1", symbol.removesuffix("^{-1}"))
                        plain = re.sub(r"\\text\{(block|hoop|cylinder|slab|top)\}", r"\\text{body}", plain)
                        plain = re.sub(r"\\omega_\{\d\}", r"\\omega", plain)
                        assert plain in listed.splitlines(), (step.key, symbol)
