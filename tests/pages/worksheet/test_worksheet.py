"""The worksheet: its answers by an independent method, its picture, and its key."""

import hashlib
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from ast import literal_eval
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from streamlit.testing.v1 import AppTest

from ramanujan import UNIT_MASS_RATIO, Oscillator, lesson, normalized_frequency_squared
from ramanujan.figures.still_machine import draw_svg
from ramanujan.lesson.worksheet import WorksheetQuestion, make_questions
from ramanujan.pages.worksheet import keys
from ramanujan.shell import address, theme
from tests.checks.browser import ROOT
from tests.checks.latex import Formula
from tests.checks.worksheets import MACHINES, key_of, name_of
from tests.settings import PATIENCE


def value(text: str, name: str) -> mpmath.mpf:
    """Return the value of a quantity, read from the LaTeX of an answer."""
    return number_of(re.search(rf"{re.escape(name)}=((?:[^$=\\]|\\(?!approx|,))+)", text)[1].strip())


@pytest.mark.parametrize("machine", MACHINES)
def test_the_key_and_each_line_of_its_working_give_the_core_s_numbers(machine):
    *_, ratio, frequency, effective_mass, faster_or_slower, _target = make_questions(machine, "1")
    squared = np.linalg.eigvals(np.linalg.solve(machine.mass_matrix, machine.stiffness_matrix)).real.max()
    answers = [
        (ratio, r"\varepsilon", machine.mass_ratio),
        (ratio, r"\Omega^2m/k", machine.normalized_frequency_squared),
        (frequency, r"\Omega^2", squared),
        (effective_mass, r"k/\Omega^2", machine.effective_mass),
    ]
    for question, name, expected in answers:
        assert float(value(question.answer, name)) == pytest.approx(expected, rel=1e-12)
    lines = [
        (ratio, 0, machine.mass_ratio),
        (ratio, 1, machine.normalized_frequency_squared),
        (frequency, 0, squared),
        (effective_mass, 0, machine.effective_mass),
        (effective_mass, 1, 3 * machine.m + 2 * machine.m_prime),
        (faster_or_slower, 0, machine.normalized_frequency_squared**0.5),
    ]
    for question, line, expected in lines:
        assert float(number_of(question.working[line].rsplit("=", 1)[1])) == pytest.approx(expected, rel=1e-12)
    # The period is rounded.
    period = 2 * np.pi / np.sqrt(squared)
    assert float(number_of(frequency.working[1].rsplit("=", 1)[1])) == pytest.approx(period, rel=1e-4)
    assert float(re.search(r"period is ([\d.]+)\u202fs", frequency.answer)[1]) == pytest.approx(period, rel=5e-4)
    exact = Fraction(repr(machine.m_prime / machine.m))
    faster = 0 if machine.mass_ratio == UNIT_MASS_RATIO else 24 - exact - 18 * exact**2
    assert faster_or_slower.answer.startswith("Neither" if faster == 0 else "Faster" if faster > 0 else "Slower")


def test_only_exact_decimals_have_an_equals_sign():
    shown = [
        re.search(r"m/k=(.*)\$", make_questions(Oscillator(1.0, m_prime, 10.0), "1")[-5].answer)[1]
        for m_prime in (5 / 6, 1.0, 62 / 55)
    ]
    assert shown == [r"\frac{9}{8} = 1.125", r"\frac{104}{99} \approx 1.0505", r"\frac{166540}{166541} \approx 0.99999"]


@pytest.mark.parametrize(("m_prime", "verdict"), [(1.12725682701621, "Faster"), (1.1272568270162111, "Slower")])
def test_the_key_names_the_faster_machine_near_the_unit_ratio(m_prime, verdict):
    """The float of Ω²m/k may round to 1, although the machine is not in step."""
    answer = make_questions(Oscillator(1.0, m_prime, 10.0), "1")[-2].answer
    assert answer.startswith(verdict)
    gap = float(18 * Fraction(repr(m_prime)) ** 2 + Fraction(repr(m_prime)) - 24)
    # To first order: Ω²m/k − 1 = −(18ε² + ε − 24)/(18ε² + 49ε + 32), and √(1 + δ) − 1 = δ/2.
    periods = 2 * (18 * m_prime**2 + 49 * m_prime + 32) / abs(gap)
    mantissa, exponent = re.search(r"after (\d\.\d+)×10([⁰¹²³⁴⁵⁶⁷⁸⁹]+)", answer).groups()
    power = int(exponent.translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")))
    assert float(mantissa) * 10**power == pytest.approx(periods, rel=6e-3)


def test_no_question_refers_to_an_earlier_stop():
    """A sheet contains four stops, so no question may refer to an earlier stop."""
    for stop in lesson.STOPS:
        assert not re.search(r"\b(again|so far|as before|earlier)\b|^Now\b", stop.question, re.IGNORECASE), stop.id


REVEALING_WORDS = {
    "two-clocks": r"equal masses the machine is|machine is a little (faster|slower)|light ones of|heavy ones of",
    "light-rollers": r"heavy ones of|rollers five times as heavy|heavier the",
    "heavy-rollers": r"light ones of|rollers five times as heavy|heavier the",
    "stiffness": r"k drops out",
    "radius": r"R drops out",
    "block": r"block (moves|is displaced by X) to the left",
    "turning-point": r"the spring is relaxed, and all energy is kinetic",
    "middle": r"Where is the energy then",
    "zero-modes": r"two zero modes|rolls freely for ever",
    "contact": r"the hoop slips",
    # The masses of this stop lie in one of its intervals.
    "by-hand": r"√1729 − 1\)/\u2060?36|1\.127\skg",
    "1729": r"4·18·24",
    "steps": r"explicit Euler adds",
}


def test_no_question_answers_another():
    """Check the sentences and options of all questions on three hundred sheets."""
    stops = {stop.question: stop.id for stop in lesson.STOPS}
    for seed in range(300):
        questions = make_questions(Oscillator(), str(seed))
        for question in questions:
            pattern = REVEALING_WORDS.get(stops.get(question.text))
            others = [other for other in questions if other is not question]
            texts = " ".join(" ".join((other.text, *other.options)) for other in others)
            assert not (pattern and re.search(pattern, texts)), (seed, question.text)


@pytest.fixture(scope="module")
def levels() -> tuple[list[WorksheetQuestion], ...]:
    """The questions without options of a sheet, for each level."""
    sheets = (make_questions(Oscillator(), "1", level) for level in (1, 2, 3))
    return tuple([question for question in sheet if not question.options] for sheet in sheets)


CALCULATIONS = 5
"""Number of calculations after the steps of the derivation."""


def test_a_higher_level_leaves_more_of_the_derivation_blank(levels):
    """Level 1 has one gap in a step, level 2 one in each equation, and level 3 no equations. The answers are equal."""
    easy, medium, hard = (sheet[:-CALCULATIONS] for sheet in levels)
    assert len(easy) >= 5
    for first, second, third in zip(easy, medium, hard, strict=True):
        assert first.answer == second.answer == third.answer
        equations = first.answer.count("$$") // 2
        assert first.blanks.count("ldots") == 1
        assert second.blanks.count("ldots") == equations >= 1
        assert not third.blanks
        # The text does not contain the equation that the student must fill in.
        missing = first.answer.rsplit("$$", 2)[1]
        assert missing not in first.text + first.blanks
        assert missing not in second.text + second.blanks
    for sheet in levels:
        assert "$U$ as a function of the compression $x$ first, then of $\\varphi$" in sheet[2].text


def test_a_longer_answer_has_more_lines_and_points(levels):
    easy, medium, hard = levels
    for question in hard[:-CALCULATIONS]:
        assert 0 <= question.space - len(question.answer) / 90 <= 2
    for question in hard:
        assert question.points == question.space // 2
    assert sum(question.space for question in easy) < sum(question.space for question in medium)


def test_the_key_of_the_derivation_ends_in_the_frequency(levels):
    """Evaluate Ω² for masses that occur in no step."""
    last_step = levels[0][-CALCULATIONS - 1]
    m, m_prime, k = 1.3, 0.7, 21.0
    right = last_step.answer.rsplit("=", 1)[1].removesuffix("}$$")
    expected = Oscillator(m, m_prime, k).natural_frequency_squared
    assert float(number_of(right, **{"m'": m_prime, "m": m, "k": k})) == pytest.approx(expected, rel=1e-12)


SPACES = """
from tests.checks.worksheets import MACHINES
from ramanujan.lesson.worksheet import make_questions
sheets = [make_questions(machine, seed, level) for level in (1, 2, 3) for machine in MACHINES for seed in "12"]
print([[question.space for question in sheet] for sheet in sheets])
"""


def test_points_and_lines_are_the_same_in_every_language_and_for_every_machine():
    sheets = set()
    for language in ("en", "de"):  # German has longer words
        environment = os.environ | {"RAMANUJAN_LANGUAGE": language}
        command = [sys.executable, "-c", SPACES]
        result = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, check=True)
        sheets.add(result.stdout)
    (spaces,) = map(literal_eval, map(bytes.decode, sheets))
    sheets_of_level = 2 * len(MACHINES)
    for start in range(0, len(spaces), sheets_of_level):
        assert len(set(map(tuple, spaces[start : start + sheets_of_level]))) == 1
    # The calculations with the longest numbers fit their lines.
    for machine in MACHINES:
        for question in make_questions(machine, "1")[-CALCULATIONS:]:
            assert question.space >= sum(map(len, (*question.working, question.answer))) / 90


def number_of(latex: str, **values: float) -> mpmath.mpf:
    """Return the value of an expression in LaTeX, without its unit."""
    # The parser reads \, as a multiplication sign.
    plain = re.sub(r"\\[,;]\\mathrm\{.*\}$", "", latex).replace(r"\pi", r"\,\pi")
    return Formula(plain).value({r"\pi": mpmath.pi, **values})


@pytest.mark.parametrize("seed", list("1234"))
def test_the_ratio_in_the_key_gives_the_requested_frequency(seed):
    *_, last = make_questions(Oscillator(), seed)
    requested = sp.Rational(re.search(r"m/k=(\d+/\d+)", last.text)[1])
    exact = number_of(re.search(r"so \$\\varepsilon=(\\frac\{.*?\}\{\d+\})", last.answer)[1])
    assert normalized_frequency_squared(float(exact)) == pytest.approx(float(requested), rel=1e-12)
    # Set the frequency equal to the target. The discriminant is that of 18wε² + (49w − 48)ε + 32w − 56.
    frequency, target = last.working[0].rsplit("=", 1)
    assert float(number_of(target)) == float(requested)
    assert float(number_of(frequency, **{r"\varepsilon": float(exact)})) == pytest.approx(float(requested), rel=1e-12)
    _name, put_in, discriminant = last.working[1].split("=")
    assert number_of(put_in) == number_of(discriminant)
    a, b, c = 18 * requested, 49 * requested - 48, 32 * requested - 56
    assert sp.sqrt(int(number_of(discriminant)) / (b * b - 4 * a * c)).is_rational


def test_the_letters_of_the_key_name_the_right_options():
    stops = {stop.question: stop for stop in lesson.STOPS}
    letters = set()
    for seed in range(30):
        for question in make_questions(Oscillator(), str(seed)):
            if question.options:
                stop = stops[question.text]
                letter = re.match(r"\*\*(\w)\.\*\*", question.answer)[1]
                assert f"{letter}. {stop.options[stop.answer()]}" in question.options
                assert len(question.options) == len(stop.options)
                letters.add((stop.id, letter))
    # The seed shuffles the options, so the letter of a right option varies.
    assert len(letters) > 1.5 * len({name for name, _ in letters})


def test_a_seed_determines_the_worksheet():
    machine = Oscillator()
    assert make_questions(machine, "a") == make_questions(machine, "a")
    assert len({make_questions(machine, str(seed)) for seed in range(10)}) > 5


@pytest.mark.parametrize("radius", [0.05, 0.1, 0.2])
def test_the_picture_is_to_scale(radius):
    """Compare a roller's diameter and the compression of the spring with the machine."""
    root = ET.fromstring(draw_svg(Oscillator(radius=radius), 0.08, theme.paper_colors()))
    paths = {path.get("data-body"): path.get("d") for path in root.iter("{http://www.w3.org/2000/svg}path")}
    assert {"block", "hoop", "cylinder", "slab", "top"} <= paths.keys()
    down = [float(arc.split()[-1]) for arc in paths["top"].strip("z").split("a")[1:]]
    assert down == [pytest.approx(200 * radius), pytest.approx(-200 * radius)]
    # The slab touches the lower rollers: its lower side is at their highest point.
    slab = re.match(r"M(-?[\d.]+) (-?[\d.]+)", paths["slab"])
    hoop = re.match(r"M(-?[\d.]+) (-?[\d.]+)", paths["hoop"])
    assert float(slab[2]) == pytest.approx(float(hoop[2]), abs=1e-3)


def sheet(**query: str) -> AppTest:
    app = AppTest.from_file(str(ROOT / "app.py"), default_timeout=PATIENCE)
    app.run()
    app.query_params.update(query)
    return app.switch_page("ramanujan/pages/worksheet/page.py").run()


def test_questions_show_no_answer_and_the_key_shows_all():
    name = name_of(5)
    blank = "\n".join(text.value for text in sheet(seed=name).markdown)
    app = sheet(seed=name, paper="key", key=key_of(5))
    key = "\n".join(text.value for text in app.markdown)
    for question in make_questions(Oscillator(k=10.0), name):
        assert question.text in blank
        assert question.blanks in blank
        assert question.text in key
        assert question.answer in key
        assert question.answer not in blank
        assert all(line in key for line in question.working)
    assert "mass ratio is $\\varepsilon=m'/m$" in blank
    # Only the key of a sheet opens its answers.
    typed = f" {name_of(6)[:5].lower()}-{name_of(6)[5:]}"
    other = app.text_input(key="worksheet_name").set_value(typed).run()
    assert other.query_params["seed"] == name_of(6)
    without_key, with_wrong_key = sheet(seed=name, paper="key"), sheet(seed=name, paper="key", key=key_of(6))
    for closed in (other, without_key, with_wrong_key):
        assert closed.title[0].value.startswith("Ramanujan’s oscillator: worksheet")
        assert "paper" not in {chips.key for chips in closed.button_group}


def test_the_author_of_a_worksheet_has_its_key():
    app = sheet()
    [new_worksheet] = [button for button in app.button if button.label == "New worksheet with its key"]
    author = new_worksheet.click().run()
    name, key = author.query_params["seed"], author.query_params["key"]
    assert keys.name(key) == name
    spaced_name = f"{name[:5]} {name[5:]}"
    sheets = {"worksheet": author, "key": sheet(seed=name, paper="key", key=key)}
    for kind, opened in sheets.items():
        assert opened.title[0].value == f"Ramanujan’s oscillator: {kind}"
        assert f"Name of this worksheet: {spaced_name}." in "".join(caption.value for caption in opened.caption)
    assert "key" in address.PRIVATE


def test_an_invalid_name_gets_a_sentence_and_preserves_the_worksheet():
    app = sheet(seed=name_of(5))
    app.text_input(key="worksheet_name").set_value("<b>1729</b>").run()
    assert app.query_params["seed"] == name_of(5)
    assert [warning.value for warning in app.warning] == [
        "A worksheet’s name has 10 letters, all from BCDFHJKLMNPRSTWXZ. The old name was kept."
    ]


def test_a_name_does_not_reveal_its_key():
    """Names have at least 40 bits, and the hash is slow: scrypt uses 16 MB for each key."""
    names = {name_of(number) for number in range(12)}
    assert len(names) == 12
    assert len(keys.ALPHABET) ** len(names.pop()) > 2**40
    with pytest.MonkeyPatch.context() as patch:
        memory = []
        patch.setattr(hashlib, "scrypt", lambda *_, n, r, **__: memory.append(128 * n * r) or bytes(64))
        keys.name(key_of(1729))
    assert min(memory) >= 2**24


def test_the_key_calculates_with_the_typed_masses():
    questions = make_questions(Oscillator(1.56, 1.08, 7.5), "1")
    calculations = [question for question in questions if question.working]
    assert calculations[0].working[0] == r"\varepsilon=\frac{m'}{m}=\frac{1.08}{1.56}=\frac{9}{13}"
