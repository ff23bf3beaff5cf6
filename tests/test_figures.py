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

PAGES = ("motion", "taxicab", "speed")


def test_a_figure_is_sent_as_plotly_would_send_it() -> None:
    values = np.linspace(0, 1, 5, dtype=np.float32)
    trace, layout = {"type": "scatter", "x": values, "y": [1, 2, 3, 4, 5], "name": "line"}, {"height": 300}
    sent = plotly.io.to_json(drawn([trace], layout).to_dict(), validate=False)
    checked = go.Figure([trace], layout | {"template": {}})
    assert json.loads(sent) == {**json.loads(checked.to_json()), "layout": layout}
    with pytest.raises(ValueError, match="colour"):
        drawn([{"type": "scatter", "colour": "red"}], {}).checked()


@pytest.mark.parametrize("page", PAGES)
def test_plotly_knows_every_property_of_a_page(app: AppTest, page: str, monkeypatch: pytest.MonkeyPatch) -> None:
    import streamlit as st

    sent = []
    chart = st.plotly_chart
    monkeypatch.setattr(st, "plotly_chart", lambda figure, **more: (sent.append(figure), chart(figure, **more))[1])
    app.query_params["periods"] = "1"
    app.switch_page(f"ramanujan/scenes/{page}.py").run()
    if page == "motion":
        for view in ("displacements", "energy", "momentum", "forces"):
            app.session_state["figure"] = view
            app.run()
    assert not app.exception
    assert sent
    for figure in sent:
        assert isinstance(figure, BaseFigure)
        checked = type(figure).checked(figure) if hasattr(figure, "checked") else figure
        assert checked.layout.template.layout.font.size == 14
