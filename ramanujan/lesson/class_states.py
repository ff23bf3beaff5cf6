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
    """The current question of a class, without secrets.

    stop : id of the stop, None before the first, `END` after the last
    vote : the current vote
    phase : the phase on the screens; the lecturer may return to an earlier one
    reached : the latest phase that the question has reached
    answered : number of present students with an answer
    present : number of students whose browser has sent a request lately
    is_known : whether this version of the app has the stop; if not, `stop` is None
    """

    stop: str | None
    vote: Vote
    phase: Phase
    reached: Phase
    answered: int
    present: int
    is_known: bool = True


@dataclass(frozen=True)
class Seats:
    """The seats of a class, for the lecturer.

    taken : number of seats
    present : number of students whose browser has sent a request lately
    newcomers : number of students who joined within the last minute
    is_open : whether more students may join
    """

    taken: int
    present: int
    newcomers: int
    is_open: bool


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
