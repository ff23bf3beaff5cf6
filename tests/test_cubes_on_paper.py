"""The drawing of the cubes for paper: every unit cube of three faces, in the right proportions."""

import itertools
import math
import re
from xml.etree import ElementTree

import pytest

from ramanujan.figures.cubes import cubes_svg


@pytest.mark.parametrize("turn", [0, 40, 130, 190, 305])
@pytest.mark.parametrize("sides", [(12, 1), (10, 9)])
def test_cubes_on_paper_show_every_unit_cube_of_three_faces(sides, turn):
    svg = ElementTree.fromstring(cubes_svg(sides, widest=19, apart=False, turn=turn, color="#0b6477"))
    paths = [path.attrib for path in svg.iter("{http://www.w3.org/2000/svg}path")]
    edges = {name: [path["d"].count("M") for path in paths if path.get("data-face") == name] for name in ("x", "top")}
    # n unit cubes need n + 1 lines in each of two directions.
    assert sorted(edges["x"]) == sorted(edges["top"]) == sorted(2 * (n + 1) for n in sides)
    # Seen from an elevation, a horizontal square shrinks by its sine, whatever the direction; an edge is ten long.
    tops = [path["d"] for path, lines in itertools.pairwise(paths) if lines.get("data-face") == "top"]
    elevation = math.sin(math.atan2(0.42, 0.85))
    assert sorted(map(area, tops)) == pytest.approx(sorted(100 * n**2 * elevation for n in sides), rel=0.05)


def test_cubes_on_paper_can_be_pulled_apart():
    assert cubes_svg((10, 9), widest=19, apart=False, turn=305, color="#0b6477").count("<use") == 0
    assert cubes_svg((10, 9), widest=19, apart=True, turn=305, color="#0b6477").count("<use") == 9 + 8


def area(outline: str) -> float:
    """The area within a closed outline M x y x y … z."""
    numbers = [float(text) for text in re.findall(r"-?[\d.]+", outline)]
    corners = list(zip(numbers[::2], numbers[1::2], strict=True))
    return abs(sum(x * v - u * y for (x, y), (u, v) in zip(corners, [*corners[1:], corners[0]], strict=True))) / 2
