"""The figures written as dictionaries: Plotly validates every property and reads the arrays."""

import json
import re

import numpy as np
import plotly.graph_objects as go
import plotly.io
import pytest
from plotly.basedatatypes import BaseFigure
from streamlit.testing.v1 import AppTest

from ramanujan.figures import drawn
from ramanujan.figures.labels import Area, beside
from ramanujan.shell.navigation import PAGES
from tests.browser import ROOT

DRAWN = {path.stem for path in (ROOT / "ramanujan" / "figures").glob("*.py")} & set(PAGES)
"""Pages with figures. The file with the page's name draws them."""


def test_a_figure_equals_plotlys_own_json() -> None:
    values = np.linspace(0, 1, 5, dtype=np.float32)
    trace, layout = {"type": "scatter", "x": values, "y": [1, 2, 3, 4, 5], "name": "line"}, {"height": 300}
    sent = plotly.io.to_json(drawn([trace], layout).to_dict(), validate=False)
    checked = go.Figure([trace], layout | {"template": {}})
    assert json.loads(sent) == {**json.loads(checked.to_json()), "layout": layout}
    with pytest.raises(ValueError, match="colour"):
        go.Figure(drawn([{"type": "scatter", "colour": "red"}], {}).to_dict())


def boxes(notes: list[dict], area: Area, size: float, screen: tuple[float, float]) -> dict[str, np.ndarray]:
    """Return the left, lower, right and upper ends of the names in a panel [px]."""
    found = {}
    for note in notes:
        width, height = 0.5 * size * len(note["text"]), 0.9 * size
        x, y = (
            (note[name] - low) / (high - low) * pixels
            for name, (low, high), pixels in zip("xy", (area.x_range, area.y_range), screen, strict=True)
        )
        left = x - {"left": 0, "center": width / 2, "right": width}[note["xanchor"]]
        middle = y + {"bottom": 1, "middle": 0, "top": -1}[note["yanchor"]] * 0.65 * size + note.get("yshift", 0)
        found[note["text"]] = np.array([left, middle - height / 2, left + width, middle + height / 2])
    return found


def test_names_touch_neither_curves_nor_each_other_on_a_phone_and_on_a_projector() -> None:
    t = np.linspace(0, 4, 2001)
    wave = np.cos(np.pi * t)
    curves = {"hoop": 0.2 * wave, "slab": wave, "ring": wave, "top cylinder": 0 * t - 1.5, "all of them": 0 * t + 1.5}
    upper, lower = (
        Area([(name, "red", t, scale * y) for name, y in curves.items()], (0, 4), (-2, 2), 410, axis)
        for axis, scale in (("y", 0.1), ("y2", 1))
    )
    notes = beside(upper, lower)
    # Names of close curves would touch, so they are in the other panel.
    assert {note["text"] for note in notes if note["yref"] == "y2"} == set(curves)
    assert {note["text"] for note in notes if note["yref"] == "y"} < set(curves)
    for size, screen in ((13, (278, 410)), (15, (780, 410)), (24, (1069, 374))):
        for area in (upper, lower):
            found = boxes([note for note in notes if note["yref"] == area.axis], area, size, screen)
            points = [np.column_stack([x / 4 * screen[0], (y + 2) / 4 * screen[1]]) for *_name, x, y in area.curves]
            for name, box in found.items():
                assert np.all(box >= -1)
                assert not np.any(
                    np.all((np.concatenate(points) > box[:2]) & (np.concatenate(points) < box[2:]), axis=1)
                )
                assert not [
                    n
                    for n, other in found.items()
                    if n != name and np.all(box[:2] < other[2:]) and np.all(other[:2] < box[2:])
                ]
    # A curve without points has no name. A band that is too narrow has no name.
    found = [("failed", "#123", t, np.full(len(t), np.nan)), ("right", "#123", t, 0 * t + 0.5)]
    assert [note["text"] for note in beside(Area(found, (0, 4), (0, 1), 410))] == ["right"]
    bands = {"thin": [0 * t, 0 * t + 0.01], "broad": [0 * t + 0.01, 0 * t + 1]}
    assert [note["text"] for note in beside(Area([], (0, 4), (0, 1), 410, bands=bands))] == ["broad"]


def letters_high(key: str) -> int:
    """Return the height of a figure in em, from the last matching rule of type.css."""
    rules = (ROOT / "ramanujan/browser/components/type.css").read_text(encoding="utf-8")
    [usual] = re.findall(r"\.stPlotlyChart \{ height: calc\(var\(--high, (\d+)\)", rules)
    own = [
        high
        for selectors, high in re.findall(r"^ *(.*) \{ --high: (\d+); \}", rules, re.MULTILINE)
        for part, name in re.findall(r"(\.|\*=\")st-key-(\w+)", selectors)
        if key == name or (part != "." and key.startswith(name))
    ]
    return int([usual, *own][-1])


@pytest.mark.parametrize("name", PAGES)
def test_plotly_knows_every_property_of_a_page(app: AppTest, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    import streamlit as st

    app.run()
    sent = []
    chart = st.plotly_chart
    monkeypatch.setattr(
        st, "plotly_chart", lambda figure, **more: (sent.append((figure, more["key"])), chart(figure, **more))[1]
    )
    app.query_params.update(dict(part.split("=") for part in PAGES[name].quick.split("&") if part))
    app.switch_page(PAGES[name].file).run()
    for key in PAGES[name].url_parameters:
        for view in key.options if key.name == "figure" else ():
            app.session_state["figure"] = view
            app.run()
    assert not app.exception
    assert bool(sent) == (name in DRAWN)
    assert all(any(map(str.isdigit, chart.proto.alt)) for chart in app.get("plotly_chart")), "words with numbers"
    for figure, key in sent:
        assert isinstance(figure, BaseFigure)
        # The figure has the height of its place on the page, so it is drawn only once.
        assert figure.to_dict()["layout"]["height"] == 16 * letters_high(key)
        assert go.Figure(figure.to_dict()).layout.template.layout.font.size == 14
