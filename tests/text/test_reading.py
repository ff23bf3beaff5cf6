"""Typed numbers: Python, the script of the page and the table agree, with both decimal marks."""

import json
import subprocess
from fractions import Fraction
from pathlib import Path

import pytest

from ramanujan import browser
from ramanujan.text.reading import read_number, two_readings
from tests.checks.browser import NODE
from tests.checks.typed_numbers import SCIENTIFIC, TYPED_NUMBERS
from tests.settings import PATIENCE

TABLE = TYPED_NUMBERS | SCIENTIFIC
SCRIPT = (Path(browser.__file__).parent / "numbers.js").read_text(encoding="utf-8")
_SWAPPED = str.maketrans(".,．，", ",.，．")


def exchange_marks(result: object, mark: str) -> object:
    """Return a text or two readings for this decimal mark."""
    if mark == "." or not isinstance(result, str | tuple):
        return result
    return result.translate(_SWAPPED) if isinstance(result, str) else tuple(map(exchange_marks, result, ",,"))


def list_cases(mark: str) -> dict[str, object]:
    """Return text → float, None, or two readings."""
    return {
        exchange_marks(text, mark): float(result) if isinstance(result, Fraction) else exchange_marks(result, mark)
        for text, result in TABLE.items()
    }


@pytest.mark.parametrize("mark", ".,")
def test_a_typed_number_is_read_as_in_the_table(mark):
    for text, expected in list_cases(mark).items():
        readings = two_readings(text, mark)
        result = (readings["decimal"], readings["whole"]) if readings else read_number(text, mark)
        assert result == expected, text
        assert read_number(text, mark) is None or not readings, text


def test_a_number_of_any_length_is_read():
    assert read_number("1" * 60) == float("1" * 60)
    assert read_number("1" * 61) is None


@pytest.mark.parametrize("mark", ".,")
def test_the_standalone_file_reads_the_same_numbers(mark):
    cases = list_cases(mark)
    script = SCRIPT.replace("export ", "")
    script += f"""
const results = {json.dumps(list(cases))}.map((text) => {{
  const readings = twoReadings(text, "{mark}"), value = readNumber(text, "{mark}");
  return readings ? [value, readings.text, readings.decimal, readings.whole] : value;
}});
console.log(JSON.stringify(results));"""
    done = subprocess.run([NODE, "-e", script], capture_output=True, text=True, check=True, timeout=PATIENCE)
    for (text, expected), result in zip(cases.items(), json.loads(done.stdout), strict=True):
        if isinstance(expected, tuple):
            assert result == [None, two_readings(text, mark)["text"], *expected], text
        else:
            assert result == (expected if expected is None else pytest.approx(expected, rel=1e-15)), text
