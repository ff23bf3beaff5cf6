"""The commands and programs in README run as printed."""

import os
import re
import shlex
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from ramanujan import lesson
from ramanujan.text.translation import language_ids
from tests.checks.browser import ROOT
from tests.settings import PATIENCE

README = (ROOT / "README.md").read_text(encoding="utf-8")


def block(name: str) -> str:
    """Return the code in README below a comment with this name."""
    (code,) = re.findall(rf"<!-- {name} -->\n```\w+\n(.*?)```", README, re.DOTALL)
    return code


def run(folder: Path, *command: str) -> subprocess.CompletedProcess:
    """Run a command beside a folder `oscillator` with the app and its environment, without the suite's settings."""
    app = folder / "oscillator"
    app.mkdir()
    for path in ROOT.iterdir():
        if path.name != ".venv":
            (app / path.name).symlink_to(path)
    (app / ".venv").symlink_to(sys.prefix)
    environment = {
        name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "PYTEST", "RAMANUJAN"))
    }
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)


def test_the_app_test_runs_by_the_printed_commands(tmp_path):
    (tmp_path / "test_in_step.py").write_text(block("an app test"))
    result = run(tmp_path, "bash", "-c", block("run the app test"))
    assert "1 passed" in result.stdout, result.stdout[-2000:] + result.stderr[-2000:]
    assert result.returncode == 0


@pytest.mark.parametrize("name", ["the start command", "the start command on Windows"])
def test_an_older_python_stops_the_start_with_one_sentence(name):
    _python, _option, check = shlex.split(block(name).partition("&&")[0].partition("; if")[0])
    for version, sentence in (((3, 10, 18), "This app needs Python 3.11 or newer.\n"), ((3, 11, 0), "")):
        script = f"import sys; sys.version_info = {version}\n{check}"
        result = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
        assert result.stderr == sentence
        assert (result.returncode == 0) == (not sentence)


def test_the_printed_lines_import_the_package_from_another_folder(tmp_path):
    printed_lines = block("in a notebook elsewhere")
    last_line = printed_lines.splitlines()[-1]
    use = "\nprint(Oscillator(1, 1, 1).normalized_frequency_squared)"
    for name, lines, output in (("all_lines", printed_lines, "1.0505"), ("last_line", last_line, "")):
        (tmp_path / name).mkdir()
        result = run(tmp_path / name, sys.executable, "-c", lines + use)
        assert result.stdout.startswith(output), result.stderr
        assert ("No module named 'ramanujan'" in result.stderr) == (not output)


def test_the_lesson_takes_as_long_as_its_stops():
    for stops in (lesson.STOPS, [stop for stop in lesson.STOPS if stop.is_in_short_lesson]):
        assert f"{len(stops)} stops in {sum(stop.minutes for stop in stops)} minutes" in README


def test_an_occupied_port_is_named_before_the_app_is_imported():
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        place = ("--server.address", "127.0.0.1", "--server.port", str(port), "--server.headless", "true")
        command = (sys.executable, "-X", "importtime", "-m", "streamlit", "run", "app.py", *place)
        result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert f"Port {port} is not available" in result.stdout + result.stderr
    assert result.returncode == 1
    assert "streamlit.web" in result.stderr
    assert "sympy" not in result.stderr


def test_an_unknown_language_stops_the_start_with_one_sentence():
    command = (sys.executable, "-m", "streamlit", "run", "app.py", "--server.port", "0", "--server.headless", "true")
    tlh = os.environ | {"RAMANUJAN_LANGUAGE": "tlh"}
    result = subprocess.run(command, cwd=ROOT, env=tlh, capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert result.stderr.endswith(f"RAMANUJAN_LANGUAGE must be one of {', '.join(language_ids())}. It is tlh.\n")
    assert "Traceback" not in result.stderr
    assert result.returncode == 1


@pytest.mark.parametrize("languages", ["en", "en:/,tlh:/tlh/"])
def test_a_wrong_list_of_languages_is_named_at_the_import(languages):
    command = (sys.executable, "-c", "import ramanujan.text.translation")
    wrong = os.environ | {"RAMANUJAN_LANGUAGES": languages}
    result = subprocess.run(command, cwd=ROOT, env=wrong, capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert result.stderr.endswith(f"RAMANUJAN_LANGUAGES must be a list such as en:/,hu:/hu/. It is {languages}.\n")
