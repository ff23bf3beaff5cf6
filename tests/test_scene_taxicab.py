"""Page 4 under AppTest: its texts against brute force, mpmath and SymPy; its figures; bad input."""

import re
from collections import Counter
from fractions import Fraction
from itertools import combinations

import mpmath
import numpy as np
import plotly.graph_objects as go
import pytest
import sympy as sp
from streamlit.testing.v1 import AppTest

from ramanujan import normalized_frequency_squared
from ramanujan.browser import stage
from ramanujan.figures import taxicab as figures
from ramanujan.number_theory import BODIES, BodyChoice, machines
from ramanujan.pages.taxicab import cache

PAGE = "ramanujan/pages/taxicab/page.py"
COLORS = dict.fromkeys(("ink", "faint", "paper", "primary", "top", "hoop", "on_hoop", "block"), "#123456")


@pytest.fixture
def page(app: AppTest) -> AppTest:
    return app.run().switch_page(PAGE).run()


def words(page: AppTest) -> str:
    return "\n".join(element.value for element in page.markdown)


def opened(page: AppTest) -> AppTest:
    """Open the expander with digits and fractions."""
    page.session_state["fold_digits"] = True
    return page.run()


def two_cubes(n: int) -> list[tuple[int, int]]:
    return [(x, y) for x in range(1, 200) for y in range(x, 200) if x**3 + y**3 == n]


def smallest_in_two_ways() -> int:
    sums = Counter(x**3 + y**3 for x in range(1, 30) for y in range(x, 30))
    return min(n for n, ways in sums.items() if ways == 2)


def test_the_taxicab_number_is_computed(page: AppTest) -> None:
    assert not page.exception
    number = smallest_in_two_ways()
    assert page.title[0].value == str(number)
    assert f"{number}=1^{{3}} + 12^{{3}} = 9^{{3}} + 10^{{3}}" in words(page)
    assert any(rf"\sqrt{{{number}}}" in formula.value for formula in page.latex)


@pytest.mark.parametrize("digits", [1, 100, 1000])
def test_the_requested_number_of_digits_is_shown(page: AppTest, digits: int) -> None:
    assert not page.code
    opened(page).number_input(key="digits").set_value(digits).run()
    with mpmath.workdps(digits + 20):
        root = (mpmath.sqrt(smallest_in_two_ways()) - 1) / 36
        expected = mpmath.nstr(mpmath.floor(root * mpmath.mpf(10) ** digits) / mpmath.mpf(10) ** digits, digits + 1)
    # mpmath omits trailing zeros.
    assert page.code[0].value.rstrip("0") == expected
    assert len(page.code[0].value) == digits + 2


def test_each_practical_ratio_has_its_error(page: AppTest) -> None:
    rows = re.findall(
        r"\| \$(\d+)/(\d+)\$ \| \$\{(-?\d+)/(\d+)\\approx.*?\$ \| ([\d\u202f]+) periods?", words(opened(page))
    )
    assert [row[:2] for row in rows][2:4] == [("9", "8"), ("62", "55")]
    for p, q, over, under, periods in rows:
        value = normalized_frequency_squared(int(p) / int(q))
        # The rounding error of the float is a few ulp of 1.
        assert int(over) / int(under) == pytest.approx(value - 1, abs=1e-15)
        turns = int(periods.replace("\u202f", "")) * abs(value**0.5 - 1)
        # Periods are rounded to whole ones (1 in 40), and √ of the last row's value has lost digits (1e-9).
        assert turns == pytest.approx(1, rel=0.02)


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
    assert ("is not a sum of two positive cubes" in text) == (not two_cubes(number))
    betas = [float(BODIES[body]) for body in bodies]
    assert sent[-1]["shape_factors"] == dict(zip(("hoop", "cylinder", "top"), betas, strict=True))
    # With its own ratio the machine is in step, and the page states this.
    page.button(key="own_ratio").click().run()
    assert r"it has $\Omega^2m/k=1$" in words(page)
    page.button(key="paper_bodies").click().run()
    assert f"The discriminant **{smallest_in_two_ways()}**" in words(page)


@pytest.mark.parametrize(("p", "q"), [(1, 1000), (1000, 999), (104, 99)])
def test_a_target_and_its_norm(page: AppTest, p: int, q: int) -> None:
    page.number_input(key="p").set_value(p)
    page.number_input(key="q").set_value(q)
    page.run()
    assert not page.exception
    formulas = [formula.value for formula in page.latex]
    [place_of_norm, *_others] = [place for place, formula in enumerate(formulas) if "+ 3 \\cdot" in formula]
    norm = formulas[place_of_norm]
    x, y, right = re.search(r"(\(?-?\d+\)?)\^2 \+ 3 \\cdot (\d+)\^2 = (.+)", norm).groups()
    x, y = int(x.strip("()")), int(y)
    factor, _, number = right.rpartition(r"^2 \cdot ")
    assert x * x + 3 * y * y == int(factor or 1) ** 2 * int(number)
    assert f"The discriminant **{number}**" in words(page)
    # The quadratic on the page has this discriminant, and its root reproduces the target.
    w = sp.Rational(p, q)
    epsilon = sp.Symbol("epsilon", positive=True)
    formulas_above = formulas[:place_of_norm]
    quadratic = next(formula for formula in reversed(formulas_above) if formula.strip("$\n ").endswith("= 0"))
    text = quadratic.strip("$\n ").removesuffix("= 0").replace(r"\,", "*").replace(r"\varepsilon", "epsilon")
    polynomial = sp.Poly(sp.sympify(text.replace("^{2}", "**2"), {"epsilon": epsilon}), epsilon)
    assert polynomial.discriminant() == int(number)
    root = max(polynomial.nroots(30))
    assert float(normalized_frequency_squared(float(root))) == pytest.approx(float(w), rel=1e-12)


def test_norms_are_multiplicative(page: AppTest) -> None:
    names = {name: sp.Symbol(name) for name in "abcdxy"}
    shown = {formula.value.strip("$\n ") for formula in page.latex}
    for text in (cache.norm_multiplied_out(), cache.product_of_norms()):
        assert text in shown
        plain = re.sub(r"\\left|\\right|\\,|[{}]", "", text.replace(r"\sqrt{-3}", "I*sqrt(3)").replace("^", "**"))
        plain = re.sub(r"(?<=[abcdxy\d)]) ?(?=[abcdxyI(](?!qrt))", "*", plain)
        left, right = (sp.sympify(side, names) for side in plain.split("="))
        assert sp.expand(left - right) == 0
    # Each prime factor is the norm in the same row.
    primes = re.findall(r"(\d+)=(\d+)\^2\+3\\cdot(\d+)\^2[,$]", words(page))
    assert sp.prod(int(prime) for prime, _, _ in primes) == smallest_in_two_ways()
    assert all(int(prime) == int(u) ** 2 + 3 * int(v) ** 2 for prime, u, v in primes)


def test_a_target_out_of_reach_gets_one_sentence_and_the_last_good_one_stays(page: AppTest) -> None:
    page.number_input(key="p").set_value(3).run()
    (warning,) = page.warning
    assert "between 0 and 7/4" in warning.value
    assert "3/1 is not, so 1/1 is shown." in warning.value
    page.number_input(key="q").set_value(2).run()
    assert not page.warning
    page.number_input(key="p").set_value(4).run()
    assert "3/2 is shown." in page.warning[0].value


def test_the_identity_of_the_norm_is_true_for_every_target() -> None:
    p, q = sp.symbols("p q")
    text = cache.norm_identity().replace(r"\begin{aligned}", "").replace(r"\end{aligned}", "")
    text = re.sub(r"\\\\|\\quad|\\,|&", " ", text).replace(r"\cdot", "*").replace("^", "**")
    text = re.sub(r"(\d|p|q|\))\s*(?=[pq(])", r"\1*", text)
    left, right = (sp.sympify(side, {"p": p, "q": q}) for side in text.split("="))
    assert sp.expand(left - right) == 0


def test_the_norm_does_not_depend_on_the_top_body() -> None:
    def primes(left: str, right: str) -> set[int]:
        targets = [Fraction(p, q) for p in range(1, 12) for q in range(8, 12)]
        numbers = [BodyChoice(left, right, top, w) for top in BODIES for w in targets if w < Fraction(5, 3)]
        return {prime for number in numbers for prime, power in number.factorization if power % 2}

    assert all(prime == 3 or prime % 3 == 1 for prime in primes("hoop", "cylinder"))
    # Negative control: another pair has different primes.
    assert any(prime % 3 == 2 for prime in primes("hoop", "sphere"))


def test_the_count_of_cubes_against_brute_force(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "COUNTED_PART", 6)
    tally = cache.tally.__wrapped__("hoop", "cylinder")
    targets = {Fraction(p, q) for p in range(1, 7) for q in range(1, 7)}
    # A machine with any top body reaches each target below 5/3.
    targets = {w for w in targets if w < Fraction(5, 3)}
    numbers = [BodyChoice("hoop", "cylinder", top, w).discriminant for top in BODIES for w in targets]
    assert tally.machines == len(numbers)
    assert tally.sums == sum(bool(two_cubes(number)) for number in numbers)
    assert tally.taxicabs == sum(len(two_cubes(number)) > 1 for number in numbers)


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
        ratios, values = cache.curve(min(root / 2, 0.9), max(2 * root, 1.1))
        crossing = figures.draw_level_crossing(
            ratios, values, level=w, level_label="w", root=root, root_label="r", present=(1, 1), colors=COLORS
        )
        figure = go.Figure(crossing.to_dict())
        label = figure.layout.annotations[0]
        low, high = figure.layout.yaxis.range
        # Without margins, the plot is 270 px high. A label of two lines extends 20 px from its middle.
        height = 270 * (w - low) / (high - low) - label.ay
        assert 20 <= height <= 270 - 10


def test_no_equation_is_shown_twice():
    equations = cache.unit_equations()
    assert len(set(equations)) == len(equations) > 3
