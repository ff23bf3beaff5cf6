"""The limit of open files, in a process with low limits."""

import subprocess
import sys

import pytest

pytest.importorskip("resource")

SCRIPT = """
import resource
resource.setrlimit(resource.RLIMIT_NOFILE, ({limit}, {most}))
from ramanujan.server.open_files import raise_limit
raise_limit()
print(resource.getrlimit(resource.RLIMIT_NOFILE)[0])
"""


@pytest.mark.parametrize(("most", "is_enough"), [(3000, True), (1024, False)])
def test_the_limit_is_raised_and_a_low_one_is_logged(most: int, is_enough: bool) -> None:
    script = SCRIPT.format(limit=256, most=most)
    result = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True)
    assert int(result.stdout) == most
    warning = f"This process can open {most} files, but 200 visitors need 2500."
    assert (warning in result.stderr) != is_enough
