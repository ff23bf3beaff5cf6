"""The figures that are written as dictionaries: Plotly itself checks every property, and reads the arrays."""

from __future__ import annotations

import json

import numpy as np
import plotly.graph_objects as go
import plotly.io
import pytest
from plotly.basedatatypes import BaseFigure
from streamlit.testing.v1 import AppTest

from ramanujan.figures import drawn
from ramanujan.shell.navigation import PAGES
from tests.browser import ROOT

DRAWN = {path.stem for path in (ROOT / "ramanujan" / "figures").glob("*.py")} & set(PAGES)
"""Pages with figures: those of a page are in the file of its name."""


def test_a_figure_is_sent_as_plotly_would_send_it() -> None:
    values = np.linspace(0, 1, 5, dtype=np.float32)
    trace, layout = {"type": "scatter", "x": values, "y": [1, 2, 3, 4, 5], "name": "line"}, {"height": 300}
    sent = plotly.io.to_json(drawn([trace], layout).to_dict(), validate=False)
    checked = go.Figure([trace], layout | {"template": {}})
    assert json.loads(sent) == {**json.loads(checked.to_json()), "layout": layout}
    with pytest.raises(ValueError, match="colour"):
        drawn([{"type": "scatter", "colour": "red"}], {}).checked()


@pytest.mark.parametrize("name", PAGES)
def test_plotly_knows_every_property_of_a_page(app: AppTest, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    import streamlit as st

    app.run()
    sent = []
    chart = st.plotly_chart
    monkeypatch.setattr(st, "plotly_chart", lambda figure, **more: (sent.append(figure), chart(figure, **more))[1])
    app.query_params.update(dict(part.split("=") for part in PAGES[name].quick.split("&") if part))
    app.switch_page(PAGES[name].file).run()
    for key in PAGES[name].url_parameters:
        for view in key.options if key.name == "figure" else ():
            app.session_state["figure"] = view
            app.run()
    assert not app.exception
    assert bool(sent) == (name in DRAWN)
    for figure in sent:
        assert isinstance(figure, BaseFigure)
        checked = type(figure).checked(figure) if hasattr(figure, "checked") else figure
        assert checked.layout.template.layout.font.size == 14
