"""Files for a spreadsheet: read back in each language, and opened by LibreOffice with RAMANUJAN_DEEP."""

import csv
import functools
import io
import json
import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest

from ramanujan import Oscillator
from ramanujan.pages.motion import cache
from ramanujan.pages.motion.files import columns
from tests.checks.browser import ROOT
from tests.settings import DEEP

FILES = """
import json
from ramanujan import Oscillator, lesson
from ramanujan.classroom.results import write_csv
from ramanujan.classroom.states import ClassResult
from ramanujan.pages.motion import cache, files
motion = cache.record.__wrapped__(Oscillator(2.5, 1.0, 10.0), 0.08, 0.04, -1.3)
stop = lesson.STOPS[0]
votes = {option: number for number, option in enumerate(stop.options)}
results = [ClassResult(stop.id, 1764000000.0, 7, votes, None), ClassResult(stop.id, 1764000900.0, 7, votes, votes)]
print(json.dumps([files.sheet(motion, 0.2, [("m [kg]", 2.5)]), write_csv(results)]))
"""
LOCALES = {"en": 1033, "hu": 1038}
"""Language → LibreOffice's number of its locale."""
CELL, ROW, ROWS, COLUMNS = (
    f"{{urn:oasis:names:tc:opendocument:xmlns:table:1.0}}{name}"
    for name in ("table-cell", "table-row", "number-rows-repeated", "number-columns-repeated")
)
TYPE, VALUE = (f"{{urn:oasis:names:tc:opendocument:xmlns:office:1.0}}{name}" for name in ("value-type", "value"))


LONGEST = len("-0.000123456789012")
"""The longest cell of a motion."""


def accuracy(series: np.ndarray) -> dict[str, float]:
    """Return the tolerance of a column: 12 significant digits of its largest number, at most 15 decimal places."""
    return {"rel": 0, "abs": max(5.1e-12 * float(np.max(np.abs(series))), 5.1e-16)}


@functools.cache
def write_files(language: str) -> tuple[str, str]:
    """Return the files of a motion and of a class, from a server in this language."""
    environment = os.environ | {"RAMANUJAN_LANGUAGE": language}
    done = subprocess.run([sys.executable, "-c", FILES], cwd=ROOT, env=environment, capture_output=True, check=True)
    return json.loads(done.stdout)


def cells(file: Path) -> list[ET.Element]:
    """Return the cells in the non-empty rows of a document. Equal neighbours are stored once."""
    all_cells = []
    for row in ET.parse(file).iter(ROW):
        filled = [cell for cell in row.iter(CELL) if cell.get(TYPE)]
        repeated = [cell for cell in filled for _ in range(int(cell.get(COLUMNS, "1")))]
        all_cells += repeated * int(row.get(ROWS, "1")) if filled else []
    return all_cells


@pytest.mark.parametrize("language", ["en", "hu"])
def test_a_spreadsheet_has_all_numbers_and_words_of_its_language(language):
    motion, votes = write_files(language)
    comma = language != "en"
    assert motion.startswith("\ufeff")
    rows = list(csv.reader(io.StringIO(motion.removeprefix("\ufeff"), newline=""), delimiter=";" if comma else ","))
    assert rows[2] == ["m [kg]", "2,5" if comma else "2.5"]
    header, *numbers = rows[rows.index([]) + 1 :]
    expected = columns(cache.record.__wrapped__(Oscillator(2.5, 1.0, 10.0), 0.08, 0.04, -1.3))
    assert len(set(header)) == len(header) == len(expected)
    assert not any(set("e." if comma else "e,") & set(cell) for row in numbers for cell in row)
    assert max(len(cell) for row in numbers for cell in row) <= LONGEST
    for column, series in zip(zip(*numbers, strict=True), expected.values(), strict=True):
        assert [float(cell.replace(",", ".")) for cell in column] == pytest.approx(series.tolist(), **accuracy(series))
    words = {"en": {"yes", "no"}, "hu": {"igen", "nem"}}
    assert words[language] <= {cell for row in votes.splitlines() for cell in row.split(";" if comma else ",")}


@pytest.mark.parametrize("language", ["en", "hu"])
def test_numpy_reads_the_numbers_by_the_line_in_the_file(language, tmp_path):
    text, votes = write_files(language)
    file = tmp_path / "motion.csv"
    file.write_text(text, encoding="utf-8", newline="")
    [first_cell] = next(
        csv.reader(io.StringIO(text.removeprefix("\ufeff")), delimiter="," if language == "en" else ";")
    )
    numbers = eval(first_cell[first_cell.index("numpy.") :], {"numpy": np, "file": file})
    expected = columns(cache.record.__wrapped__(Oscillator(2.5, 1.0, 10.0), 0.08, 0.04, -1.3))
    for column, series in zip(numbers.T, expected.values(), strict=True):
        assert column == pytest.approx(series, **accuracy(series))
    if language == "en":
        file.write_text(votes, encoding="utf-8", newline="")
        table = np.loadtxt(file, delimiter=",", quotechar='"', dtype=str, encoding="utf-8-sig")
        assert table.shape == (1 + 8, 7)


@pytest.mark.skipif(not DEEP, reason="LibreOffice is used only with RAMANUJAN_DEEP")
@pytest.mark.parametrize("language", LOCALES)
def test_libreoffice_reads_every_number_as_a_number(language, tmp_path):
    motion, votes = write_files(language)
    separator = ord("," if language == "en" else ";")
    for name, text in (("motion", motion), ("votes", votes)):
        (tmp_path / f"{name}.csv").write_text(text, encoding="utf-8", newline="")
    opened = f"CSV:{separator},34,76,1,,{LOCALES[language]},false,true"
    profile = f"-env:UserInstallation={(tmp_path / 'profile').as_uri()}"
    command = ["soffice", profile, "--headless", f"--infilter={opened}", "--convert-to", "fods", "--outdir", tmp_path]
    subprocess.run([*command, *tmp_path.glob("*.csv")], capture_output=True, timeout=300, check=True)
    numbers = [float(cell.get(VALUE)) for cell in cells(tmp_path / "motion.fods") if cell.get(TYPE) == "float"]
    series = columns(cache.record.__wrapped__(Oscillator(2.5, 1.0, 10.0), 0.08, 0.04, -1.3))
    values = [value for row in zip(*series.values(), strict=True) for value in map(float, row)]
    assert numbers[-len(values) :] == pytest.approx(values, rel=1e-11, abs=1e-11)
    kinds = [cell.get(TYPE) for cell in cells(tmp_path / "votes.fods")]
    assert kinds.count("date") == 8
    assert kinds.count("float") == 8 + 8 + 4
