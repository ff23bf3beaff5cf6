"""The types of the package, as mypy checks them."""

import subprocess
import sys

import pytest

from tests.browser import ROOT

CORE = (
    "validation",
    "frequency",
    "oscillator",
    "motion",
    "energy",
    "contact",
    "record",
    "integrators",
    "number_theory",
)
"""Rooms that pass `mypy --strict`."""


@pytest.mark.xdist_group("mypy")
@pytest.mark.parametrize("options", [("--strict", *(f"--package=ramanujan.{room}" for room in CORE)), ()])
def test_mypy_finds_no_error(options):
    done = subprocess.run(
        [sys.executable, "-m", "mypy", *options], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
