"""The figures written as dictionaries: Plotly validates every property and reads the arrays."""

import json
import re

import numpy as np
import plotly.graph_objects as go
import plotly.io
import pytest
from plotly.basedatatypes import BaseFigure
from streamlit.testing.v1 import AppTest

from ramanujan.browser.modules import collect_files
from ramanujan.figures import encode_figure
from ramanujan.pages.oscillator.cache import figure as draw_curve
from ramanujan.pages.used_by_shell import ENTRIES
from ramanujan.shell.menu import PAGES
from tests.checks.browser import ROOT

DRAWN = {path.stem.removesuffix("_page") for path in (ROOT / "ramanujan" / "figures").glob("*_page.py")} & set(PAGES)
"""Pages with figures. The file with the page's name draws them."""


def test_a_figure_equals_plotlys_own_json() -> None:
    values = np.linspace(0, 1, 5, dtype=np.float32)
    trace, layout = {"type": "scatter", "x": values, "y": [1, 2, 3, 4, 5], "name": "line"}, {"height": 300}
    sent = plotly.io.to_json(encode_figure([trace], layout).to_dict(), validate=False)
    checked = go.Figure([trace], layout | {"template": {}})
    assert json.loads(sent) == {**json.loads(checked.to_json()), "layout": layout}
    with pytest.raises(ValueError, match="colour"):
        go.Figure(encode_figure([{"type": "scatter", "colour": "red"}], {}).to_dict())


def test_a_label_in_the_inset_is_below_its_frame() -> None:
    layout = draw_curve("light").to_dict()["layout"]
    axis = layout["yaxis2"]
    [label] = [note for note in layout["annotations"] if note.get("yref") == "y2" and "104/99" in note["text"]]
    panel, letters = 356, 24  # the height of the panel on a slide of 1280×720 pixels, and of its letters [px]
    (bottom, top), (low, high) = axis["domain"], axis["range"]
    room = panel * (top - bottom) * (high - label["y"]) / (high - low)
    assert room >= label["yshift"] + 1.3 * letters * (label["text"].count("<br>") + 1)


def letters_high(key: str) -> float:
    """Return the height of a figure on a wide screen in em, from the last matching rule of the sheets."""
    files = collect_files()
    rules = (files["page.css"] + files["type.css"]).decode()
    [usual] = re.findall(r"\.stPlotlyChart \{ height: calc\(var\(--high, (\d+)\)", rules)
    own = [
        high
        for selectors, high in re.findall(r"^ *([^{]*) \{ --high: ([\d.]+); ", rules, re.MULTILINE)
        for part, name in re.findall(r"(\.|\*=\")st-key-(\w+)", selectors)
        if key == name or (part != "." and key.startswith(name))
    ]
    return float([usual, *own][-1])


@pytest.mark.parametrize("name", PAGES)
def test_plotly_accepts_every_property_of_a_figure(app: AppTest, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    import streamlit as st

    app.run()
    sent = []
    chart = st.plotly_chart
    monkeypatch.setattr(
        st, "plotly_chart", lambda figure, **more: (sent.append((figure, more["key"])), chart(figure, **more))[1]
    )
    app.switch_page(PAGES[name].file).run()
    for key in ENTRIES[name].url_parameters:
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
        # The names are in the figure, beside what they name.
        assert not figure.to_dict()["layout"]["showlegend"]
