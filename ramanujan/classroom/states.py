"""The states of a class, its question, its votes and its seats, as immutable values."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

END = "end"
"""The stop id of the end of the lesson, where the class looks back at its votes."""


class Phase(IntEnum):
    """The phases of a question; each phase adds to the content of the phases before it."""

    ASKED = 0
    """Students answer."""
    REVEALED = 1
    """The distribution of the votes is visible, and later answers do not count."""
    RUNNING = 2
    """The machine runs."""
    SOLVED = 3
    """The right answer and its explanation are visible."""


class Vote(NamedTuple):
    """One of the votes on a stop.

    times_asked : how many times the lecturer has opened this question with new votes, from 1
    number : 1 for the vote before students talk to their neighbours, 2 for the vote after that, within the same opening
    """

    times_asked: int = 1
    number: int = 1

    @property
    def is_second(self) -> bool:
        """Whether this is the vote after the discussion."""
        return self.number == 2


@dataclass(frozen=True)
class Class:
    """A new class, for the lecturer: the code for everybody, and the secret key."""

    code: str
    key: str


@dataclass(frozen=True)
class Seat:
    """A student's place in a class: a random voter."""

    code: str
    voter: str


@dataclass(frozen=True)
class ClassQuestion:
    """A question of a class in one of its votes, without secrets.

    stop : id of the stop; for the current question None before the first, `END` after the last
    vote : the vote
    phase : the phase on the screens; the lecturer may return to an earlier one
    reached : the latest phase that the question has reached
    answer : the option of the student who reads the class, None without an answer
    """

    stop: str | None
    vote: Vote
    phase: Phase = Phase.ASKED
    reached: Phase = Phase.ASKED
    answer: str | None = None


@dataclass(frozen=True)
class ClassView:
    """A class as a screen reads it at one moment, without secrets.

    current : the current question
    asked : all votes on all questions so far, the earliest question first
    answered : number of present students with an answer to the current question
    present : number of students whose browser has sent a request lately
    taken : number of seats
    is_open : whether more students may join
    expires : time at which the class and all its answers are deleted [s since 1970]
    machine : values of the lecturer's sliders, as a URL query
    desk_view : the desk's view of the machine, as `Classes.set_view` stored it
    desk_view_age : age of the desk's view [s]
    """

    current: ClassQuestion
    asked: tuple[ClassQuestion, ...]
    answered: int
    present: int
    taken: int
    is_open: bool
    expires: float
    machine: str | None
    desk_view: str | None
    desk_view_age: float

    def find_last_vote(self, stop: str) -> ClassQuestion | None:
        """Return the last vote on a stop; None if it was never asked."""
        return max((each for each in self.asked if each.stop == stop), key=lambda each: each.vote, default=None)

    def list_solved(self) -> list[tuple[str, Vote]]:
        """Return stop and last vote of each question whose right answer was shown; one asked anew counts twice."""
        last_votes = {(each.stop, each.vote.times_asked): each for each in self.asked}
        return [(each.stop, each.vote) for each in last_votes.values() if each.stop and each.reached == Phase.SOLVED]


@dataclass(frozen=True)
class ClassResult:
    """The result of one question, for the lecturer's file.

    stop : id of the stop
    at : time of the question [s since 1970]
    present : number of students present when the result was shown
    first, second : option → number of votes; `second` is None without a second vote
    """

    stop: str
    at: float
    present: int
    first: Mapping[str, int]
    second: Mapping[str, int] | None
