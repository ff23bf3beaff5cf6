"""What the lesson keeps: the right option of each stop and why it is right, worked out once for all visitors."""

from __future__ import annotations

from dataclasses import dataclass

import streamlit as st

from ramanujan import lesson


@dataclass(frozen=True)
class Solution:
    """The right option of a stop, as its id and in words, and the explanation."""

    option: str
    label: str
    explanation: str


@st.cache_resource(show_spinner=False, max_entries=64)
def solution(stop: str) -> Solution:
    """Return the solution of the stop with this id."""
    asked = lesson.stop(stop)
    answer = asked.answer()
    return Solution(answer, asked.option(answer).label, asked.explanation())
