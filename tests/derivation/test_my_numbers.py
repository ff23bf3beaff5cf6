"""Every displayed equation of every route is true, on pages and in files.

`tests.checks.latex` parses its LaTeX. Both sides must agree to fifty digits for the exact motion of the machine. mpmath
computes this motion from the mass matrix, independently of the package's formulas.
"""

import random
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property, partial

import mpmath
import numpy as np
import pytest
import sympy as sp

from ramanujan import UNIT_MASS_RATIO
from ramanujan.derivation import ROUTES
from ramanujan.derivation.model import k, m, m_prime
from ramanujan.derivation.nomenclature import nomenclature
from ramanujan.derivation.numbers import Numbers, is_unit_ratio
from ramanujan.derivation.rows import align, make_rows
from ramanujan.pages.derivation import cache as page
from ramanujan.pages.oscillator import cache as first_page
from ramanujan.text.names import PARTS
from tests.checks import reference
from tests.checks.latex import Formula, Number, equations, formula, last_place, sides
from tests.settings import DEEP

INKS = tuple((part, "#123456") for part in (*PARTS, "cube"))

COUNT = 60 if DEEP else 10
"""Number of machines for which all equations are tested."""

ROOT = (mpmath.sqrt(1729) - 1) / 36
Masses = tuple[float, float, float]


@cache
def machines() -> list[Masses]:
    """Return sixty machines: decimals, fractions, ε*, equal masses, corners. The first ten include each kind."""
    source = random.Random(1729)
    on_steps = [
        (source.randint(10, 100) / 20, source.randint(1, 1000) / 100, source.randint(2, 400) / 2) for _ in range(9)
    ]
    typed = [tuple(round(10 ** source.uniform(-1, 1), digits) or 1.0 for digits in (1, 2, 1)) for _ in range(9)]
    fractions = [tuple(source.randint(1, 40) / source.randint(1, 9) for _ in range(3)) for _ in range(9)]
    anywhere = [tuple(10 ** source.uniform(-3, 3) for _ in range(3)) for _ in range(5)]
    root = [
        (mass, UNIT_MASS_RATIO * mass, source.randint(1, 999) / 10) for mass in (1.0, 3.7, 0.5, 1.2345678, 2 / 3, 4.1)
    ]
    near = [(1.0, 1.127256827016210, 1.0), (2.0, 2.254513654, 9.9), (1.0, 1.13, 0.1)]
    equal = [(mass, mass, stiffness) for mass, stiffness in ((1.0, 12.3), (0.1, 7.0), (1.2345678, 0.7), (5 / 6, 1 / 3))]
    corners = [(mass, roller, k) for mass in (0.5, 5.0) for roller in (0.01, 10.0) for k in (1.0, 200.0)]
    extreme = [(1e-3, 1e3, 1e-3), (1e3, 1e-3, 1e3), (1e-3, 1e-3, 1e3)]
    by_kind = [[(1.0, 2.0, 12.3), *typed], root, fractions, equal, anywhere, corners, near, on_steps, extreme]
    first = [kind[0] for kind in by_kind]
    return [*first, *(masses for kind in by_kind for masses in kind[1:])][:60]


# The exact motion


@dataclass(frozen=True)
class Moment:
    """A machine at one moment of its motion.

    Parameters
    ----------
    mass, roller, stiffness, R : m, m′ [kg], k [N/m], R [m]
    q, q_dot : coordinates X, φ, Φ and their rates
    """

    mass: mpmath.mpf
    roller: mpmath.mpf
    stiffness: mpmath.mpf
    R: mpmath.mpf
    q: mpmath.matrix
    q_dot: mpmath.matrix

    @cached_property
    def M(self) -> mpmath.matrix:
        return mass_matrix(self.mass, self.roller, self.R)

    @cached_property
    def K(self) -> mpmath.matrix:
        return mpmath.diag([0, 4 * self.stiffness * self.R**2, 0])

    @cached_property
    def inverse(self) -> mpmath.matrix:
        return self.M**-1

    @cached_property
    def q_ddot(self) -> mpmath.matrix:
        return -self.inverse * self.K * self.q

    @cached_property
    def frequency_squared(self) -> mpmath.mpf:
        return self.K[1, 1] * self.inverse[1, 1]

    def right(self, of: mpmath.matrix) -> dict[str, mpmath.mpf]:
        """Return the displacement of each body to the right, or its derivative, from those of the coordinates."""
        X, phi, Phi = of
        R = self.R
        return {"block": -X, "hoop": R * phi - X, "cylinder": R * phi - X, "slab": 2 * R * phi - X, "top": R * Phi - X}

    def angles(self, of: mpmath.matrix) -> dict[str, mpmath.mpf]:
        """Return the angle of each roller, or its derivative."""
        _X, phi, Phi = of
        return {"hoop": phi, "cylinder": phi, "top": Phi}


def mass_matrix(mass: mpmath.mpf, roller: mpmath.mpf, R: mpmath.mpf) -> mpmath.matrix:
    """Return the mass matrix for the coordinates X, φ, Φ."""
    inertia, _stiffness = reference.matrices(mass, roller, 0, R)
    return mpmath.matrix(inertia)


def mode_shape(inverse: mpmath.matrix) -> mpmath.matrix:
    """Return X, φ, Φ of the oscillating mode for φ = 1, from the inverse mass matrix."""
    return inverse[:, 1] / inverse[1, 1]


def random_moment(mass: mpmath.mpf, roller: mpmath.mpf, stiffness: mpmath.mpf, in_mode: bool) -> Moment:
    """Return a random moment of a machine with a random radius. The parameters are those of `motion`."""
    source = random.Random(f"{mass}{roller}")
    R, *state = (mpmath.mpf(source.randint(1, 999)) / source.randint(1, 99) for _ in range(7))
    if in_mode:
        shape = mode_shape(mass_matrix(mass, roller, R) ** -1)
        q, q_dot = shape * state[0], shape * state[3]
    else:
        q, q_dot = mpmath.matrix(state[:3]), mpmath.matrix(state[3:])
    return Moment(mass, roller, stiffness, R, q, q_dot)


def body_values(letter: str, of: dict[str, mpmath.mpf]) -> dict[str, mpmath.mpf]:
    """Return quantities of bodies by their names in LaTeX."""
    return {rf"{letter}_{{\text{{{name}}}}}": value for name, value in of.items()}


def values_of_coordinates(moment: Moment) -> dict[str, Number]:
    """Return coordinates, momenta and their derivatives."""
    p, p_dot = moment.M * moment.q_dot, moment.M * moment.q_ddot
    values = {}
    for place, letter in enumerate(("X", r"\varphi", r"\Phi")):
        values[letter] = moment.q[place]
        values[rf"\dot{{{letter}}}"] = moment.q_dot[place]
        values[rf"\ddot{{{letter}}}"] = moment.q_ddot[place]
        values[f"p_{{{letter}}}"] = p[place]
        values[rf"\dot{{p}}_{{{letter}}}"] = p_dot[place]
    values[r"\xi"] = moment.q_dot[0] / (moment.R * moment.q_dot[1])
    values[r"\eta"] = moment.q_dot[2] / moment.q_dot[1]
    return values


def values_of_bodies(moment: Moment) -> dict[str, Number]:
    """Return velocities, accelerations, forces and energies."""
    mass, roller, R = moment.mass, moment.roller, moment.R
    masses = {"block": mass, "hoop": roller, "cylinder": roller, "slab": mass, "top": mass}
    inertia = {"hoop": roller * R**2, "cylinder": roller * R**2 / 2, "top": mass * R**2 / 2}
    v, a = moment.right(moment.q_dot), moment.right(moment.q_ddot)
    omega, alpha = moment.angles(moment.q_dot), moment.angles(moment.q_ddot)
    kinetic = {n: (masses[n] * v[n] ** 2 + inertia.get(n, 0) * omega.get(n, 0) ** 2) / 2 for n in masses}
    compression = 2 * R * moment.q[1]
    T, U = sum(kinetic.values()), moment.stiffness * compression**2 / 2
    # The forces on a roller, S at its top and F at its bottom, accelerate it and turn it.
    S = {n: (masses[n] * a[n] + inertia[n] * alpha[n] / R) / 2 for n in ("hoop", "cylinder")}
    F = {n: masses[n] * a[n] - S.get(n, 0) for n in inertia}
    return {
        **body_values("v", v),
        **body_values("a", a),
        **body_values(r"\alpha", alpha),
        **body_values("I", inertia),
        **body_values("T", kinetic),
        **body_values("S", S),
        **body_values("F", F),
        "x": compression,
        "T": T,
        "U": U,
        r"\mathcal{L}": T - U,
        r"\mathcal{H}": T + U,
    }


def values_of_machine(moment: Moment) -> dict[str, Number]:
    """Return parameters, matrices, effective masses and frequencies."""
    M, squared = moment.M, moment.frequency_squared
    clamped = M[1, 1] / moment.R**2
    # H₀ belongs to the two conserved momenta, those of X and Φ.
    p = M * moment.q_dot
    conserved, block_and_top = mpmath.matrix([p[0], p[2]]), mpmath.matrix([[M[0, 0], M[0, 2]], [M[2, 0], M[2, 2]]])
    matrices = {"M": M, "K": moment.K, "M^{-1}": moment.inverse, "v": mode_shape(moment.inverse)}
    return {
        r"\varepsilon": moment.roller / moment.mass,
        r"\varepsilon_{*}": ROOT,
        "m": moment.mass,
        "m'": moment.roller,
        "k": moment.stiffness,
        "R": moment.R,
        r"\mathcal{H}_{0}": (conserved.T * block_and_top**-1 * conserved)[0] / 2,
        r"\Omega^{2}": squared,
        r"\Omega_{\text{clamped}}^{2}": 4 * moment.stiffness / clamped,
        "M_{e}": 4 * moment.stiffness / squared,
        "M_{x}": moment.stiffness / squared,
        r"M_{\text{clamped}}": clamped,
        **{name: np.array(matrix.tolist(), dtype=object) for name, matrix in matrices.items()},
        r"\omega": mpmath.sqrt(squared),
        r"\omega_{1}": mpmath.mpf(0),
        r"\omega_{2}": mpmath.mpf(0),
        r"\omega_{3}": mpmath.sqrt(squared),
    }


@cache
def motion(mass: mpmath.mpf, roller: mpmath.mpf, stiffness: mpmath.mpf, in_mode: bool) -> dict[str, Number]:
    """Return the values of all symbols at a moment of a motion: name in LaTeX → value.

    Parameters
    ----------
    mass, roller, stiffness : m, m′ [kg], k [N/m]
    in_mode : whether the motion is purely in the oscillating mode; otherwise the machine also glides and rolls
    """
    moment = random_moment(mass, roller, stiffness, in_mode)
    return {**values_of_coordinates(moment), **values_of_bodies(moment), **values_of_machine(moment)}


def motions(name: str, key: str, equal_masses: bool, given: Masses) -> Iterator[dict[str, Number]]:
    """Yield the possible motions of a step: of the given machine, or of the step's special machine.

    The last two steps of Euler–Lagrange state a condition on ε, which only ε* satisfies.
    """
    exact = Numbers(*given).exact
    mass, roller, stiffness = (mpmath.mpf(str(sp.N(exact[symbol], 100))) for symbol in (m, m_prime, k))
    yield motion(mass, mass if equal_masses else roller, stiffness, name == "energy")
    if key in ("unit", "root"):
        yield motion(mass, ROOT * mass, stiffness, False)


def holds(line: str, known: dict[str, Number]) -> bool:
    """Return whether both sides of an equation agree to fifty digits, and its decimal with its right side."""
    left, right, decimal, is_exact = sides(line)
    left_formula, right_formula = formula(left), formula(right)
    left_value, right_value = left_formula.value(known), right_formula.value(known)
    tolerance = mpmath.mpf("1e-50")
    allowed = tolerance * (1 + abs(right_value)) + left_formula.cut_off(known) + right_formula.cut_off(known)
    if not np.all(abs(left_value - right_value) <= allowed):
        return False
    if not decimal:
        return True
    decimal_value = formula(decimal).value({})
    half_a_digit = mpmath.mpf(0 if is_exact else 0.5)
    return bool(abs(decimal_value - right_value) <= last_place(decimal) * (tolerance + half_a_digit))


@pytest.fixture(autouse=True)
def hundred_digits() -> Iterator[None]:
    """Set the precision to 100 digits, because tests in other files may change it."""
    with mpmath.workdps(100):
        yield


# The displayed equations


def route_equations(name: str, equal_masses: bool, numbers: Numbers | None) -> Iterator[tuple[str, str]]:
    """Yield every equation that pages and files show of a route, with its step."""
    route = ROUTES.with_equal_masses(name) if equal_masses else ROUTES[name]
    keys = [step.key for step in route.steps]
    of_rows = {key: [row.latex for row in make_rows(route[key], numbers)] for key in keys}
    article = page.document.__wrapped__(name, numbers, "latex", equal_masses=equal_masses)
    in_article: dict[str, list[str]] = {}
    for key, section in zip(keys, article.split("\\section{")[1:], strict=True):
        in_article[key] = []
        for block in re.findall(r"\\begin\{align\*\}\n(.*?)\n\\end", section, re.DOTALL):
            in_article[key] += equations(block, " \\\\\n")
    on_page = {}
    for number, key in enumerate(keys):
        step = partial(page.step.__wrapped__, name, number, numbers, equal_masses=equal_masses)
        on_page[key] = equations(step()[2])
        yield from ((key, line) for line in equations(plain(step(INKS)[2])))
    assert in_article == on_page == of_rows, (name, numbers)
    yield from ((key, line) for key in keys for line in of_rows[key])


def displayed(given: Masses | None) -> Iterator[tuple[str, str, bool, str]]:
    """Yield every displayed equation: its route, its step, whether the masses are equal, and its LaTeX.

    Parameters
    ----------
    given : m, m′ [kg] and k [N/m]; none for the routes in symbols
    """
    numbers = Numbers(*given) if given else None
    for name in ROUTES:
        yield from ((name, key, False, line) for key, line in route_equations(name, False, numbers))
        if name == "euler_lagrange" or not given:
            equal = numbers and numbers.with_equal_masses
            yield from ((name, key, True, line) for key, line in route_equations(name, True, equal))
    (shape, *_), momenta = page.spectrum.__wrapped__(numbers)
    yield from (("matrix", "", False, line) for line in (shape, *equations(momenta)))
    for (_idea, (*_, key)), step in zip(first_page.SUMMARY, first_page.summary.__wrapped__(numbers), strict=True):
        blocks = [
            *(align(detail.details, first_page.LINE_WIDTH) for detail in step.steps),
            align(step.numbers, first_page.LINE_WIDTH),
        ]
        of_blocks = [line for block in filter(None, blocks) for line in equations(block)]
        yield from (("euler_lagrange", key, False, line) for line in (*step.results, *of_blocks))
    yield from (("matrix", "", False, line) for line in page.result.__wrapped__(numbers))


def plain(display: str) -> str:
    """Return the LaTeX of a display without colours."""
    text = display
    while r"\textcolor{" in text:
        start = text.index(r"\textcolor{")
        begin = place = text.index("}{", start) + 2
        depth = 1
        while depth:
            depth += {"{": 1, "}": -1}.get(text[place], 0)
            place += 1
        text = text[:start] + text[begin : place - 1] + text[place:]
    return text


@pytest.mark.parametrize("given", [None, *machines()[:COUNT]], ids=str)
def test_every_shown_equation_is_true(given):
    lines = set(displayed(given))
    assert len(lines) > 120
    for *where, line in lines:
        assert any(holds(line, known) for known in motions(*where, given or (1.7, 0.9, 12.3))), (where, line)
        left, right, *_ = sides(line)
        # Only the equation of a determinant may contain no symbol.
        assert Formula(left).names + Formula(right).names or left.startswith(r"\left|"), (where, line)


def test_negative_control_numbers_of_another_machine_are_detected():
    """Negative control for the test above."""
    silent = {("euler_lagrange", "velocities"), ("newton", "rolling"), ("newton", "accelerations")}
    # These contain no mass. The zero modes do not depend on k, and equal masses fix Ω²m/k.
    silent |= {("matrix", "zero_modes"), ("euler_lagrange", "close")}
    shown, other = list(displayed((1.85, 0.86, 33.5))), (1.86, 0.87, 33.6)
    noticed = set()
    for name, key, equal, line in shown:
        is_true = any(holds(line, known) for known in motions(name, key, equal, other))
        if not is_true:
            noticed.add((name, key))
    assert {(name, key) for name, key, *_ in shown} - noticed == silent


def test_negative_control_a_lost_bracket_is_detected():
    (known,) = motions("newton", "frequency", False, (1.0, 2.0, 12.3))
    line = r"\ddot{\varphi} + \frac{492\,\varphi}{5\,\left(8 + 14 - \frac{216}{19}\right)} = 0"
    assert holds(line, known)
    assert not holds(line.replace("8 + 14", "8 - 14"), known)
    for side_by_side in (r"5\,8", "5 8"):
        with pytest.raises(ValueError, match="side by side"):
            holds(line.replace(r"5\,\left(8", side_by_side).replace(r"\right)", ""), known)


@pytest.mark.parametrize(
    ("mass", "roller_mass", "formula"), [(1, 2, "m=1"), (2, 1, "m'=1"), (1, 1, "m=m'=1"), (2, 3, ""), (2, 4, "")]
)
def test_a_step_mentions_a_mass_of_one_kilogram_that_is_not_written_as_a_factor(mass, roller_mass, formula):
    numbers = Numbers(mass, roller_mass, 10)
    for key in ("inertia", "energies", "sum"):
        step = ROUTES["euler_lagrange"][key]
        added = step.for_numbers(numbers).reason.removeprefix(step.reason)
        assert re.findall(r"\$(.*?)\\,\\mathrm{kg}\$", added) == ([formula] if formula else []), key
    # The velocities contain no mass.
    step = ROUTES["euler_lagrange"]["velocities"]
    assert step.for_numbers(numbers).reason == step.reason


@pytest.mark.parametrize(("number", "entered"), [(0.86, "43/50"), (5 / 6, "5/6"), (1.2345678, "12345678/10000000")])
def test_a_number_is_read_as_entered(number, entered):
    assert set(Numbers(number, number, number).exact.values()) == {sp.Rational(entered)}


# ε*


def test_only_the_float_nearest_to_the_root_is_read_as_the_root():
    for mass in (0.5, 1.0, 3.7, 1.2345678):
        roller = UNIT_MASS_RATIO * mass
        assert is_unit_ratio(mass, roller)
        assert Numbers(mass, roller, 1.0).exact[m_prime].has(sp.sqrt(1729))
        for other in (roller * (1 + 1e-15), roller * (1 - 1e-15)):
            assert not is_unit_ratio(mass, other)
            assert Numbers(mass, other, 1.0).exact[m_prime].is_Rational


def test_only_the_root_is_called_in_step():
    step = ROUTES["euler_lagrange"]["root"]

    def lines(mass: float, roller: float) -> list[str]:
        return [row.latex for row in make_rows(step, Numbers(mass, roller, 10.0))]

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
    listed = "\n".join(nomenclature(ROUTES[name])).splitlines()
    for masses in (None, (1.85, 0.86, 33.5)):
        for step in ROUTES[name].steps:
            for row in make_rows(step, Numbers(*masses) if masses else None):
                left, right, *_decimal = sides(row.latex)
                for symbol in Formula(left).names + Formula(right).names:
                    assert letter_of(symbol) in listed, (step.key, symbol)


def letter_of(symbol: str) -> str:
    """Return the symbol that the list contains: the letter of a derivative, an inverse or a body's quantity."""
    letter = re.sub(r"\\d?dot\{(\\?\w+)\}", r"\1", symbol.removesuffix("^{-1}"))
    letter = re.sub(r"\\text\{(block|hoop|cylinder|slab|top)\}", r"\\text{body}", letter)
    return re.sub(r"\\omega_\{\d\}", r"\\omega", letter)
