"""Fixtures of a class. Each file has a fixture `school` with its own store."""

import pytest

from ramanujan.classroom import rules
from tests.checks.classes import OPTIONS, Clock


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def opened(school: rules.Classes) -> rules.Class:
    """A class with the question “faster”."""
    opened = school.open_class()
    school.ask(opened.key, "faster", OPTIONS)
    return opened
