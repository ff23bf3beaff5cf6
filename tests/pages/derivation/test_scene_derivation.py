"""Page 2 under AppTest: every route in both views, and a student's input."""

import json
import re
from fractions import Fraction

import pytest
import sympy as sp

from ramanujan.answers import QUESTIONS, find_question
from ramanujan.browser import stage
from ramanujan.derivation import ROUTES, energy_conservation
from ramanujan.derivation.lagrangian import terms_by_part
from ramanujan.derivation.model import machine
from ramanujan.derivation.numbers import Numbers
from ramanujan.derivation.printers import latex
from ramanujan.derivation.remarks import REMARKS
from ramanujan.pages.derivation import cache
from ramanujan.shell.sections import typed_answer
from ramanujan.text.names import PARTS
from tests.checks.reading import wide_formulas
from tests.checks.reference import frequency_squared

PAGE = "ramanujan/pages/derivation/page.py"
TITLES = {name: ROUTES[name].title for name in ROUTES}


@pytest.fixture
def page(app):
    """The page after its first run."""
    return sound(app.run().switch_page(PAGE).run())


def sound(app):
    assert not app.exception
    name = app.session_state.get("question", None)
    assert app.title[0].value == (typed_answer.find_title(name) if name else "Many ways to one frequency")
    return app


def choose(app, **choices):
    for key, value in choices.items():
        app.session_state[key] = value
    return sound(app.run())


def headings(app) -> list[str]:
    return [text.value.splitlines()[0] for text in app.markdown if text.value.startswith("## ")]


def formulas(app) -> str:
    """Return the formulas of the page in a wide window."""
    return "\n".join(block.value for block in displays(app))


def displays(app) -> list:
    return [block for block in wide_formulas(app) if block.type == "latex"]


# Routes and steps


@pytest.mark.parametrize("name", ROUTES)
def test_reading_shows_every_step_of_a_route_and_numbers_end_in_the_present_frequency(page, name):
    choose(page, route=name, show="reading")
    assert headings(page) == [f"## {n}. {step.heading}" for n, step in enumerate(ROUTES[name].steps, start=1)]
    symbols = [block.value for block in displays(page) if "s^{-2}" not in block.value]
    # The sliders show 1.85, 0.86 and 33.5. The expected frequency is computed in exact fractions.
    choose(page, m=1.85, m_prime=0.86, k=33.5)
    assert [block.value for block in displays(page) if "s^{-2}" not in block.value] == symbols
    choose(page, values="numbers")
    mass, roller, stiffness = Fraction(185, 100), Fraction(86, 100), Fraction(335, 10)
    squared = frequency_squared(mass, roller, stiffness)
    result = rf"\frac{{{squared.numerator}}}{{{squared.denominator}}} \approx {float(squared):.5f}"
    assert result in formulas(page)
    steps, results, shapes, momenta = len(ROUTES[name].steps), 2, 3, 1
    assert len(displays(page)) == steps + results + shapes + momenta


def test_a_lecture_contains_every_step_of_its_route(page):
    for name, title in TITLES.items():
        choose(page, route=name)
        wanted = [step.heading for step in ROUTES[name].steps]
        assert headings(page) == [f"## {n}. {heading}" for n, heading in enumerate(wanted, start=1)]
        (turner,) = (e.proto for e in page.get("bidi_component") if e.proto.id.endswith("-lecture_turn"))
        data = json.loads(turner.json)
        assert (data["route"], data["headings"]) == (name, wanted)
        assert title


def test_moving_a_slider_repeats_no_derivation(page, monkeypatch):
    def fail(*_, **__):
        raise AssertionError("derived again")

    choose(page, show="reading")
    for name in ("solve", "hessian", "roots"):
        monkeypatch.setattr(sp, name, fail)
    for name in ROUTES:
        choose(page, route=name, values="numbers", m=1.11, m_prime=2.22, k=44.0)
    choose(page, m=3.33)
    # Negative control: a derivation calls the replaced functions.
    with pytest.raises(AssertionError):
        energy_conservation.build(machine())


def test_all_routes_have_one_result_and_a_button_with_a_check_mark(page):
    assert latex(ROUTES["newton"].natural_frequency_squared) in formulas(page)
    assert formulas(page).count(r"\frac{1040}{99}") == 1
    for name in ("newton", "matrix", "euler_lagrange"):
        button = page.button(f"select_{name}")
        assert TITLES[name] in button.label
        assert button.proto.icon == ":material/check:"
        sound(button.click().run())
        assert headings(page) == [f"## {n}. {step.heading}" for n, step in enumerate(ROUTES[name].steps, start=1)]


# The bodies' terms


@pytest.mark.parametrize("name", ROUTES)
def test_the_terms_of_all_parts_add_up_to_the_equation(name):
    sums = [e for step in ROUTES[name].steps for e in step.equations if terms_by_part(e)]
    assert bool(sums) == (name != "newton")
    for equation in sums:
        terms = terms_by_part(equation)
        assert set(terms) <= set(PARTS)
        assert sp.expand(sum(map(sum, terms.values())) - equation.rhs) == 0


@pytest.mark.parametrize("numbers", [None, Numbers(1.0, 1.0, 10.0)], ids=["symbols", "numbers"])
def test_only_the_symbols_of_a_part_have_its_colour(numbers):
    inks = tuple((part, f"#{n}{n}{n}{n}{n}{n}") for n, part in enumerate(PARTS, start=1))
    shown = {
        (name, step.key): cache.step(name, number, numbers, (*inks, ("cube", "#777777")))[2]
        for name in ROUTES
        for number, step in enumerate(ROUTES[name].steps)
    }
    colors = {place: re.findall(r"textcolor\{(.*?)\}", text) for place, text in shown.items()}
    # The energies of the bodies in their order, followed by the energy of the spring.
    energies = [ink for part, ink in inks for _n in range(1 + (part in ("hoop", "cylinder", "top")))]
    in_order = [*energies[:-3], *energies[-2:], energies[-3]]
    assert colors["euler_lagrange", "sum"] == in_order
    assert colors["matrix", "energies"] == [*in_order[:-1], in_order[-1], in_order[-1]]
    for (part, ink), line in zip(inks, shown["euler_lagrange", "velocities"].split(r"\\"), strict=False):
        if part not in ("spring", "top"):
            assert f"\\textcolor{{{ink}}}{{v_{{\\text{{{part}}}}}}}" in line
            assert len(set(re.findall(r"#\d+", line))) == 1
    # All other bodies act on the block. Each force has the colour of its body.
    assert set(colors["newton", "forces"]) == {ink for part, ink in inks if part != "spring"}
    assert not colors["euler_lagrange", "ratio"]


# Modes and notes


def test_three_modes_and_two_conserved_momenta_are_shown(page):
    assert formulas(page).count("v =") == 3
    assert r"p_{X} &=" in formulas(page)
    assert r"p_{\Phi} &=" in formulas(page)


def test_every_note_on_the_paper_is_shown(page):
    notes = [text.value for text in page.markdown if "The paper has:" in text.value]
    assert len(notes) == len(REMARKS) >= 6


# Try it yourself


def test_each_line_names_the_operation_that_leads_to_it(page):
    shown = formulas(page)
    insert, collect = r"\text{insert $\ddot{X}$}", r"\text{collect $\ddot{\varphi}$}"
    for operation in (r"\times \frac{3}{2}", insert, r"\text{cancel $8$}", collect, r"\times 72", r"+\,1"):
        assert rf"\vert\ {operation}" in shown, operation
    assert shown.count(r"\underline{") == 15
    marked = {name for name in ROUTES if any(any(step.underlined_terms) for step in ROUTES[name].steps)}
    # No line of the matrix route adds, removes or moves a term of an earlier line.
    assert marked == {*ROUTES} - {"matrix"}
    for route in (*(ROUTES[name] for name in ROUTES), ROUTES.with_equal_masses("euler_lagrange")):
        for step in route.steps:
            for shown_step in (step, step.for_numbers(Numbers(1, 1, 10))):
                assert len(shown_step.operations) == len(shown_step.equations), (route.title, step.key)
                assert any(shown_step.operations), (route.title, step.key)


def test_a_link_leads_from_the_steps_to_the_questions(page):
    links = [text.value for text in page.markdown if "[Try it yourself](#try)" in text.value]
    assert len(links) == len({find_question(name).steps[-1] for name in QUESTIONS})
    (section,) = (header.proto for header in page.header if header.value == "Try it yourself")
    assert section.anchor == "try"


def test_an_open_question_hides_steps_and_results(page):
    assert page.latex
    sound(page.button(key="open_natural_frequency_squared").click().run())
    assert not page.latex
    assert page.query_params["question"] == "natural_frequency_squared"
    sound(page.button(key="close_question").click().run())
    assert page.latex
    assert "question" not in page.query_params


def answer(app, question: str, text: str):
    choose(app, question=question)
    app.text_input(key=f"answer_{question}").set_value(text)
    (check,) = (button for button in app.button if button.label == "Check")
    return sound(check.click().run())


def test_each_kind_of_verdict_has_its_box(page):
    ask = "natural_frequency_squared"
    assert answer(page, ask, "8k(7m+6m')/(32m^2+49m m'+18m'^2)").success
    assert answer(page, ask, "8k R (7m+6m')/(32m^2 R+49m m' R+18m'^2 R)").info
    assert answer(page, ask, "k/m").warning
    assert answer(page, ask, "k/").error


def test_a_right_answer_leads_to_an_unsolved_question(page):
    """After the last question, begin again with the first one."""
    right = {"natural_frequency_squared": "8k(7m+6m')/(32m^2+49m m'+18m'^2)", "unit_mass_ratio": "(sqrt(1729)-1)/36"}
    following = []
    for question, text in right.items():
        answer(page, question, "k/m")
        assert "next_question" not in {button.key for button in page.button}
        answer(page, question, text)
        sound(page.button(key="next_question").click().run())
        following.append(page.session_state["question"])
    assert following == ["unit_quadratic", "kinetic_energy_block"]


def test_every_question_can_be_asked(page):
    for question in QUESTIONS:
        choose(page, question=question)
        assert any(find_question(question).prompt() in text.value for text in page.markdown), question


def test_a_typed_formula_is_displayed_as_parsed(page):
    for text in ("(m/m)^(-2)", "k/(m/m)^(-2)", "(√(R/R))^(-12)", "1/0"):
        answer(page, "potential_energy", text)
        assert typed_answer.typeset_as_parsed(text) in formulas(page), text
    assert typed_answer.typeset_as_parsed("m +") is None


def test_the_machine_has_its_velocities_at_the_steps_about_them(page, monkeypatch):
    sent, true_payload = [], stage.payload
    monkeypatch.setattr(stage, "payload", lambda *a, **more: sent.append(more) or true_payload(*a, **more))
    # Euler–Lagrange finds velocities and momenta, Hamilton's route uses both, and energy and matrix find their ratios.
    for route, step, is_drawn in (
        ("euler_lagrange", 1, True), ("euler_lagrange", 2, False), ("euler_lagrange", 6, True), ("hamilton", 3, True),
        ("newton", 2, False), ("energy", 2, False), ("energy", 3, True), ("matrix", 8, True),
    ):  # fmt: skip
        sent.clear()
        page.session_state["route"] = route
        page.session_state["step"] = step
        page.run()
        assert any(more.get("velocities") for more in sent) == is_drawn
