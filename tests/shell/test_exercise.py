"""An exercise by link under AppTest: its order, its verdicts, no answers for students, and the sheet at its end."""

import re
from urllib.parse import parse_qs, urlsplit

import pytest

from ramanujan import lesson
from ramanujan.answers import QUESTIONS, find_answer_equations, find_question, judge
from ramanujan.derivation.printers import latex
from ramanujan.shell.sections import typed_answer
from tests.checks.answers import RIGHT
from tests.checks.scenes import unbroken

PAGE = "ramanujan/pages/lesson/page.py"
WORKSHEET = "ramanujan/pages/worksheet/page.py"


def opened(app, **address):
    app.run()
    for key, text in address.items():
        app.query_params[key] = text
    return unbroken(app.switch_page(PAGE).run())


def answer(app, name: str, text: str):
    app.text_input(key=f"answer_{name}").set_value(text)
    return unbroken(next(button for button in app.button if button.label == "Check").click().run())


def go(app, item: int):
    app.session_state["item"] = item
    return unbroken(app.run())


def hint(app, name: str):
    return unbroken(app.button(key=f"hint_{name}").click().run())


@pytest.mark.parametrize("name", QUESTIONS)
def test_hints_lead_to_the_step_and_only_the_step_has_the_answer(name):
    hints = find_question(name).hints
    assert len(hints) >= 2
    for text in hints:
        for formula in re.findall(r"\$([^$]+)\$", text):
            sides = {formula, *re.split("=|,", formula)}
            assert not [side for side in sides if judge(name, side).kind in ("right", "unsimplified")], text
    stated = [latex(side) for equation in find_answer_equations(name) for side in (equation, *equation.args)]
    assert any(judge(name, text).kind in ("right", "unsimplified") for text in stated)


def test_an_exercise_keeps_its_order_shows_no_answer_and_ends_in_a_sheet(app):
    items = ("unit_quadratic", "two-cubes", "potential_energy")
    opened(app, exercise=",".join(items))
    assert app.title[0].value == "The quadratic equation"
    answer(app, "unit_quadratic", "18 eps^2 + eps = 24")
    assert app.success
    # A later wrong answer does not replace a right one.
    answer(app, "unit_quadratic", "18 eps^2 = 24")
    assert app.warning
    go(app, 2)
    assert app.title[0].value == lesson.find_task("two-cubes").heading
    go(app, 3)
    for _ in find_question("potential_energy").hints:
        hint(app, "potential_energy")
    assert "hint_potential_energy" not in [button.key for button in app.button]
    assert not app.latex
    answer(app, "potential_energy", "k` <b>|$R$")
    go(app, 4)
    assert "Save this worksheet" in [button.proto.label for button in app.get("download_button")]
    (sheet,) = (text.value for text in app.markdown if text.value.startswith("# "))
    headings = re.findall(r"^\d+\. \*\*(.*?)\.\*\*", sheet, re.MULTILINE)
    assert headings == ["The quadratic equation", lesson.find_task("two-cubes").heading, "The potential energy"]
    first, second, third = re.split(r"^\d+\. ", sheet, flags=re.MULTILINE)[1:]
    assert "`` 18 eps^2 + eps = 24 ``" in first
    assert re.search(r"Right since \d{4}-\d\d-\d\d \d\d:\d\d \w+", first)
    assert "Not done yet." in second
    assert "Not right yet." in third
    assert "`` k <b>|$R$ ``" in third
    assert f"Hints used: {len(find_question('potential_energy').hints)}" in third
    for item in range(1, 5):
        go(app, item)
        assert not [button for button in app.button if button.label == "Show me this step"]
        assert not [text for text in app.markdown if text.value.startswith("## 1.")]


@pytest.mark.parametrize("bad", ["phi_equation,nobody", ""])
def test_a_bad_link_gets_one_sentence_and_the_lesson(app, bad):
    (warning,) = opened(app, exercise=bad).warning
    assert "The value of exercise in the address was ignored" in warning.value
    assert "nobody" not in warning.value
    assert app.title[0].value.startswith("1. ")
    assert not unbroken(app.run()).warning


def test_the_lecturer_composes_a_link_in_the_order_of_choice(app):
    unbroken(app.run().switch_page(WORKSHEET).run())
    app.slider(key="k").set_value(33.5)
    # A shorter number would not be in step.
    in_step = (1729**0.5 - 1) / 36
    unbroken(app.slider(key="m_prime").set_value(in_step).run())
    app.multiselect(key="composed").set_value(["two-cubes", "block_momentum"])
    (link,) = (block.value for block in unbroken(app.run()).code)
    assert urlsplit(link).path.endswith("/lesson")
    query = parse_qs(urlsplit(link).query)
    assert query == {"m_prime": [repr(in_step)], "k": ["33.5"], "exercise": ["two-cubes,block_momentum"]}


def test_a_session_lists_the_solved_questions(app):
    app.run()
    unbroken(app.switch_page("ramanujan/pages/derivation/page.py").run())
    for name in ("block_momentum", "kinetic_energy_block"):
        app.session_state["question"] = name
        answer(unbroken(app.run()), name, RIGHT[name][0])
    # Open another page and return.
    app.switch_page(WORKSHEET).run()
    unbroken(app.switch_page("ramanujan/pages/derivation/page.py").run())
    # A question remains open.
    unbroken(app.button(key="close_question").click().run())
    solved = [button.label for button in app.button if button.proto.icon == ":material/check_circle:"]
    assert solved == ["The kinetic energy of the block", "The momentum of X"]
    assert any(text.value.startswith(f"**Solved so far: 2 of {len(QUESTIONS)}") for text in app.markdown)
    # After all hints the step is shown on request.
    name = "block_momentum"
    app.session_state["question"] = name
    unbroken(app.run())
    before = len(app.latex)
    for _ in find_question(name).hints:
        hint(app, name)
        assert len(app.latex) == before
    assert app.button(key=f"hint_{name}").label == "Show me this step"
    hint(app, name)
    assert len(app.latex) == before + 1
    assert typed_answer.typeset_answer_step(name) in app.latex[-1].value
