"""The drawn stacks of cubes: number of unit cubes, directions of view, layers pulled apart."""

import re

import numpy as np
import pytest

from ramanujan.browser.components import cubes
from tests.checks.browser import next_frame
from tests.checks.engines import ANY_ENGINE

SUMS = [(12, 1), (10, 9)]
ELEVATION = np.arctan2(0.42, 0.85)
CUBES = "document.querySelector('.st-key-cubes > *').shadowRoot"
TURN = f"{CUBES}.querySelector('[type=range]')"
READ = f"""[...{CUBES}.querySelectorAll("svg")].map((svg) => [...svg.querySelectorAll("g")].map((layer) => [
  layer.getAttribute("class"),
  Number(/ (-?[\\d.]+)\\)/.exec(layer.getAttribute("transform"))[1]),
  [...layer.querySelectorAll("path")].map((path) => [path.getAttribute("class"), path.getAttribute("d")]),
]))"""


@pytest.fixture
def drawn(bare):
    drawn = bare()
    drawn.put(lambda: cubes.mount(SUMS, ["twelve and one", "ten and nine"], ["first ", "second "], 1729))
    next_frame(drawn.page)  # the stacks are drawn once they are visible
    return drawn.page


def area(outline: str) -> float:
    """The area of a closed outline M x y L x y … z."""
    x, y = np.array(re.findall(r"-?[\d.]+", outline), dtype=float).reshape(-1, 2).T
    return abs(x @ np.roll(y, 1) - y @ np.roll(x, 1)) / 2


@ANY_ENGINE
def test_every_unit_cube_of_three_faces_can_be_counted_from_every_side(drawn):
    for turn in (0, 40, 130, 190, 305):
        drawn.evaluate(f"(turn) => {{ {TURN}.value = turn; {TURN}.dispatchEvent(new Event('input')); }}", turn)
        for sides, layers in zip(SUMS, drawn.evaluate(READ), strict=True):
            assert sorted(name for name, *_ in layers) == ["cube-0", "cube-1"]
            for name, _, paths in layers:
                side = sides[int(name[-1])]
                # n unit cubes have n + 1 lines in each of two directions.
                assert [d.count("M") for kind, d in paths if kind == "grid"] == [2 * (side + 1)] * 3
                # The area of a horizontal square shrinks by the sine of the elevation, for every direction of view.
                top = next(d for kind, d in paths if kind == "top")
                assert area(top) == pytest.approx(100 * side**2 * np.sin(ELEVATION), rel=1e-2)
    drawn.evaluate(f"() => {CUBES}.querySelector('[type=checkbox]').click()")
    for sides, layers in zip(SUMS, drawn.evaluate(READ), strict=True):
        assert len(layers) == sum(sides), "a cube of side n has n layers"
        for n, side in enumerate(sides):
            mine = [(rise, paths) for name, rise, paths in layers if name == f"cube-{n}"]
            # Each layer is one unit cube high, and half a unit cube above the one below it.
            assert np.diff([rise for rise, _ in mine]) == pytest.approx([-15 * np.cos(ELEVATION)] * (side - 1))
            assert all(d.count("M") == side + 3 for _, paths in mine for kind, d in paths[:4] if kind == "grid")


def test_a_drag_turns_the_cubes_until_the_release(drawn):
    centre = f"""(({{ x, y, width, height }}) => [x + width / 2, y + height / 2])(
      {CUBES}.querySelector("svg").getBoundingClientRect())"""
    (x, y), before = drawn.evaluate(centre), drawn.evaluate(READ)
    drawn.mouse.move(x, y)
    drawn.mouse.down()
    drawn.mouse.move(x + 40, y, steps=6)
    next_frame(drawn)
    drawn.mouse.up()
    after = drawn.evaluate(READ)
    for old, new in zip(before, after, strict=True):
        assert len(old) == len(new) == 2
        assert all(layer != turned for layer, turned in zip(old, new, strict=True))
    drawn.mouse.move(x + 10, y, steps=3)
    next_frame(drawn)
    assert drawn.evaluate(READ) == after
