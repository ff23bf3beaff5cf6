"""What is known of a class: by the lecturer, by a student, by everybody once it is revealed."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import NamedTuple

END = "end"
"""The place after the last stop, at which the class looks back at its votes."""


class Phase(IntEnum):
    """How far a question has come; each phase shows what the one before has shown, and more."""

    ASKED = 0
    REVEALED = 1
    """Everybody sees how the class has voted; no answer is taken any more."""
    RUNNING = 2
    """The machine runs."""
    SOLVED = 3
    """The right answer is named and explained."""


class Vote(NamedTuple):
    """One of the votes on a stop.

    asking : how often the class had been asked about this stop, from 1
    number : 1 for the vote before students talk to their neighbours, 2 for the one after
    """

    asking: int = 1
    number: int = 1

    @property
    def is_second(self) -> bool:
        """Whether the class votes for the second time, after talking."""
        return self.number == 2


@dataclass(frozen=True)
class Class:
    """A class as the lecturer gets it: its code for everybody, its key for nobody else."""

    code: str
    key: str


@dataclass(frozen=True)
class Seat:
    """A student's place in a class: a random voter."""

    code: str
    voter: str


@dataclass(frozen=True)
class Question:
    """What a class is asked now, as everybody may know it.

    stop : id of the stop, None before the first, `END` after the last
    vote : which vote on it
    phase : what is shown of it; the lecturer may go back to an earlier phase
    reached : how far the question has come
    answered : how many of those present have answered
    present : how many students were heard of lately
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
    """Who sits in a class, for the lecturer.

    taken : how many seats are taken
    present : how many of their students were heard of lately
    lately : how many were taken within the last minute
    is_open : whether somebody else may join
    """

    taken: int
    present: int
    lately: int
    is_open: bool


@dataclass(frozen=True)
class Asked:
    """A question that was asked, for the lecturer's file.

    stop : its id
    at : when it was asked [s since 1970]
    present : how many were present when its result was shown
    first, second : option → number of votes; `second` is None without a second vote
    """

    stop: str
    at: float
    present: int
    first: Mapping[str, int]
    second: Mapping[str, int] | None
