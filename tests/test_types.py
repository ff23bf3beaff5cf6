"""The types of the package, as mypy checks them; .mypy.ini makes it strict in the core."""

import subprocess
import sys

from tests.checks.browser import ROOT


def test_mypy_finds_no_error():
    done = subprocess.run([sys.executable, "-m", "mypy"], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
