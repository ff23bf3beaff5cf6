"""The lesson: independent computations of the answers, and solved and failed attempts at every task."""

import itertools
import math
import random
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, partial
from operator import itemgetter
from typing import NamedTuple

import mpmath
import numpy as np
import pytest
from scipy.linalg import expm

from ramanujan import UNIT_MASS_RATIO, Oscillator, lesson
from ramanujan.lesson import Attempt, clocks, computing, directions, modes
from tests.checks.reference import matrices

M, K, R = 1.0, 10.0, 0.1


def eigenvalues(m=M, m_prime=1.0, k=K, radius=R, top=0.5) -> np.ndarray:
    mass, stiffness = map(np.array, matrices(m, m_prime, k, radius, top))
    return np.sort(np.linalg.eigvals(np.linalg.solve(mass, stiffness)).real)


def normalized(**machine) -> float:
    return eigenvalues(**machine)[-1] * machine.get("m", M) / machine.get("k", K)


class State(NamedTuple):
    """Coordinates and rates of a machine."""

    X: float
    phi: float
    Phi: float
    X_dot: float
    phi_dot: float
    Phi_dot: float


@dataclass(frozen=True)
class Release:
    """The motion of a released machine: its state at a time, by a matrix exponential, and its half period."""

    state: Callable[[float], State]
    half_period: float


@cache
def release(x0=0.08) -> Release:
    """Return the motion of the released machine with equal masses."""
    mass, stiffness = map(np.array, matrices(M, 1.0, K, R))
    rates = np.block([[np.zeros((3, 3)), np.eye(3)], [-np.linalg.solve(mass, stiffness), np.zeros((3, 3))]])
    start = [0, x0 / (2 * R), 0, 0, 0, 0]
    return Release(lambda t: State(*expm(rates * t) @ start), math.pi / math.sqrt(eigenvalues()[-1]))


def kinetic(state: State) -> dict[str, float]:
    """Return the kinetic energy of each body, from velocities relative to the ground."""
    X, phi, Phi = state.X_dot, state.phi_dot, state.Phi_dot
    v = {"block": -X, "hoop": R * phi - X, "slab": 2 * R * phi - X, "top": R * Phi - X}
    spin = {"hoop": 0.5 * (R * phi) ** 2, "top": 0.25 * (R * Phi) ** 2}
    return {body: 0.5 * x**2 + spin.get(body, 0.0) for body, x in v.items()}


def turns_gained(**machine) -> float:
    """Return the turns by which the machine is ahead of the plain mass after its ten periods."""
    return 10 * (math.sqrt(normalized(**machine)) - 1)


def root(**machine) -> mpmath.mpf:
    """Return ε for Ω² = k/m, from det(K − M) = 0 with m = k = R = 1, to 40 digits."""

    def condition(ratio):
        mass, stiffness = matrices(1, ratio, 1, 1, **machine)
        return mpmath.det(mpmath.matrix(stiffness) - mpmath.matrix(mass))

    with mpmath.workdps(40):
        return mpmath.findroot(condition, (mpmath.mpf("1.1"), mpmath.mpf("1.2")))


def brackets(label: str) -> tuple[float, float]:
    low, high = re.findall(r"[\d.]+", label)
    return float(low), float(high)


def fractions(label: str) -> list[Fraction]:
    """Return the numbers of an option, such as 9/8 and 1.127."""
    return [Fraction(text) for text in re.findall(r"\d+(?:[./]\d+)?", label.replace("\u2060", ""))]


def is_a_fraction(ratio: mpmath.mpf) -> bool:
    """Return whether a small denominator makes this number whole."""
    return min(abs(ratio * n - mpmath.nint(ratio * n)) for n in range(1, 2000)) < 1e-20


TILT = 0.08 / 0.29
"""The displaced slab loads its two rollers by (1 ± TILT)/2 of its weight: x₀ over the distance of the axes."""


def friction() -> dict[str, float]:
    """Return the required static friction for ε = 1 and a slab midway between axes 29 cm apart."""
    D, u = 18 + 49 + 32, K * 0.04 / 9.81
    return {
        "hoop_slab": 16 * 7 / D * u / (1 - TILT),
        "cylinder_slab": 12 * 5 / D * u / (1 - TILT),
        "hoop_block": 24 * 2 / D * u / (1.5 - TILT / 2),
        "cylinder_block": 2 * 11 / D * u / (1.5 - TILT / 2),
        "top_block": 16 * 2 / D * u,
    }


def run_energies(periods=20) -> tuple[float, float]:
    """Return the energy ratios after explicit Euler with 1000 and velocity Verlet with 10 steps per period."""
    growth = 1 + (2 * math.pi / 1000) ** 2
    h = 2 * math.pi / 10
    kick, drift = np.array([[1, 0], [-h / 2, 1]]), np.array([[1, h], [0, 1]])
    end = np.linalg.matrix_power(kick @ drift @ kick, 10 * periods)[:, 0]
    return growth ** (1000 * periods), end @ end


def paper_formula(m, m_prime, k):
    with np.errstate(all="ignore"):
        m, m_prime, k = map(np.float64, (m, m_prime, k))
        return 8 * k / (7 * m_prime + 8 * m - 8 * (m_prime + m) ** 2 / (7 * m / 3 + 2 * m_prime))


def option_if(condition: bool, option: str) -> str:
    """Return an option, or "?" if the computation contradicts it."""
    return option if condition else "?"


def expected_of_clocks() -> dict[str, str]:
    stiff_is_same = math.isclose(normalized(k=40.0), normalized(), rel_tol=1e-9)
    large_is_same = math.isclose(eigenvalues(radius=0.2)[-1], eigenvalues()[-1], rel_tol=1e-9)
    return {
        "two-clocks": option_if(0 < turns_gained() < 1, "ahead"),
        "light-rollers": option_if(normalized(m_prime=0.1) > normalized(), "rises"),
        "heavy-rollers": option_if(turns_gained(m_prime=5.0) < 0, "plain"),
        "stiffness": option_if(stiff_is_same, "same"),
        "radius": option_if(large_is_same, "same"),
    }


def expected_of_bodies() -> dict[str, str]:
    motion = release()
    start, end = motion.state(0), motion.state(motion.half_period)
    middle = motion.state(0.5 * motion.half_period)
    assert middle.phi_dot < 0, "the slab moves to the left, through the middle"
    path_of_centres = abs((R * end.phi - end.X) - R * start.phi)
    spring_energy = 2 * K * (R * end.phi) ** 2
    energies = kinetic(middle)
    return {
        "block": option_if(middle.X_dot < 0, "opposite"),  # X is positive to the left
        "rollers": option_if(path_of_centres < 0.1 * 0.08, "tenth"),
        "turning-point": option_if(math.isclose(spring_energy, K * 0.08**2 / 2, rel_tol=1e-6), "spring"),
        "middle": max(energies, key=energies.get),
    }


def expected_of_modes() -> dict[str, str]:
    zero_modes = int((abs(eigenvalues()) < 1e-9).sum())
    required = friction()
    return {"zero-modes": option_if(zero_modes == 2, "two"), "contact": max(required, key=required.get)}


def expected_of_ratio() -> dict[str, str]:
    exact, sphere = root(), root(top=0.4)
    intervals = {option: brackets(label) for option, label in lesson.find_stop("by-hand").options.items()}
    [by_hand] = [option for option, (low, high) in intervals.items() if low < exact < high]
    masses = {option: fractions(label) for option, label in lesson.find_stop("exactly").options.items()}
    assert not any(abs(float(mass) - float(exact)) < 1e-6 for mass in itertools.chain(*masses.values()))
    [without_number] = [option for option, numbers in masses.items() if not numbers]
    first_cubes, second_cubes = [(x, y) for x in range(1, 13) for y in range(x, 13) if x**3 + y**3 == 1729]
    terms = (1**2, 4 * 18 * 24)  # b² and −4ac
    x, y = lesson.find_stop("1729").question_numbers["norm"]
    assert x * x + 3 * y * y == 1729
    only_first_has_terms = first_cubes == (1, 12) and terms == (1**3, 12**3) and 1 not in second_cubes
    distance_to_fraction = min(abs(sphere * n - round(sphere * n)) for n in range(1, 500))
    return {
        "by-hand": by_hand,
        "exactly": option_if(not is_a_fraction(exact), without_number),
        "1729": option_if(only_first_has_terms, "first"),
        "other-body": option_if(abs(sphere - exact) > 1e-3 and distance_to_fraction > 1e-9, "another"),
    }


def expected_of_computing() -> dict[str, str]:
    euler, verlet = run_energies()
    return {
        "steps": option_if(abs(euler - 1) > 2 * abs(verlet - 1), "euler"),
        "huge-ratio": option_if(paper_formula(1.0, 1e200, 1.0) == 0, "zero"),
    }


@cache
def expected() -> dict[str, str]:
    """Return the right option of every stop, computed without the package."""
    chapters = (expected_of_clocks, expected_of_bodies, expected_of_modes, expected_of_ratio, expected_of_computing)
    return {stop: option for chapter in chapters for stop, option in chapter().items()}


# Stops


@pytest.mark.parametrize("name", [stop.id for stop in lesson.STOPS])
def test_answer_agrees_with_an_independent_computation(name):
    assert lesson.find_stop(name).answer() == expected()[name]


def test_a_stop_is_complete_and_its_right_option_has_no_fixed_place():
    places = []
    for stop in lesson.STOPS:
        names = list(stop.options)
        assert re.fullmatch(r"[a-z0-9-]+", stop.id)
        assert all(re.fullmatch(r"[a-z_]+", name) for name in names)
        assert len(set(names)) == len(names) >= 3
        places.append(names.index(stop.answer()) + 1)
        assert re.search(r"\d|\btwo\b", stop.explanation())
        assert stop.hints
        assert stop.question.rstrip("?.") != stop.question
    assert {1, 2, 3, 4} == set(places)
    assert max(map(places.count, places)) <= len(places) / 2
    assert len({stop.id for stop in lesson.STOPS}) == len(lesson.STOPS) >= 12
    assert 40 <= sum(stop.minutes for stop in lesson.STOPS) <= 50


@pytest.mark.parametrize("entry", [*lesson.STOPS, *lesson.TASKS], ids=lambda entry: entry.id)
def test_questions_and_hints_do_not_contain_the_explanation(entry):
    texts = " ".join([entry.heading, *entry.hints, getattr(entry, "question", ""), getattr(entry, "text", "")])
    if isinstance(entry, lesson.Stop):
        assert not set(re.split(r"(?<=[.?!]) ", entry.explanation())) & set(re.split(r"(?<=[.?!]) ", texts))
    longest = max(len(sentence.split()) for sentence in re.split(r"(?<=[.?!:]) ", texts))
    assert longest <= 26


@pytest.mark.parametrize(
    ("module", "name", "machine", "stop", "answer"),
    [
        (clocks, "EQUAL", Oscillator(m=1.0, m_prime=1.5), "two-clocks", "behind"),
        (clocks, "LIGHT", Oscillator(m=1.0, m_prime=2.0), "light-rollers", "falls"),
        (clocks, "LARGE", Oscillator(m=1.0, m_prime=1.0, k=5.0), "radius", "longer"),
        (modes, "EQUAL", Oscillator(m=1.0, m_prime=0.1, k=10.0), "contact", "top_block"),
        (directions, "EQUAL", Oscillator(m=1.0, m_prime=0.1, k=10.0), "middle", "slab"),
    ],
)
def test_the_answer_depends_on_the_machine(monkeypatch, module, name, machine, stop, answer):
    monkeypatch.setattr(module, name, machine)
    assert lesson.find_stop(stop).answer() == answer


def test_the_explanations_quote_the_right_numbers():
    def explanation(name):
        return lesson.find_stop(name).explanation()

    assert f"{turns_gained():.2f} of a full turn" in explanation("two-clocks")
    assert f"{1 / normalized():.3f}" in explanation("two-clocks")
    assert f"{normalized(m_prime=0.1):.3f}" in explanation("light-rollers")
    assert f"{-turns_gained(m_prime=5.0):.2f} full turns" in explanation("heavy-rollers")
    assert f"{mpmath.nstr(root(), 7)}" in explanation("exactly")
    assert f"{float(root(top=0.4)):.3f}" in explanation("other-body")
    assert "48" in explanation("other-body")
    middle = kinetic(release().state(release().half_period / 2))
    assert f"{100 * middle['slab'] / (K * 0.08**2 / 2):.0f}\u202f%" in explanation("middle")
    needed = sorted(friction().values())
    assert f"{needed[-1]:.4f}" in explanation("contact")
    assert f"{needed[-2]:.4f}" in explanation("contact")
    assert f"{run_energies()[0]:.1f}" in explanation("steps")
    with mpmath.workdps(30):
        huge = mpmath.mpf(8) * 6 * mpmath.mpf(10) ** 200 / (18 * mpmath.mpf(10) ** 400)
    assert mpmath.nstr(huge * mpmath.mpf(10) ** 200, 3) in explanation("huge-ratio")
    # The machine of this stop has heavy rollers, shows its masses, and does not move.
    [run] = lesson.find_stop("huge-ratio").runs
    assert "10²⁰⁰ kg" in run.label
    assert run.machine.period > 1e40


def test_a_sampled_motion_has_equidistant_states_of_the_run():
    for method, steps in computing.STEPS_PER_PERIOD.items():
        shown = computing.sample_history(method)
        q = computing.compute_history(method).q
        assert np.allclose(shown["q"], q[:: steps // shown["per_period"]], rtol=0, atol=1e-5)
        assert len(shown["q"]) <= 1100


def test_every_wrong_option_has_a_reply_that_ends_in_a_question():
    for stop in lesson.STOPS:
        right = stop.answer()
        replies = {option: stop.reply(option) for option in stop.options if option != right}
        assert all(reply.endswith("?") for reply in replies.values())
        assert len(set(replies.values())) == len(replies)
        # A reply does not reveal the right option.
        assert not any(stop.options[right].rstrip(".") in reply for reply in replies.values())


def test_the_replies_are_computed_for_this_machine():
    def reply_to(stop, option):
        return lesson.find_stop(stop).reply(option).replace("\u202f", " ")

    # The first stop speaks of turns; Ω²m/k comes later.
    assert f"{10 * (1 - 5**-0.5):.1f} turns behind" in reply_to("two-clocks", "far_behind")
    for option in ("behind", "together"):
        assert f"makes {1 + turns_gained() / 10:.3f} turns" in reply_to("two-clocks", option)
    # The equation with the candidate inserted, and the two frequencies.
    for option in ("eighths", "decimal"):
        [x] = fractions(lesson.find_stop("exactly").options[option])
        assert f"{float(18 * x**2 + x - 24):.3g}".replace("-", "−") in reply_to("exactly", option)
        periods = 1 / abs(math.sqrt(normalized(m_prime=float(x))) - 1)
        number = re.search(r"After (\d+(?: \d+)?) periods", reply_to("exactly", option))[1]
        assert float(number.replace(" ", "")) == pytest.approx(periods, rel=3e-3)
    low, high = fractions(lesson.find_stop("exactly").options["several"])
    assert f"{normalized(m_prime=float(low)):.5g}" in reply_to("exactly", "several")
    assert f"{normalized(m_prime=float(high)):.5g}" in reply_to("exactly", "several")
    # Below this ratio, the top cylinder slips first.
    light = float(re.search(r"ε were less than (\d+\.\d+)", reply_to("contact", "top_block"))[1])
    for ratio, first in ((light - 0.02, "top"), (light + 0.02, "hoop")):
        needed = {"hoop": 16 * ratio * (3 * ratio + 4) / (1 - TILT), "top": 16 * (1 + ratio)}
        assert max(needed, key=needed.get) == first
    assert "0.0132" in reply_to("contact", "top_block")
    end = release().state(release().half_period)
    assert f"{100 * abs(end.X):.2f} cm" in reply_to("rollers", "all")
    load = 0.5 * (1 - TILT)
    assert f"{100 * load:.0f}\u202f%" in lesson.find_stop("contact").explanation()


def test_the_program_of_the_last_stop_is_the_formula_of_the_question():
    formula = re.search(r"console.log\((.*)\);", computing.program_text(), re.DOTALL)[1].strip()
    for m, m_prime, k in ((1.0, 2.0, 3.0), (4.0, 0.5, 7.0), (1.0, 1e200, 1.0)):
        with np.errstate(all="ignore"):
            values = {"m": np.float64(m), "M": np.float64(m_prime), "k": np.float64(k)}
            assert eval(formula, {}, values) == paper_formula(m, m_prime, k)


MODERATE = re.compile(r"\b(same|stays?|exactly|neither|both|about|half|none of)\b", re.IGNORECASE)
REASON = re.compile(r"[:;]|\b(because|since|so that|without|drives|carries)\b")
WRITTEN = re.compile(r"\d|\b(one|two|three|half|tenth|first|second|zero)\b")


def choose_by_length(choose, options):
    length = choose(len(label) for _id, label in options)
    return [(id, label) for id, label in options if len(label) == length]


def choose_by_words(pattern, is_wanted, options):
    chosen = [(id, label) for id, label in options if bool(pattern.search(label)) == is_wanted]
    return chosen or options


def choose_middle(options):
    return options[(len(options) - 1) // 2 : len(options) // 2 + 1]


STRATEGIES = {
    "the longest": partial(choose_by_length, max),
    "the shortest": partial(choose_by_length, min),
    "with a reason": partial(choose_by_words, REASON, True),
    "without a reason": partial(choose_by_words, REASON, False),
    "with a number": partial(choose_by_words, WRITTEN, True),
    "without a number": partial(choose_by_words, WRITTEN, False),
    "the first": itemgetter(slice(1)),
    "the last": itemgetter(slice(-1, None)),
    "the most moderate": partial(choose_by_words, MODERATE, True),
    "in the middle": choose_middle,
}


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_options_do_not_reveal_the_right_one(strategy):
    """A strategy based on the form of the options, with random choice among equals, scores as by chance."""

    answers = {stop.id: stop.answer() for stop in lesson.STOPS}

    def right(options, stop):
        chosen = STRATEGIES[strategy](options)
        return sum(option == answers[stop.id] for option, _label in chosen) / len(chosen)

    chance = sum(1 / len(stop.options) for stop in lesson.STOPS)
    assert sum(right(list(stop.options.items()), stop) for stop in lesson.STOPS) <= chance + 2
    # The paper shows the options as drawings.
    draw = random.Random(1)
    repetitions, score = 200, 0.0
    for _repetition in range(repetitions):
        for stop in lesson.STOPS:
            shuffled = draw.sample(list(stop.options.items()), len(stop.options))
            score += right(shuffled, stop)
    assert score / repetitions <= chance + 2


# Tasks


def attempt(ratio=1.0, m=1.0, k=K, **others) -> Attempt:
    return Attempt(machine=Oscillator(m=m, m_prime=ratio * m, k=k), **others)


TWO_SECONDS = attempt(k=K * (math.sqrt(1 / eigenvalues()[-1]) * math.pi) ** 2)
SOLVED = {
    "in-step": attempt(1.1275),
    "by-ear": attempt(1.11),
    "nine-eighths": attempt(5 / 6),
    "two-seconds": TWO_SECONDS,
    "parting": attempt(0.6685),
    "half-way": attempt(20.0, m=0.5),
    "no-slip": attempt(k=100.0, compression=0.0235),
    "top-at-rest": attempt(release=0.0, glide=-0.1, spin=1.0),
    "half-energy": attempt(part=3 / 8),
    "period": attempt(seconds=10 * 2 * math.pi / math.sqrt(eigenvalues()[-1]) * 1.008),
    "exact-ratio": attempt(formula="48/(1+√1729)"),
    "cheapest": attempt(method="rk4", steps=14),
    "two-cubes": attempt(bodies=("sphere", "sphere", "shell")),
}
MISSED = {
    "in-step": [attempt(1.13), attempt(1.12)],
    "by-ear": [attempt(1.1), attempt(1.155)],
    "nine-eighths": [attempt(0.83), attempt(0.8333333)],
    "two-seconds": [replace(TWO_SECONDS, machine=replace(TWO_SECONDS.machine, k=TWO_SECONDS.machine.k * 1.01))],
    "parting": [attempt(UNIT_MASS_RATIO), attempt(0.6)],
    "half-way": [attempt(10.0)],
    "no-slip": [attempt(k=100.0, compression=0.022), attempt(k=100.0, compression=0.025)],
    "top-at-rest": [attempt(release=0.01, glide=-0.1, spin=1.0), attempt(release=0.0, glide=-0.1, spin=-1.0)],
    "half-energy": [attempt(part=0.25), attempt(part=0.11), attempt(part=-1.0), attempt(part=math.inf)],
    "period": [attempt(seconds=19.0), attempt(seconds=-1.0), attempt(k=200.0, seconds=4.3)],
    "exact-ratio": [attempt(formula="1.127"), attempt(formula="(√1729+1)/36"), attempt(formula="import os")],
    "cheapest": [attempt(method="rk4", steps=13), attempt(method="yoshida6", steps=10), attempt(steps=192)],
    "two-cubes": [attempt(bodies=("cylinder", "hoop", "cylinder")), attempt(bodies=("hoop", "hoop", "hoop"))],
}
"""Attempts that nearly solve a task. test_scene_lesson.py checks that new pages show no solved task."""


@pytest.mark.parametrize("name", [task.id for task in lesson.TASKS])
def test_every_task_can_be_done_and_missed(name):
    judge = lesson.find_task(name).judge
    verdict = judge(SOLVED[name])
    assert verdict.is_done, verdict.sentence
    for missed in MISSED[name]:
        verdict = judge(missed)
        assert not verdict.is_done
        assert verdict.sentence.endswith((".", "?"))


def test_a_negligible_share_of_energy_is_called_none():
    sentence = lesson.find_task("half-energy").judge(attempt(part=1 / 4)).sentence
    assert sentence.startswith("At that moment the spring holds none of the energy.")


def test_verdict_contains_the_distance_from_the_goal():
    def sentence(name, **values):
        return lesson.find_task(name).judge(attempt(**values)).sentence

    off = normalized(m_prime=1.2) - 1
    assert off < 0
    assert f"too slow by {-off:.3f}" in sentence("in-step", ratio=1.2)
    gained = math.sqrt(normalized(m_prime=0.5)) - 1
    assert f"{1 / gained:.2f}" in sentence("parting", ratio=0.5)
    assert "0.5" in sentence("half-energy", part=0.12) or "%" in sentence("half-energy", part=0.12)
    # 54 % of x₀ against 50 %.
    assert "7.7\u202f% farther" in sentence("half-way")
    # An angle counts no whole turns, so an error of more than half a turn has no number.
    assert "at least half a turn off" in sentence("cheapest", method="explicit_euler", steps=30)
    assert "up to 0.13 of a turn" in sentence("cheapest", method="velocity_verlet", steps=20)


DIRECTIONS = {r"\bapart\b": 1, r"\b(towards|together|meet)\b": -1}
"""Words of a sentence on two bodies → the sign of the change of their distance."""


def test_every_sentence_states_the_true_direction_of_slab_and_block():
    """Compute the motion until the spring is relaxed by a matrix exponential, for light and heavy rollers."""
    motion = release()
    changes = []
    for part in (0.1, 0.3, 0.49):
        state = motion.state(part * motion.half_period)
        block, slab = -state.X_dot, 2 * R * state.phi_dot - state.X_dot
        # The block is to the right of the slab, with the spring between them.
        changes.append(block - slab)
    assert len(set(map(np.sign, changes))) == 1
    texts = [text for task in lesson.TASKS for text in (task.heading, task.text, *task.hints)]
    attempts = (SOLVED["half-way"], *MISSED["half-way"])
    texts += [lesson.find_task("half-way").judge(tried).sentence for tried in attempts]
    stated = set()
    for sentence in re.split(r"(?<=[.?!]) ", " ".join(texts)):
        is_on_both = {"slab", "block"} <= set(re.findall(r"\w+", sentence.lower()))
        if is_on_both:
            stated |= {sign for words, sign in DIRECTIONS.items() if re.search(words, sentence, re.IGNORECASE)}
    assert stated == {np.sign(changes[0])}


def test_the_verdict_states_the_true_displacements():
    motion = release()
    start, middle = motion.state(0), motion.state(motion.half_period / 2)
    block = abs(middle.X - start.X)
    slab = abs(2 * R * (middle.phi - start.phi) - (middle.X - start.X))
    sentence = lesson.find_task("half-way").judge(attempt()).sentence
    assert f"covers {100 * slab / 0.08:.2f}\u202f% of x₀, the block {100 * block / 0.08:.2f}\u202f%" in sentence


def test_the_short_lesson_states_the_equation_before_its_root():
    """The short lesson does not contain the stop that solves the equation."""
    texts = [(stop.question, stop.exhibit) for stop in lesson.STOPS if stop.is_in_short_lesson]
    [(question, exhibit)] = [(question, exhibit) for question, exhibit in texts if "√1729" in question]
    a, b, c = re.search(r"(\d+)ε² \+ (\d*)ε − (\d+) = 0", question.replace("\xa0", " ")).groups()
    assert abs(int(a) * root() ** 2 + int(b or 1) * root() - int(c)) < 1e-12
    assert question.index("ε²") < question.index("√1729")
    # The condition that leads to the equation, in words and as a formula.
    assert re.search(r"Ω²\s=\sk/m leads to", question)
    assert r"\Omega^2m" in exhibit


def test_no_reply_contains_the_requested_number():
    stop = lesson.find_stop("other-body")
    number = round(float((6 * root(top=0.4)) ** 2))  # ε = √n/6
    assert all(str(number) not in stop.reply(option) for option in stop.options if option != stop.answer())


def test_last_stop_quotes_the_output_of_its_program():
    value = paper_formula(1.0, 1e200, 1.0)
    assert value == 0
    assert math.copysign(1, value) == -1
    stop = lesson.find_stop("huge-ratio")
    assert "−0" in stop.explanation()
    assert computing.program_text() in stop.outcome
    assert "\n// -0\n" in stop.outcome
    assert "-0\n" not in stop.exhibit


def test_the_hints_on_other_bodies_are_true():
    from ramanujan.number_theory import machines

    others = [m for m in machines() if m.cubes and m.discriminant != 1729]
    assert all("shell" in m.bodies for m in others)
    assert any(m.bodies[:2] == ("sphere", "sphere") for m in others)
    assert "denominator 6" in lesson.find_task("nine-eighths").hints[-1]
