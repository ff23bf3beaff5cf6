"""What the sections of page 5 share: what a person has set, the experiments that this asks for, figures and tables."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Any

import streamlit as st

from ramanujan import Oscillator
from ramanujan.pages.speed import cache, downsampling, experiments, verdicts
from ramanujan.shell import drawings

CHOSEN, MEASURED, OTHERS = range(3)
"""The order in which the page's experiments are taken."""


@dataclass
class Setting:
    """What a person has set, and the experiments that this asks for: order, key, job, place for its progress.

    at_once : seconds that the page may still take for runs before it is drawn; most runs are over by then, and the
        page need not be drawn a second time to show them
    """

    machine: Oscillator
    method: str
    steps: int
    periods: int
    precision: str
    tasks: list[tuple[int, str, experiments.Job, Any]] = field(default_factory=list)
    at_once: float = 0.15

    @property
    def parameters(self) -> tuple[float, float, float]:
        """m, m′ [kg] and k [N/m]."""
        return self.machine.m, self.machine.m_prime, self.machine.k

    def add(self, order: int, key: str, job: experiments.Job, place: Any) -> None:
        """Take an experiment while the page is open."""
        self.tasks.append((order, key, job, place))

    def run_of(self, name: str, order: int, title: str, place: Any) -> experiments.Record[downsampling.Run]:
        """Return what is known of a method's run with these settings; where nothing is, take it now or soon."""
        how = (name, self.steps, self.periods, self.precision)
        record = cache.run(*self.parameters, *how)
        if record.results is None:
            key = f"run {name}"
            job = experiments.job(key, record, lambda: downsampling.run_pieces(self.machine, *how), title)
            start = time.monotonic()
            if self.at_once > 0 and job.advance(self.at_once):
                experiments.drop(key)
            else:
                self.add(order, key, job, place)
            self.at_once -= time.monotonic() - start
        return record


def chart(figure: Any, key: str, alt: str) -> None:
    """Put a figure on the page."""
    drawings.plot(figure, key, alt)


def show_table(rows: verdicts.Table, key: str) -> None:
    """Draw a table that scrolls by itself where the page is narrow."""
    with st.container(key=f"table_{key}"):
        st.markdown(verdicts.table(rows))
