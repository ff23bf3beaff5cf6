"""The view settings in a lecturer's link: hidden parts, projector, and the values that Reset restores."""

import json
from collections import Counter

import pytest
from streamlit.testing.v1 import AppTest

from ramanujan import Oscillator
from ramanujan.shell import display_mode
from ramanujan.shell.display_mode import PARTS
from ramanujan.shell.menu import PAGES
from ramanujan.shell.parameters import PARAMETERS
from tests.checks.browser import ROOT
from tests.checks.scenes import DEFAULTS, sound, steps, values
from tests.settings import PATIENCE

MACHINE = Oscillator(1.0, 2.0, 10.0)
LINK = {"m": "1.0", "m_prime": "2.0", "k": "10.0"}
NUMBERS = [f"{MACHINE.normalized_frequency_squared:.4f}", f"{MACHINE.natural_frequency:.3f}", f"{MACHINE.period:.3f}"]


def opened(app, **query):
    app.query_params.update(query)
    return sound(app.run())


def sent(app) -> str:
    """Return the text of all elements sent to the page, including published messages and figures."""
    return "\n".join(str(element.proto) for element in app.main) + "\n".join(
        str(element.proto) for element in app.sidebar
    )


def published(app) -> dict[str, object]:
    """Return topic → published message. A fragment's message replaces the sidebar's."""
    components = [component.proto for component in app.get("bidi_component")]
    messages = [json.loads(component.json) for component in components if "unseen-published" in component.id]
    return {topic: payload for message in reversed(messages) for topic, payload in message.items()}


def test_a_link_hides_parts_of_the_first_page(app):
    opened(app, **LINK, hide="numbers,curve,clocks")
    # The steps remain visible, in symbols.
    assert "varepsilon" in steps(app)
    assert published(app)["machine/oscillator"]["hide"] == ["clocks", "numbers"]
    assert not app.get("plotly_chart")
    assert not any(number in sent(app) for number in NUMBERS)
    assert not any("hand" in text.value for text in app.markdown)


def test_by_default_nothing_is_hidden(app):
    """Negative control: without `hide`, the same page contains all parts."""
    opened(app, **LINK)
    assert "hide" not in published(app)["machine/oscillator"]
    assert app.get("plotly_chart")
    assert any("hand" in text.value for text in app.markdown)


def test_the_first_slide_has_the_slider_of_the_rollers_and_the_sidebar_the_others(app):
    opened(app, view="projector")
    assert [slider.key for slider in app.main.slider] == ["m_prime"]
    assert {"m", "k", "compression", "radius"} <= {slider.key for slider in app.sidebar.slider}
    assert "m_prime" not in {slider.key for slider in app.sidebar.slider}
    assert any("story" in component.proto.id for component in app.get("bidi_component"))


@pytest.mark.parametrize("path", ["derivation", "motion", "taxicab", "speed"])
def test_hidden_parts_remain_hidden_on_every_page(app, path):
    opened(app, hide="clocks,numbers,curve")
    sound(app.switch_page(f"ramanujan/pages/{path}/page.py").run())
    assert app.query_params["hide"] == "clocks,numbers,curve"
    stages = [payload for topic, payload in published(app).items() if topic.startswith("machine/")]
    assert stages
    assert all({"clocks", "numbers"} <= set(payload["hide"]) for payload in stages)
    assert not any("Ω²m/k" in str(chart.proto) for chart in app.get("plotly_chart"))


def test_parts_can_be_hidden_one_by_one_and_all_at_once(app):
    opened(app, hide=",".join(PARTS))
    assert not app.warning
    assert not app.get("plotly_chart")
    assert len(app.markdown) < 5


def test_reset_restores_the_settings_of_the_link(app):
    opened(app, m_prime="2.5", k="20")
    linked = {**DEFAULTS, "m_prime": 2.5, "k": 20.0}
    for key, control in PARAMETERS.items():
        app.slider(key=key).set_value(control.most)
    app.run()
    assert values(app) != linked
    app.pills(key="preset").set_value("reset").run()
    assert values(sound(app)) == linked
    assert "your link" in app.info[0].value
    # A second Reset restores the app's defaults, and a third the link's values.
    app.pills(key="preset").set_value("reset").run()
    assert values(sound(app)) == DEFAULTS
    app.pills(key="preset").set_value("reset").run()
    assert values(sound(app)) == linked


def test_only_a_preset_or_a_stop_of_the_lesson_sets_the_hands_to_the_start(app):
    def releases() -> int:
        return next(payload["releases"] for topic, payload in published(app).items() if topic.startswith("machine/"))

    opened(app)
    before = releases()
    app.slider(key="m_prime").set_value(2.0).run()
    assert releases() == before
    app.pills(key="preset").set_value("equal").run()
    assert releases() == before + 1
    app.slider(key="k").set_value(20.0).run()
    assert releases() == before + 1
    sound(app.switch_page("ramanujan/pages/lesson/page.py").run())
    before = releases()
    app.button(key="option_two-clocks_ahead").click().run()
    assert releases() == before + 1


def test_reset_ignores_invalid_settings_of_the_link(app):
    opened(app, m="0", k="20")
    app.slider(key="m").set_value(3.0).run()
    app.pills(key="preset").set_value("reset").run()
    assert values(sound(app)) == {**DEFAULTS, "k": 20.0}


def all_texts(app) -> list[str]:
    """Return all words, formulas and figures of the page."""
    figures = [str(chart.proto) for chart in app.get("plotly_chart")]
    return sorted([text.value for text in (*app.markdown, *app.latex)] + figures)


@pytest.mark.parametrize(
    ("path", "folded"),
    [
        ("derivation", ["compression"]),
        ("motion", []),
        ("taxicab", ["k", "compression"]),
        ("speed", ["compression"]),
    ],
)
def test_a_folded_slider_preserves_its_value(app, path, folded):
    values = {"k": 33.0, "compression": 3.0}
    opened(app, **{key: str(value) for key, value in values.items()})
    sound(app.switch_page(f"ramanujan/pages/{path}/page.py").run())
    more = next(expander for expander in app.sidebar.expander if expander.label.startswith("More"))
    assert {expander.key for expander in more.slider} == {"radius", *folded}
    assert {key: app.slider(key=key).value for key in values} == values
    before = all_texts(app)
    for key in folded or values:
        app.slider(key=key).set_value(values[key] + 1.0)
    sound(app.run())
    # If no slider is folded, the words or figures change.
    assert (all_texts(app) == before) == bool(folded)


@pytest.mark.parametrize("path", ["oscillator", "derivation", "motion", "taxicab", "speed"])
def test_after_a_slider_the_page_agrees_with_its_address(app, path, monkeypatch):
    """AppTest returns the whole page after every change. In a browser only the redrawn parts change."""

    def shown(app, **machine: str) -> AppTest:
        opened(app, **machine)
        for key in ("symbols", "margin", *(f"summary_{number}" for number in range(1, 7))):
            app.session_state[key] = True
        app.session_state["topic"] = "limits"  # of Speed, where the phase depends on the machine
        return sound(app.switch_page(PAGES[path].file).run())

    assert not shown(app).warning, "with a message the whole page is drawn again"
    before = all_texts(app), published(app)
    for key, value in (("m_prime", 2.5), ("k", 20.0)):
        app.slider(key=key).set_value(value).run()
    moved = all_texts(sound(app)), published(app)
    assert moved[0] != before[0]
    assert moved[1]["exact/k"]["value"] == 20
    other = shown(AppTest.from_file(str(ROOT / "app.py"), default_timeout=PATIENCE), m_prime="2.5", k="20")
    assert (all_texts(other), published(other)) == moved
    monkeypatch.setattr(display_mode, "is_browser", lambda: True)
    for key in ("m_prime", "k"):
        other.slider(key=key).set_value(PARAMETERS[key].default)
    redrawn = Counter(all_texts(other.run()))
    assert bool(other.slider) == (path in ("motion", "speed")), "the other pages draw what follows the machine alone"
    assert redrawn <= Counter(before[0]) <= Counter(moved[0]) + redrawn
    assert moved[1] | published(other) == before[1]


def test_a_link_that_changes_a_slider_draws_the_whole_other_page(app, monkeypatch):
    """Fragments of the page before would be redrawn in the other page, and end it with an error in the browser."""
    opened(app, m="2")
    sound(app.switch_page(PAGES["taxicab"].file).run())
    monkeypatch.setattr(display_mode, "is_browser", lambda: True)
    app.slider(key="m").set_value(PARAMETERS["m"].default)
    sound(app.switch_page(PAGES["motion"].file).run())
    assert app.title[0].value == PAGES["motion"].title
