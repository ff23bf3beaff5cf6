"""The curve of Ω²m/k over the mass ratio as SVG, with its limits and two marked machines. curve.js moves its ring."""

import math
from collections.abc import Iterable
from typing import Any
from xml.etree import ElementTree as ET

from ramanujan.figures import MASS_RATIO, without_tags
from ramanujan.figures.oscillator_page import FrequencyCurve, limit_labels
from ramanujan.pages.oscillator import cache as first_page
from ramanujan.pages.oscillator import shared_with_file
from ramanujan.text.numerals import number
from ramanujan.text.translation import _

_WIDTH, _HEIGHT = 640, 330
_LEFT, _RIGHT, _TOP, _BOTTOM = 48, 628, 12, 290
"""The size of the picture, and the sides of the panel in it."""
_RATIO_TICKS, _VALUE_TICKS = (0.01, 0.1, 1, 10), (0, 0.5, 1, 1.5)
_EVERY = 8
"""Draw one of so many points of the figure in the app, which has a point for each pixel of a wide screen."""


def draw_svg(curve: FrequencyCurve) -> str:
    """Return the curve as SVG."""
    svg = ET.Element("svg", {"class": "curve", "viewBox": f"0 0 {_WIDTH} {_HEIGHT}", "role": "img"})
    svg.set("aria-label", shared_with_file.curve_alternative(curve))
    _draw_axes(svg, curve)
    _draw_lines(svg, curve)
    _draw_marks(svg, curve)
    return ET.tostring(svg, encoding="unicode")


def describe_panel(curve: FrequencyCurve) -> dict[str, Any]:
    """Return the data of curve.js.

    range, across : ends of the axis of the mass ratio, and their x
    up : y of Ω²m/k = 0 and of 1
    marks : the marked ratios
    """
    return {
        "range": first_page.CURVE_RANGE,
        "across": (_LEFT, _RIGHT),
        "up": (_y(0, curve), _y(1, curve)),
        "marks": (curve.equal.ratio, curve.unit.ratio),
    }


def _x(ratio: float) -> float:
    """Return x of a mass ratio, on a logarithmic axis."""
    least, most = first_page.CURVE_RANGE
    return _LEFT + math.log(ratio / least) / math.log(most / least) * (_RIGHT - _LEFT)


def _y(value: float, curve: FrequencyCurve) -> float:
    """Return y of a value of Ω²m/k, on an axis that begins at 0."""
    return _BOTTOM - value / (1.16 * curve.light_limit) * (_BOTTOM - _TOP)


def _add(parent: ET.Element, name: str, class_name: str = "", text: str = "", **attributes: Any) -> None:
    """Add an element to a picture. Numbers have two decimals."""
    written = {key: f"{value:.2f}" if isinstance(value, float) else str(value) for key, value in attributes.items()}
    node = ET.SubElement(parent, name, written)
    if class_name:
        node.set("class", class_name)
    node.text = text


def _write_path(curve: FrequencyCurve, ratios: Iterable[float], values: Iterable[float]) -> str:
    """Return the path through points."""
    points = (f"{_x(ratio):.2f} {_y(value, curve):.2f}" for ratio, value in zip(ratios, values, strict=True))
    return "M" + "L".join(points)


def _draw_axes(svg: ET.Element, curve: FrequencyCurve) -> None:
    """Draw the grid with its numbers, and the names of the axes."""
    for ratio in _RATIO_TICKS:
        _add(svg, "line", "grid", x1=_x(ratio), x2=_x(ratio), y1=_TOP, y2=_BOTTOM)
        _add(svg, "text", "axis", number(ratio, strip=True), x=_x(ratio), y=_BOTTOM + 16)
    for value in _VALUE_TICKS:
        _add(svg, "line", "grid", x1=_LEFT, x2=_RIGHT, y1=_y(value, curve), y2=_y(value, curve))
        _add(svg, "text", "scale", number(value, strip=True), x=_LEFT - 6, y=_y(value, curve) + 4)
    _add(svg, "text", "axis", without_tags(MASS_RATIO), x=(_LEFT + _RIGHT) / 2, y=_BOTTOM + 34)
    _add(svg, "text", "", "Ω²m/k", x=4, y=_TOP + 2)


def _draw_lines(svg: ET.Element, curve: FrequencyCurve) -> None:
    """Draw the curve, the line “in step”, and the limits; the asymptote begins near the curve."""
    ends = first_page.CURVE_RANGE
    is_near_curve = curve.heavy_limit < 0.75 * curve.light_limit
    ratios, asymptote = curve.ratios[is_near_curve], curve.heavy_limit[is_near_curve]
    light, heavy = limit_labels(curve)
    _add(svg, "path", "limit", d=_write_path(curve, ends, [curve.light_limit] * 2))
    _add(svg, "path", "limit", d=_write_path(curve, ratios[::_EVERY], asymptote[::_EVERY]))
    _add(svg, "path", "unity", d=_write_path(curve, ends, [1, 1]))
    _add(svg, "text", "", light, x=_LEFT + 6, y=_y(curve.light_limit, curve) - 5)
    _add(svg, "text", "", heavy.replace("<br>", " "), x=_x(ratios[0]) + 8, y=_y(asymptote[0], curve) + 4)
    _add(svg, "text", "scale unity", _("in step"), x=_RIGHT, y=_y(1, curve) - 6)
    _add(svg, "path", "line", d=_write_path(curve, curve.ratios[::_EVERY], curve.values[::_EVERY]))


def _draw_marks(svg: ET.Element, curve: FrequencyCurve) -> None:
    """Draw the marked machines with lines from their labels, and the ring of the present machine below them.

    Without scripts the ring has no radius.
    """
    equal_x, equal_y = _x(curve.equal.ratio), _y(curve.equal.value, curve)
    unit_x, unit_y = _x(curve.unit.ratio), _y(curve.unit.value, curve)
    label_x, label_y = _x(0.5), _y(0.55, curve)
    _add(svg, "line", x1=_x(0.7), x2=equal_x - 5, y1=_y(0.9, curve), y2=equal_y + 5)
    _add(svg, "line", x1=_x(0.53), x2=unit_x - 3, y1=_y(0.62, curve), y2=unit_y + 6)
    _add(svg, "text", "scale", curve.equal.label.replace("<br>", ": "), x=_x(0.68), y=_y(0.87, curve))
    _add(svg, "text", "scale unit number", str(first_page.discriminant()), x=label_x, y=label_y)
    _add(svg, "text", "scale unit", f"ε = {first_page.unit_ratio()}", x=label_x, y=label_y + 20)
    _add(svg, "circle", "ring")
    _add(svg, "circle", "equal", cx=equal_x, cy=equal_y, r=5)
    _add(svg, "path", "unit", d=_write_star(9), transform=f"translate({unit_x:.2f} {unit_y:.2f})")


def _write_star(radius: float) -> str:
    """Return the path of a star with five points around the origin."""
    corners = []
    for tenth in range(10):
        angle, length = tenth * math.tau / 10, radius if tenth % 2 == 0 else 0.45 * radius
        corners.append(f"{length * math.sin(angle):.2f} {-length * math.cos(angle):.2f}")
    return f"M{'L'.join(corners)}z"
