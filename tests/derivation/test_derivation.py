"""Requirements on every step of every route, and on the numbers for a machine."""

import re
from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp

from ramanujan import UNIT_MASS_RATIO, derivation
from ramanujan.derivation import ROUTES, Route, Step
from ramanujan.derivation.export import to_latex, to_notebook
from ramanujan.derivation.model import Machine, Omega_squared, equation, k, m, m_prime
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.printers import latex
from ramanujan.pages.derivation import cache

TWO_MASSES = Numbers(2.0, 3.0, 50.0)


# Requirements on a step


@pytest.mark.parametrize("name", ROUTES)
def test_a_step_consists_of_exact_equations_and_texts_without_results(name):
    for step in ROUTES[name].steps:
        for relation in step.equations:
            assert isinstance(relation, sp.Eq), step.key
            assert not relation.atoms(sp.Float), step.key
        assert re.fullmatch(r"[A-Z].*[^.:]", step.heading), step.key
        assert step.reason.endswith((".", "?"))
        assert step.reason.count("$") % 2 == 0
        # A single digit belongs to a formula such as 2Rφ or to "close to 1". Results have more, a point or a root.
        assert not re.search(r"\d\d|\d\.\d|\\frac\{\d|\\sqrt", step.heading + step.reason), step.key


def test_routes_and_steps_are_displayed_in_a_notebook():
    route = ROUTES["energy"]
    shown = route._repr_markdown_()
    for step in route.steps:
        assert step._repr_markdown_() in shown
        assert step.heading in shown
        assert all(f"$${latex(relation)}$$" in shown for relation in step.equations)


def test_a_new_route_needs_one_file_and_one_line(monkeypatch):
    """Its file suffices for the page, the notebook, and the exports with and without numbers."""

    def build(_bodies: Machine) -> Route:
        step = Step("only", "Ask the others", "Another route knows.", (equation(Omega_squared, k / m),))
        return Route(
            name="trivial",
            title="Trivial",
            idea="no physics",
            steps=(step,),
            natural_frequency_squared=k / m,
            cells={"only": "Omega_squared = k / m"},
        )

    monkeypatch.setitem(ROUTES.data, "trivial", build)
    route, numbers = ROUTES["trivial"], Numbers(2.0, 1.0, 3.0)
    assert r"\Omega^{2} &= \frac{3}{2} = 1.5\,\mathrm{s^{-2}}" in to_latex(route, numbers)
    assert r"\Omega^{2} &= \frac{k}{m}" in to_latex(route)
    assert "Omega_squared = k / m" in to_notebook(route)
    assert r"\frac{3}{2} = 1.5" in cache.step("trivial", 0, numbers)[2]
    assert not cache.agrees.__wrapped__("trivial")
    monkeypatch.undo()
    # In the package, a file that adds a route is named on one line of `ramanujan.derivation`.
    package = Path(derivation.__file__)
    files = {path.stem for path in package.parent.glob("*.py") if "@ROUTES.add" in path.read_text(encoding="utf-8")}
    (line,) = (line for line in package.read_text(encoding="utf-8").splitlines() if "import euler_lagrange" in line)
    named = line.partition("import ")[2].partition("#")[0]
    assert files == {name.strip() for name in named.split(",")}
    assert len(files) == len(ROUTES)


@pytest.mark.parametrize("name", ROUTES)
def test_equal_masses_are_inserted_into_every_line(name):
    """Each step of the general machine has a counterpart, up to the condition on ε. No line contains m′."""
    general, equal = ROUTES[name], ROUTES.with_equal_masses(name)
    ratio = ("ratio", "unit", "root")
    assert [s.key for s in general.steps if s.key not in ratio] == [s.key for s in equal.steps if s.key != "close"]
    for step in equal.steps:
        assert not any(relation.has(m_prime) for relation in step.equations)
        if step.key != "close":
            assert step.heading == general[step.key].heading
    at_equal = general.natural_frequency_squared.subs(m_prime, m)
    assert sp.cancel(equal.natural_frequency_squared - at_equal) == 0
    assert len(general.steps) <= 14
    assert equal.title != general.title


@pytest.mark.parametrize(
    ("roller_mass", "word"), [(2.0, "faster"), (UNIT_MASS_RATIO * 2, "in step"), (3.0, "more slowly")]
)
def test_the_sign_of_the_condition_matches_the_frequency(roller_mass, word):
    numbers = replace(TWO_MASSES, m_prime=roller_mass)
    step = ROUTES["euler_lagrange"]["unit"]
    adapted = step.for_numbers(numbers)
    assert word in adapted.reason
    signs = {sp.sign(numbers.insert_into(relation.rhs)) for relation in adapted.equations}
    assert signs == {{"faster": -1, "in step": 0, "more slowly": 1}[word]}
