"""What README promises to whoever uses the package, or tests the app, from another folder: it runs as printed."""

import os
import re
import socket
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

from ramanujan import lesson
from ramanujan.translation import known
from tests.browser import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")
EVERY_PAGE = """

def test_every_page():
    for page in __import__("pathlib").Path("oscillator/ramanujan/pages").glob("*/page.py"):
        at = AppTest.from_file("oscillator/app.py", default_timeout=60).run().switch_page(str(page.resolve())).run()
        assert at.slider(key="m_prime").set_value(2.0).run().title, page
        assert not at.exception, page
"""


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
    (tmp_path / "test_in_step.py").write_text(block("an app test") + EVERY_PAGE)
    done = run(tmp_path, "-m", "pytest", "-q", "-p", "no:cacheprovider", "test_in_step.py")
    assert "2 passed" in done.stdout, done.stdout[-2000:]


def test_the_package_is_found_from_another_folder_by_the_lines_that_say_where_it_is(tmp_path):
    there = block("in a notebook elsewhere")
    here = there.splitlines()[-1]
    asks = "\nprint(Oscillator(1, 1, 1).normalized_frequency_squared)"
    for name, lines, said in (("elsewhere", there, "1.0505"), ("alone", here, "")):
        (tmp_path / name).mkdir()
        done = run(tmp_path / name, "-c", lines + asks)
        assert done.stdout.startswith(said), done.stderr
        assert ("No module named 'ramanujan'" in done.stderr) == (not said)


def test_the_lesson_takes_as_long_as_its_stops():
    for stops in (lesson.STOPS, [stop for stop in lesson.STOPS if stop.short]):
        assert f"{len(stops)} stops in {sum(stop.minutes for stop in stops)} minutes" in README


def test_every_benchmark_is_named_and_prints_its_help(monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["", "--help"])
    for file in (ROOT / "tests/benchmarks").glob("*.py"):
        if hasattr(benchmark := import_module(f"tests.benchmarks.{file.stem}"), "main"):
            assert f"python -m {benchmark.__name__}`" in README
            with pytest.raises(SystemExit, match="0"):
                benchmark.main()
            assert benchmark.__doc__.split()[:4] == capsys.readouterr().out.partition("\n\n")[2].split()[:4]


def test_a_port_that_is_taken_is_named_before_the_app_is_imported():
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        place = ("--server.address", "127.0.0.1", "--server.port", str(port), "--server.headless", "true")
        command = (sys.executable, "-X", "importtime", "-m", "streamlit", "run", "app.py", *place)
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=60, check=False)
    assert f"Port {port} is not available" in done.stdout + done.stderr
    assert done.returncode == 1
    assert "streamlit.web" in done.stderr
    assert "sympy" not in done.stderr


def test_a_language_that_is_not_known_stops_the_start_with_a_sentence():
    command = (sys.executable, "-m", "streamlit", "run", "app.py", "--server.port", "0", "--server.headless", "true")
    tlh = os.environ | {"RAMANUJAN_LANGUAGE": "tlh"}
    done = subprocess.run(command, cwd=ROOT, env=tlh, capture_output=True, text=True, timeout=60, check=False)
    assert done.stderr.endswith(f"RAMANUJAN_LANGUAGE must be one of {', '.join(known())}. It is tlh.\n")
    assert "Traceback" not in done.stderr
    assert done.returncode == 1
