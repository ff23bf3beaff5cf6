"""The class on the lesson's page: a round for lecturer and students, and the data hidden from each of them."""

import asyncio
import csv
import io
import re
import sqlite3
from concurrent.futures import ThreadPoolExecutor
from datetime import UTC, datetime, timedelta
from types import SimpleNamespace

import pytest
import streamlit as st
from streamlit.testing.v1 import AppTest

from ramanujan import lesson
from ramanujan.classroom import rules
from ramanujan.classroom.results import write_csv
from ramanujan.server import asgi
from ramanujan.shell import address as class_address
from ramanujan.shell import class_session, local_time
from tests.checks.browser import ROOT
from tests.checks.scenes import walked
from tests.settings import PATIENCE

PAGE = "ramanujan/pages/lesson/page.py"
STOP = lesson.STOPS[0]
RIGHT = STOP.answer()
WRONG = next(option for option in STOP.options if option != RIGHT)
LETTER = "ABCD"[list(STOP.options).index(WRONG)]


@pytest.fixture(autouse=True)
def school(tmp_path, monkeypatch) -> rules.Classes:
    """The classes of a separate server."""
    monkeypatch.setenv("RAMANUJAN_CLASSES", str(tmp_path / "classes.sqlite"))
    return rules.shared()


@pytest.fixture(autouse=True)
def cookies(monkeypatch) -> None:
    """Read the browser's name from the session, because AppTest sends no cookies."""
    monkeypatch.setattr(class_session, "identify_browser", lambda: st.session_state.get("cookie", ""))


def visitor(cookie: str = "", **link: str) -> AppTest:
    """Return the lesson's page in a new session with this address."""
    app = AppTest.from_file(str(ROOT / "app.py"), default_timeout=PATIENCE).run()
    app.session_state["cookie"] = cookie
    for key, value in link.items():
        app.query_params[key] = value
    return app.switch_page(PAGE).run()


def words(app: AppTest) -> str:
    """Return all words of the page."""
    assert not app.exception
    kinds = (app.title, app.subheader, app.markdown, app.text, app.caption, app.info, app.success, app.warning)
    bars = [element.proto.text for element in app.get("progress")]
    labels = [radio.label for radio in app.radio]
    return "\n".join([*(element.value for kind in kinds for element in kind), *bars, *labels])


def press(app: AppTest, name: str) -> AppTest:
    return app.button(key=f"class_{name}").click().run()


def answer(app: AppTest, option: str) -> AppTest:
    return app.radio[0].set_value(option).run()


@pytest.fixture
def lecturer() -> AppTest:
    """The page of a lecturer with an open class, at the first stop."""
    return press(visitor(), "open")


@pytest.mark.parametrize("host", ["192.168.1.20", None])
def test_a_class_at_localhost_shows_the_address_in_the_network_or_a_warning(monkeypatch, host):
    monkeypatch.setattr(type(st.context), "url", property(lambda _context: "http://localhost:8501/lesson"))
    monkeypatch.setattr(class_address, "_network_host", lambda: host)
    desk = visitor()
    assert ("Phones cannot open the address of this page" in words(desk)) == (host is None)
    wall = visitor(**{"class": address(press(desk, "open"))["class"]}, wall="on")
    assert ("Phones cannot open the address of this page" in words(wall)) == (host is None)
    assert f"{host or 'localhost'}:8501/lesson" in words(wall)


def test_presets_that_reveal_the_answer_are_hidden_until_it_is_shown():
    # The lecturer predicted the motion in an earlier lesson. This class has not.
    stop = lesson.find_stop("exactly")
    lecturer = press(visitor(stop=stop.id, chosen=f"exactly.{stop.answer()}"), "open")
    student = visitor(**{"class": address(lecturer)["class"]})

    def offered(app: AppTest) -> bool:
        return any("preset" in pills.proto.id for pills in app.get("button_group"))

    assert not offered(lecturer)
    for step in ("ask", "reveal", "run"):
        assert not offered(press(lecturer, step))
    assert offered(press(lecturer, "solve"))
    # A phone never offers presets, because its machine follows the desk.
    assert not offered(student)
    assert not offered(student.run())


def address(app: AppTest) -> dict[str, str]:
    """Return the parameters of the address."""
    return {key: value if isinstance(value, str) else value[0] for key, value in app.query_params.items()}


def code_of(lecturer: AppTest) -> str:
    return address(lecturer)["class"]


def test_a_second_vote_is_shown_and_downloaded(lecturer, school):
    students = [visitor(**{"class": code_of(lecturer)}) for _ in range(3)]
    assert "The first question will appear here" in words(students[0])
    assert "3 students have joined" in words(lecturer.run())

    press(lecturer, "ask")
    for student, option in zip(students, (WRONG, WRONG, RIGHT), strict=True):
        assert STOP.question in words(student.run())
        answer(student, option)
        assert "Your answer counts" in words(student)
    assert "Answers: 3 of 3" in words(lecturer.run())
    for page in (lecturer, *students):
        assert not page.get("progress")
        assert STOP.explanation() not in words(page)
    assert not [button for button in lecturer.button if button.key.startswith("option_")]

    press(lecturer, "reveal")
    assert sum("2 of 3, 67\u202f%" in words(page.run()) for page in (lecturer, *students)) == 4
    assert "This was your answer" in words(students[0])

    press(lecturer, "again")
    for student, option in zip(students, (RIGHT, RIGHT, WRONG), strict=True):
        assert "Second vote" in words(student.run())
        assert student.radio[0].value is None
        answer(student, option)
    assert "Second vote. Answers: 3 of 3" in words(lecturer.run())
    press(lecturer, "reveal")
    for page in (lecturer, students[0].run()):
        assert "Second vote" in words(page)
        assert "2 of 3, 67\u202f%" in words(page)
        # The share of right answers would reveal the right option.
        assert "right" not in words(page).lower().replace(STOP.question.lower(), "")

    # After the machine has run, desk and phones show the right answer with its reason.
    press(lecturer, "run")
    assert STOP.explanation() not in words(lecturer)
    press(lecturer, "solve")
    assert STOP.explanation() in words(lecturer)
    for page in (lecturer, students[0].run()):
        assert "Wrong, then right: 2.** Right, then wrong: 1." in words(page)
    right_letter = "ABCD"[list(STOP.options).index(RIGHT)]
    right_label = f":green[:material/check_circle:] **{right_letter}. {STOP.options[RIGHT]}**"
    assert f"{right_label} – *This was your answer.*" in words(students[0].run())
    assert STOP.explanation() in words(students[0])
    # A wrong answer first gets the reply to its option.
    assert STOP.reply(WRONG) in words(students[2].run())
    assert STOP.reply(WRONG) not in words(students[0])
    assert right_label in words(students[2].run())
    # A phone shows its own answer. Desk and wall show the most common wrong answer.
    wall = visitor(**{"class": code_of(lecturer), "wall": "on"})
    assert f"**You chose:** {LETTER}. {STOP.options[WRONG]}\\\n{STOP.reply(WRONG)}" in words(students[2])
    assert f"{STOP.options[WRONG]}\\\n{STOP.reply(WRONG)}" in words(lecturer)
    assert len(lecturer.get("progress")) == 2 * len(STOP.options)
    assert f"**You may have thought:** *{LETTER}. {STOP.options[WRONG]}* {STOP.reply(WRONG)}" in words(wall)
    # The wall shows the shares of all options, and marks the right one.
    percents = {RIGHT: "67\u202f%", WRONG: "33\u202f%"}
    letters = zip(STOP.options, "ABCD", strict=False)
    shares = [f"**{letter}** " + percents.get(option, "0\u202f%") for option, letter in letters]
    right = list(STOP.options).index(RIGHT)
    shares[right] = f":green[:material/check_circle:] {shares[right]}"
    assert [bar.proto.text for bar in wall.get("progress")] == shares

    text = write_csv(school.read_results_for_lecturer(address(lecturer)["lecturer"]))
    rows = list(csv.DictReader(io.StringIO(text.removeprefix("\ufeff"))))
    votes = {RIGHT: ("1", "2", "yes"), WRONG: ("2", "1", "no")}
    columns = ("Votes", "Votes after the discussion", "Right answer")
    assert {row["Option"]: tuple(map(row.get, columns)) for row in rows} == {
        label: votes.get(option, ("0", "0", "no")) for option, label in STOP.options.items()
    }
    assert {(row["Stop"], row["Students present"]) for row in rows} == {(STOP.heading, "3")}


def test_an_option_with_another_id_in_a_newer_version_stays_in_the_file(school):
    opened = school.open_class()
    school.ask(opened.key, STOP.id, ["old", *(option for option in STOP.options if option != WRONG)])
    school.vote(school.join(opened.code), STOP.id, "old")
    school.show(opened.key, rules.Phase.SOLVED)
    rows = csv.DictReader(io.StringIO(write_csv(school.read_results_for_lecturer(opened.key))))
    assert next((row["Option"], row["Votes"]) for row in rows) == ("old", "1")
    assert STOP.options[WRONG] in words(visitor(lecturer=opened.key))


def test_a_late_answer_gets_its_reason_and_does_not_count(lecturer, school):
    first, second = (visitor(**{"class": code_of(lecturer)}) for _ in range(2))
    press(lecturer, "ask")
    for student in (first, second):
        student.run()
    press(lecturer, "again")
    answer(first, RIGHT)
    assert "another vote has begun" in words(first)
    assert first.radio[0].value is None
    # The second vote shows no warning about an answer that missed the first.
    answer(first, RIGHT)
    assert "Your answer counts" in words(first)
    assert "too late" not in words(first)
    second.run()
    press(lecturer, "reveal")
    answer(second, RIGHT)
    assert "Your answer came too late" in words(second)
    assert sum(school.read_distribution(code_of(lecturer), STOP.id).values()) == 1


def test_a_closed_vote_shows_the_own_vote_and_the_reason(lecturer):
    voter, late = (visitor(**{"class": code_of(lecturer)}) for _ in range(2))
    press(lecturer, "ask")
    answer(voter.run(), WRONG)
    press(lecturer, "reveal")
    no_vote = "You have no answer to this question. The result has been shown, so nobody can vote on it now."
    assert "can no longer be changed" in words(voter.run())
    assert no_vote in words(late.run())
    # After the desk goes back, the question is visible again, but the vote stays closed.
    press(lecturer, "back")
    assert f"{STOP.options[WRONG]} – *This was your answer.*" in words(voter.run())
    assert no_vote in words(late.run())
    assert not voter.radio
    press(lecturer, "again")
    press(lecturer, "reveal")
    assert f"**Your answer in the first vote:** {LETTER}. {STOP.options[WRONG]}" in words(voter.run())
    assert "*First vote:* 1 of 1, 100" in words(voter)
    assert "*Second vote:* –" in words(voter)


def test_only_the_button_that_moves_the_class_is_primary_and_the_end_leads_to_the_first_page(lecturer):
    for name in ("ask", "reveal", "run", "solve", "next"):
        moving = [button for button in lecturer.button if button.proto.type == "primary"]
        assert [button.key for button in moving] == [f"class_{name}"]
        press(lecturer, name)
    press(lecturer, "close")
    assert lecturer.title[0].value == f"1. {STOP.heading}"
    assert "The class has ended, and its answers are deleted." in words(lecturer)
    assert not lecturer.warning


def test_the_expiry_is_in_the_time_zone_of_the_desk(monkeypatch):
    at = datetime(2026, 3, 1, 23, 30, tzinfo=UTC).timestamp()
    for zone, date in (("Europe/Budapest", "2026-03-02, 00:30 CET"), (None, "2026-03-01, 23:30 UTC")):
        monkeypatch.setattr(local_time.st, "context", SimpleNamespace(timezone=zone))
        assert local_time.date_and_time(at) == date


def test_no_student_receives_the_lecturers_key(lecturer):
    secret = address(lecturer)["lecturer"].partition("-")[2]
    student = visitor(**{"class": code_of(lecturer)})
    pages = [everything(student)]
    for name in ("ask", "reveal", "again", "reveal", "run", "solve"):
        press(lecturer, name)
        pages.append(everything(student.run()))
    assert secret not in "".join(pages)
    assert STOP.heading in pages[1]  # negative control: a heading sent to students
    # The lecturer's page may be on a projector, so only its address contains the key.
    assert secret not in everything(lecturer, with_address=False)
    assert secret in everything(lecturer)


def everything(app: AppTest, with_address: bool = True) -> str:
    """Return every message to a page as text, followed by its address."""
    assert not app.exception
    elements = (element for block in (app.main, app.sidebar) for element in walked(block))
    sent = [str(element.proto) for element in elements if getattr(element, "proto", None) is not None]
    return "\n".join([*sent, str(address(app)) if with_address else ""])


@pytest.mark.parametrize("text", ["", "BCDFHJ", "<script>**bold**</script>"])
def test_a_bad_code_gets_one_sentence_and_is_not_repeated(text):
    app = visitor()
    app.text_input(key="class_code").set_value(text)
    app.button(key="FormSubmitter:class_join-Join").click().run()
    [warning] = [each.value for each in app.warning]
    assert re.fullmatch(r"(A class code has six letters|There is no class with this code)[^<>*]*", warning)
    assert STOP.question in words(app)


@pytest.mark.parametrize(
    ("link", "start"),
    [
        ({"class": "bcdfhj"}, "There is no class with this code"),
        ({"lecturer": f"BCDFHJ-{'x' * 32}"}, "This lecturer’s address belongs to no class"),
    ],
)
def test_a_link_to_a_missing_class_gets_one_sentence(link, start):
    app = visitor(**link)
    [warning] = [each.value for each in app.warning]
    assert warning.startswith(start)
    assert STOP.question in words(app)


def test_a_reload_on_another_page_preserves_the_role(lecturer):
    student = visitor("phone", **{"class": code_of(lecturer)})
    press(lecturer, "ask")
    answer(student.run(), RIGHT)
    for person, still in ((lecturer, "1 of 1"), (student, "Your answer counts")):
        other_page = person.switch_page("ramanujan/pages/motion/page.py").run()
        link = address(other_page)
        assert {"class", "lecturer"} & set(link) == {"class", *(["lecturer"] if person is lecturer else [])}
        again = AppTest.from_file(str(ROOT / "app.py"), default_timeout=PATIENCE).run()
        again.session_state["cookie"] = "phone"
        for key, value in link.items():
            again.query_params[key] = value
        again.switch_page("ramanujan/pages/motion/page.py").run()
        assert still in words(again.switch_page(PAGE).run())


def test_a_session_without_a_cookie_has_one_seat(lecturer):
    student = visitor(**{"class": code_of(lecturer)})
    for _ in range(3):
        press(student, "leave")
        student.text_input(key="class_code").set_value(code_of(lecturer))
        student.button(key="FormSubmitter:class_join-Join").click().run()
    assert "1 student has joined" in words(lecturer.run())


def test_the_desk_closes_the_class_and_a_removed_phone_joins_again(lecturer, school, monkeypatch):
    student = visitor(**{"class": code_of(lecturer)})
    press(lecturer, "bar")
    late = visitor(**{"class": code_of(lecturer)})
    assert "closed this class to newcomers" in words(late)
    press(lecturer, "bar")
    with monkeypatch.context() as later:
        later.setattr(rules, "PRESENCE_DURATION", -1.0)
        press(lecturer, "clear")
    assert "0 students have joined" in words(lecturer)
    assert "The first question will appear here" in words(student.run())
    assert "1 student has joined" in words(lecturer.run())


def test_the_end_of_a_class_releases_all_screens(lecturer):
    student = visitor(**{"class": code_of(lecturer)})
    press(lecturer, "close")
    assert not {"class", "lecturer"} & set(address(lecturer))
    assert "The class has ended." in words(student.run())
    press(student, "leave")
    assert not {"class", "wall"} & set(address(student))
    assert STOP.question in words(student)


def test_the_server_deletes_expired_answers_again_and_again(tmp_path, monkeypatch, school):
    monkeypatch.setattr(asgi, "DELETION_INTERVAL", 0.01)
    # The classes of 1970 have expired.
    earlier = rules.Classes(tmp_path / "classes.sqlite", lambda: 0.0)

    def count_classes() -> int:
        with sqlite3.connect(tmp_path / "classes.sqlite") as file:
            return file.execute("SELECT COUNT(*) FROM class").fetchone()[0]

    async def serve() -> None:
        deletion = asyncio.create_task(asgi.delete_expired_answers())
        for _ in range(2):
            earlier.open_class()
            while count_classes():
                await asyncio.sleep(0.01)
        deletion.cancel()

    # A thread has no event loop, where Playwright may have left one.
    with ThreadPoolExecutor(1) as thread:
        thread.submit(asyncio.run, asyncio.wait_for(serve(), PATIENCE)).result()


def test_without_a_database_the_lesson_works(tmp_path, monkeypatch):
    (tmp_path / "file").touch()
    monkeypatch.setenv("RAMANUJAN_CLASSES", str(tmp_path / "file" / "classes.sqlite"))
    app = press(visitor(), "open")
    assert "no folder in which it can keep the answers" in words(app)
    assert STOP.question in words(app)


def test_the_wall_shows_the_machine_that_the_lecturer_sets(lecturer):
    wall = visitor(**{"class": code_of(lecturer), "wall": "on"})
    lecturer.session_state["stop"] = "by-hand"
    lecturer.run()
    for step in ("ask", "reveal", "run"):
        assert lecturer.sidebar.slider(key="m_prime")
        press(lecturer, step)
    # Now the slider is below the machine, and the wall shows its value.
    assert "m_prime" not in [slider.key for slider in lecturer.sidebar.slider]
    lecturer.slider(key="m_prime").set_value(1.1).run()
    assert wall.run().session_state["m_prime"] == 1.1
    assert "m′\u00a0=\u00a01.1\u202fkg" in words(wall)
    assert not [button for button in wall.button if button.key.startswith("class_")]


def test_the_desk_can_view_an_earlier_stop_without_the_class(lecturer):
    student = visitor(**{"class": code_of(lecturer)})
    press(lecturer, "ask")
    answer(student.run(), WRONG)
    for step in ("reveal", "run", "solve", "next"):
        press(lecturer, step)
    second = student.run().title[0].value
    assert second != STOP.heading
    lecturer.session_state["stop"] = STOP.id
    assert "The class is still at" in words(lecturer.run())
    assert "1 of 1, 100" in words(lecturer)
    assert student.run().title[0].value == second
    press(lecturer, "anew")
    assert student.run().title[0].value == STOP.heading
    assert student.radio[0].value is None


def test_the_desk_takes_the_class_back_view_by_view(lecturer, school):
    """Use the two keys of a clicker, which work in every view. Going back opens no vote again."""
    student = visitor(**{"class": code_of(lecturer)})

    def keys() -> list[tuple[str, bool]]:
        shortcuts = [(button.proto.shortcut, button.disabled) for button in lecturer.button]
        return [(shortcut, is_disabled) for shortcut, is_disabled in shortcuts if "page" in shortcut]

    assert keys() == [("pageup", True), ("pagedown", False)]
    for name in ("ask", "reveal", "run", "solve", "next"):
        press(lecturer, name)
        assert keys() == [("pageup", name == "ask"), ("pagedown", False)]
    shown = [school.read(code_of(lecturer)).current.phase]
    for _ in range(4):
        press(lecturer, "back")
        shown.append(school.read(code_of(lecturer)).current.phase)
    assert shown == [0, 3, 2, 1, 0]
    assert school.read(code_of(lecturer)).current.stop == lecturer.session_state["stop"] == STOP.id
    assert STOP.question in words(student.run())
    assert not student.radio
    press(lecturer, "reveal")
    assert "Nobody has voted." in words(student.run())
    # The desk opens a stop that the class has not reached.
    lecturer.session_state["stop"] = [stop.id for stop in lesson.STOPS if stop.is_in_short_lesson][3]
    lecturer.run()
    assert keys() == [("pageup", False), ("pagedown", False)]
    press(lecturer, "back")
    assert school.read(code_of(lecturer)).current.stop == STOP.id != lecturer.session_state["stop"]


def test_at_the_end_the_class_sees_its_results_without_the_code(lecturer, school):
    students = [visitor(**{"class": code_of(lecturer)}) for _ in range(2)]
    code = code_of(lecturer)
    wall = visitor(**{"class": code, "wall": "on"})
    path = [stop for stop in lesson.STOPS if stop.is_in_short_lesson]
    press(lecturer, "ask")
    for student, option in zip(students, (WRONG, RIGHT), strict=True):
        answer(student.run(), option)
    press(lecturer, "again")
    for student in students:
        answer(student.run(), RIGHT)
    for number in range(len(path)):
        for step in ("reveal", "run", "solve"):
            press(lecturer, step)
        press(lecturer, "next" if number < len(path) - 1 else "finish")
    for page in (lecturer, wall.run(), students[0].run()):
        assert "1 of 2, 50\u202f%" in words(page)
        assert "2 of 2, 100\u202f%" in words(page)
        assert all(stop.heading in words(page) for stop in path)
    assert f"{code[:3]} {code[3:]}" not in words(wall)
    with pytest.raises(rules.ClassError, match="asked no question"):
        school.vote(class_seat(students[0]), STOP.id, RIGHT)
    press(students[0], "alone")
    assert not {"class"} & set(address(students[0]))
    press(lecturer, "back")
    assert path[-1].heading == wall.run().title[0].value
    # Before a class is deleted, the page offers its votes again.
    ending = [button.proto.id for button in lecturer.get("download_button")]
    assert sum("class_csv" in each for each in ending) == 2
    assert "Seats that never voted" not in words(lecturer)
    lecturer.session_state["class_seats"] = True
    assert "Seats that never voted: 0. Seats taken in the last minute: " in words(lecturer.run())


def class_seat(student: AppTest) -> rules.Seat:
    return student.session_state["class_seat"]


def test_a_class_at_the_stop_of_another_version_shows_one_sentence_on_each_screen(lecturer, school):
    code, key = code_of(lecturer), address(lecturer)["lecturer"]
    school.ask(key, "stop-of-another-version", ["yes", "no"])
    for page in (lecturer.run(), visitor(**{"class": code}), visitor(**{"class": code, "wall": "on"})):
        assert "at a question that this version of the app does not have" in words(page)


def test_desk_and_phone_describe_the_stored_data(school):
    app = visitor()
    before = datetime.now(UTC) + timedelta(days=7)
    [offered] = [caption.value for caption in app.caption if "without names" in caption.value]
    student = visitor(**{"class": school.open_class().code})
    [stored] = [caption.value for caption in student.caption if "without names" in caption.value]
    after = datetime.now(UTC) + timedelta(days=7)
    assert "cookie prevents extra votes for 30 days" in offered
    for sentence in (offered, stored):
        assert sentence.endswith((f"{before:%Y-%m-%d}.", f"{after:%Y-%m-%d}."))
