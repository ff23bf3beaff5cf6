"""How thorough and how patient a run of the tests is."""

import os
from collections.abc import Callable
from typing import NoReturn

import pytest

DEEP = bool(os.environ.get("RAMANUJAN_DEEP"))
"""Whether random tests try many more cases, and programs that are slow to install are used."""
REQUIRED = bool(os.environ.get("RAMANUJAN_REQUIRE"))
"""Whether a test fails, instead of being skipped, if a program that it needs is missing. CI sets it."""
PATIENCE = 120
"""Limit of every wait for a state [s]. A test that passes never waits longer than the app needs."""


def skip_missing(program: str, packages: str) -> NoReturn:
    """Skip a test whose program is missing, or fail if all programs are required."""
    end: Callable[[str], NoReturn] = pytest.fail if REQUIRED else pytest.skip
    end(f"{program} is missing (on Debian: apt-get install {packages})")
