"""What is known of a class: by the lecturer, by a student, by everybody once it is revealed."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum


class Phase(IntEnum):
    """How far a question has come; each phase shows what the one before has shown, and more."""

    ASKED = 0
    REVEALED = 1
    """Everybody sees how the class has voted; no answer is taken any more."""
    RUNNING = 2
    """The machine runs."""
    SOLVED = 3
    """The right answer is named and explained."""


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

    stop : id of the stop, None before the first
    round : number of the vote; odd for a first vote, even for the second vote that follows it
    phase : how far the question has come
    answered : how many of those present have answered
    present : how many students were heard of lately
    """

    stop: str | None
    round: int
    phase: Phase
    answered: int
    present: int

    @property
    def is_second(self) -> bool:
        """Whether the class votes for the second time, after talking."""
        return self.round % 2 == 0


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
