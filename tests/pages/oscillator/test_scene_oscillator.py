"""Page 1 and the sidebar under AppTest: every control at its ends, presets, exact entries, good and bad links."""

import json
import math
import re
from functools import partial

import pytest

from ramanujan import UNIT_MASS_RATIO, Oscillator
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.shell.sidebar import PRESETS, set_number
from tests.checks.latex import equations
from tests.checks.reference import frequency_squared
from tests.checks.scenes import DEFAULTS, HOSTILE, opened, sound, steps, values


def box(app, key: str) -> dict[str, object]:
    """Return the message to a slider's box, from the machine's fragment or else from the sidebar."""
    messages = (json.loads(e.proto.json) for e in app.get("bidi_component") if "unseen-published" in e.proto.id)
    return next(message[f"exact/{key}"] for message in messages if f"exact/{key}" in message)


def type_in(app, key: str, text: str):
    """Pass a text to the callback of a box, and run the app."""
    app.session_state["requests"].append(partial(set_number, key, text))
    return app.run()


def lines(app) -> list[str]:
    """Return the labels of the six steps, which are visible when folded."""
    return [expander.label for expander in app.expander if (expander.key or "").startswith("summary_")]


def test_the_first_run_shows_the_defaults(app):
    assert values(sound(app.run())) == DEFAULTS
    assert not app.warning
    assert not any("$$" in text.value for text in app.markdown)
    assert "derivation" in [link.proto.page for link in app.get("page_link")]


def test_six_steps_show_their_results_without_a_click_and_nothing_twice(app):
    folded = lines(sound(app.run()))
    folded = [line.replace("dfrac", "frac") for line in folded]
    assert [line[2:4] for line in folded] == [f"{n}." for n in range(1, 7)]
    lagrangian, acceleration, inserted, ratio = (folded[n] for n in (1, 3, 4, 5))
    assert r"\mathcal{L} = \frac{1}{2}\,\left(3\,m + 2\,m'\right)\,\dot{X}^{2} + " in lagrangian
    assert r"\ddot{X} = \frac{6\,\left(m + m'\right)}{7\,m + 6\,m'}\,R\,\ddot{\varphi}" in acceleration
    assert r"- {\frac{12\,\left(m + m'\right)^{2}}{7\,m + 6\,m'}\,R\,\ddot{\varphi}} + 4\,k\,R\,\varphi = 0" in inserted
    assert r"\Omega^{2} = \frac{8\,k\,\left(7\,m + 6\,m'\right)}" in inserted
    quadratic = [r"18\,\varepsilon^{2} + \varepsilon - 24 = 0", r"\left(36\,\varepsilon + 1\right)^{2} = 1729"]
    assert 0 < ratio.index(quadratic[0]) < ratio.index(quadratic[1]) < ratio.index(r"\frac{\sqrt{1729} - 1}{36}")
    text = steps(app)
    written = re.findall(r"[^$]+ = [^$]+", "".join(folded))
    written += [line for display in re.findall(r"\$\$\n(.*?)\n\$\$", text) for line in equations(display)]
    assert len(written) == len(set(written)) > 30
    # Numbers have a separate heading, and a sentence that names their machine.
    for section in text.split("**")[2::2]:
        symbols, _heading, numbers = section.partition("### Your machine")
        assert "The numbers are for" not in symbols
        assert ("The numbers are for" in numbers) == ("$$" in numbers)
    assert text.index(r"\varepsilon &= 1 ") > text.rindex("### Your machine")


def test_a_slide_lists_the_results_of_all_six_steps_in_one_table(app):
    # A slide has no room for the ideas.
    folded = [re.sub(r" \*[^*]+\*(?= \$)", "", line) for line in lines(app.run())]
    on_projector = opened("oscillator", {"view": "projector"})
    table = on_projector.get_by_key("table-six_steps").markdown[0].value
    # On the slide, a long equation is broken before a sign.
    table = table.replace(r"\allowbreak", "").replace(r"\nobreak", "")
    assert [" ".join(row.strip("| ").split(" | ")) for row in table.splitlines()[2:]] == folded
    assert not lines(on_projector)


def test_the_page_states_whether_the_machine_is_in_step(app):
    app.run()
    for key, value in (("m", 2.3), ("m_prime", 5.0), ("k", 37.0)):
        app.slider(key=key).set_value(value)
    sentence = app.run().get_by_key("your_machine").markdown[0].value
    squared = frequency_squared(2.3, 5, 37)
    omega, normalized = math.sqrt(squared), squared * 2.3 / 37
    # A formula contains no line break.
    assert f"Ω²m/k\u00a0=\u00a0{normalized:.7f}, Ω\u00a0=\u00a0{omega:.4f}\u202frad/s, period" in sentence
    assert f"period {2 * math.pi / omega:.3f}\u202fs" in sentence
    assert "slower than the plain mass" in sentence
    app.pills(key="preset").set_value("unit").run()
    assert "in step with the plain mass" in app.get_by_key("your_machine").markdown[0].value
    # The style sheets show the reason while the hands are locked, also on a slide.
    for view in ("", "projector"):
        app.query_params["view"] = view
        assert "1729 = 1³" in app.run().get_by_key("why").markdown[0].value


def test_every_slider_at_its_ends_and_between_its_steps(app):
    app.run()
    for key, parameter in PARAMETERS.items():
        between = (parameter.least + parameter.most) / 2 + parameter.step / math.pi
        for value in (parameter.least, parameter.most, between):
            sound(app.slider(key=key).set_value(value).run())
            assert app.slider(key=key).value == value
            assert box(app, key)["value"] == float(box(app, key)["text"]) == value
            assert not app.warning


RATIOS = {"equal": 1.0, "unit": (math.sqrt(1729) - 1) / 36, "light": 0.1, "heavy": 5.0}
"""Preset → mass ratio in its label. A new preset needs an entry."""


@pytest.mark.parametrize("preset", PRESETS)
def test_presets_choose_round_values_in_range_and_their_ratio(app, preset):
    assert preset in (*RATIOS, "reset"), f"Add the mass ratio of {preset!r} to RATIOS."
    app.run()
    ratio = RATIOS.get(preset)
    for m in (0.5, 0.77, 1.0, 3.7, 4.99, 5.0):
        app.slider(key="m").set_value(m).run()
        now = values(sound(app.pills(key="preset").set_value(preset).run()))
        assert all(PARAMETERS[key].least <= value <= PARAMETERS[key].most for key, value in now.items()), m
        assert app.pills(key="preset").value is None
        if ratio:
            other = f"At m = {m} the ratio is not that of RATIOS. The sliders allow ratios from 0.01 to 20."
            assert now["m_prime"] / now["m"] == pytest.approx(ratio, rel=4e-16), other
        if ratio and preset != "unit":
            shown = [repr(now[key]) for key in ("m", "m_prime")]
            assert max(map(len, shown)) <= 6, f"The boxes show {shown}. Choose a ratio with at most two decimals."
        if preset == "unit":
            assert (now["m"], now["m_prime"]) == (m, UNIT_MASS_RATIO * m)
            machine = Oscillator(now["m"], now["m_prime"], now["k"])
            assert machine.normalized_frequency_squared == pytest.approx(1, rel=4e-16)
    if preset == "unit":
        # The derivation uses the exact ratio: it shows roots and 1729, no digits of a float.
        derivation = steps(app)
        assert r"\sqrt{1729}" in derivation
        assert "1.127" not in derivation


def test_a_preset_lowers_m_if_m_prime_would_exceed_its_range(app):
    app.run()
    app.slider(key="m").set_value(5.0).run()
    app.pills(key="preset").set_value("heavy").run()
    now = values(sound(app))
    assert (now["m"], now["m_prime"]) == (2.0, 10.0)
    (info,) = app.info
    assert info.value == "m was changed from 5\u202fkg to 2\u202fkg, because m′ can be at most 10\u202fkg."
    sound(app.run())
    assert not app.info


@pytest.mark.parametrize(("moved", "kept"), [(1.0, 0.1), (3.0, 3.0)])
def test_an_old_message_does_not_undo_a_preset(app, moved, kept):
    """The message contains the old m′, unless the user has moved that slider since."""
    app.run()
    app.pills(key="preset").set_value("light").run()
    last_received = app.slider(key="update_seen").value
    app.slider(key="update_seen").set_value(last_received - 1)
    app.slider(key="m_prime").set_value(moved)
    app.slider(key="k").set_value(20.0).run()
    assert (values(app)["m_prime"], values(app)["k"]) == (kept, 20.0)
    # Negative control: a message sent after the preset changes the value.
    app.slider(key="m_prime").set_value(moved).run()
    assert values(app)["m_prime"] == moved


def test_a_box_accepts_numbers_and_fractions(app):
    app.run()
    for text, number in {"9/8": 1.125, " 2 ": 2.0, "1,5": 1.5, "1e0": 1.0, "4.5/3": 1.5, "1:2": 0.5}.items():
        sound(type_in(app, "m", text))
        assert app.slider(key="m").value == number
    assert not app.warning


def test_a_bad_entry_gets_one_sentence_and_changes_nothing(app):
    app.run()
    app.slider(key="m").set_value(2.5).run()
    for text in HOSTILE:
        sound(type_in(app, "m", text))
        assert app.slider(key="m").value == 2.5
        assert box(app, "m")["text"] == "2.5"
        (warning,) = app.warning
        assert warning.value.endswith("The old value, 2.5\u202fkg, was kept.")
        assert text in ("", "0") or text not in warning.value
        sound(app.run())
        assert not app.warning


def test_an_ambiguous_number_in_a_box_changes_nothing(app):
    app.query_params["k"] = "20"
    app.run()
    sound(type_in(app, "k", "1,000"))
    assert app.slider(key="k").value == 20
    assert box(app, "k")["text"] == "20.0"
    (warning,) = app.warning
    assert warning.value == (
        "1,000 can mean 1.000 or 1000. Type one of these two for k. The old value, 20\u202fN/m, was kept."
    )
    sound(type_in(app, "k", "12,5"))
    assert app.slider(key="k").value == 12.5
    assert not app.warning


def test_a_mass_out_of_range_in_a_link_is_refused(app):
    app.query_params.update({"m": "9", "k": "20"})
    sound(app.run())
    assert values(app) == {**DEFAULTS, "k": 20.0}
    (warning,) = app.warning
    assert warning.value == "The value of m in the address was ignored: it must be a number from 0.5 to 5\u202fkg."


def test_a_link_is_read_to_the_last_digit(app):
    wanted = {"m": 1.75, "m_prime": UNIT_MASS_RATIO, "k": 12.3456789, "compression": math.pi, "radius": 7.25}
    for key, value in wanted.items():
        app.query_params[key] = repr(value)
    assert values(sound(app.run())) == wanted
    assert not app.warning


@pytest.mark.parametrize("parameter", PARAMETERS.values(), ids=PARAMETERS)
def test_a_slider_displays_every_step(parameter):
    steps = (parameter.most - parameter.least) / parameter.step
    assert steps == pytest.approx(round(steps))
    for n in range(5):
        value = parameter.least + n * parameter.step
        assert float(parameter.format % value) == pytest.approx(value)
