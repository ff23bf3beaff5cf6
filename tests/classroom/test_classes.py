"""The votes of a class: none is lost, none is visible too early, and every access needs its key."""

import multiprocessing
import os
import shutil
import signal
import sqlite3
import string
import time
from collections import Counter
from collections.abc import Iterable
from contextlib import closing
from dataclasses import astuple
from pathlib import Path

import pytest

from ramanujan.classroom import rules, store
from ramanujan.classroom.codes import ALPHABET, read_code
from ramanujan.classroom.rules import (
    ABSENCE,
    CLASSES,
    LIFETIME,
    PRESENCE_DURATION,
    PRESENCE_INTERVAL,
    STUDENTS,
    ClassError,
    Phase,
    Seat,
    SeatError,
)
from tests.checks.classes import (  # noqa: F401 (these tests also use PostgreSQL)
    FIRST,
    NEW_PROCESS,
    OPTIONS,
    Clock,
    answer_as,
    answered,
    chosen,
    collect_confirmed,
    test_a_browser_is_a_different_voter_in_each_class,
    test_a_stop_that_is_asked_again_later_begins_a_new_vote_and_keeps_the_old_ones,
    test_an_answer_is_changed_until_the_reveal_and_a_late_one_is_refused_with_its_reason,
    test_first_and_second_vote_are_compared_student_by_student,
    test_only_the_key_opens_the_lecturers_desk,
    test_seats_that_never_voted_and_new_seats_are_counted,
    test_students_with_a_recent_request_count_as_present,
    test_the_distribution_is_hidden_until_it_is_revealed,
)
from tests.settings import PATIENCE


@pytest.fixture
def school(tmp_path: Path, clock: Clock) -> rules.Classes:
    return rules.Classes(tmp_path / "classes.sqlite", clock)


def no_such_code(code: str) -> str:
    """Return a well-formed code that is not this one."""
    return code[:-1] + next(letter for letter in ALPHABET if letter != code[-1])


# ---- no vote is lost


def answer_until_killed(path: Path, code: str, votes: multiprocessing.connection.Connection) -> None:
    """Answer once, then begin another answer and lock the file without ending."""
    school = rules.Classes(path, Clock())
    first, second = (school.join(code) for _ in range(2))
    school.vote(first, "faster", "neither")
    with school._store.writing() as execute:
        execute("INSERT INTO vote VALUES (?, 'faster', 1, 1, ?, 'neither')", (code, second.voter))
        votes.send(first.voter)
        signal.pause()


def test_two_hundred_students_lose_no_vote_when_a_process_is_killed(school, opened):
    path, votes = school._store.path, NEW_PROCESS.Queue()
    ours, theirs = NEW_PROCESS.Pipe()
    victim = NEW_PROCESS.Process(target=answer_until_killed, args=(path, opened.code, theirs), daemon=True)
    victim.start()
    theirs.close()
    before_death = ours.recv()  # raises an error if the process has died too early
    # The victim has locked the file, so the others wait.
    others = [
        NEW_PROCESS.Process(target=answer_as, args=(path, opened.code, range(start, start + 50), votes), daemon=True)
        for start in range(0, 200, 50)
    ]
    for process in others:
        process.start()
    os.kill(victim.pid, signal.SIGKILL)
    confirmed = {before_death: "neither"} | collect_confirmed(others, votes)
    victim.join()
    assert victim.exitcode == -signal.SIGKILL
    assert len(confirmed) == 201
    assert answered(school, opened) == 201
    school.show(opened.key, Phase.REVEALED)
    # The count contains the last confirmed answer of each student, and no unfinished one.
    counts = Counter(confirmed.values())
    assert school.read_distribution(opened.code, "faster") == {option: counts[option] for option in OPTIONS}


def test_timeout_raises_a_sentence(school, opened, monkeypatch):
    monkeypatch.setattr(store, "PATIENCE", 0.0)
    seat = school.join(opened.code)
    busy = rules.Classes(school._store.path, school._clock)
    with busy._store.writing(), pytest.raises(ClassError, match="too much to do"):
        school.vote(seat, "faster", "plain")
    school.vote(seat, "faster", "plain")
    assert answered(school, opened) == 1


# ---- visibility of results


def test_a_hidden_first_vote_is_revealed_with_the_second(school, opened):
    seat = school.join(opened.code)
    school.vote(seat, "faster", "plain")
    school.begin_second_vote(opened.key)
    with pytest.raises(ClassError, match="not been shown"):
        school.read_distribution(opened.code, "faster", FIRST)
    school.show(opened.key, Phase.REVEALED)
    assert school.read_distribution(opened.code, "faster", FIRST)["plain"] == 1


def test_a_solved_question_cannot_be_asked_again(school, opened):
    school.show(opened.key, Phase.SOLVED)
    assert astuple(school.read(opened.code).current)[1:3] == (FIRST, Phase.SOLVED)
    with pytest.raises(ClassError, match="already seen the right answer"):
        school.begin_second_vote(opened.key)


def test_a_class_without_a_question_accepts_no_answer(school):
    opened = school.open_class()
    seat = school.join(opened.code)
    assert school.read(opened.code).current.stop is None
    for act in (
        lambda: school.vote(seat, "faster", "plain"),
        lambda: school.show(opened.key, Phase.REVEALED),
        lambda: school.begin_second_vote(opened.key),
    ):
        with pytest.raises(ClassError, match="asked no question"):
            act()


# ---- codes, keys and seats


def test_a_code_is_read_in_any_spelling_and_its_letters_are_distinct(school, opened):
    typed = f" {opened.code[:3].lower()}-{opened.code[3:]}\n"
    assert school.join(typed).code == opened.code
    assert not set(ALPHABET) & set("AEIOUY" + "QGV" + string.digits)
    assert len({school.open_class().code for _ in range(50)}) == 50


@pytest.mark.parametrize(
    ("text", "code"),
    [
        # Cyrillic, Greek, full-width letters
        ("ВСКМРТ", "BCKMPT"),
        ("всн хѕј", "BCHXSJ"),
        ("ΒΗΚΜΝΡ", "BHKMNP"),
        ("ΤΧΖкРD", "TXZKPD"),
        ("ｂｃｄ\u3000ｆｈｊ", "BCDFHJ"),
        # Links
        ("https://school.example/de/lesson?class=BCDFHJ", "BCDFHJ"),
        ("localhost:8501/lesson?m_prime=1.1272&class=BCDFHJ&part=tasks#top", "BCDFHJ"),
        ("Join here: https://school.example/lesson?class=BCD%20FHJ).", "BCDFHJ"),
        (f"https://school.example/lesson?{'m=2&' * 100}class=BCDFHJ", "BCDFHJ"),
    ],
)
def test_look_alike_letters_and_links_are_read_as_a_code(text, code):
    assert read_code(text) == code


@pytest.mark.parametrize(
    "text",
    [
        "",
        "A" * 10_000,
        "'; DROP TABLE class;--",
        "bcd fgh",
        "БЮЛЯ",
        "https://school.example/lesson",
        "/lesson?class=bcd",
    ],
)
def test_invalid_code_raises_a_sentence(school, text):
    assert read_code(text) is None
    with pytest.raises(ClassError, match=r"has six letters|contains [AG]"):
        school.join(text)


def test_repeating_a_counted_answer_after_the_reveal_is_accepted(school, opened):
    """A browser may repeat an answer after losing its connection. A different answer is too late."""
    seat, other = school.join(opened.code), school.join(opened.code)
    school.vote(seat, "faster", "plain", FIRST)
    school.show(opened.key, Phase.REVEALED)
    school.vote(seat, "faster", "plain", FIRST)
    school.begin_second_vote(opened.key)
    school.vote(seat, "faster", "plain", FIRST)
    assert school.read_distribution(opened.code, "faster", FIRST)["plain"] == 1
    for voter, option in ((seat.voter, "machine"), (other.voter, "plain")):
        with pytest.raises(ClassError, match="too late"):
            school.vote(Seat(opened.code, voter), "faster", option, FIRST)


def test_right_code_works_after_many_wrong_ones(school, opened):
    for number in range(30):
        with pytest.raises(ClassError, match="no class with this code"):
            school.join(no_such_code(opened.code), f"guesser {number}")
    assert school.join(opened.code, "latecomer").code == opened.code


def test_lecturer_closes_the_class_and_removes_absent_students_with_their_answers(school, opened, clock):
    stays = school.join(opened.code, "stays")
    empty = [school.join(opened.code, f"script {number}") for number in range(38)]
    for seat in empty:
        school.vote(seat, "faster", "plain")
    school.vote(stays, "faster", "machine")
    seats = school.read(opened.code)
    assert (seats.taken, seats.present, seats.is_open) == (39, 39, True)
    school.let_join(opened.key, False)
    clock.now += PRESENCE_DURATION + 1
    school.join(opened.code, "stays")
    with pytest.raises(ClassError, match="closed this class to newcomers"):
        school.join(opened.code, "script 99")
    school.remove_absent(opened.key)
    seats = school.read(opened.code)
    assert (seats.taken, seats.present, seats.is_open) == (1, 1, False)
    for act in (lambda: chosen(school, empty[0]), lambda: school.vote(empty[0], "faster", "plain")):
        with pytest.raises(SeatError, match="did not count"):
            act()
    school.let_join(opened.key, True)
    back = school.join(opened.code, "script 0")
    assert chosen(school, back) is None
    school.show(opened.key, Phase.REVEALED)
    assert school.read_distribution(opened.code, "faster") == {"machine": 1, "plain": 0, "neither": 0}
    # Results that the class has seen do not change.
    clock.now += PRESENCE_DURATION + 1
    school.remove_absent(opened.key)
    assert school.read_distribution(opened.code, "faster")["machine"] == 1


def test_database_does_not_contain_the_lecturers_key(school, opened):
    secret = opened.key.partition("-")[2]
    assert len(secret) >= 32
    seat = school.join(opened.code)
    rows = b"".join(file.read_bytes() for file in school._store.path.parent.iterdir())
    assert secret.encode() not in rows
    assert seat.voter.encode() in rows  # Negative control: the search finds a value stored in plain text.


def test_a_voter_without_a_seat_cannot_vote(school, opened):
    other = school.open_class()
    seat = school.join(other.code)
    for voter in ("", "somebody", seat.voter):
        with pytest.raises(ClassError, match="did not count"):
            school.vote(Seat(opened.code, voter), "faster", "plain")
    assert answered(school, opened) == 0


# ---- limits and the end


def test_expired_class_is_deleted_with_all_its_rows(school, opened, clock):
    seat = school.join(opened.code)
    school.vote(seat, "faster", "plain")
    clock.now += LIFETIME - 1
    assert school.find_code(opened.key) == opened.code
    clock.now += 1
    for act in (
        lambda: school.read(opened.code),
        lambda: school.join(opened.code),
        lambda: school.vote(seat, "faster", "plain"),
        lambda: school.read_for_lecturer(opened.key),
    ):
        with pytest.raises(ClassError, match=r"has ended|may have ended"):
            act()
    assert count_rows(school) == {"class": 0, "question": 0, "voter": 0, "vote": 0}


def test_closed_class_is_deleted_at_once(school, opened):
    other = school.open_class()
    seat = school.join(opened.code)
    school.vote(seat, "faster", "plain")
    school.close(opened.key)
    with pytest.raises(ClassError, match=r"has ended|may have ended"):
        school.read(opened.code)
    assert count_rows(school) == {"class": 1, "question": 0, "voter": 0, "vote": 0}
    assert school.read(other.code).present == 0


def count_rows(school: rules.Classes) -> dict[str, int]:
    """Count the rows of each table, read directly from the database file."""
    file = sqlite3.connect(school._store.path)
    tables = ("class", "question", "voter", "vote")
    return {table: file.execute(f"SELECT COUNT(*) FROM {table}").fetchone()[0] for table in tables}


def stored_bytes(school: rules.Classes) -> bytes:
    """Return the content of all files of the database."""
    return b"".join(file.read_bytes() for file in school._store.path.parent.iterdir())


def test_delete_expired_overwrites_the_answers_and_creates_no_database(school, opened, clock):
    seat = school.join(opened.code, "a voter with a long name")
    school.vote(seat, "faster", "plain")
    clock.now += 1
    lasting = school.open_class()
    assert seat.voter.encode() in stored_bytes(school)  # negative control
    clock.now += LIFETIME - 1
    school.delete_expired()
    assert seat.voter.encode() not in stored_bytes(school)
    assert opened.code.encode() not in stored_bytes(school)
    assert count_rows(school) == {"class": 1, "question": 0, "voter": 0, "vote": 0}
    assert school.read(lasting.code).expires == clock.now + 1
    unused = rules.Classes(school._store.path.parent / "unused" / "classes.sqlite", clock)
    unused.delete_expired()
    assert not unused._store.path.parent.exists()


def test_full_class_raises_a_sentence(school, opened):
    for _ in range(STUDENTS):
        seat = school.join(opened.code)
    with pytest.raises(ClassError, match="full: it has 500 students"):
        school.join(opened.code)
    school.join(opened.code, seat.voter)


def stay(school: rules.Classes, clock: Clock, codes: Iterable[str], duration: float) -> None:
    """Let a screen of each class read it during some time."""
    end = clock.now + duration
    while clock.now < end:
        clock.now += PRESENCE_INTERVAL + 1
        for code in codes:
            school.read(code)


def test_lecturer_opens_a_class_after_a_stranger_has_opened_and_joined_all(school, clock):
    strangers = []
    for _ in range(CLASSES):
        clock.now += 0.1
        strangers.append(school.open_class())
        # The pages of the stranger read the class once.
        school.read(school.join(strangers[-1].code).code)
    lecture = school.open_class()
    assert count_rows(school)["class"] == CLASSES
    with pytest.raises(ClassError, match="belongs to no class"):
        school.find_code(strangers[0].key)
    assert school.find_code(strangers[1].key)
    assert school.join(lecture.code)


def test_a_class_with_somebody_present_is_not_replaced(school, clock):
    """Nobody has joined the lecturer's class, but its desk is open. The least recently used class goes first."""
    lecture, left = school.open_class(), school.open_class()
    stay(school, clock, [left.code], 20)
    clock.now += ABSENCE
    stay(school, clock, [lecture.code], 20)
    strangers = [school.open_class() for _ in range(2 * CLASSES)]
    assert count_rows(school)["class"] == CLASSES
    assert school.find_code(lecture.key)
    # Classes where nobody has stayed were replaced before the class that everybody has left.
    assert school.find_code(left.key)
    stay(school, clock, [stranger.code for stranger in strangers[-CLASSES + 2 :]], 10)
    school.open_class()
    with pytest.raises(ClassError, match="belongs to no class"):
        school.find_code(left.key)


def test_a_server_with_somebody_present_in_every_class_raises_a_sentence(school, clock):
    opened = [school.open_class().code for _ in range(CLASSES)]
    stay(school, clock, opened, 10)
    clock.now += ABSENCE - 1
    with pytest.raises(ClassError, match="no room for another class"):
        school.open_class()
    clock.now += 1
    school.open_class()


def test_two_requests_a_second_lock_nobody_out(school, clock):
    opened = school.open_class()
    for number in range(STUDENTS // 2):
        clock.now += 0.5
        # A pupil presses *Open a class*, and another one joins.
        school.open_class()
        school.join(opened.code, f"pupil {number}")
        stay(school, clock, [opened.code], 0.1)
    assert school.join(opened.code)
    assert school.find_code(school.open_class().key)
    assert school.find_code(opened.key)


def test_unusable_file_raises_a_sentence(tmp_path):
    no_database = tmp_path / "notes.txt"
    no_database.write_text("Nothing that SQLite has written. " * 100)
    for path, sentence in (
        (no_database, "cannot keep answers"),
        (tmp_path, "cannot keep answers"),
        (no_database / "classes.sqlite", "no folder in which it can keep"),
    ):
        with pytest.raises(ClassError, match=sentence):
            rules.Classes(path).open_class()
    assert no_database.read_text().startswith("Nothing")


def test_classes_of_another_version_stay_in_their_file(tmp_path, caplog):
    path = tmp_path / "classes.sqlite"
    with closing(sqlite3.connect(path)) as file:
        file.executescript(
            "CREATE TABLE class (code TEXT); INSERT INTO class VALUES ('BCDFHJ'); PRAGMA user_version = 2;"
        )
    for _process in range(2):
        school = rules.Classes(path)
        opened = school.open_class()
        assert school.find_code(opened.key)
        [sentence] = [record.message for record in caplog.records]
        assert sentence == (
            f"The classes in {path} are from another version of the app and stay there. "
            f"New ones are in {tmp_path / 'classes-4.sqlite'}."
        )
        caplog.clear()
    with closing(sqlite3.connect(path)) as file:
        assert file.execute("SELECT code FROM class").fetchall() == [("BCDFHJ",)]
    assert count_rows(school)["class"] == 2


def test_a_deleted_or_damaged_file_accepts_no_vote(school, opened):
    """Temporary files may be deleted, and a disk may be full. Only stored votes are acknowledged."""
    path, seat = school._store.path, school.join(opened.code)
    for number in range(100):
        school.join(opened.code, f"student {number}")
    wait_for_rest(path)
    whole = path.read_bytes()

    def refused(sentence: str) -> None:
        with pytest.raises(ClassError, match=sentence):
            school.vote(seat, "faster", "plain")

    path.unlink()
    refused("no class with this code")
    wait_for_rest(path)
    path.write_bytes(whole[: len(whole) // 2])
    refused("cannot keep answers")
    path.write_bytes(b"")
    refused("no class with this code")
    again = school.open_class()
    assert school.join(again.code).code == again.code
    wait_for_rest(path)
    path.write_bytes(whole)
    school.vote(seat, "faster", "plain")
    assert answered(school, opened) == 1


def wait_for_rest(path: Path) -> None:
    """Wait until all data is in the file, and its log is deleted."""
    end = time.monotonic() + PATIENCE
    while list(path.parent.glob(f"{path.name}-*")):
        assert time.monotonic() < end
        time.sleep(0.01)


def test_votes_are_copied_from_the_log_into_the_file_after_the_last_one(school, opened, monkeypatch):
    """The copy takes longer than twenty votes, and a call is never the last to close the file."""
    path, seats = school._store.path, [school.join(opened.code) for _ in range(3)]
    wait_for_rest(path)
    before = path.read_bytes()
    monkeypatch.setattr(store, "HOLD", PATIENCE)
    for seat in seats:
        school.vote(seat, "faster", "plain")
    assert path.read_bytes() == before
    school._store._rest()
    wait_for_rest(path)
    assert path.read_bytes() != before
    assert answered(school, opened) == 3


@pytest.mark.parametrize("replacement", ["nothing", "an earlier copy"])
def test_a_file_that_is_deleted_or_replaced_directly_after_a_vote(school, opened, replacement):
    """Two connections keep the old file and its log open. The new file gets no rows from the old log."""
    path, seat = school._store.path, school.join(opened.code)
    other = rules.Classes(path, school._clock)
    wait_for_rest(path)
    copy = path.with_name("copy.sqlite")
    shutil.copy(path, copy)
    for classes in (school, other):
        classes.vote(classes.join(opened.code, "lost"), "faster", "plain")
    assert path.with_name(f"{path.name}-wal").stat().st_size
    if replacement == "nothing":
        path.unlink()
        opened = school.open_class()
        school.ask(opened.key, "faster", OPTIONS)
        seat = school.join(opened.code)
    else:
        copy.replace(path)
    school.vote(seat, "faster", "plain")
    other.vote(seat, "faster", "machine")
    wait_for_rest(path)
    assert chosen(other, seat) == "machine"
    assert (answered(school, opened), school.read(opened.code).taken) == (1, 1)
    with closing(sqlite3.connect(path)) as file:
        assert file.execute("PRAGMA integrity_check").fetchall() == [("ok",)]


def test_the_environment_sets_the_file_and_only_its_owner_can_read_it(tmp_path, monkeypatch):
    monkeypatch.setenv("RAMANUJAN_CLASSES", str(tmp_path / "here.sqlite"))
    rules.shared().open_class()
    assert {file.name.partition("-")[0] for file in tmp_path.iterdir()} == {"here.sqlite"}
    assert all(file.stat().st_mode & 0o077 == 0 for file in tmp_path.iterdir())


@pytest.mark.skipif(os.name != "posix", reason="other systems name the folder otherwise")
def test_by_default_the_file_is_in_the_data_folder_of_the_user(tmp_path, monkeypatch):
    """Answers are stored for up to seven days, but a restart empties a folder for temporary files."""
    monkeypatch.delenv("RAMANUJAN_CLASSES")
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.setenv("HOME", str(tmp_path))
    for named, folder in (("", tmp_path / ".local/share"), (str(tmp_path / "data"), tmp_path / "data")):
        monkeypatch.setenv("XDG_DATA_HOME", named)
        rules.shared().open_class()
        assert (folder / "ramanujan/classes.sqlite").stat().st_mode & 0o077 == 0
        assert (folder / "ramanujan").stat().st_mode & 0o077 == 0
