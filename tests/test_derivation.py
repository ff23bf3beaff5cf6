"""What every step of every route has to be, and what is said about one machine."""

import re
from pathlib import Path

import pytest
import sympy as sp

from ramanujan import derivation
from ramanujan.derivation import ROUTES, Route, Step
from ramanujan.derivation.export import to_latex, to_markdown, to_notebook
from ramanujan.derivation.printers import latex
from ramanujan.derivation.rows import row, rows
from ramanujan.derivation.steps import Routes, equation
from ramanujan.derivation.symbols import Omega_squared, k, m, m_prime, machine
from ramanujan.derivation.templates import template
from tests.latex import Formula, sides

UNIT_RATIO = (sp.sqrt(1729) - 1) / 36
TWO_MASSES = {m: sp.Integer(2), m_prime: sp.Integer(3), k: sp.Integer(50)}
STEPS = [(name, step.key) for name in ROUTES for step in ROUTES[name].steps]


# What a step is


@pytest.mark.parametrize(("name", "key"), STEPS)
def test_a_step_states_sympy_equations_only(name, key):
    for relation in ROUTES[name][key].equations:
        assert isinstance(relation, sp.Eq)
        assert not relation.atoms(sp.Float)


@pytest.mark.parametrize(("name", "key"), STEPS)
def test_heading_and_reason_are_there_and_hold_no_result(name, key):
    step = ROUTES[name][key]
    assert step.heading[0].isupper()
    assert step.heading[-1] not in ".:"
    assert step.reason.endswith((".", "?"))
    assert step.reason.count("$") % 2 == 0
    # One digit belongs to a formula such as 2Rφ or to "close to 1"; results have more, or a point, or a root.
    assert not re.search(r"\d\d|\d\.\d|\\frac\{\d|\\sqrt", step.heading + step.reason)


def test_what_is_not_there_is_refused_by_name():
    with pytest.raises(KeyError, match="guess"):
        ROUTES["guess"]
    with pytest.raises(ValueError, match=r"key must be one of rolling, forces, .*not 'nope'"):
        ROUTES["newton"]["nope"]
    with pytest.raises(ValueError, match="name must be one of block, hoop, cylinder, slab, top, not 'wheel'"):
        machine()["wheel"]


def test_routes_and_steps_show_themselves_in_a_notebook():
    route = ROUTES["energy"]
    shown = route._repr_markdown_()
    for step in route.steps:
        assert step._repr_markdown_() in shown
        assert step.heading in shown
        assert all(f"$${latex(relation)}$$" in shown for relation in step.equations)


def test_a_new_route_needs_one_file_and_one_line():
    """What its file holds is enough for the registry, the exports with and without numbers, and the notebook."""
    routes = Routes()

    @routes.add("trivial")
    def build() -> Route:
        step = Step("only", "Ask the others", "Another route knows.", (equation(Omega_squared, k / m),))
        return Route("trivial", "Trivial", (step,), k / m, {"only": "Omega_squared = k / m"})

    route = routes["trivial"]
    assert routes["trivial"] is route
    assert list(routes) == ["trivial"]
    values = {m: sp.Integer(2), m_prime: sp.Integer(1), k: sp.Integer(3)}
    assert r"\Omega^{2} = \frac{3}{2} = 1.5\,\mathrm{s^{-2}}" in to_markdown(route, values)
    assert r"\Omega^{2} &= \frac{k}{m}" in to_latex(route)
    assert "Omega_squared = k / m" in to_notebook(route)
    # In the package, a file that adds a route is named on one line of `ramanujan.derivation`.
    package = Path(derivation.__file__)
    files = {path.stem for path in package.parent.glob("*.py") if "@ROUTES.add" in path.read_text(encoding="utf-8")}
    (line,) = (line for line in package.read_text(encoding="utf-8").splitlines() if "import euler_lagrange" in line)
    named = line.partition("import ")[2].partition("#")[0]
    assert files == {name.strip() for name in named.split(",")}
    assert len(files) == len(ROUTES)


def test_every_reason_about_equal_masses_says_so():
    for name, key in STEPS:
        step = ROUTES[name][key]
        assert (step.case is not None) == key.startswith("equal_")
        if step.case is not None:
            assert "masses are all equal" in step.reason
            assert "stays in symbols" in step.about(TWO_MASSES).reason
            same = TWO_MASSES | {m_prime: TWO_MASSES[m]}
            assert "stays in symbols" not in step.about(same).reason
            for each in rows(step, same):
                assert {"m", "m'", "k"}.isdisjoint(Formula(sides(each.latex)[1]).names)


def test_with_equal_masses_nothing_is_told_twice():
    same = TWO_MASSES | {m_prime: TWO_MASSES[m]}
    route = ROUTES["euler_lagrange"]
    headings = [step.heading for step in route.steps]
    assert len(set(headings)) == len(headings)
    in_numbers = [tuple(each.latex for each in rows(step, same)) for step in route.steps]
    assert len(set(in_numbers)) == len(in_numbers)
    for step in route.steps:
        if step.told is not None:
            assert "said this already" in step.about(same).reason
            assert "said this already" not in step.about(TWO_MASSES).reason
            assert rows(step, same) == rows(step)


@pytest.mark.parametrize(
    ("roller_mass", "word"), [(sp.Integer(2), "faster"), (UNIT_RATIO * 2, "in step"), (sp.Integer(3), "more slowly")]
)
def test_the_condition_says_on_which_side_a_machine_is(roller_mass, word):
    values = TWO_MASSES | {m_prime: roller_mass}
    step = ROUTES["euler_lagrange"]["unit"]
    assert word in step.about(values).reason
    signs = {number.evaluated(values)[0].numerator.compare(0) for number in map(template, residuals(step, values))}
    assert signs == {{"faster": -1, "in step": 0, "more slowly": 1}[word]}


def residuals(step: Step, values: dict) -> list[sp.Expr]:
    return [relation.rhs for relation in step.about(values).equations]


@pytest.mark.parametrize("name", ROUTES)
def test_at_the_unit_ratio_alone_the_frequency_is_that_of_the_plain_mass(name):
    for mass, stiffness in ((sp.Rational(2, 3), sp.Rational(9, 4)), (sp.Integer(5), sp.Rational(1, 7))):
        values = {m: mass, m_prime: UNIT_RATIO * mass, k: stiffness}
        frequency = equation(Omega_squared, ROUTES[name].natural_frequency_squared)
        plain = row(equation(Omega_squared, k / m), values).latex
        assert row(frequency, values).latex == plain
        assert row(frequency, values | {m_prime: values[m_prime] * sp.Rational(999, 1000)}).latex != plain
