"""The grammar of a typed formula: accepted texts, refused texts, and limits."""

import re
from collections.abc import Iterator
from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from ramanujan.answers import QUESTIONS, find_answer_equations, find_question, judge
from ramanujan.answers.grammar import MAX_DEPTH, MAX_LENGTH, MAX_WEIGHT, parse, typeset
from ramanujan.answers.spelling import MAX_DIGITS, SYMBOLS, UnreadableError
from ramanujan.answers.typed_formulas import is_decimal
from ramanujan.answers.values import Formula
from ramanujan.derivation import ROUTES
from ramanujan.derivation.printers import latex
from tests.checks.typed_numbers import TYPED_NUMBERS
from tests.settings import DEEP

POINT = {
    name: Fraction(p) for name, p in zip(SYMBOLS, (2, 3, 5, 7, 11, 13, 37, 17, 19, 41, 23, 29, 43, 31), strict=True)
}
m, mp, k, R, X, Xd, Xdd, phi, phid, phidd, Phi, Phid, Phidd, eps = POINT.values()


def _outcome(text: str) -> tuple[sp.Expr | None, str]:
    try:
        return parse(text), ""
    except UnreadableError as refusal:
        return None, str(refusal)


def value(text: str) -> sp.Expr:
    """Return the value of a text at `POINT`, computed by SymPy."""
    parsed = parse(text)
    numbers = {s: sp.Rational(s.name) for s in parsed.free_symbols if is_decimal(s)}
    numbers |= {symbol: sp.Rational(POINT[name].numerator) for name, symbol in SYMBOLS.items()}
    return parsed.xreplace(numbers).doit()


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2k", 2 * k),
        ("k(7m+6m')", k * (7 * m + 6 * mp)),
        ("mm'", m * mp),
        ("m_prime*X_dot*phi_dot*Phi_dot", mp * Xd * phid * Phid),
        ("Phi' phi'", Phid * phid),
        ("k÷m−R–X", k / m - R - X),
        ("4(m+m′):(7m+6m′)", 4 * (m + mp) / (7 * m + 6 * mp)),
        ("1:2 m ∶ k", m / 2 / k),
        (r"m_p m_{p}", mp * mp),
        ("¼ m + ¾ m", m),
        ("m²+m³", m**2 + m**3),
        ("1/2 m X'^2", m * Xd**2 / 2),
        ("m/k/R", m / k / R),
        ("-m^2", -(m**2)),
        ("2^-1", Fraction(1, 2)),
        ("2^3^2", 2**9),
        ("m - -k", m + k),
        (".25", Fraction(1, 4)),
        ("\t m\u00a0+\u2009k\n", m + k),
        ("[m + k] R", (m + k) * R),
        ("⅓m + ⅔m", m),
        ("dX/dt dphi/dt dΦ/dt", Xd * phid * Phid),
        ("(dφ/dt)²", phid**2),
        ("Xdot phidot dPhi", Xd * phid * Phid),
        # A space after a number or a bracket ends the denominator.
        ("m/12 ((3R Phi' - 3X')^2 + k)", m / 12 * ((3 * R * Phid - 3 * Xd) ** 2 + k)),
        ("k/(2m) R", k * R / (2 * m)),
        ("1/2m", m / 2),
        ("(k/m) 8(7+m)", k / m * 8 * (7 + m)),
        ("(8m+k)R 0.5", (8 * m + k) * R / 2),
        ("0,5 m", m / 2),
        ("0{,}125 m", m / 8),
        ("1\u202f729 m", 1729 * m),
        (r"\frac{k}{2m}R", k / (2 * m) * R),
        (r"\frac12 m\dot{\varphi}^2", m * phid**2 / 2),
        (r"\tfrac{1}{2}\,m'\left(R\,\dot\varphi - \dot X\right)^{2}", mp * (R * phid - Xd) ** 2 / 2),
        (r"$m^{\prime}\cdot{m'}^{2}\times\Phi\dot{\Phi}\varepsilon$", mp**3 * Phi * Phid * eps),
    ],
)
def test_formulas_are_parsed(text: str, expected: Fraction) -> None:
    assert value(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        # Dashes and hyphens
        *((f"k{dash}m", k - m) for dash in ("—", "–", "−", "‐", "‑", "‒", "―", "－", "﹣", "--")),
        ("m^−2 + m⁻²", 2 / m**2),
        # Letters and signs of word processors, and of pages in PDF and MathML
        ("½ 𝑚 𝑋̇²", m * Xd**2 / 2),
        ("𝑚′𝑅𝜑̇ + 𝒎𝝋 + 𝜙𝜀𝛷", mp * R * phid + m * phi + phi * eps * Phi),
        ("8\u2062k\u2062(7\u200bm\ufeff+6\u2062m′)", 8 * k * (7 * m + 6 * mp)),
        ("\u202am\u202ck", m * k),
        ("ｍ＋６＊ｋ／（２Ｒ）", m + 6 * k / (2 * R)),
        ("m\u2003+\u2002k\u3000+\u00a0R", m + k + R),
        ("m•k·R×m⋅k", m**2 * k**2 * R),
        # Quotation marks
        *((f"m{quote}", mp) for quote in "ʼ’′'`´ʹ‘＇"),
        *((f"X{quotes}", Xdd) for quotes in ("″", '"', "”", "“", "’’", "′′")),
        # LaTeX of other pages
        (r"\(\mathrm{m}\,\mathit{k}\)", m * k),
        (r"\[\frac{k}{m}\]", k / m),
        (r"$$\left( m + k \right) R$$", (m + k) * R),
        (r"1\,729\,m", 1729 * m),
    ],
)
def test_pasted_formulas_are_parsed(text: str, expected: Fraction) -> None:
    assert value(text) == expected


def list_shown_formulas() -> Iterator[sp.Expr]:
    """Yield the formulas of all steps and answers that contain only letters of the grammar."""
    equations = [equation for route in ROUTES.values() for step in route.steps for equation in step.equations]
    for name in QUESTIONS:
        equations += find_answer_equations(name)
    letters = {symbol: sp.Dummy() for symbol in SYMBOLS.values()}
    for side in dict.fromkeys(side for equation in equations for side in equation.args):
        unknown = side.xreplace(letters).atoms(sp.Symbol, sp.Derivative) - {*letters.values()}
        is_number = isinstance(side, sp.Expr) and not side.is_Matrix and not side.has(sp.MatrixExpr, sp.Determinant)
        if is_number and not unknown:
            yield side


@pytest.mark.parametrize(("text", "expected"), TYPED_NUMBERS.items())
def test_a_number_has_the_same_value_in_a_formula_and_in_a_box(text: str, expected: object) -> None:
    if isinstance(expected, Fraction):
        assert value(text) == expected
    elif isinstance(expected, tuple):
        assert "can mean {} or {}.".format(*expected) in _outcome(text)[1]


@pytest.mark.parametrize("text", ["{}", "${}$", "$${}$$", r"\({}\)"])
def test_a_formula_copied_from_the_app_is_parsed(text: str) -> None:
    shown = list(list_shown_formulas())
    assert len(shown) > 60
    for formula in shown:
        copied = text.format(latex(formula))
        assert Formula(parse(copied)).equals(Formula(formula)), copied


@pytest.mark.parametrize("name", QUESTIONS)
def test_an_answer_copied_from_the_app_is_right(name: str) -> None:
    assert judge(name, f"${latex(find_question(name).right)}$").kind == "right"


@pytest.mark.parametrize("text", ["√(1729)", "1729^(1/2)", "1729^½", "sqrt 1729"])
def test_roots_are_parsed(text: str) -> None:
    assert value(text) == sp.sqrt(1729)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "first"),
        ("m = 2", "equals sign"),
        ("Ω", "without Ω"),
        ("m ≈ 2", "equals sign"),
        ("m < 2", "comparison"),
        ("^".join("1" * 150), "nested"),
        ("m\ud800", "cannot be shown"),
        ("m%", "“%”"),
        ("m; k", "“;”"),
        ("2\u0301", "“◌\u0301”"),
        ("m\u0301", "“ḿ”"),
        ("öm", "“öm”"),
        ("foo_bar", "“foo_bar”"),
        ("m_2", "“m_2”"),
        ("m_phi", "“m_phi”"),
        ("m_p' + k", "“m_p'”"),
        ("m''", "m''"),
        ("m.real", "“.”"),
        ("12,500 k", "12,500 can mean 12.500 or 12500."),
        ("k/(m + 1,127m')", "1,127 can mean 1.127 or 1127."),
        ("2 3", "Two numbers"),
        ("m2", "follows a name"),
        ("(m)2", "follows a bracket"),
        ("k/2m", "denominator"),
        ("k/(m)(R)", "denominator"),
        ("4(m+k):2m", "denominator"),
        ("√2m", "root end"),
        ("m+", "not complete"),
        ("()", "missing"),
        ("(m", "without a closing"),
        ("m)", "without an opening"),
        ("m^k", "exponent"),
        ("m^(1/3)", "exponent"),
        ("((((m^12)^12)^12)^12)", "large"),
        ("1e999999", "“e” is not known"),
        ("9" * 200, "digits"),
        ("(" * 10**6, "long"),
        ("(" * 100 + "m" + ")" * 100, "nested"),
    ],
)
def test_unreadable_text_raises_a_sentence(text: str, words: str) -> None:
    with pytest.raises(UnreadableError, match=r"[.?]") as refusal:
        parse(text)
    sentence = str(refusal.value)
    assert words.lower() in sentence.lower()
    assert sentence.endswith((".", "?"))


@pytest.mark.parametrize(
    ("text", "limit"),
    [
        (lambda n: "m" * n, MAX_WEIGHT),
        (lambda n: "(" * n + "m" + ")" * n, MAX_DEPTH),
        (lambda n: "9" * n, MAX_DIGITS),
        (lambda n: f"m^{n}", 12),
        (lambda n: "+" * (n - 1) + "m", MAX_LENGTH),
    ],
)
def test_limits_are_exact(text, limit) -> None:
    parse(text(limit))
    with pytest.raises(UnreadableError):
        parse(text(limit + 1))


def test_repeated_signs_do_not_count_as_nesting() -> None:
    assert value("- " * 299 + "m") == -m


_FORMULAS = st.recursive(
    st.sampled_from([*POINT]) | st.integers(0, 99).map(str),
    lambda inner: (
        st.tuples(inner, st.sampled_from(["+", "-", "*", "·", "/"]), inner).map(lambda parts: f"({''.join(parts)})")
        | st.tuples(inner, st.integers(0, 3)).map(lambda parts: "({})^{}".format(*parts))
        | inner.map("(-{})".format)
    ),
    max_leaves=12,
)
_NAMES = re.compile("|".join([*sorted(POINT, key=len, reverse=True), r"\d+"]))


def computed(text: str) -> Fraction:
    """Return Python's value of a formula at `POINT`."""
    plain = _NAMES.sub(lambda match: f"Fraction({POINT.get(match[0], match[0])})", text)
    return eval(plain.replace("^", "**").replace("·", "*"))


@example("-(1*(m+m))")
@settings(deadline=None, max_examples=20_000 if DEEP else 200)
@given(_FORMULAS.filter(lambda text: len(text) < MAX_LENGTH))
def test_the_value_agrees_with_python(text: str) -> None:
    try:
        expected = computed(text)
    except ZeroDivisionError:
        assume(False)
    parsed, refusal = _outcome(text)
    if parsed is None:
        # The only possible errors for a well-formed text.
        assert any(word in refusal for word in ("large", "nested"))
        return
    assert value(text) == expected
    # The LaTeX of a formula can be parsed again, unless it is too long.
    again = typeset(text)
    assert len(again) > MAX_LENGTH or "nested" in _outcome(again)[1] or value(again) == expected


@pytest.mark.parametrize(
    ("text", "formula"),
    [
        ("1/2 m X'^2", r"\frac{1}{2}\,m\,{\dot{X}}^{2}"),
        ("8k(7m+6m')/(32m^2)", r"\frac{8\,k\,\left(7\,m + 6\,m'\right)}{32\,{m}^{2}}"),
        ("m-(k-R)", r"m - \left(k - R\right)"),
        ("0.250*3^2", r"0.250 \cdot {3}^{2}"),
    ],
)
def test_typeset_formula(text, formula):
    assert typeset(text) == formula
