"""Page 4 under AppTest: its texts against brute force and SymPy; its figures; bad input."""

import re
from base64 import b64decode
from collections import Counter
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, product

import numpy as np
import plotly.graph_objects as go
import pytest
import sympy as sp
from streamlit.testing.v1 import AppTest

from ramanujan import normalized_frequency_squared
from ramanujan.browser import stage
from ramanujan.derivation.model import epsilon
from ramanujan.derivation.numbers import unit_frequency_condition
from ramanujan.figures import taxicab_page as figures
from ramanujan.number_theory import BODIES, BodyChoice, machines
from ramanujan.pages.taxicab import cache, other_targets

PAGE = "ramanujan/pages/taxicab/page.py"
COLORS = dict.fromkeys(("ink", "faint", "paper", "primary", "top", "hoop", "on_hoop", "block_ink"), "#123456")


@pytest.fixture
def page(app: AppTest) -> AppTest:
    return app.run().switch_page(PAGE).run()


def words(page: AppTest) -> str:
    return "\n".join(element.value for element in page.markdown)


def two_cubes(n: int) -> list[tuple[int, int]]:
    return [(x, y) for x in range(1, 200) for y in range(x, 200) if x**3 + y**3 == n]


def smallest_in_two_ways() -> int:
    sums = Counter(x**3 + y**3 for x in range(1, 30) for y in range(x, 30))
    return min(n for n, ways in sums.items() if ways == 2)


def test_the_taxicab_number_is_computed(page: AppTest) -> None:
    assert not page.exception
    number = smallest_in_two_ways()
    assert page.title[0].value == str(number)
    assert "1^{3} + 12^{3} = 9^{3} + 10^{3}" in words(page)
    assert any(rf"\sqrt{{{number}}}" in formula.value for formula in page.latex)
    reason = page.latex[0].value
    assert reason.index("18") < reason.index("72") < reason.index("36") < reason.index(str(number))


@pytest.mark.parametrize("bodies", [("hoop", "shell", "sphere"), ("sphere", "cylinder", "hoop"), ("shell",) * 3])
def test_other_bodies_reach_numbers_and_stage(
    page: AppTest, bodies: tuple[str, str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    sent = []
    true_payload = stage.payload
    monkeypatch.setattr(stage, "payload", lambda *a, **more: sent.append(more) or true_payload(*a, **more))
    for place, body in zip(("left", "right", "top"), bodies, strict=True):
        page.segmented_control(key=place).set_value(body)
    page.run()
    assert not page.exception
    number = BodyChoice(*bodies).discriminant
    text = words(page)
    assert f"The discriminant **{number}**" in text
    # The first other target leads to a sum of two cubes.
    assert text.count("is not a sum of two positive cubes") == (not two_cubes(number))
    betas = [float(BODIES[body]) for body in bodies]
    assert sent[-1]["shape_factors"] == dict(zip(("hoop", "cylinder", "top"), betas, strict=True))
    # The number is large. With other bodies and the same masses the machine is not in step until its ratio is set.
    assert any(f">{number}<" in element.proto.body for element in page.get("html"))
    assert r"it has $\Omega^2m/k=1$" not in text
    page.button(key="own_ratio").click().run()
    assert r"it has $\Omega^2m/k=1$" in words(page)
    page.button(key="paper_bodies").click().run()
    assert f"The discriminant **{smallest_in_two_ways()}**" in words(page)
    assert r"it has $\Omega^2m/k=1$" in words(page)


@pytest.mark.parametrize(("p", "q"), [(1, 1000), (1000, 999), (104, 99), (3, 2)])
def test_a_target_has_its_quadratic_and_its_ratio(page: AppTest, p: int, q: int) -> None:
    of_paper = {formula.value for formula in page.latex}
    page.number_input(key="p").set_value(p)
    page.number_input(key="q").set_value(q)
    page.run()
    assert not page.exception
    quadratic, solution = [formula.value.strip("$\n ") for formula in page.latex if formula.value not in of_paper]
    text = quadratic.removesuffix("= 0").replace(r"\,", "*").replace(r"\varepsilon", "epsilon")
    polynomial = sp.Poly(sp.sympify(text.replace("^{2}", "**2"), {"epsilon": epsilon}), epsilon)
    assert f"The discriminant **{polynomial.discriminant()}**" in words(page)
    assert rf"\sqrt{{{polynomial.discriminant()}}}" in solution
    root = max(polynomial.nroots(30))
    assert float(normalized_frequency_squared(float(root))) == pytest.approx(p / q, rel=1e-12)


def test_all_simple_targets_that_lead_to_a_sum_of_two_cubes_are_named(page: AppTest) -> None:
    sums = Counter(x**3 + y**3 for x in range(1, 200) for y in range(x, 200))
    parts = range(1, 21)
    targets = sorted({Fraction(p, q) for p in parts for q in parts if 4 * p < 7 * q})
    names = []
    for target in targets:
        # Ω²m/k = w, multiplied by the denominator, with coprime coefficients.
        coefficients = sp.Matrix([18 * target, 49 * target - 48, 32 * target - 56])
        a, b, c = coefficients * sp.ilcm(*(term.q for term in coefficients))
        discriminant = (b**2 - 4 * a * c) / sp.igcd(a, b, c) ** 2
        assert discriminant < 200**3
        ways = sums[int(discriminant)]
        if ways:
            names.append(f"{target} (in {ways} ways)" if ways > 1 else str(target))
    assert "1 (in 2 ways)" in names
    expected = f"of the {len(targets)} targets with $p$ and $q$ up to 20, only these lead to one: {', '.join(names)}."
    assert expected in words(page)


def test_a_target_out_of_reach_gets_one_sentence_and_the_last_good_one_stays(page: AppTest) -> None:
    page.number_input(key="q").set_value(1).run()
    (warning,) = page.warning
    assert "between 0 and 7/4" in warning.value
    assert "3/1 is not, so 3/16 is shown." in warning.value
    page.number_input(key="q").set_value(4).run()
    assert not page.warning
    page.number_input(key="p").set_value(8).run()
    assert "3/4 is shown." in page.warning[0].value


def test_the_formula_of_the_discriminant_is_true_for_every_target(page: AppTest) -> None:
    assert other_targets.DISCRIMINANT in [formula.value.strip("$\n ") for formula in page.latex]
    p, q = sp.symbols("p q", positive=True)
    text = other_targets.DISCRIMINANT.replace(r"\,", "*").replace("^", "**")
    formula = sp.sympify(re.sub(r"(\d)(?=[pq])", r"\1*", text), {"p": p, "q": q})
    numerator, denominator = sp.fraction(unit_frequency_condition().normalized_frequency_squared)
    a, b, c = sp.Poly(sp.expand(p * denominator - q * numerator), epsilon).all_coeffs()
    assert sp.expand(formula - (b**2 - 4 * a * c)) == 0


def test_all_ways_to_write_the_number_in_its_form_are_shown(page: AppTest) -> None:
    number = smallest_in_two_ways()
    ways = [(x, y) for y in range(1, 25) for x in range(1, 42) if x * x + 3 * y * y == number]
    shown = re.findall(r"(\d+)\^2\+3\\cdot(\d+)\^2", words(page))
    # The first way is also in the visible sentence above the details.
    assert [(int(x), int(y)) for x, y in shown] == [ways[0], *ways]
    assert len(ways) == 4
    assert ways[0] == (48 - 7, 4)


def test_the_last_factor_of_a_sum_of_two_cubes_has_the_same_form() -> None:
    squares = {n * n for n in range(100)}
    for x, y in product(range(1, 40), repeat=2):
        factor = x * x - x * y + y * y
        assert any(factor - 3 * n * n in squares for n in range(40))


def test_the_norm_does_not_depend_on_the_top_body() -> None:
    def primes(left: str, right: str) -> set[int]:
        targets = [Fraction(p, q) for p in range(1, 12) for q in range(8, 12)]
        numbers = [BodyChoice(left, right, top, w) for top in BODIES for w in targets if w < Fraction(5, 3)]
        return {prime for number in numbers for prime, power in number.factorization if power % 2}

    assert all(prime == 3 or prime % 3 == 1 for prime in primes("hoop", "cylinder"))
    # Negative control: another pair has different primes.
    assert any(prime % 3 == 2 for prime in primes("hoop", "sphere"))


def test_the_papers_rollers_lead_to_the_most_sums_of_two_cubes(page: AppTest) -> None:
    parts = range(1, 21)
    # A machine with any top body reaches each target below 5/3.
    targets = {Fraction(p, q) for p in parts for q in parts if Fraction(p, q) < Fraction(5, 3)}
    sums = {x**3 + y**3 for x in range(1, 500) for y in range(x, 500)}
    counts = Counter()
    for left, right in combinations_with_replacement(BODIES, 2):
        numbers = [BodyChoice(left, right, top, target).discriminant for top in BODIES for target in targets]
        assert max(numbers) < 500**3
        counts[left, right] = sum(number in sums for number in numbers)
    (pair, most), (_pair, second), *_others = counts.most_common()
    assert pair == ("hoop", "cylinder")
    assert f"these rollers lead to {most} sums of two cubes, any other pair to at most {second}." in words(page)


def test_no_machine_with_one_other_body_leads_to_a_sum_of_two_cubes() -> None:
    paper = BodyChoice()
    lower, neighbours = Counter([paper.left, paper.right]), []
    for machine in machines():
        changes = (lower - Counter([machine.left, machine.right])).total() + (machine.top != paper.top)
        if changes == 1:
            neighbours.append(machine)
    assert len(neighbours) == 9  # three places, three other bodies in each
    assert not any(two_cubes(machine.discriminant) for machine in neighbours)


def test_the_figure_of_all_machines_marks_the_chosen_one() -> None:
    every = machines()
    grid = figures.draw_machine_grid(
        [str(n) for n in range(10)],
        list(BODIES),
        [machine.discriminant for machine in every],
        [len(machine.cubes) for machine in every],
        (2, 2),
        COLORS,
    )
    table, numbers = go.Figure(grid.to_dict()).data
    assert np.sum(np.array(table.z) == 2) == 1
    assert np.sum(np.array(table.z) == 1) == 2
    # A click returns the index of the point, which must be the machine's.
    assert [int(re.sub("</?b>", "", text)) for text in numbers.text] == [machine.discriminant for machine in every]
    assert all(a.discriminant != b.discriminant for a, b in combinations(every, 2))


def test_labels_of_the_curve_stay_on_the_figure_at_every_target() -> None:
    for w in (1 / 1000, 0.3, 1.0, 1.3, 1.74):
        root = (48 - 49 * w + ((7 * w - 48) ** 2 + 48 * w * w) ** 0.5) / (36 * w)
        ratios, values = cache.curve(max(2 * root, 1.1))
        crossing = figures.draw_level_crossing(
            ratios, values, level=w, level_label="w", root=root, root_label="r", present=(1, 1), colors=COLORS
        )
        figure = go.Figure(crossing.to_dict())
        label = figure.layout.annotations[0]
        low, high = figure.layout.yaxis.range
        # Without margins, the plot is 270 px high. A label of two lines extends 20 px from its middle.
        height = 270 * (w - low) / (high - low) - label.ay
        assert 20 <= height <= 270 - 10


def test_all_whole_points_of_the_curve_of_the_sums_are_marked() -> None:
    number = smallest_in_two_ways()
    curve, marked = go.Figure(figures.draw_sums_of_cubes(number, two_cubes(number), COLORS).to_dict()).data
    points = [(x, y) for x, y in product(range(1, 20), repeat=2) if x**3 + y**3 == number]
    assert sorted(zip(marked.x, marked.y, strict=True)) == points
    x, y = (np.frombuffer(b64decode(values["bdata"]), np.float32) for values in (curve.x, curve.y))
    assert x**3 + y**3 == pytest.approx(number, rel=1e-5)


def test_no_equation_is_shown_twice():
    equations = cache.unit_equations("#000", "#fff").split(r"\\")
    assert len(set(equations)) == len(equations) > 3
