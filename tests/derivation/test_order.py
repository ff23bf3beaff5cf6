"""Formulas have a textbook's order: the paper's order in its equations, and one rule for all other lines."""

import re
import unicodedata
from itertools import pairwise

import pytest
import sympy as sp

from ramanujan.derivation import ROUTES, Route
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.order import in_order
from ramanujan.derivation.printers import latex
from ramanujan.derivation.rows import make_rows
from tests.checks.browser import ROOT

LETTERS = {r"\varphi": "φ", r"\Phi": "Φ", r"\Omega": "Ω", r"\omega": "ω", r"\alpha": "α", r"\xi": "ξ", r"\eta": "η"}
SIGNS = {r"\varepsilon": "ε", r"\mathcal{L}": "ℒ", r"\mathcal{H}": "ℋ", "m'": "m′", r"\,": ""}
SIGNS |= {r"\left(": "(", r"\right)": ")", " - ": " − ", "- ": "−", "-": "−"}
FRACTIONS = {"[1/2]": "½", "[3/4]": "¾", "[1/4]": "¼"}


def read(text: str) -> str:
    """Return LaTeX as plain text, with longer fractions in square brackets: ½(3m + 2m′)Ẋ² + [8k/99m]X."""
    for mark, plain in (LETTERS | SIGNS).items():
        text = text.replace(mark, plain)
    text = re.sub(r"\\text\{(\w+)\}", r"\1", text)
    text = re.sub(r"\\(d?)dot\{(\w)\}", lambda dots: dots[2] + ("\u0308" if dots[1] else "\u0307"), text)
    text = re.sub(r"\^\{(\d)\}", lambda power: "⁰¹²³⁴⁵⁶⁷⁸⁹"[int(power[1])], text)
    text = re.sub(r"_\{(\w+)\}", r"_\1", text)
    text = re.sub(r"\\sqrt\{(\w+)\}", r"√\1", text)
    while r"\frac" in text:
        text = re.sub(r"\\frac\{([^{}]*)\}\{([^{}]*)\}", lambda parts: f"[{parts[1]}/{parts[2]}]", text)
    for fraction, plain in (FRACTIONS | {"{": "", "}": ""}).items():
        text = text.replace(fraction, plain)
    return unicodedata.normalize("NFC", text)


def lines(route: Route, key: str, numbers: Numbers | None = None) -> list[str]:
    """Return the lines of a step as plain text."""
    return [read(row.unmarked.latex.rpartition(r":\ ")[2]) for row in make_rows(route[key], numbers)]


# The paper


PAPER = {
    ("1", "any", "sum", 0): "ℒ = ½mẊ² + ½m′(Rφ̇ − Ẋ)² + ½m′R²φ̇² + ½m′(Rφ̇ − Ẋ)² + ¼m′R²φ̇² + ½m(2Rφ̇ − Ẋ)² + ½m(RΦ̇ − Ẋ)² "
    "+ ¼mR²Φ̇² − 2kR²φ²",
    ("2", "equal", "lagrangian", 0): "ℒ = [5/2]mẊ² + ¾mR²Φ̇² + [15/4]mR²φ̇² − mRẊΦ̇ − 4mRẊφ̇ − 2kR²φ²",
    ("4a", "equal", "motion", 0): "5Ẍ − RΦ̈ − 4Rφ̈ = 0",
    ("4b", "equal", "motion", 2): "[3/2]RΦ̈ − Ẍ = 0",
    ("4c", "equal", "motion", 1): "[15/2]mRφ̈ − 4mẌ + 4kRφ = 0",
    ("5", "equal", "frequency", 0): "φ̈ + Ω²φ = 0",
    ("6, left", "equal", "elimination", 2): "[15/2]Ẍ − Ẍ = 6Rφ̈",
    ("6, right", "equal", "elimination", 3): "Ẍ = [12/13]Rφ̈",
    ("7", "equal", "insertion", -1): "φ̈ + [104k/99m]φ = 0",
    ("8", "equal", "frequency", 1): "Ω² = [104k/99m]",
    ("9", "any", "lagrangian", 0): "ℒ = ½(3m + 2m′)Ẋ² + ¾mR²Φ̇² + ¼(8m + 7m′)R²φ̇² − mRẊΦ̇ − 2(m + m′)RẊφ̇ − 2kR²φ²",
    ("10a", "any", "motion", 0): "(3m + 2m′)Ẍ − mRΦ̈ − 2(m + m′)Rφ̈ = 0",
    ("10b", "any", "motion", 2): "[3/2]RΦ̈ − Ẍ = 0",
    ("10c", "any", "motion", 1): "½(8m + 7m′)Rφ̈ − 2(m + m′)Ẍ + 4kRφ = 0",
    ("11a", "any", "elimination", 3): "Ẍ = [6(m + m′)/7m + 6m′]Rφ̈",
    ("11b", "any", "elimination", 4): "Φ̈ = [4(m + m′)/7m + 6m′]φ̈",
    ("12", "any", "insertion", 2): "φ̈ + [8k/8m + 7m′ − [24(m + m′)²/7m + 6m′]]φ = 0",
    ("13", "any", "unit", 2): "7ε(7 + 6ε) − 24(1 + ε)² = 0",
    ("14", "any", "root", -1): "ε = [√1729 − 1/36]",
    ("15", "any", "root", 3): "(36ε + 1)² = 1729",
}
"""Number, masses, step and line → the equation of the paper, in its order.

The paper writes both m + m′ and m′ + m, and both ẊΦ̇ and φ̇Ẋ. The list puts m before m′, and X before φ. The angle of the
top cylinder, ϕ in the paper, is Φ. Moments of inertia and the spring's compression are inserted into (1).
"""


@pytest.mark.parametrize("place", PAPER, ids=lambda place: place[0])
def test_the_equations_of_the_paper_have_its_order(place):
    _number, masses, key, line = place
    route = ROUTES["euler_lagrange"] if masses == "any" else ROUTES.with_equal_masses("euler_lagrange")
    assert lines(route, key)[line] == PAPER[place]


def test_the_list_of_the_paper_s_equations_names_their_steps():
    """`.github/paper.md` lists each equation with the number and the heading of its step."""
    text = (ROOT / ".github" / "paper.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| \(([\w, ]+)\) \| (any|equal) \| (\d+) \| (.*) \| `(\w+)` \|$", text, re.MULTILINE)
    listed = {(number, masses, key) for numbers, masses, *_, key in rows for number in numbers.split(", ")}
    assert listed == {(number.partition(",")[0], masses, key) for number, masses, key, _line in PAPER}
    for _numbers, masses, order, heading, key in rows:
        route = ROUTES["euler_lagrange"] if masses == "any" else ROUTES.with_equal_masses("euler_lagrange")
        step = route.steps[int(order) - 1]
        assert (step.heading, step.key) == (heading, key)


# All other lines


TEXTBOOK = {
    ("euler_lagrange", "momenta", 0): "p_X = (3m + 2m′)Ẋ − mRΦ̇ − 2(m + m′)Rφ̇",
    ("euler_lagrange", "momenta", 1): "p_φ = ½(8m + 7m′)R²φ̇ − 2(m + m′)RẊ",
    ("euler_lagrange", "momenta", 2): "p_Φ = [3/2]mR²Φ̇ − mRẊ",
    ("euler_lagrange", "inertia", 0): "I_hoop = m′R²",
    ("euler_lagrange", "ratio", 1): "[Ω²m/k] = [8/8 + 7ε − [24(1 + ε)²/7 + 6ε]]",
    ("euler_lagrange", "ratio", 2): "[Ω²m/k] = [8(7 + 6ε)/18ε² + 49ε + 32]",
    ("hamilton", "hamiltonian", 0): "ℋ = ½p_XẊ + ½p_φφ̇ + ½p_ΦΦ̇ + U",
    ("hamilton", "reduction", 0): "ℋ = [(p_φ + [2(m + m′)/7m + 6m′](3Rp_X + 2p_Φ))²/2M_eR²] + 2kR²φ² + ℋ_0",
    ("newton", "rolling", 2): "a_hoop − Rα_hoop = a_block",
    ("newton", "forces", 0): "ma_block = 2kRφ − F_hoop − F_cylinder − F_top",
    ("newton", "forces", 1): "m′a_hoop = S_hoop + F_hoop",
    ("newton", "torques", 0): "m′R²α_hoop = RS_hoop − RF_hoop",
    ("newton", "contact", 0): "S_hoop = [m′(4m + 3m′)/7m + 6m′]Rφ̈",
    ("energy", "spring_mass", 0): "M_x = [3/8]m′ + [m(8m + 7m′)/2(7m + 6m′)]",
    ("matrix", "determinant", 1): "¼ω⁴mR⁴(8k(7m + 6m′) − ω²(32m² + 49mm′ + 18m′²)) = 0",
}
"""Route, step and line → the line in a textbook's order."""

NUMBERS = {
    ("euler_lagrange", "lagrangian", 0): "ℒ = [7/2]Ẋ² + ¾R²Φ̇² + [11/2]R²φ̇² − RẊΦ̇ − 6RẊφ̇ − [123/5]R²φ²",
    ("euler_lagrange", "motion", 1): "11Rφ̈ − 6Ẍ + [246/5]Rφ = 0",
    ("hamilton", "inversion", 3): "p_φ + [18/19]Rp_X + [12/19]p_Φ = [101/19]R²φ̇",
    ("matrix", "determinant", 1): "ω⁴R⁴([2337/5] − [101/2]ω²) = 0",
}
"""Lines as in the table above, with the numbers of a machine."""


@pytest.mark.parametrize(
    ("place", "line", "numbers"),
    [*((*each, None) for each in TEXTBOOK.items()), *((*each, Numbers(1.0, 2.0, 12.3)) for each in NUMBERS.items())],
    ids=str,
)
def test_a_line_has_the_order_of_a_textbook(place, line, numbers):
    name, key, number = place
    assert lines(ROUTES[name], key, numbers)[number] == line


def test_single_numbers_and_brackets_preserve_their_sign():
    m, k = sp.symbols("m k", positive=True)
    cases = {
        sp.Mul(2, -1, evaluate=False): "−2",
        sp.Mul(-1, m + k, evaluate=False): "−(k + m)",
        sp.Mul(-2, -m - k, evaluate=False): "2(k + m)",
        in_order(m, sp.Integer(-1), -k): "m − 1 − k",
        sp.Mul(sp.Rational(1, 2), m + k, evaluate=False): "[k + m/2]",
        m * (1 - sp.sqrt(3)): "−(√3 − 1)m",
        -(m**2) / (2 * k): "−[m²/2k]",
    }
    for expression, text in cases.items():
        assert read(latex(expression)) == text, expression


def test_a_term_has_the_same_place_on_all_lines_of_a_step():
    """Unknowns have the same order on adjacent lines that contain them."""
    for name, key, few in (
        ("euler_lagrange", "elimination", slice(1, 3)),
        ("euler_lagrange", "insertion", slice(4)),
        ("newton", "solution", slice(1, 3)),
    ):
        orders = [re.findall("Ẍ|φ\u0308?|Φ\u0308", line) for line in lines(ROUTES[name], key)[few]]
        assert all(len(order) > 1 for order in orders)
        for order, following in pairwise(orders):
            common = [unknown for unknown in dict.fromkeys(order) if unknown in following]
            assert common == [unknown for unknown in dict.fromkeys(following) if unknown in order], (name, key)
