"""A class for tests, a clock that they advance, and the tests of a class in any store.

A file that imports these tests has a fixture `school` with its own store.
"""

import multiprocessing
import random
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import astuple
from functools import partial
from pathlib import Path

import pytest

from ramanujan.classroom import rules
from ramanujan.classroom.codes import hash_browser
from ramanujan.classroom.rules import (
    ClassError,
    Phase,
    Seat,
    Vote,
)
from tests.settings import PATIENCE

OPTIONS = ["machine", "plain", "neither"]
NEW_PROCESS = multiprocessing.get_context("forkserver")
NEW_PROCESS.set_forkserver_preload(["tests.checks.classes"])  # import the common modules once


class Clock:
    """A clock that advances only on demand."""

    now = 1_729_000_000.0

    def __call__(self) -> float:
        return self.now


FIRST = Vote()


def answered(school: rules.Classes, opened: rules.Class) -> int:
    return school.read(opened.code).answered


def chosen(school: rules.Classes, seat: Seat) -> str | None:
    return school.read(seat.code, seat.voter).current.answer


def answer_as(
    place: Path | str, code: str, students: range, votes: multiprocessing.Queue, retries: bool = False
) -> None:
    """Join, answer and change answers as some students, in another process. With `retries`, retry failed attempts."""
    school, chance = rules.Classes(place, Clock()), random.Random(students.start)

    def act(action: Callable, *values: object) -> object:
        while True:
            with suppress(*[ClassError] if retries else []):
                return action(*values)
            time.sleep(0.05)

    seats = [act(school.join, code) for _student in students]
    for _ in range(5 if retries else chance.randint(2, 3)):
        chance.shuffle(seats)
        for seat in seats:
            option = chance.choice(OPTIONS)
            act(school.vote, seat, "faster", option)
            votes.put((seat.voter, option))


def collect_confirmed(processes: list, votes: multiprocessing.Queue) -> dict[str, str]:
    """Wait until all processes have succeeded. Return the last confirmed answer of each voter."""
    last_answers, end = {}, time.monotonic() + PATIENCE
    while any(process.is_alive() for process in processes) or not votes.empty():
        assert time.monotonic() < end, "a process does not end"
        while not votes.empty():
            voter, option = votes.get()
            last_answers[voter] = option
    for process in processes:
        process.join()
    assert {process.exitcode for process in processes} == {0}
    return last_answers


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
    before = school.read(opened.code)
    school.vote(seat, "faster", "machine")
    assert school.read(opened.code) == before
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
    assert astuple(school.read(opened.code).current)[:3] == ("faster", Vote(1, 2), Phase.REVEALED)
    with pytest.raises(ClassError, match="already voted twice"):
        school.begin_second_vote(opened.key)


def test_seats_that_never_voted_and_new_seats_are_counted(school, opened, clock):
    seats = [school.join(opened.code, f"student {number}") for number in range(5)]
    school.vote(seats[0], "faster", "plain")
    school.ask(opened.key, "energy", ["spring", "slab"])
    school.vote(seats[1], "energy", "slab")
    assert school.count_unusual_seats(opened.key) == (3, 5)
    clock.now += 61
    school.join(opened.code, "student 4")
    school.join(opened.code, "student 4, second browser")
    other = school.open_class()
    school.join(other.code)
    assert school.count_unusual_seats(opened.key) == (4, 1)


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
            school.read_for_lecturer,
            school.read_results_for_lecturer,
            school.count_unusual_seats,
        ):
            with pytest.raises(ClassError, match="belongs to no class"):
                act(key)
        with pytest.raises(ClassError, match="belongs to no class"):
            school.ask(key, "faster", OPTIONS)
    assert school.read(opened.code).current.stop == "faster"


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
    assert school.read(opened.code).present == 2
    assert school.join(other.code, hash_browser("phone", other.code)).voter != tabs[0].voter


def test_students_with_a_recent_request_count_as_present(school, opened, clock):
    stays, leaves = school.join(opened.code), school.join(opened.code)
    for seat in (stays, leaves):
        school.vote(seat, "faster", "plain")
    clock.now += 19
    chosen(school, stays)
    clock.now += 2
    question = school.read(opened.code)
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
    assert not school.read(opened.code).current.vote.is_second
    school.vote(seat, "faster", "machine", Vote(2))
    school.show(opened.key, Phase.REVEALED)
    first, second, third = school.read_results_for_lecturer(opened.key)
    votes = [{option: n for option, n in each.items() if n} for each in (first.first, first.second, third.first)]
    assert votes == [{"plain": 1}, {"neither": 1}, {"machine": 1}]
    assert [each.stop for each in (first, second, third)] == ["faster", "energy", "faster"]
    assert (second.second, third.second) == (None, None)
    assert [each.at - first.at for each in (second, third)] == [60, 120]
    assert {each.present for each in (first, second, third)} == {1}
