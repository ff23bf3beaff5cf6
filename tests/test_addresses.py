"""No address breaks a page: every key of every page with values that nobody means, old labels, and each option's id."""

from __future__ import annotations

import pytest
from streamlit.testing.v1 import AppTest

from ramanujan.shell import address as addresses
from ramanujan.shell import class_keys, parameters, stages
from ramanujan.shell.navigation import PAGES
from tests.browser import ROOT
from tests.test_worksheet import key_of

UNMEANT = {
    "empty": "",
    "blank": " ",
    "infinite": "inf",
    "minus infinity": "-inf",
    "NaN": "nan",
    "huge": "1e400",
    "negative": "-77",
    "repeated": ["1", "2"],
    "5,000 characters": "1" * 5000,
    "bidirectional": "\u202e1729\u202c",
    "HTML": "<b onclick=alert(1)>1</b>",
    "no number": "abc",
}
DANGEROUS = ("empty", "infinite", "huge", "repeated")
"""What broke pages once: Streamlit reads an empty value as None, and its number input overflows at an infinite one."""
OWN = {page.name: {key.name for key in page.url_parameters} for page in PAGES.values()}
SHARED = {key.name for key in (*parameters.URL_PARAMETERS, *class_keys.URL_PARAMETERS, *stages.URL_PARAMETERS)}
STAGE = {"layers": (), "speed": "1", "from": "ground", "paused": ""}
DEFAULTS = {
    **{f"{kept}{key}": value for kept in ("", "modes_") for key, value in STAGE.items()},
    "route": "euler_lagrange",
    "show": "lecture",
    "values": "symbols",
    "step": 1,
    "body": None,
    "question": "kinetic_energy_block",
    "glide": 0.0,
    "spin": 0.0,
    "mu": 0.2,
    "figure": "displacements",
    "left": "hoop",
    "right": "cylinder",
    "top": "cylinder",
    "p": 1,
    "q": 1,
    "digits": 100,
    "method": "velocity_verlet",
    "steps": 12,
    "periods": 30,
    "precision": "float64",
    "cost": "evaluations",
    "tolerance": 3,
    "sweep": "ratio_float64",
    "paper": "questions",
    "seed": 1,
    "level": 1,
    "exercise": (),
    "item": 1,
    "key": "",
    "exercise_number": 0,
    "exercise_key": "",
    "part": "stops",
    "stop": "two-clocks",
    "chosen": {},
    "class": "",
    "lecturer": "",
    "wall": None,
    "stops": None,
    "task": "in-step",
    "task_x0": 8.0,
    "task_glide": 0.0,
    "task_spin": 0.0,
    "task_method": "rk4",
    "task_steps": 100,
    "task_periods": 10,
    "task_left": "hoop",
    "task_right": "cylinder",
    "task_top": "cylinder",
    "m": 1.0,
    "m_prime": 1.0,
    "k": 10.0,
    "compression": 8.0,
    "radius": 10.0,
}

MEANT = {
    "derivation": {
        "route": ("hamilton", "hamilton"),
        "show": ("reading", "reading"),
        "values": ("numbers", "numbers"),
        "step": ("3", 3),
        "body": ("top", "top"),
        "question": ("unit_mass_ratio", "unit_mass_ratio"),
        "modes_layers": ("coordinates,arrows", ("coordinates", "arrows")),
        "modes_speed": ("0.5", "0.5"),
        "modes_from": ("block", "block"),
        "modes_paused": ("0.25,0.5", "0.25,0.5"),
    },
    "motion": {"glide": ("-7.5", -7.5), "spin": ("1.25", 1.25), "mu": ("0.9", 0.9), "figure": ("forces", "forces")},
    "taxicab": {
        "left": ("sphere", "sphere"),
        "right": ("shell", "shell"),
        "top": ("hoop", "hoop"),
        "p": ("104", 104),
        "q": ("99", 99),
        "digits": ("7", 7),
    },
    "speed": {
        "method": ("rk4", "rk4"),
        "steps": ("24", 24),
        "periods": ("3", 3),
        "precision": ("float32", "float32"),
        "cost": ("seconds", "seconds"),
        "tolerance": ("1e-6", 6),
        "sweep": ("scale_float32", "scale_float32"),
    },
    "worksheet": {"paper": ("key", "key"), "seed": ("7", 7), "level": ("3", 3), "key": (key_of(7), key_of(7))},
    "lesson": {
        "part": ("tasks", "tasks"),
        "stop": ("radius", "radius"),
        "stops": ("short", "short"),
        "chosen": (
            "radius.same~block.rest.predicted",
            {"radius": ("same", "answered"), "block": ("rest", "predicted")},
        ),
        "task": ("top-at-rest", "top-at-rest"),
        "exercise": ("two-cubes,top-at-rest,block_momentum", ("two-cubes", "top-at-rest", "block_momentum")),
        "item": ("2", 2),
        "exercise_key": (key_of(7), key_of(7)),
        "exercise_number": ("7", 7),
        "task_x0": ("0.5", 0.5),
        "task_glide": ("-7.5", -7.5),
        "task_spin": ("1.25", 1.25),
        "task_method": ("yoshida4", "yoshida4"),
        "task_steps": ("24", 24),
        "task_periods": ("5", 5),
        "task_left": ("sphere", "sphere"),
        "task_right": ("shell", "shell"),
        "task_top": ("hoop", "hoop"),
    },
}
OF_A_CLASS = {"class", "lecturer", "wall"}
"""Keys that mean something only while a class is open (test_scene_classroom)."""


def opened(name: str, address: dict[str, str | list[str]]) -> AppTest:
    """A page as a new visitor finds it under an address; where the page would measure for long, it has less to do."""
    app = AppTest.from_file(str(ROOT / "app.py"), default_timeout=60)
    # Only after a first run does AppTest know a page whose address is not the name of its file.
    if name != "oscillator":
        app.run().switch_page(PAGES[name].file)
    quick = dict(part.split("=") for part in PAGES[name].quick.split("&") if part)
    app.query_params.update({**quick, **address})
    app.run()
    assert not app.exception, (name, app.exception[0].message)
    assert not app.error
    assert app.title[0].value
    return app


def state(app: AppTest, key: str) -> object:
    return app.session_state[key] if key in app.session_state else DEFAULTS[key]


def test_every_key_that_a_page_declares_is_in_this_test():
    assert SHARED.union(*OWN.values()) == set(DEFAULTS)
    assert all(not OWN[a] & OWN[b] for a in OWN for b in OWN if a < b)


def test_the_list_of_pages_is_whole():
    drawn = {
        path.parent.name for path in (ROOT / "ramanujan" / "pages").glob("*/*.py") if "__main__" in path.read_text()
    }
    assert drawn == set(PAGES)


@pytest.mark.parametrize("shift", range(0, len(UNMEANT), 6))
@pytest.mark.parametrize("name", PAGES)
def test_all_keys_at_once_say_what_nobody_means(name, shift):
    """Each key by another kind, and each page with two shifts of them."""
    keys, kinds = sorted(OWN[name] | SHARED), list(UNMEANT)
    app = opened(name, {key: UNMEANT[kinds[(i + shift) % len(kinds)]] for i, key in enumerate(keys)})
    (warning,) = app.warning
    for key in keys:
        assert f" {key} " in warning.value, key
        assert state(app, key) == DEFAULTS[key], key
        # A slider that a first run has drawn already keeps to its own value, and leaves the address alone.
        assert key not in app.query_params or (name != "oscillator" and key in SHARED)
    assert "1111" not in warning.value
    assert not set("<>\u202e") & set(warning.value)
    # It is said once.
    assert not app.run().warning


@pytest.mark.parametrize("kind", DANGEROUS)
@pytest.mark.parametrize("half", [0, 1])
@pytest.mark.parametrize("name", [name for name in PAGES if OWN[name]])
def test_what_nobody_means_leaves_the_other_keys_alone(name, half, kind):
    keys = sorted(OWN[name] - OF_A_CLASS)
    bad, good = keys[half::2], keys[1 - half :: 2]
    app = opened(name, {**dict.fromkeys(bad, UNMEANT[kind]), **{key: MEANT[name][key][0] for key in good}})
    warning, *_ = app.warning  # a target of which half is a default may be out of reach
    for key in bad:
        assert f" {key} " in warning.value
        assert state(app, key) == DEFAULTS[key]
    for key in good:
        assert f" {key} " not in warning.value
        # What another key chooses may have no use for it: a task its push, a target its digits.
        assert state(app, key) in (
            (MEANT[name][key][1],) if name not in ("lesson", "taxicab") else (MEANT[name][key][1], DEFAULTS[key])
        )


# Negative controls: what is meant is taken, and nothing is said.


@pytest.mark.parametrize("name", MEANT)
def test_an_address_is_taken_and_kept_as_it_is(name):
    assert set(MEANT[name]) == OWN[name] - OF_A_CLASS
    address = {key: text for key, (text, _) in MEANT[name].items()}
    app = opened(name, address)
    assert not app.warning
    for key, (_, value) in MEANT[name].items():
        assert state(app, key) == value, key
    assert {key: app.query_params.get(key) for key in address} == address
    # Another page does not carry it; a visitor who returns finds everything as it was.
    other = "motion" if name != "motion" else "taxicab"
    app.switch_page(PAGES[other].file).run()
    assert not app.warning
    assert not OWN[name] & set(app.query_params)
    app.switch_page(PAGES[name].file).run()
    # The three modes begin anew with their page: what is seen of them, the browser alone knows.
    kept = {key: text for key, text in address.items() if not key.startswith("modes_")}
    assert {key: app.query_params.get(key) for key in kept} == kept


def test_every_option_has_a_short_ascii_id():
    for page in PAGES.values():
        for key in page.url_parameters:
            for option in getattr(key, "options", ()):
                option = (option,) if isinstance(key, addresses.Several) else option
                text = key.write(option)
                assert text.isascii()
                assert len(text) <= 25
                assert text == text.strip().replace(" ", "")
                assert key.read(text) == option


def test_a_key_of_another_page_or_of_none_is_told_once(app):
    for key in ("route", "colour"):
        app = opened("motion", {key: "newton"})
        (warning,) = app.warning
        assert "newton" not in warning.value
        assert not app.run().warning
