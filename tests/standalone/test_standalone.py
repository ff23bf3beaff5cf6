"""The standalone file without a browser: its encoding, its curve, and the command that writes it."""

import re
from html import unescape
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from fontTools.ttLib import TTFont

from ramanujan.standalone import __main__, html
from tests import fonts
from tests.checks.reference import frequency_squared


def test_the_file_is_ascii():
    """A shell or a web host may store or declare another encoding than UTF-8."""
    text = html()
    assert text.isascii()
    assert "Ramanujan&#8217;s oscillator" in text


def test_the_command_writes_the_file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    file = tmp_path / "oscillator.html"
    monkeypatch.setattr("sys.argv", ["standalone", "--output", str(file)])
    __main__.main()
    assert file.read_text(encoding="ascii") == f"{html()}\n"


def test_a_wrong_path_is_refused_in_a_sentence(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    file = tmp_path / "missing" / "oscillator.html"
    monkeypatch.setattr("sys.argv", ["standalone", "--output", str(file)])
    with pytest.raises(SystemExit) as end:
        __main__.main()
    # Python prints a text to the standard error, with the exit code 1.
    assert end.value.code == f"{file} could not be written: No such file or directory."


def test_the_curve_agrees_with_exact_frequencies():
    svg = read_curve()
    [line] = svg.iterfind("path[@class='line']")
    points = [tuple(map(float, point.split())) for point in line.get("d")[1:].split("L")]
    # The vertical lines of the grid precede the horizontal ones.
    grid = svg.findall("line[@class='grid']")
    x_at_0_01, x_at_0_1 = (float(node.get("x1")) for node in grid[:2])
    y_at_0, y_at_half = (float(node.get("y1")) for node in grid[4:6])
    for x, y in points[::12]:
        ratio = 0.01 * 10 ** ((x - x_at_0_01) / (x_at_0_1 - x_at_0_01))
        assert (y_at_0 - y) / (y_at_0 - y_at_half) / 2 == pytest.approx(frequency_squared(1, ratio, 1), abs=2e-4)


def test_the_star_is_drawn_after_the_ring():
    drawn = [(node.tag, node.get("class")) for node in read_curve()]
    assert drawn.index(("circle", "ring")) < drawn.index(("path", "unit"))


def test_the_symbols_are_explained_before_the_first_formula():
    text = html()
    steps = text.index("<ol")
    for meaning in ("displacement of the block", "angle of the hoop", "angle of the top cylinder", "A dot denotes"):
        assert 0 < text.index(meaning) < steps


def test_each_step_of_the_derivation_has_its_reasons():
    steps = html().partition('<ol class="six_steps">')[2].partition("</ol>")[0].split("</li>")[:-1]
    assert len(steps) == 6
    for step, sentence in ((steps[0], "No roller slips"), (steps[-1], "Complete the square.")):
        results, _end, reasons = step.partition("</summary>")
        assert sentence in reasons
        assert "<math" in results
        assert "<math" in reasons


def test_the_font_contains_every_letter_of_the_formulas():
    formulas = unescape("".join(re.findall("<math.*?</math>", html())))
    italics = re.sub("<mi>(.)</mi>", lambda match: fonts.ITALICS.get(match[1], match[1]), formulas)
    letters = set(re.sub("<mtext>.*?</mtext>|<[^>]*>", "", italics))
    with TTFont(fonts.STANDALONE / "formulas.woff2") as font:
        assert set(map(ord, letters)) <= font.getBestCmap().keys()
        assert font["hmtx"][font.getBestCmap()[ord("1")]][0] == round(fonts.SCALE * 500)


def read_curve() -> ET.Element:
    """Return the curve of the file."""
    return ET.fromstring(re.search("<svg class=.curve.*?</svg>", html())[0])
