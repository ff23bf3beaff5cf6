"""What README promises to whoever uses the package, or tests the app, from another folder: it runs as printed."""

import os
import re
import subprocess
import sys
from pathlib import Path

from tests.browser import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")


def block(name: str) -> str:
    """Return the Python that README has below a comment with this name."""
    (code,) = re.findall(rf"<!-- {name} -->\n```python\n(.*?)```", README, re.DOTALL)
    return code


def run(folder: Path, *command: str) -> subprocess.CompletedProcess:
    """Run Python in a folder beside which the checkout is, with nothing of the suite's own."""
    (folder / "oscillator").symlink_to(ROOT)
    own = {name: text for name, text in os.environ.items() if not name.startswith(("PYTHON", "PYTEST", "RAMANUJAN"))}
    return subprocess.run([sys.executable, *command], cwd=folder, env=own, capture_output=True, text=True, check=False)


def test_the_app_test_runs_in_a_folder_of_its_own(tmp_path):
    (tmp_path / "test_in_step.py").write_text(block("an app test"))
    done = run(tmp_path, "-m", "pytest", "-q", "-p", "no:cacheprovider", "test_in_step.py")
    assert "1 passed" in done.stdout, done.stdout[-2000:]


def test_the_package_is_found_from_another_folder_by_the_lines_that_say_where_it_is(tmp_path):
    there = block("in a notebook elsewhere")
    here = there.splitlines()[-1]
    asks = "\nprint(Oscillator(1, 1, 1).normalized_frequency_squared)"
    for name, lines, said in (("elsewhere", there, "1.0505"), ("alone", here, "")):
        (tmp_path / name).mkdir()
        done = run(tmp_path / name, "-c", lines + asks)
        assert done.stdout.startswith(said), done.stderr
        assert ("No module named 'ramanujan'" in done.stderr) == (not said)
