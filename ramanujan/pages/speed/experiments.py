"""Experiments on a page: taken piece by piece while the page is open, what they find shared by all visitors.

`Record` is what an experiment has found, `Job` one visitor's experiment under way. `work` takes pieces, shows progress
and lets go whenever the visitor does something.

`work` stands at the end of a page's script. Streamlit breaks a script off where it next speaks to the browser, so each
report of progress is also the place where a moved slider, a Stop button or a closed tab ends the work; the job stays in
the session, and the next run of the page goes on with it. What many visitors want at once, one of them works out while
the others watch. Measurements of time take turns: one visitor's at once.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import takewhile
from typing import Any, Generic, TypeVar

import streamlit as st

from ramanujan.accuracy import Piece
from ramanujan.shell import messages
from ramanujan.translation import ngettext

T = TypeVar("T")

_SLICE = 0.04
"""Seconds of work between two pauses."""
_PAUSE = 0.01
"""Seconds left to the other visitors after each slice."""
_REPORT = 0.1
"""Seconds between two reports of progress, and so the longest that a visitor's wish waits."""
_SHOW = 0.8
"""Seconds between two drawings of what is there so far."""


class Line:
    """The visitors who want to take an experiment, first come, first served; one takes it at a time, to the end.

    patience : seconds after which a visitor who is no longer heard of has left the line
    """

    def __init__(self, patience: float) -> None:
        self._patience = patience
        self._lock = threading.Lock()
        # Job → when it was last heard of; a page is heard of ten times a second while it waits or measures.
        self._heard: dict[Job, float] = {}

    def before(self, task: Job) -> list[Job]:
        """Join the line, or stay in it, and return those who come first; with none it is this one's turn."""
        with self._lock:
            now = time.monotonic()
            self._heard[task] = now
            gone = [other for other, heard in self._heard.items() if now - heard > self._patience or not other.wanted]
            for other in gone:
                del self._heard[other]
            return list(takewhile(lambda other: other is not task, self._heard)) if task in self._heard else []

    def leave(self, task: Job) -> None:
        """Leave the line; the next one moves up."""
        with self._lock:
            self._heard.pop(task, None)


_MEASURING = Line(patience=5.0)
"""Measurements of seconds, which nothing may disturb."""


@dataclass(eq=False)
class Record(Generic[T]):
    """What an experiment has found; None until one visitor has seen it through, for all who stand in its line."""

    results: tuple[T, ...] | None = None
    line: Line = field(default_factory=lambda: Line(patience=1.0))


@dataclass(eq=False)
class Job(Generic[T]):
    """An experiment under way in one session.

    record : where the results go when it is complete
    pieces : the experiment
    title : what is being done, for the progress bar
    timed : whether it measures seconds, and so must be alone
    """

    record: Record[T]
    pieces: Iterator[Piece[T]]
    title: str
    timed: bool = False
    done: float = 0.0
    results: list[T] = field(default_factory=list)
    complete: bool = False

    def __post_init__(self) -> None:
        self._before = self.record.results
        # A click begins a new run of the page while the old one still works: two threads, one experiment.
        self._turn = threading.Lock()

    @property
    def line(self) -> Line:
        """Where it waits for its turn."""
        return _MEASURING if self.timed else self.record.line

    @property
    def wanted(self) -> bool:
        """Whether there is work left that no other visitor has done meanwhile."""
        return not self.complete and self.record.results is self._before

    def advance(self, seconds: float) -> bool:
        """Take pieces for about that long, at least one, and return whether the experiment is complete."""
        end = time.monotonic() + seconds
        while not self.complete:
            with self._turn:
                self._take_piece()
            if time.monotonic() >= end:
                break
        return self.complete

    def _take_piece(self) -> None:
        piece = next(self.pieces, None)
        if piece is None:
            self.complete = True
            self.record.results = tuple(self.results)
        else:
            self.done = min(max(piece.done, 0.0), 1.0)
            if piece.result is not None:
                self.results.append(piece.result)


def job(key: str, record: Record[T], pieces: Callable[[], Iterator[Piece[T]]], title: str, timed: bool = False) -> Job:
    """Return the session's job of that key for that record; one begun for another record is dropped."""
    jobs = st.session_state.setdefault("experiments", {})
    if key not in jobs or jobs[key].record is not record:
        drop(key)
        jobs[key] = Job(record, pieces(), title, timed)
    return jobs[key]


def current(key: str) -> Job | None:
    """Return the session's job of that key, if one is under way."""
    return st.session_state.get("experiments", {}).get(key)


def drop(key: str) -> None:
    """End the session's job of that key; what it has found so far is forgotten."""
    if ended := st.session_state.get("experiments", {}).pop(key, None):
        ended.line.leave(ended)


def work(jobs: Iterable[tuple[str, Job, Any]]) -> None:
    """See the jobs through in order, each with its progress in its own place; then run the page again.

    Parameters
    ----------
    jobs : key, job and the `st.empty` that shows the progress
    """
    start = time.monotonic()
    worked = False
    for key, task, place in jobs:
        worked = True
        shown = len(task.results)
        while task.wanted:
            if before := task.line.before(task):
                place.progress(*_waiting(task, before))
                time.sleep(_REPORT)
                continue
            _take(task, _REPORT)
            place.progress(task.done, task.title)
            if len(task.results) > shown and time.monotonic() - start > _SHOW and not task.complete:
                messages.run_again()
        drop(key)
        if time.monotonic() - start > _SHOW:
            messages.run_again()
    if worked:
        messages.run_again()


def _waiting(task: Job, before: Sequence[Job]) -> tuple[float, str]:
    """Return the progress and the sentence for a visitor who waits for those before."""
    if before[0].record is task.record:
        return before[0].done, task.title
    n = len({other.record for other in before} - {task.record})
    return task.done, ngettext(
        "{n} measurement comes before yours. Measurements run one after the other, so that none disturbs another.",
        "{n} measurements come before yours. Measurements run one after the other, so that none disturbs another.",
        n,
    ).format(n=n)


def _take(task: Job, seconds: float) -> None:
    """Work for about that long, leaving room for others."""
    end = time.monotonic() + seconds
    while not task.complete and time.monotonic() < end:
        task.advance(_SLICE)
        time.sleep(_PAUSE)
