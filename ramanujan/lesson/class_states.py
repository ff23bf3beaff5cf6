"""What is known of a class: by the lecturer, by a student, by everybody once it is revealed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Class:
    """A class as the lecturer gets it: its code for everybody, its key for nobody else."""

    code: str
    key: str


@dataclass(frozen=True)
class Seat:
    """A student's place in a class: a random voter, and the session that votes under it now."""

    code: str
    voter: str
    session: str = ""


@dataclass(frozen=True)
class Question:
    """What a class is asked now, as one student sees it.

    stop : id of the stop, None before the first
    round : 1, or 2 after the class was asked again
    revealed : whether the distribution may be seen and no answer is taken any more
    solved : whether the right answer may be seen, too
    chosen : the student's own answer in this round
    kept : whether the seat is still this session's, and not taken over by another with the same address
    """

    stop: str | None
    round: int
    revealed: bool
    solved: bool
    chosen: str | None
    kept: bool


@dataclass(frozen=True)
class Desk:
    """What the lecturer sees of the present question before it is revealed: numbers of people, and no answers."""

    stop: str | None
    round: int
    revealed: bool
    solved: bool
    answered: int
    joined: int


@dataclass(frozen=True)
class Comparison:
    """First and second vote on one stop.

    first, second : option → number of votes
    to_right, to_wrong : of those who voted twice, how many changed to the right answer and away from it
    stayed_right, stayed_wrong : how many were right, or wrong, both times
    """

    first: Mapping[str, int]
    second: Mapping[str, int]
    to_right: int
    to_wrong: int
    stayed_right: int
    stayed_wrong: int
