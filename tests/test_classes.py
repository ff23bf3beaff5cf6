"""The class's votes: none is lost, none is seen too early, and nobody opens what is not theirs."""

from __future__ import annotations

import multiprocessing
import os
import random
import signal
import sqlite3
import string
from collections import Counter
from dataclasses import astuple
from pathlib import Path

import pytest

from ramanujan.lesson import class_file, classes
from ramanujan.lesson.class_codes import ALPHABET, read_code
from ramanujan.lesson.classes import CLASSES, LIFETIME, MINUTE, STUDENTS, WRONG_CODES, WRONG_CODES_OF_ALL, ClassError

OPTIONS = ["machine", "plain", "neither"]
NEW_PROCESS = multiprocessing.get_context("spawn")


class Clock:
    """A clock that stands still until it is told to go on."""

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
    """A class that is asked who is faster."""
    opened = school.open_class()
    school.present(opened.key, "faster", OPTIONS)
    return opened


def no_such_code(code: str) -> str:
    """Return a well-formed code that is not this one."""
    return code[:-1] + next(letter for letter in ALPHABET if letter != code[-1])


# ---- no vote is lost


def answer_as(path: Path, code: str, students: range, votes: multiprocessing.Queue) -> None:
    """Be some students, in a process of their own: join, answer, and change the answer once or twice."""
    school, chance = classes.Classes(path, Clock()), random.Random(students.start)
    seats = [school.join(code, f"session {student}") for student in students]
    for _ in range(chance.randint(2, 3)):
        chance.shuffle(seats)
        for seat in seats:
            option = chance.choice(OPTIONS)
            school.vote(code, seat.voter, "faster", option)
            votes.put((seat.voter, option))


def answer_until_killed(path: Path, code: str, votes: multiprocessing.connection.Connection) -> None:
    """Answer once, then begin an answer, hold the file in the middle of it, and never end."""
    school = classes.Classes(path, Clock())
    first, second = (school.join(code) for _ in range(2))
    school.vote(code, first.voter, "faster", "neither")
    with school._file.writing() as file:
        file.execute("INSERT INTO vote VALUES (?, 'faster', 1, ?, 'neither')", (code, second.voter))
        votes.send(first.voter)
        signal.pause()


def test_two_hundred_students_in_several_processes_lose_no_vote_though_one_process_dies(school, opened):
    path, votes = school._file.path, NEW_PROCESS.Queue()
    ours, theirs = NEW_PROCESS.Pipe()
    victim = NEW_PROCESS.Process(target=answer_until_killed, args=(path, opened.code, theirs))
    victim.start()
    theirs.close()
    before_death = ours.recv()  # an error if it has died too soon
    # The victim holds the file now: the others begin while it does, and wait.
    others = [
        NEW_PROCESS.Process(target=answer_as, args=(path, opened.code, range(start, start + 50), votes))
        for start in range(0, 200, 50)
    ]
    for process in others:
        process.start()
    os.kill(victim.pid, signal.SIGKILL)
    told = {before_death: "neither"}
    while any(process.is_alive() for process in others) or not votes.empty():
        while not votes.empty():
            voter, option = votes.get()
            told[voter] = option
    for process in (*others, victim):
        process.join()
    assert [process.exitcode for process in others] == [0] * 4
    assert victim.exitcode == -signal.SIGKILL
    assert len(told) == 201
    assert school.count(opened.key) == 201
    school.reveal(opened.key)
    # What each student was told last is what is counted; the answer that was never finished is not.
    assert school.distribution(opened.code, "faster") == {o: Counter(told.values())[o] for o in OPTIONS}


def test_whoever_waits_too_long_gets_a_sentence(school, opened, monkeypatch):
    monkeypatch.setattr(class_file, "PATIENCE", 0.0)
    monkeypatch.setattr(class_file, "BUSY_TIMEOUT", 0.0)
    seat = school.join(opened.code)
    busy = classes.Classes(school._file.path, school._clock)
    with busy._file.writing(), pytest.raises(ClassError, match="too much to do"):
        school.vote(opened.code, seat.voter, "faster", "plain")
    school.vote(opened.code, seat.voter, "faster", "plain")
    assert school.count(opened.key) == 1


# ---- what is seen, by whom, and when


def test_nobody_sees_the_distribution_before_it_is_revealed(school, opened):
    seat = school.join(opened.code)
    school.vote(opened.code, seat.voter, "faster", "plain")
    for who in (opened.code, opened.key):
        for number in (None, 1, 2):
            with pytest.raises(ClassError, match="not been shown"):
                school.distribution(who, "faster", number)
        with pytest.raises(ClassError, match="not been shown"):
            school.comparison(who, "faster", "plain")
    # What the lecturer sees is the same for every answer that was given.
    before = school.desk(opened.key)
    school.vote(opened.code, seat.voter, "faster", "machine")
    assert school.desk(opened.key) == before
    assert (before.answered, before.joined) == (1, 1)

    school.reveal(opened.key)
    assert school.distribution(opened.code, "faster") == {"machine": 1, "plain": 0, "neither": 0}
    school.ask_again(opened.key)
    # The first vote was seen; the second is not, not even by way of the comparison.
    assert school.distribution(opened.code, "faster", 1) == {"machine": 1, "plain": 0, "neither": 0}
    for refused in (
        lambda: school.distribution(opened.key, "faster", 2),
        lambda: school.comparison(opened.key, "faster", "machine"),
    ):
        with pytest.raises(ClassError, match="not been shown"):
            refused()


def test_a_first_vote_that_was_never_revealed_is_revealed_with_the_second(school, opened):
    seat = school.join(opened.code)
    school.vote(opened.code, seat.voter, "faster", "plain")
    school.ask_again(opened.key)
    with pytest.raises(ClassError, match="not been shown"):
        school.distribution(opened.key, "faster", 1)
    school.reveal(opened.key)
    assert school.distribution(opened.key, "faster", 1)["plain"] == 1


def test_first_and_second_vote_are_compared_student_by_student(school, opened):
    """Against a count by hand; who answers only once is in one distribution and has not changed."""
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
    for round_ in (0, 1):
        for seat, vote in zip(seats, votes, strict=True):
            if vote[round_]:
                school.vote(opened.code, seat.voter, "faster", vote[round_], round_ + 1)
        (school.ask_again if round_ == 0 else school.reveal)(opened.key)
    found = school.comparison(opened.code, "faster", "machine")
    assert found.first == {"machine": 2, "plain": 4, "neither": 2}
    assert found.second == {"machine": 5, "plain": 1, "neither": 2}
    assert (found.to_right, found.to_wrong, found.stayed_right, found.stayed_wrong) == (3, 1, 1, 2)


def test_an_answer_is_changed_until_the_reveal_and_a_late_one_is_refused_with_its_reason(school, opened):
    seat = school.join(opened.code)

    def vote(stop: str = "faster", option: str = "plain", round_: int | None = 1) -> None:
        school.vote(opened.code, seat.voter, stop, option, round_)

    vote()
    vote(option="neither")
    assert school.question(seat).chosen == "neither"
    assert school.count(opened.key) == 1
    with pytest.raises(ClassError, match="no such answer"):
        vote(option="nobody")
    school.ask_again(opened.key)
    with pytest.raises(ClassError, match="second vote has begun"):
        vote()
    assert school.question(seat).chosen is None
    school.reveal(opened.key)
    with pytest.raises(ClassError, match="already been shown"):
        vote(round_=2)
    school.present(opened.key, "energy", ["spring", "slab"])
    with pytest.raises(ClassError, match="another question"):
        vote(round_=2)
    # A stop to which the lecturer returns is as it was left.
    school.present(opened.key, "faster", OPTIONS)
    assert astuple(school.question(seat))[:3] == ("faster", 2, True)
    with pytest.raises(ClassError, match="already voted twice"):
        school.ask_again(opened.key)


def test_a_question_whose_answer_is_known_is_not_asked_again(school, opened):
    seat = school.join(opened.code)
    assert not school.question(seat).solved
    school.solve(opened.key)
    assert astuple(school.question(seat))[1:4] == (1, True, True)
    with pytest.raises(ClassError, match="already seen the right answer"):
        school.ask_again(opened.key)


def test_a_class_that_was_asked_nothing_takes_no_answer(school):
    opened = school.open_class()
    seat = school.join(opened.code)
    assert school.question(seat).stop is None
    for act in (
        lambda: school.vote(opened.code, seat.voter, "faster", "plain"),
        lambda: school.reveal(opened.key),
        lambda: school.ask_again(opened.key),
    ):
        with pytest.raises(ClassError, match="not been asked a question"):
            act()


# ---- codes, keys and seats


def test_a_code_is_read_however_it_was_typed_and_no_two_letters_look_alike(school, opened):
    typed = f" {opened.code[:3].lower()}-{opened.code[3:]}\n"
    assert school.join(typed).code == opened.code
    assert not set(ALPHABET) & set("AEIOUY" + "QGV" + string.digits)
    assert len({school.open_class().code for _ in range(50)}) == 50


@pytest.mark.parametrize(
    "text", ["", "ABC", "A" * 10_000, "ABCDE1", "'; DROP TABLE class;--", "ⒷⒸⒹⒻⒽⒿ", "\0\0\0\0\0\0"]
)
def test_what_cannot_be_a_code_gets_a_sentence_and_is_no_wrong_guess(school, text):
    assert read_code(text) is None
    for _ in range(WRONG_CODES + 1):
        with pytest.raises(ClassError, match=r"has six letters|contains A"):
            school.join(text, "phone")


def test_a_code_with_a_letter_that_no_code_has_says_which(school):
    with pytest.raises(ClassError, match="No class code contains G"):
        school.join("bcd fgh")


def test_an_answer_that_counts_may_be_said_again_after_the_result_is_shown(school, opened):
    """As a browser does that has lost its connection meanwhile; another answer still comes too late."""
    seat, other = school.join(opened.code), school.join(opened.code)
    school.vote(opened.code, seat.voter, "faster", "plain", 1)
    school.reveal(opened.key)
    school.vote(opened.code, seat.voter, "faster", "plain", 1)
    school.ask_again(opened.key)
    school.vote(opened.code, seat.voter, "faster", "plain", 1)
    assert school.distribution(opened.key, "faster", 1)["plain"] == 1
    for voter, option in ((seat.voter, "machine"), (other.voter, "plain")):
        with pytest.raises(ClassError, match="too late"):
            school.vote(opened.code, voter, "faster", option, 1)


def test_a_session_and_all_sessions_together_may_try_only_so_many_codes(school, opened, clock):
    wrong = no_such_code(opened.code)
    seated = school.join(opened.code, "early")
    for _ in range(WRONG_CODES):
        with pytest.raises(ClassError, match="no class with this code"):
            school.join(wrong, "guesser")
    with pytest.raises(ClassError, match="Too many wrong codes"):
        school.join(opened.code, "guesser")
    school.join(opened.code, "another")
    for number in range(WRONG_CODES_OF_ALL - WRONG_CODES):
        with pytest.raises(ClassError, match="no class with this code"):
            school.join(wrong, f"guesser {number}")
    with pytest.raises(ClassError, match="Too many wrong codes"):
        school.join(opened.code, "latecomer")
    # Whoever has a seat already keeps it, also after a reload.
    assert school.join(opened.code, "reloaded", seated.voter).voter == seated.voter
    clock.now += MINUTE
    school.join(opened.code, "latecomer")


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
        for act in (school.desk, school.reveal, school.ask_again, school.solve, school.close, school.count):
            with pytest.raises(ClassError, match="belongs to no class"):
                act(key)
        with pytest.raises(ClassError, match="belongs to no class"):
            school.present(key, "faster", OPTIONS)
    assert school.desk(opened.key).stop == "faster"


def test_nothing_that_a_student_gets_holds_the_key_and_the_file_does_not_either(school, opened):
    secret = opened.key.partition("-")[2]
    assert len(secret) >= 32
    seat = school.join(opened.code, "phone")
    got = [seat, school.question(seat)]
    school.vote(opened.code, seat.voter, "faster", "plain")
    school.ask_again(opened.key)
    school.reveal(opened.key)
    got += [school.distribution(opened.code, "faster"), school.comparison(opened.code, "faster", "plain")]
    with pytest.raises(ClassError) as refused:
        school.vote(opened.code, seat.voter, "faster", "plain")
    got.append(refused.value)
    assert secret not in repr(got)
    kept = b"".join(file.read_bytes() for file in school._file.path.parent.iterdir())
    assert secret.encode() not in kept
    assert seat.voter.encode() in kept  # negative control: what is kept in the open is found


def test_a_voter_who_never_joined_has_no_vote(school, opened):
    other = school.open_class()
    seat = school.join(other.code)
    for voter in ("", "somebody", seat.voter):
        with pytest.raises(ClassError, match="did not count"):
            school.vote(opened.code, voter, "faster", "plain")
    assert school.count(opened.key) == 0


def test_an_address_that_was_shared_costs_nobody_their_vote(school, opened):
    """A student sends the whole address to a neighbour, voter and all."""
    first = school.join(opened.code, "first phone")
    school.vote(opened.code, first.voter, "faster", "plain")
    neighbour = school.join(opened.code, "second phone", first.voter)
    assert (school.question(first).kept, school.question(neighbour).kept) == (False, True)
    moved = school.move(first)
    assert school.question(moved).chosen == "plain"
    assert school.question(neighbour).chosen is None
    school.vote(opened.code, neighbour.voter, "faster", "machine")
    school.reveal(opened.key)
    assert school.distribution(opened.code, "faster") == {"machine": 1, "plain": 1, "neither": 0}


# ---- limits and the end


def test_a_class_is_gone_after_a_day_and_nothing_of_it_remains(school, opened, clock):
    seat = school.join(opened.code)
    school.vote(opened.code, seat.voter, "faster", "plain")
    clock.now += LIFETIME - 1
    assert school.count(opened.key) == 1
    clock.now += 1
    for act in (
        lambda: school.question(seat),
        lambda: school.join(opened.code, "new"),
        lambda: school.vote(opened.code, seat.voter, "faster", "plain"),
        lambda: school.desk(opened.key),
    ):
        with pytest.raises(ClassError, match=r"has ended|may have ended"):
            act()
    assert left(school) == {"class": 0, "question": 0, "voter": 0, "vote": 0}


def test_a_class_that_its_lecturer_ends_is_gone_at_once(school, opened):
    other = school.open_class()
    seat = school.join(opened.code)
    school.vote(opened.code, seat.voter, "faster", "plain")
    school.close(opened.key)
    with pytest.raises(ClassError, match=r"has ended|may have ended"):
        school.question(seat)
    assert left(school) == {"class": 1, "question": 0, "voter": 0, "vote": 0}
    assert school.desk(other.key).joined == 0


def left(school: classes.Classes) -> dict[str, int]:
    """Count what is in the file, past the room's own door."""
    file = sqlite3.connect(school._file.path)
    tables = ("class", "question", "voter", "vote")
    return {table: file.execute(f"SELECT COUNT(*) FROM {table}").fetchone()[0] for table in tables}


def test_a_full_class_and_a_full_server_say_so(school, opened, clock):
    for _ in range(STUDENTS):
        seat = school.join(opened.code)
    with pytest.raises(ClassError, match="full: it has 500 students"):
        school.join(opened.code)
    school.join(opened.code, "reloaded", seat.voter)
    for _ in range(CLASSES - 1):
        school.open_class()
    with pytest.raises(ClassError, match="no room for another class"):
        school.open_class()
    clock.now += LIFETIME
    school.open_class()


def test_a_file_that_cannot_be_used_gets_a_sentence(tmp_path):
    no_database = tmp_path / "notes.txt"
    no_database.write_text("Nothing that SQLite has written. " * 100)
    for path in (no_database, tmp_path, tmp_path / "no folder" / "classes.sqlite"):
        with pytest.raises(ClassError, match="cannot keep answers"):
            classes.Classes(path).open_class()
    assert no_database.read_text().startswith("Nothing")


def test_a_file_that_is_taken_away_is_made_anew_for_all(school, opened):
    """As a cleaner of temporary files does; both processes go on with one new file."""
    for file in list(school._file.path.parent.iterdir()):
        file.unlink()
    other = classes.Classes(school._file.path, school._clock)
    again = other.open_class()
    assert school.join(again.code).code == again.code
    with pytest.raises(ClassError, match="no class with this code"):
        school.join(opened.code)


def test_the_file_is_where_the_environment_says_and_only_its_owner_reads_it(tmp_path, monkeypatch):
    monkeypatch.setenv("RAMANUJAN_CLASSES", str(tmp_path / "here.sqlite"))
    classes.shared().open_class()
    assert {file.name.partition("-")[0] for file in tmp_path.iterdir()} == {"here.sqlite"}
    assert all(file.stat().st_mode & 0o077 == 0 for file in tmp_path.iterdir())
