"""The votes of a class: none is lost, none is visible too early, and every access needs its key."""

import multiprocessing
import os
import random
import signal
import sqlite3
import string
import time
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from dataclasses import astuple
from functools import partial
from pathlib import Path

import pytest

from ramanujan.lesson import class_store, classes
from ramanujan.lesson.class_codes import ALPHABET, hash_browser, read_code
from ramanujan.lesson.classes import (
    CLASSES,
    DAY,
    MINUTE,
    NETWORK_SEATS,
    PRESENCE_DURATION,
    STUDENTS,
    ClassError,
    CrowdError,
    Phase,
    Seat,
    SeatError,
    Vote,
)

OPTIONS = ["machine", "plain", "neither"]
FIRST = Vote()
NEW_PROCESS = multiprocessing.get_context("forkserver")
NEW_PROCESS.set_forkserver_preload(["tests.test_classes"])  # import the common modules once


class Clock:
    """A clock that advances only on demand."""

    now = 1_729_000_000.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def school(tmp_path: Path, clock: Clock) -> classes.Classes:
    return classes.Classes(tmp_path / "classes.sqlite", clock)


@pytest.fixture
def opened(school: classes.Classes) -> classes.Class:
    """A class with the question “faster”."""
    opened = school.open_class()
    school.ask(opened.key, "faster", OPTIONS)
    return opened


def answered(school: classes.Classes, opened: classes.Class) -> int:
    return school.read_question(opened.code).answered


def chosen(school: classes.Classes, seat: Seat) -> str | None:
    return school.read_answer(seat, school.read_question(seat.code))


def no_such_code(code: str) -> str:
    """Return a well-formed code that is not this one."""
    return code[:-1] + next(letter for letter in ALPHABET if letter != code[-1])


# ---- no vote is lost


def answer_as(
    place: Path | str, code: str, students: range, votes: multiprocessing.Queue, retries: bool = False
) -> None:
    """Join, answer and change answers as some students, in another process. With `retries`, retry failed attempts."""
    school, chance = classes.Classes(place, Clock()), random.Random(students.start)

    def act(action: Callable, *values: object) -> object:
        while True:
            with suppress(*[ClassError] if retries else []):
                return action(*values)
            time.sleep(0.05)

    seats = [act(school.join, code, "", f"10.0.0.{student}") for student in students]
    for _ in range(5 if retries else chance.randint(2, 3)):
        chance.shuffle(seats)
        for seat in seats:
            option = chance.choice(OPTIONS)
            act(school.vote, seat, "faster", option)
            votes.put((seat.voter, option))


def answer_until_killed(path: Path, code: str, votes: multiprocessing.connection.Connection) -> None:
    """Answer once, then begin another answer and lock the file without ending."""
    school = classes.Classes(path, Clock())
    first, second = (school.join(code) for _ in range(2))
    school.vote(first, "faster", "neither")
    with school._store.writing() as execute:
        execute("INSERT INTO vote VALUES (?, 'faster', 1, 1, ?, 'neither')", (code, second.voter))
        votes.send(first.voter)
        signal.pause()


def collect_confirmed(processes: list, votes: multiprocessing.Queue) -> dict[str, str]:
    """Wait until all processes have succeeded. Return the last confirmed answer of each voter."""
    last_answers = {}
    while any(process.is_alive() for process in processes) or not votes.empty():
        while not votes.empty():
            voter, option = votes.get()
            last_answers[voter] = option
    for process in processes:
        process.join()
    assert {process.exitcode for process in processes} == {0}
    return last_answers


def test_two_hundred_students_lose_no_vote_when_a_process_is_killed(school, opened):
    path, votes = school._store.path, NEW_PROCESS.Queue()
    ours, theirs = NEW_PROCESS.Pipe()
    victim = NEW_PROCESS.Process(target=answer_until_killed, args=(path, opened.code, theirs))
    victim.start()
    theirs.close()
    before_death = ours.recv()  # raises an error if the process has died too early
    # The victim has locked the file, so the others wait.
    others = [
        NEW_PROCESS.Process(target=answer_as, args=(path, opened.code, range(start, start + 50), votes))
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
    monkeypatch.setattr(class_store, "PATIENCE", 0.0)
    seat = school.join(opened.code)
    busy = classes.Classes(school._store.path, school._clock)
    with busy._store.writing(), pytest.raises(ClassError, match="too much to do"):
        school.vote(seat, "faster", "plain")
    school.vote(seat, "faster", "plain")
    assert answered(school, opened) == 1


# ---- visibility of results


def test_the_distribution_is_hidden_until_it_is_revealed(school, opened):
    seat = school.join(opened.code)
    school.vote(seat, "faster", "plain")
    for asked in (None, FIRST, Vote(1, 2)):
        with pytest.raises(ClassError, match="not been shown"):
            school.read_distribution(opened.code, "faster", asked)
    with pytest.raises(ClassError, match="not been shown"):
        school.count_changes(opened.code, "faster", "plain")
    assert school.read_results_for_lecturer(opened.key) == []
    # The public data do not depend on the answers.
    before = school.read_question(opened.code)
    school.vote(seat, "faster", "machine")
    assert school.read_question(opened.code) == before
    assert (before.answered, before.present) == (1, 1)

    school.show(opened.key, Phase.REVEALED)
    assert school.read_distribution(opened.code, "faster") == {"machine": 1, "plain": 0, "neither": 0}
    school.begin_second_vote(opened.key)
    # The first vote is public. The second is hidden, also in the comparison.
    assert school.read_distribution(opened.code, "faster", FIRST) == {"machine": 1, "plain": 0, "neither": 0}
    for refused in (
        lambda: school.read_distribution(opened.code, "faster", Vote(1, 2)),
        lambda: school.count_changes(opened.code, "faster", "machine"),
    ):
        with pytest.raises(ClassError, match="not been shown"):
            refused()


def test_a_hidden_first_vote_is_revealed_with_the_second(school, opened):
    seat = school.join(opened.code)
    school.vote(seat, "faster", "plain")
    school.begin_second_vote(opened.key)
    with pytest.raises(ClassError, match="not been shown"):
        school.read_distribution(opened.code, "faster", FIRST)
    school.show(opened.key, Phase.REVEALED)
    assert school.read_distribution(opened.code, "faster", FIRST)["plain"] == 1


def test_first_and_second_vote_are_compared_student_by_student(school, opened):
    """Compare with a manual count. A student with one answer is in one distribution, and not in the changes."""
    votes = [
        ("plain", "machine"),
        ("plain", "machine"),
        ("neither", "machine"),
        ("machine", "plain"),
        ("machine", "machine"),
        ("plain", "neither"),
        ("neither", "neither"),
        ("plain", None),
        (None, "machine"),
    ]
    seats = [school.join(opened.code) for _ in votes]
    for number in (1, 2):
        for seat, options in zip(seats, votes, strict=True):
            option = options[number - 1]
            if option:
                school.vote(seat, "faster", option, Vote(1, number))
        school.begin_second_vote(opened.key) if number == 1 else school.show(opened.key, Phase.REVEALED)
    assert school.read_distribution(opened.code, "faster", FIRST) == {"machine": 2, "plain": 4, "neither": 2}
    assert school.read_distribution(opened.code, "faster", Vote(1, 2)) == {"machine": 5, "plain": 1, "neither": 2}
    # (right in the first vote, right in the second vote) → number of students
    changes = {(False, True): 3, (True, False): 1, (True, True): 1, (False, False): 2}
    assert school.count_changes(opened.code, "faster", "machine") == changes


def test_an_answer_is_changed_until_the_reveal_and_a_late_one_is_refused_with_its_reason(school, opened):
    seat = school.join(opened.code)

    def vote(stop: str = "faster", option: str = "plain", asked: Vote = FIRST) -> None:
        school.vote(seat, stop, option, asked)

    vote()
    vote(option="neither")
    assert chosen(school, seat) == "neither"
    assert answered(school, opened) == 1
    with pytest.raises(ClassError, match="no such answer"):
        vote(option="nobody")
    school.begin_second_vote(opened.key)
    with pytest.raises(ClassError, match="another vote has begun"):
        vote()
    assert chosen(school, seat) is None
    school.show(opened.key, Phase.REVEALED)
    with pytest.raises(ClassError, match="already been shown"):
        vote(asked=Vote(1, 2))
    school.ask(opened.key, "energy", ["spring", "slab"])
    with pytest.raises(ClassError, match="another question"):
        vote(asked=Vote(1, 2))
    # A return to a stop restores its state.
    school.ask(opened.key, "faster", OPTIONS)
    assert astuple(school.read_question(opened.code))[:3] == ("faster", Vote(1, 2), Phase.REVEALED)
    with pytest.raises(ClassError, match="already voted twice"):
        school.begin_second_vote(opened.key)


def test_a_solved_question_cannot_be_asked_again(school, opened):
    school.show(opened.key, Phase.SOLVED)
    assert astuple(school.read_question(opened.code))[1:3] == (FIRST, Phase.SOLVED)
    with pytest.raises(ClassError, match="already seen the right answer"):
        school.begin_second_vote(opened.key)


def test_a_class_without_a_question_accepts_no_answer(school):
    opened = school.open_class()
    seat = school.join(opened.code)
    assert school.read_question(opened.code).stop is None
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


@pytest.mark.parametrize("text", ["", "A" * 10_000, "'; DROP TABLE class;--", "ⒷⒸⒹⒻⒽⒿ", "bcd fgh"])
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
            school.join(no_such_code(opened.code), f"guesser {number}", "10.0.0.7")
    assert school.join(opened.code, "latecomer", "10.0.0.7").code == opened.code


@pytest.mark.parametrize(
    ("addresses", "elsewhere"),
    [
        (["10.0.0.7", "::ffff:10.0.0.7"], "10.0.0.8"),
        ([f"2001:db8:0:7:{number:x}::1" for number in range(100)], "2001:db8:0:8::1"),
        ([""], "10.0.0.7"),
    ],
)
def test_a_network_gets_seats_as_fast_as_a_lecture_hall_takes_them(school, opened, clock, addresses, elsewhere):
    for number in range(NETWORK_SEATS):
        clock.now += 0.5
        school.join(opened.code, f"phone {number}", addresses[number % len(addresses)])
    assert NETWORK_SEATS >= 60
    for number in range(30):
        with pytest.raises(CrowdError, match="joins by itself"):
            school.join(opened.code, f"script {number}", addresses[number % len(addresses)])
    # A student with a seat keeps it, and other students need not wait.
    assert school.join(opened.code, "phone 0", addresses[0]).voter == "phone 0"
    school.join(opened.code, "another", elsewhere)
    seats = school.count_seats(opened.key)
    assert (seats.taken, seats.newcomers) == (NETWORK_SEATS + 1, NETWORK_SEATS + 1)
    # They joined within half a minute, so the first seat is free half a minute later.
    clock.now += MINUTE / 2 + 0.5
    school.join(opened.code, "script 0", addresses[0])
    with pytest.raises(CrowdError):
        school.join(opened.code, "script 1", addresses[0])
    clock.now += MINUTE
    school.join(opened.code, "script 2", addresses[0])
    rows = sqlite3.connect(school._store.path).execute("SELECT COUNT(*) FROM voter WHERE network IS NOT NULL")
    assert rows.fetchone() == (1,)


def test_lecturer_closes_the_class_and_removes_absent_students_with_their_answers(school, opened, clock):
    stays = school.join(opened.code, "stays")
    empty = [school.join(opened.code, f"script {number}") for number in range(38)]
    for seat in empty:
        school.vote(seat, "faster", "plain")
    school.vote(stays, "faster", "machine")
    seats = school.count_seats(opened.key)
    assert (seats.taken, seats.present, seats.newcomers, seats.is_open) == (39, 39, 39, True)
    school.let_join(opened.key, False)
    clock.now += PRESENCE_DURATION + 1
    school.join(opened.code, "stays")
    with pytest.raises(ClassError, match="closed this class to newcomers"):
        school.join(opened.code, "script 99")
    school.remove_absent(opened.key)
    seats = school.count_seats(opened.key)
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


def test_only_the_key_opens_the_lecturers_desk(school, opened):
    other = school.open_class()
    seat = school.join(opened.code)
    wrong = [
        "",
        "-",
        opened.code,
        f"{opened.code}-",
        opened.key[:-1],
        f"{opened.key}x",
        f"{opened.code}-{other.key.partition('-')[2]}",
        f"{opened.code}-{seat.voter}",
        f"{opened.code}-é",
    ]
    for key in wrong:
        reveal = partial(school.show, phase=Phase.REVEALED)
        for act in (
            reveal,
            school.begin_second_vote,
            school.close,
            school.count_seats,
            school.read_results_for_lecturer,
        ):
            with pytest.raises(ClassError, match="belongs to no class"):
                act(key)
        with pytest.raises(ClassError, match="belongs to no class"):
            school.ask(key, "faster", OPTIONS)
    assert school.read_question(opened.code).stop == "faster"


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


def test_a_browser_is_a_different_voter_in_each_class(school, opened):
    """Three tabs of one phone share one vote. Another phone has a second vote."""
    other = school.open_class()
    tabs = [school.join(opened.code, hash_browser("phone", opened.code.lower())) for _ in range(3)]
    neighbour = school.join(opened.code, hash_browser("another phone", opened.code))
    for seat, option in zip(tabs, OPTIONS, strict=True):
        school.vote(seat, "faster", option)
    school.vote(neighbour, "faster", "plain")
    school.show(opened.key, Phase.REVEALED)
    assert school.read_distribution(opened.code, "faster") == {"machine": 0, "plain": 1, "neither": 1}
    assert school.read_question(opened.code).present == 2
    assert school.join(other.code, hash_browser("phone", other.code)).voter != tabs[0].voter


def test_students_with_a_recent_request_count_as_present(school, opened, clock):
    stays, leaves = school.join(opened.code), school.join(opened.code)
    for seat in (stays, leaves):
        school.vote(seat, "faster", "plain")
    clock.now += 19
    chosen(school, stays)
    clock.now += 2
    question = school.read_question(opened.code)
    assert (question.answered, question.present) == (1, 1)
    school.show(opened.key, Phase.REVEALED)
    # The votes of absent students count, too.
    assert school.read_distribution(opened.code, "faster")["plain"] == 2


def test_a_stop_that_is_asked_again_later_begins_a_new_vote_and_keeps_the_old_ones(school, opened, clock):
    seat = school.join(opened.code)
    school.vote(seat, "faster", "plain", FIRST)
    school.begin_second_vote(opened.key)
    school.vote(seat, "faster", "neither", Vote(1, 2))
    school.show(opened.key, Phase.SOLVED)
    clock.now += 60
    school.ask(opened.key, "energy", ["spring", "slab"])
    school.vote(seat, "energy", "slab")
    school.show(opened.key, Phase.REVEALED)
    clock.now += 60
    school.ask(opened.key, "faster", OPTIONS, anew=True)
    assert chosen(school, seat) is None
    assert not school.read_question(opened.code).vote.is_second
    school.vote(seat, "faster", "machine", Vote(2))
    school.show(opened.key, Phase.REVEALED)
    first, second, third = school.read_results_for_lecturer(opened.key)
    votes = [{option: n for option, n in each.items() if n} for each in (first.first, first.second, third.first)]
    assert votes == [{"plain": 1}, {"neither": 1}, {"machine": 1}]
    assert [each.stop for each in (first, second, third)] == ["faster", "energy", "faster"]
    assert (second.second, third.second) == (None, None)
    assert [each.at - first.at for each in (second, third)] == [60, 120]
    assert {each.present for each in (first, second, third)} == {1}


# ---- limits and the end


def test_expired_class_is_deleted_with_all_its_rows(school, opened, clock):
    seat = school.join(opened.code)
    school.vote(seat, "faster", "plain")
    clock.now += DAY - 1
    assert school.find_code(opened.key) == opened.code
    clock.now += 1
    for act in (
        lambda: school.read_question(opened.code),
        lambda: school.join(opened.code),
        lambda: school.vote(seat, "faster", "plain"),
        lambda: school.read_expiry(opened.code),
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
        school.read_question(opened.code)
    assert count_rows(school) == {"class": 1, "question": 0, "voter": 0, "vote": 0}
    assert school.read_question(other.code).present == 0


def count_rows(school: classes.Classes) -> dict[str, int]:
    """Count the rows of each table, read directly from the database file."""
    file = sqlite3.connect(school._store.path)
    tables = ("class", "question", "voter", "vote")
    return {table: file.execute(f"SELECT COUNT(*) FROM {table}").fetchone()[0] for table in tables}


def stored_bytes(school: classes.Classes) -> bytes:
    """Return the content of all files of the database."""
    return b"".join(file.read_bytes() for file in school._store.path.parent.iterdir())


def test_delete_expired_overwrites_the_answers_and_creates_no_database(school, opened, clock):
    seat = school.join(opened.code, "a voter with a long name", "10.0.0.7")
    school.vote(seat, "faster", "plain")
    lasting = school.open_class(30 * DAY)
    assert seat.voter.encode() in stored_bytes(school)  # negative control
    clock.now += DAY
    school.delete_expired()
    assert seat.voter.encode() not in stored_bytes(school)
    assert opened.code.encode() not in stored_bytes(school)
    assert count_rows(school) == {"class": 1, "question": 0, "voter": 0, "vote": 0}
    assert school.read_expiry(lasting.code) == clock.now + 29 * DAY
    unused = classes.Classes(school._store.path.parent / "unused" / "classes.sqlite", clock)
    unused.delete_expired()
    assert not unused._store.path.parent.exists()


def test_full_class_raises_a_sentence(school, opened):
    for number in range(STUDENTS):
        seat = school.join(opened.code, address=f"10.0.{number // 50}.7")
    with pytest.raises(ClassError, match="full: it has 500 students"):
        school.join(opened.code)
    school.join(opened.code, seat.voter)


def test_lecturer_gets_a_class_during_a_flood_of_openings(school, opened, clock):
    """A flood comes from several networks, and each is slowed down. A class with students is not deleted."""
    school.join(opened.code)
    lecture = school.open_class(address="10.9.0.1")
    flood = []
    for number in range(2 * CLASSES):
        clock.now += 0.1
        flood.append(school.open_class(address=f"10.0.{number // NETWORK_SEATS}.7"))
    assert count_rows(school)["class"] == CLASSES
    # The oldest classes without students have been deleted, including the lecturer's.
    assert school.find_code(flood[-1].key)
    for deleted in (lecture, flood[0]):
        with pytest.raises(ClassError, match="belongs to no class"):
            school.find_code(deleted.key)
    again = school.open_class(address="10.9.0.1")
    assert school.join(again.code)
    assert school.find_code(opened.key)


def test_the_classes_of_a_network_are_limited_and_the_network_is_deleted(school, clock):
    for number in range(NETWORK_SEATS):
        school.open_class(address=f"2001:db8:0:7:{number:x}::1")
    with pytest.raises(CrowdError, match="60 classes were opened from your network"):
        school.open_class(address="2001:db8:0:7::1")
    school.open_class(address="2001:db8:0:8::1")
    clock.now += MINUTE
    school.open_class(address="2001:db8:0:7::1")
    rows = sqlite3.connect(school._store.path).execute("SELECT COUNT(*) FROM class WHERE network IS NOT NULL")
    assert rows.fetchone() == (1,)


def test_class_limit_raises_a_sentence(school, clock):
    for number in range(CLASSES):
        school.join(school.open_class(address=f"10.0.{number // NETWORK_SEATS}.7").code)
    with pytest.raises(ClassError, match="no room for another class"):
        school.open_class()
    clock.now += DAY
    school.open_class()


def test_unusable_file_raises_a_sentence(tmp_path):
    no_database = tmp_path / "notes.txt"
    no_database.write_text("Nothing that SQLite has written. " * 100)
    for path, sentence in (
        (no_database, "cannot keep answers"),
        (tmp_path, "cannot keep answers"),
        (no_database / "classes.sqlite", "no folder in which it can keep"),
    ):
        with pytest.raises(ClassError, match=sentence):
            classes.Classes(path).open_class()
    assert no_database.read_text().startswith("Nothing")


def test_an_upgrade_of_the_app_preserves_a_class(school, opened):
    """The first schema had no number and lacked the columns of the second."""
    seat = school.join(opened.code)
    school.vote(seat, "faster", "plain")
    with sqlite3.connect(school._store.path) as file:
        for column in ("opened", "network", "was_joined"):
            file.execute(f"ALTER TABLE class DROP COLUMN {column}")
        file.execute("PRAGMA user_version = 0")
    assert chosen(school, seat) == "plain"
    # The upgraded class may have had students, so it is not deleted for another class.
    for number in range(CLASSES):
        school.open_class(address=f"10.0.{number // NETWORK_SEATS}.7")
    assert school.find_code(opened.key)


def test_a_deleted_or_damaged_file_accepts_no_vote(school, opened):
    """Temporary files may be deleted, and a disk may be full. Only stored votes are acknowledged."""
    path, seat = school._store.path, school.join(opened.code)
    for number in range(100):
        school.join(opened.code, f"student {number}", f"10.0.0.{number}")
    whole = path.read_bytes()

    def refused(sentence: str) -> None:
        with pytest.raises(ClassError, match=sentence):
            school.vote(seat, "faster", "plain")

    path.unlink()
    refused("no class with this code")
    path.write_bytes(whole[: len(whole) // 2])
    refused("cannot keep answers")
    path.write_bytes(b"")
    refused("no class with this code")
    again = school.open_class()
    assert school.join(again.code).code == again.code
    path.write_bytes(whole)
    school.vote(seat, "faster", "plain")
    assert answered(school, opened) == 1


def test_the_environment_sets_the_file_and_only_its_owner_can_read_it(tmp_path, monkeypatch):
    monkeypatch.setenv("RAMANUJAN_CLASSES", str(tmp_path / "here.sqlite"))
    classes.shared().open_class()
    assert {file.name.partition("-")[0] for file in tmp_path.iterdir()} == {"here.sqlite"}
    assert all(file.stat().st_mode & 0o077 == 0 for file in tmp_path.iterdir())


@pytest.mark.skipif(os.name != "posix", reason="other systems name the folder otherwise")
def test_by_default_the_file_is_in_the_data_folder_of_the_user(tmp_path, monkeypatch):
    """Answers are stored for up to 30 days, but a restart empties a folder for temporary files."""
    monkeypatch.delenv("RAMANUJAN_CLASSES")
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.setenv("HOME", str(tmp_path))
    for named, folder in (("", tmp_path / ".local/share"), (str(tmp_path / "data"), tmp_path / "data")):
        monkeypatch.setenv("XDG_DATA_HOME", named)
        classes.shared().open_class()
        assert (folder / "ramanujan/classes.sqlite").stat().st_mode & 0o077 == 0
        assert (folder / "ramanujan").stat().st_mode & 0o077 == 0
