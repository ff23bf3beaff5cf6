"""The page Lesson under AppTest: stops before and after the prediction, tasks, links, and hidden answers."""

import json
import re

import pytest

from ramanujan import UNIT_MASS_RATIO, lesson
from ramanujan.browser import stage
from ramanujan.lesson import computing
from ramanujan.pages.classroom.shared_elements import add_letters
from ramanujan.pages.used_by_shell import ENTRIES
from tests.checks.scenes import sent, unbroken
from tests.settings import DEEP

PAGE = "ramanujan/pages/lesson/page.py"
IDS = [stop.id for stop in lesson.STOPS]
ALIKE = {"light-rollers", "heavy-rollers", "stiffness", "radius", "block", "rollers", "turning-point"}
"""Stops with the same parts as the first one; they are opened only if RAMANUJAN_DEEP is set."""


@pytest.fixture
def opened(app):
    """Open the page with an address: opened(stop="block")."""

    def visit(**address):
        # A page reads its address when it opens, so the visit starts on the first page.
        app.switch_page("ramanujan/pages/oscillator/page.py").run()
        for key, text in address.items():
            app.query_params[key] = text
        return unbroken(app.switch_page(PAGE).run())

    return visit


def stage_payloads(app) -> list[dict]:
    """Return the payloads of the stages on the page."""
    messages = [
        json.loads(e.proto.json)
        for e in app.get("bidi_component")
        if "stage_" in e.proto.id and "published" in e.proto.id
    ]
    return [payload for message in messages for payload in message.values()]


def choose(app, stop, option):
    return unbroken(app.button(key=f"option_{stop}_{option}").click().run())


def go_on(app, stop):
    return unbroken(app.button(key=f"on_{stop}").click().run())


def other_than(stop) -> str:
    return next(option for option in stop.options if option != stop.answer())


def frequencies(stop) -> set[str]:
    """Return the texts of all numbers that reveal the frequency of a machine of this stop."""
    texts = set()
    for machine in {stop.machine, stop.final_machine, *(run.machine for run in stop.runs)}:
        values = (
            machine.normalized_frequency_squared,
            machine.natural_frequency,
            machine.period,
            machine.effective_mass,
        )
        texts |= {f"{value:.{digits}g}" for value in values for digits in (4, 5, 7)}
    return {text for text in texts if len(text) > 4}


def sentences(text: str) -> set[str]:
    return {sentence for sentence in re.split(r"(?<=[.?!]) ", text) if len(sentence) > 12}


# Stops


@pytest.mark.parametrize("name", IDS if DEEP else [i for i in IDS if i not in ALIKE])
def test_a_stop_reveals_its_motion_and_its_answer_only_on_request(opened, name):
    stop = lesson.find_stop(name)
    wrong = other_than(stop)
    reply, right = stop.reply(wrong), stop.options[stop.answer()]
    app = opened(stop=name)
    page = sent(app)
    explanation = sentences(stop.explanation()) | {stop.onward.label, "right\u00a0answer", "prediction was"}
    giveaways = explanation | sentences(reply) | (set() if stop.exhibit or name == "other-body" else frequencies(stop))
    if name in ("by-hand", "exactly"):
        # The options of the stop "exactly" contain close numbers, so compare seven digits.
        giveaways.add(f"{UNIT_MASS_RATIO:.{3 if name == 'by-hand' else 7}g}")
    assert [text for text in giveaways if text in page] == []
    # All options look the same: each label occurs once, as a button.
    for option, label in add_letters(stop).items():
        assert page.count(json.dumps(label, ensure_ascii=False)) == 1
        assert page.count(f'-option_{name}_{option}"') == 1
    assert stop.question in [text.value for text in app.markdown]
    # The present stop is the only one on the page.
    others = [other_stop for other_stop in lesson.STOPS if other_stop is not stop]
    for other_stop in others:
        assert other_stop.question not in page
        assert not sentences(other_stop.explanation()) & sentences(page)
    assert not [pills for pills in app.get("button_group") if "preset" in pills.proto.id]

    # After a choice the reader can still change it.
    choose(app, name, wrong)
    page = sent(app)
    assert [text for text in giveaways if text in page] == []
    check_marks(app, stop, wrong)
    before = app.button(key=f"on_{name}").label, stage_payloads(app), {text.value for text in app.markdown}
    for machine in stage_payloads(app):
        assert set(stop.hides) <= set(machine["hide"])
        assert not {"samples", "slipping"} & set(machine)

    # While the machine runs, a wrong choice gets a reply without the answer.
    page = sent(go_on(app, name))
    check_button(app, stop, *before)
    assert reply in page
    assert f"You predicted: *{stop.options[wrong].removesuffix('.')}.* {reply}" in markdown(app)
    assert right not in reply
    check_marks(app, stop, wrong)
    assert [text for text in explanation - {"prediction was"} if text in page] == []
    assert len(stage_payloads(app)) == len(stop.runs)
    assert not any(
        set(stop.hides) & set(machine["hide"]) - {"energy", "arrows", "forces"} for machine in stage_payloads(app)
    )
    unbroken(app.button(key=f"again_{name}").click().run())
    assert [text for text in giveaways if text in sent(app)] == []

    # Negative control: at the end the page contains all of these texts.
    go_on(go_on(choose(app, name, wrong), name), name)
    page = sent(app)
    assert all(
        sentence in page for sentence in sentences(stop.explanation()) | {reply, stop.onward.label, "Right answer:"}
    )
    check_marks(app, stop, wrong, stop.answer())
    assert app.pills(key="preset").options

    app = go_on(opened(stop=name, chosen=f"{name}.{stop.answer()}.predicted"), name)
    shown = markdown(app)
    check_marks(app, stop, stop.answer(), stop.answer())
    assert "Your prediction was right." in shown
    assert stop.explanation() in shown


def markdown(app) -> str:
    return "\n".join(text.value for text in app.markdown)


def check_marks(app, stop, chosen: str, right: str | None = None) -> None:
    """Check that all options are still listed, and that only the prediction and the right answer are marked."""
    listed = next(text.value for text in app.markdown if text.value.startswith("- ")).splitlines()
    for line, (option, label) in zip(listed, add_letters(stop).items(), strict=True):
        assert label in line
        assert ("prediction" in line) == (option == chosen)
        assert ("check_circle" in line) == (option == right)
        assert (line == f"- {label}") == (option not in (chosen, right))


SLOW = 60.0
"""A period [s] too long for a visible motion."""


def check_button(app, stop, label: str, before: list[dict], words: set[str]) -> None:
    """Check that a button starts only a machine at rest, with a visible motion. Any other button shows new content."""
    after = stage_payloads(app)
    starts = "motion" in before[0]["hide"] and "motion" not in after[0]["hide"] and stop.runs[0].machine.period < SLOW
    layers = set(before[0]["hide"]) & set(stage.LAYERS) - set(after[0]["hide"])
    exhibits = [text.value for text in app.markdown if text.value not in words and text.value.startswith(("$$", "```"))]
    assert label == ("Run the machine" if starts else "Check it")
    assert starts or layers or exhibits


def test_the_observed_machines_are_those_of_the_stop(opened):
    app = opened(stop="steps", chosen="steps.euler")
    exact, euler, verlet = stage_payloads(app)
    assert "samples" not in exact
    assert len(euler["samples"]["q"]) > len(verlet["samples"]["q"]) == 201
    for run, method in ((euler, "explicit_euler"), (verlet, "velocity_verlet")):
        energies = run["samples"]["energies"]
        assert len(energies) == len(run["samples"]["q"])
        assert energies[-1] == pytest.approx(computing.final_energy_ratio(method), abs=1e-4)
    # The bars of all three machines have one scale, and the largest energy fills its bar.
    for each in (exact, euler, verlet):
        assert each["most_energy"] == pytest.approx(max(euler["samples"]["energies"]), abs=1e-4)
    app = opened(stop="contact", chosen="contact.top_block")
    assert stage_payloads(app)[0]["slipping"] == "hoop_slab"
    app = opened(stop="other-body", chosen="other-body.same")
    assert stage_payloads(app)[0]["parameters"]["beta_top"] == 0.4
    swings, glides, rolls = stage_payloads(opened(stop="zero-modes", chosen="zero-modes.one"))
    assert "initial" not in swings
    assert [key for each in (glides, rolls) for key, value in each["initial"].items() if value] == ["X_dot", "Phi_dot"]


def test_the_sliders_have_the_machine_of_the_stop_and_can_be_moved(opened):
    app = opened(stop="heavy-rollers")
    assert app.slider(key="m_prime").value == 5.0
    unbroken(app.slider(key="m_prime").set_value(4.0).run())
    assert stage_payloads(app)[0]["parameters"]["m_prime"] == 4.0
    assert any("You have changed the machine." in text.value for text in app.markdown)
    # The prediction is about the machine of the stop.
    go_on(choose(app, "heavy-rollers", "plain"), "heavy-rollers")
    assert app.slider(key="m_prime").value == 5.0
    unbroken(app.slider(key="m_prime").set_value(3.0).run())
    assert stage_payloads(app)[0]["parameters"]["m_prime"] == 3.0


def test_a_machine_is_shown_exactly_in_step_only_after_the_prediction(opened):
    app = opened(stop="exactly")
    assert app.slider(key="m_prime").value == 1.0
    go_on(choose(app, "exactly", "decimal"), "exactly")
    assert app.slider(key="m_prime").value == UNIT_MASS_RATIO


def test_a_link_hides_parts_of_every_stage(opened):
    for address in ({"stop": "zero-modes", "chosen": "zero-modes.two"}, {"part": "tasks", "task": "in-step"}):
        stages = stage_payloads(opened(**address, hide="plain,arrows"))
        assert stages
        assert all({"plain", "arrows"} <= set(value["hide"]) for value in stages), address


def test_hints_come_one_by_one(opened):
    app = opened(stop="two-clocks")
    hints = lesson.find_stop("two-clocks").hints

    def shown():
        text = "\n".join(each.value for each in app.markdown).replace("\\", "")
        return [hint in text for hint in hints]

    assert shown() == [False, False]
    unbroken(app.button(key="hint_two-clocks").click().run())
    assert shown() == [True, False]
    unbroken(app.button(key="hint_two-clocks").click().run())
    assert shown() == [True, True]
    assert "hint_two-clocks" not in [button.key for button in app.button]


def test_the_short_lesson_has_six_stops_and_an_end_with_the_answers(opened):
    short = [stop for stop in lesson.STOPS if stop.is_in_short_lesson]
    assert len(short) == 6
    assert sum(stop.minutes for stop in short) <= 20
    first, second, *others = short
    predictions = (
        f"{first.id}.{first.answer()}~{second.id}.{other_than(second)}~{others[0].id}.{others[0].answer()}.predicted"
    )
    app = opened(stops="short", stop="end", chosen=predictions)
    shown = "\n".join(text.value for text in app.markdown)
    assert "You answered 2 of 6 questions. Your prediction was right at 1 of them." in shown
    wrong, right = second.options[other_than(second)], second.options[second.answer()]
    assert (
        f"| **1. {first.heading}** | :green[:material/check_circle:] Right | {first.options[first.answer()]} |" in shown
    )
    assert f"| **2. {second.heading}** | {wrong} | {right} |" in shown
    # The sums of cubes answer a question that is still open.
    assert "1729 = 1³" not in shown
    is_shown = [stop.options[stop.answer()] in shown for stop in short]
    assert is_shown == [True, True, False, False, False, False]
    # A button leads to each question that is still open.
    assert [button.label for button in app.button if button.key.startswith("open_")] == [
        f"{number}. {stop.heading}" for number, stop in enumerate(short[2:], start=3)
    ]
    # Another leads back to the reason of each question with a wrong prediction.
    assert [button.label for button in app.button if button.key.startswith("missed_")] == [f"2. {second.heading}"]
    assert len(app.get("page_link")) == 4
    unbroken(app.button(key=f"open_{short[2].id}").click().run())
    assert app.title[0].value == f"3. {short[2].heading}"
    every = "~".join(f"{stop.id}.{stop.answer()}" for stop in short)
    assert "1729 = 1³" in markdown(opened(stops="short", stop="end", chosen=every))
    unbroken(app.button(key="to_tasks").click().run())
    assert app.title[0].value == lesson.TASKS[0].heading
    # A link can also open a stop outside the six.
    assert (
        opened(part="stops", stops="short", stop="contact").title[0].value
        == f"4. {lesson.find_stop('contact').heading}"
    )


# The parameters of the address


def test_a_link_preserves_its_machine_and_other_visitors_get_the_machine_of_the_stop(app):
    app.query_params["m_prime"] = "0.3"
    unbroken(app.run())
    assert app.slider(key="m_prime").value == 0.3
    app.query_params["stop"] = "light-rollers"
    unbroken(app.switch_page(PAGE).run())
    assert app.slider(key="m_prime").value == lesson.find_stop("light-rollers").machine.m_prime


# Tasks and notes


@pytest.mark.parametrize("name", [task.id for task in lesson.TASKS])
def test_every_task_without_a_text_box_is_judged_when_it_opens(opened, name):
    app = opened(part="tasks", task=name)
    assert app.title[0].value == lesson.find_task(name).heading
    waits = not {"part", "seconds", "formula"}.isdisjoint(lesson.find_task(name).fields)
    assert any("Not yet." in text.value for text in app.markdown) != waits
    for machine in stage_payloads(app):
        assert set(lesson.find_task(name).hides) == set(machine.get("hide", ()))


def done(app) -> bool:
    return any("**Done.**" in text.value for text in unbroken(app).markdown)


def test_tasks_can_be_completed_with_the_controls_of_the_page(opened):
    app = opened(part="tasks", task="in-step")
    assert not done(app)
    assert done(app.slider(key="m_prime").set_value(1.1275).run())

    app = opened(part="tasks", task="half-energy")
    assert done(app.text_input(key="task_part").set_value("3/8").run())
    assert not done(app.text_input(key="task_part").set_value("<b>").run())
    unbroken(app.text_input(key="task_part").set_value("1/1,250").run())
    assert any("can mean 1.250 or 1250" in text.value.replace("\\", "") for text in app.markdown)

    app = opened(part="tasks", task="two-cubes", task_left="sphere", task_right="sphere")
    assert not done(app)
    assert done(app.selectbox(key="task_top").set_value("shell").run())


def test_the_notes_cover_every_stop_and_name_their_sources(opened):
    app = opened(part="notes")
    # The page describes their contents before it shows them.
    assert "right answers" in app.toggle(key="notes_shown").label
    assert not any("Right answer" in text.value for text in app.markdown)
    unbroken(app.toggle(key="notes_shown").set_value(True).run())
    shown = "\n".join(text.value for text in app.markdown)
    assert all(stop.heading in shown for stop in lesson.STOPS)
    assert all(source in shown for source in lesson.SOURCES)
    cited = set(re.findall(r"\[(\d)\]", shown))
    assert cited == {str(number) for number in range(1, len(lesson.SOURCES) + 1)}


def test_the_notes_of_a_short_lesson_list_its_stops_only(opened):
    shown = markdown(opened(part="notes", stops="short"))
    for stop in lesson.STOPS:
        assert (f" {stop.heading} :small" in shown) == stop.is_in_short_lesson, stop.id


def test_the_number_of_a_stop_in_the_address_opens_it(opened):
    short = [stop for stop in lesson.STOPS if stop.is_in_short_lesson]
    assert opened(stop="2").title[0].value == f"2. {lesson.STOPS[1].heading}"
    app = opened(stop="6", stops="short")
    assert app.title[0].value == f"6. {short[5].heading}"
    assert app.query_params["stop"] == short[5].id
    assert opened(stop="7", stops="short").warning


def test_a_slide_of_the_end_names_missed_stops_by_their_numbers_in_the_table(opened):
    missed = lesson.STOPS[2]
    assert opened(stop="end").title[0].value == "The end of the lesson"
    app = opened(stop="end", view="projector", chosen=f"{missed.id}.{other_than(missed)}")
    assert app.title[0].value == "What you have seen"
    assert f"**3. {missed.heading}**" in markdown(app)
    assert app.button(key=f"missed_{missed.id}").label == "3"


def test_the_full_page_understands_the_link_of_every_stop():
    for stop in lesson.STOPS:
        keys = {key.name: key for key in ENTRIES[stop.onward.page].url_parameters}
        for key, text in stop.onward.query.items():
            assert keys[key].write(keys[key].read(text)) == text, stop.id
