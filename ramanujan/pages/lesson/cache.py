"""What the lesson keeps for all visitors: the right option of each stop, why it is right, what the others are told."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import streamlit as st

from ramanujan import lesson


@dataclass(frozen=True)
class Solution:
    """The right option of a stop, as its id and in words, the explanation, and what to say to each wrong option."""

    option: str
    label: str
    explanation: str
    replies: Mapping[str, str]


@st.cache_resource(show_spinner=False, max_entries=64)
def solution(stop: str) -> Solution:
    """Return the solution of the stop with this id."""
    asked = lesson.stop(stop)
    answer = asked.answer()
    replies = {name: asked.reply(name) for name in asked.replies}
    return Solution(answer, asked.option(answer).label, asked.explanation(), replies)
