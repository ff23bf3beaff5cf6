"""The paper's own route, equation by equation; and what every step of every route has to be."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from ramanujan import Oscillator, derivation
from ramanujan.derivation import ROUTES, Route, Step
from ramanujan.derivation.elimination import unit_condition
from ramanujan.derivation.export import to_latex, to_markdown, to_notebook
from ramanujan.derivation.printers import latex
from ramanujan.derivation.rows import row, rows
from ramanujan.derivation.steps import Routes, equation
from ramanujan.derivation.symbols import COORDINATES, Omega_squared, Phi, R, X, epsilon, k, m, m_prime, machine, phi, t
from tests import reference
from tests.latex import Formula, sides
from tests.reference import equal, holds

UNIT_RATIO = (sp.sqrt(1729) - 1) / 36
TWO_MASSES = {m: sp.Integer(2), m_prime: sp.Integer(3), k: sp.Integer(50)}
STEPS = [(name, step.key) for name in ROUTES for step in ROUTES[name].steps]
X_dot, phi_dot, Phi_dot = (q.diff(t) for q in COORDINATES)


def paper_lagrangian() -> sp.Expr:
    """The paper's Lagrangian of section 2, as printed."""
    return (
        (3 * m + 2 * m_prime) / 2 * X_dot**2
        + sp.Rational(3, 4) * m * R**2 * Phi_dot**2
        + (sp.Rational(7, 4) * m_prime + 2 * m) * R**2 * phi_dot**2
        - m * R * X_dot * Phi_dot
        - 2 * (m_prime + m) * R * phi_dot * X_dot
        - 2 * k * R**2 * phi**2
    )


def equal_masses(relation: sp.Eq) -> sp.Eq:
    return sp.Eq(*(side.subs(m_prime, m) for side in relation.args), evaluate=False)


def holds_for_equal_masses(relation: sp.Eq) -> bool:
    """Tell whether an equation in m alone is true along the motion of the machine with m′ = m."""
    motion = {a: value.subs(m_prime, m) for a, value in reference.accelerations().items()}
    frequency = reference.natural_frequency_squared().subs(m_prime, m)
    left, right = (side.subs(Omega_squared, frequency).subs(motion) for side in relation.args)
    return equal(left, right)


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


@pytest.mark.parametrize("name", ROUTES)
def test_keys_find_their_steps(name):
    route = ROUTES[name]
    assert len({step.key for step in route.steps}) == len(route.steps)
    assert all(route[step.key] is step for step in route.steps)
    assert route.name == name


def test_a_route_is_derived_once():
    assert ROUTES["euler_lagrange"] is ROUTES["euler_lagrange"]


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


# The paper's route


def test_velocities_are_those_over_the_ground():
    velocity = {relation.lhs.name: relation.rhs for relation in ROUTES["euler_lagrange"]["velocities"].equations}
    rolled = {"block": 0, "hoop": R * phi_dot, "cylinder": R * phi_dot, "slab": 2 * R * phi_dot, "top": R * Phi_dot}
    assert velocity == {f"v_{name}": sp.expand(path - X_dot) for name, path in rolled.items()}


def test_energies_add_up_to_the_lagrangian():
    *kinetic, potential = ROUTES["euler_lagrange"]["energies"].equations
    total = sum(relation.rhs for relation in kinetic) - potential.rhs
    assert equal(total, reference.lagrangian())
    assert not equal(total - kinetic[1].rhs, reference.lagrangian())


def test_lagrangians_are_the_printed_ones():
    route = ROUTES["euler_lagrange"]
    assert sp.expand(route["lagrangian"].equations[0].rhs - paper_lagrangian()) == 0
    assert sp.expand(route["equal_lagrangian"].equations[0].rhs - paper_lagrangian().subs(m_prime, m)) == 0


@pytest.mark.parametrize("q", COORDINATES)
@pytest.mark.parametrize("prefix", ["", "equal_"])
def test_each_equation_of_motion_belongs_to_its_coordinate(prefix, q):
    relation = ROUTES["euler_lagrange"][f"{prefix}motion"].equations[COORDINATES.index(q)]
    L = reference.lagrangian()
    expected = L.diff(q.diff(t)).diff(t) - L.diff(q)
    if prefix:
        expected = expected.subs(m_prime, m)
    ratio = sp.cancel(relation.lhs / expected)
    assert relation.rhs == 0
    assert ratio.free_symbols <= {m, R}


@pytest.mark.parametrize("key", ["elimination", "frequency"])
def test_elimination_holds_along_the_motion(key):
    definitions = {Omega_squared: reference.natural_frequency_squared()}
    for relation in ROUTES["euler_lagrange"][key].equations:
        assert holds(relation, definitions)
    for relation in ROUTES["euler_lagrange"][f"equal_{key}"].equations:
        assert holds_for_equal_masses(relation)


def test_a_wrong_elimination_would_be_noticed():
    relation = ROUTES["euler_lagrange"]["elimination"].equations[1]
    assert not holds(sp.Eq(relation.lhs, -relation.rhs, evaluate=False))


def test_equal_masses_give_104_over_99():
    route = ROUTES["euler_lagrange"]
    assert route["equal_frequency"].equations[-1].rhs == sp.Rational(104, 99) * k / m
    assert route["equal_close"].equations[0].rhs == sp.Rational(104, 99)
    assert holds_for_equal_masses(route["equal_close"].equations[0])


def test_elimination_of_the_equal_masses_is_the_printed_one():
    Phi_of_X, X_of_phi, _ = ROUTES["euler_lagrange"]["equal_elimination"].equations
    assert X_of_phi.rhs == sp.Rational(12, 13) * R * phi.diff(t, 2)
    assert Phi_of_X.lhs == Phi.diff(t, 2)
    assert Phi_of_X.rhs == 2 * X.diff(t, 2) / (3 * R)


def test_only_the_ratio_matters():
    definition, normalized = ROUTES["euler_lagrange"]["ratio"].equations
    assert definition.args == (epsilon, m_prime / m)
    true_value = reference.natural_frequency_squared() * m / k
    assert equal(normalized.rhs.subs(epsilon, m_prime / m), true_value)


def test_the_condition_is_the_printed_quadratic():
    (relation,) = ROUTES["euler_lagrange"]["unit"].equations
    assert relation.lhs == 18 * epsilon**2 + epsilon - 24
    assert relation.rhs == 0


def test_the_root_gives_exactly_one():
    condition, root, square = ROUTES["euler_lagrange"]["root"].equations
    assert condition == ROUTES["euler_lagrange"]["unit"].equations[0]
    assert sp.simplify(root.rhs - UNIT_RATIO) == 0
    normalized = ROUTES["euler_lagrange"]["ratio"].equations[1].rhs
    assert sp.radsimp(normalized.subs(epsilon, root.rhs)) == 1
    assert square.rhs == 1729
    assert sp.expand(square.lhs - square.rhs - 72 * (18 * epsilon**2 + epsilon - 24)) == 0


def test_unit_condition_follows_another_frequency():
    # A plain mass m + m′/2 on the spring has the unit frequency only without m′, so no positive ratio exists.
    with pytest.raises(ValueError, match="natural_frequency_squared"):
        unit_condition(k / (m + m_prime / 2))


# Numbers put in


fractions = st.fractions(min_value=Fraction(1, 1000), max_value=1000, max_denominator=1000)


@settings(deadline=None, max_examples=40)
@given(fractions, fractions, fractions)
def test_numbers_agree_with_the_floating_point_machine(mass, roller_mass, stiffness):
    values = {s: sp.Rational(v) for s, v in zip((m, m_prime, k), (mass, roller_mass, stiffness), strict=True)}
    frequency = ROUTES["euler_lagrange"].natural_frequency_squared.subs(values)
    machine = Oscillator(float(mass), float(roller_mass), float(stiffness))
    # Three inputs and the result are rounded: a few units of 1.1e-16 each.
    assert float(frequency) == pytest.approx(machine.natural_frequency_squared, rel=2e-15)


@pytest.mark.parametrize("name", ROUTES)
def test_at_the_unit_ratio_alone_the_frequency_is_that_of_the_plain_mass(name):
    for mass, stiffness in ((sp.Rational(2, 3), sp.Rational(9, 4)), (sp.Integer(5), sp.Rational(1, 7))):
        values = {m: mass, m_prime: UNIT_RATIO * mass, k: stiffness}
        frequency = equation(Omega_squared, ROUTES[name].natural_frequency_squared)
        plain = row(equation(Omega_squared, k / m), values).latex
        assert row(frequency, values).latex == plain
        assert row(frequency, values | {m_prime: values[m_prime] * sp.Rational(999, 1000)}).latex != plain
