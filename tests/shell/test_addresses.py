"""No address breaks a page: every key of every page with invalid values, old labels, and each option's id."""

import socket
from itertools import cycle
from pathlib import Path

import pytest
import streamlit as st
from streamlit.testing.v1 import AppTest

from ramanujan.pages.used_by_shell import ENTRIES
from ramanujan.shell import address as addresses
from ramanujan.shell import class_keys, display_mode, parameters, stages
from ramanujan.shell.menu import PAGES
from tests.checks.browser import ROOT
from tests.checks.scenes import INVALID_TEXTS, opened
from tests.checks.worksheets import key_of, name_of

DANGEROUS = ("empty", "infinite", "huge", "repeated")
"""Values that once broke pages. Streamlit reads an empty value as None, and its number input overflows at infinity."""
OWN = {name: {key.name: key for key in entry.url_parameters} for name, entry in ENTRIES.items()}
_EVERYWHERE = (parameters, class_keys, display_mode, stages)
SHARED = {key.name: key for room in _EVERYWHERE for key in room.URL_PARAMETERS if key is not display_mode.SLIDE}
"""Keys of all pages, without the name of a slide, which can be any short word."""
DEFAULTS = {name: key.default for keys in (SHARED, *OWN.values()) for name, key in keys.items()}
OF_A_CLASS = {"class", "lecturer", "wall"}
"""Keys with an effect only while a class is open (test_scene_classroom)."""
ENDS = ("", ").", ",", "”", "…\u00a0")
"""Punctuation that a chat or a mail program includes in a link."""
NUMBERS = {"9/8": 1.125, "1,05": 1.05, "1:2": 0.5, "9/7)": 9 / 7, "+3/4.": 0.75, ".5": 0.5, "2e-1": 0.2}
VALID_TEXTS = {
    "step": "3",
    "modes_paused": "0.25,0.5",
    "p": "104",
    "q": "99",
    "seed": name_of(7),
    "key": key_of(7),
    "chosen": "radius.same~block.rest.predicted",
    "task": "top-at-rest",
    "task_steps": "24",
    "task_periods": "5",
    "exercise": "two-cubes,top-at-rest,block_momentum",
    "item": "2",
}
"""A text for each key that is not a choice or a slider, and for keys that control other keys."""


def valid_text(key: addresses.URLParameter) -> str:
    """Return a valid text for a value other than the default."""
    if key.name in VALID_TEXTS:
        return VALID_TEXTS[key.name]
    if isinstance(key, parameters.Parameter):
        return f"{key.default + 0.37 * (key.most - key.default):.1f}"
    if isinstance(key, addresses.Count):
        return str(key.default + 1)
    other = next(option for option in key.options if option != key.default)
    return key.write((key.options[-1], other) if isinstance(key, addresses.Several) else other)


def state(app: AppTest, key: str) -> object:
    return app.session_state[key] if key in app.session_state else DEFAULTS[key]


def test_a_key_has_one_meaning_on_all_pages():
    assert len(DEFAULTS) == len(SHARED) + sum(map(len, OWN.values()))


def test_every_page_is_listed():
    drawn = {
        path.parent.name for path in (ROOT / "ramanujan" / "pages").glob("*/*.py") if "__main__" in path.read_text()
    }
    assert drawn == set(PAGES)


@pytest.mark.parametrize("shift", range(0, len(INVALID_TEXTS), 6))
@pytest.mark.parametrize("name", PAGES)
def test_all_keys_at_once_cause_no_error(name, shift):
    """Give each key of a page another kind of invalid value. `shift` changes the kinds."""
    keys, kinds = sorted({**OWN[name], **SHARED}), list(INVALID_TEXTS)
    app = opened(name, {key: INVALID_TEXTS[kinds[(i + shift) % len(kinds)]] for i, key in enumerate(keys)})
    (warning,) = app.warning
    for key in keys:
        assert f" {key} " in warning.value, key
        assert state(app, key) == DEFAULTS[key], key
        # A slider drawn in the first run keeps its value, and does not change the address.
        assert key not in app.query_params or (name != "oscillator" and key in SHARED)
    assert "1111" not in warning.value
    assert not set("<>\u202e") & set(warning.value)
    # The warning appears once.
    assert not app.run().warning


@pytest.mark.parametrize("name", [name for name in PAGES if OWN[name]])
def test_an_invalid_value_does_not_affect_other_keys(name):
    """Every second key has an invalid value of one of the dangerous kinds."""
    keys = sorted(OWN[name].keys() - OF_A_CLASS)
    bad = {key: INVALID_TEXTS[DANGEROUS[i % 4]] for i, key in enumerate(keys[::2])}
    good = {key: valid_text(OWN[name][key]) for key in keys[1::2]}
    app = opened(name, {**bad, **good})
    warning, *_ = app.warning  # a target with default values may be out of reach
    for key in bad:
        assert f" {key} " in warning.value
        assert state(app, key) == DEFAULTS[key]
    for key, text in good.items():
        assert f" {key} " not in warning.value
        # Another key may make a key unused: a task its push.
        taken = [OWN[name][key].read(text), *([DEFAULTS[key]] if name in ("lesson", "taxicab") else [])]
        assert state(app, key) in taken


# Negative controls: a valid address is accepted without a warning.


@pytest.mark.parametrize("name", [name for name in PAGES if OWN[name]])
def test_a_valid_address_is_unchanged_by_a_run(name):
    address = {key: valid_text(OWN[name][key]) for key in OWN[name].keys() - OF_A_CLASS}
    app = opened(name, address)
    assert not app.warning
    for key, text in address.items():
        value = OWN[name][key].read(text)
        assert state(app, key) == value != DEFAULTS[key], key
    assert {key: app.query_params.get(key) for key in address} == address
    # Another page's address does not contain it. After a return, all settings are restored.
    other = "motion" if name != "motion" else "taxicab"
    app.switch_page(PAGES[other].file).run()
    assert not app.warning
    assert not OWN[name].keys() & set(app.query_params)
    app.switch_page(PAGES[name].file).run()
    # The three modes restart with their page, and only the browser knows the visible ones.
    expected = {key: text for key, text in address.items() if not key.startswith("modes_")}
    assert {key: app.query_params.get(key) for key in expected} == expected


def test_every_option_has_a_short_ascii_id():
    for entry in ENTRIES.values():
        for key in entry.url_parameters:
            for option in getattr(key, "options", ()):
                option = (option,) if isinstance(key, addresses.Several) else option
                text = key.write(option)
                assert text.isascii()
                assert len(text) <= 25
                assert text == text.strip().replace(" ", "")
                assert key.read(text) == option


def test_a_layer_of_an_earlier_version_is_ignored_without_a_message(app):
    assert not opened("motion", {"layers": "arrows,weights", "hide": "weights"}).warning


def test_an_unknown_key_is_removed_without_a_message():
    """A key is unknown, or belongs to another page, or to the program that sent the link."""
    others = {"colour": "red", "route": "newton", "utm_source": "mail", "fbclid": "abc"}
    app = opened("motion", {"figure": "energy", **others})
    assert not app.warning
    assert app.query_params == {"figure": "energy"}


@pytest.mark.parametrize("name", PAGES)
def test_punctuation_after_a_link_is_not_part_of_its_value(name):
    address = {key: valid_text(OWN[name][key]) for key in OWN[name].keys() - OF_A_CLASS}
    app = opened(name, {key: f"{text}{end}" for (key, text), end in zip(address.items(), cycle(ENDS))})
    assert not app.warning
    for key, text in address.items():
        assert state(app, key) == OWN[name][key].read(text), key
        # Only a browser writes the corrected value of a slider.
        if not OWN[name][key].is_bound:
            assert app.query_params.get(key) == text


@pytest.mark.parametrize(("text", "value"), NUMBERS.items())
def test_a_number_has_the_same_meaning_in_the_address_and_in_the_box(text, value):
    app = opened("oscillator", {"m_prime": text})
    assert not app.warning
    assert app.session_state["m_prime"] == value


@pytest.mark.parametrize("text", ["9/0", "1/2/3", "9/8x", "1,200"])
def test_a_slider_ignores_an_invalid_text(text):
    app = opened("oscillator", {"m_prime": text})
    (warning,) = app.warning
    assert " m_prime " in warning.value
    assert ("1.200 or 1200" in warning.value) == (text == "1,200")
    assert app.session_state["m_prime"] == 1
    assert "m_prime" not in app.query_params


@pytest.mark.parametrize("separator", ["", " ", "-", "\u00a0", "."])
def test_a_class_code_is_read_as_printed_on_the_wall(separator):
    for end in ENDS:
        assert class_keys.CLASS.read(f"ABC{separator}def{end}") == "ABCDEF"


@pytest.mark.parametrize(
    ("place", "listens", "port", "is_reachable"),
    [
        ("http://localhost:8501/lesson", None, 8501, True),
        ("http://127.0.0.1:8501/hu/lesson", "0.0.0.0", 8501, True),
        ("http://[::1]:8502/lesson", "::", 8502, True),
        ("http://localhost/lesson", None, 80, True),
        ("http://localhost:8501/lesson", "localhost", 8501, False),
        # A proxy or a tunnel on this computer: the address that other computers need is unknown.
        ("http://localhost/lesson", None, 8501, False),
    ],
)
def test_a_page_at_localhost_links_to_the_network_address(monkeypatch, place, listens, port, is_reachable):
    options = {"server.address": listens, "server.port": port}
    monkeypatch.setattr(st, "get_option", options.get)
    monkeypatch.setattr(type(st.context), "url", property(lambda _context: f"{place}?m=2"))
    link = addresses.link_for_others({"class": "ABC"})
    if has_network() and is_reachable:
        assert not addresses.is_only_for_this_computer()
        assert link.port == port
        # Only an address of this computer can be bound.
        with socket.create_server((link.hostname, 0)):
            assert not link.hostname.startswith("127.")
    else:
        assert addresses.is_only_for_this_computer()
        assert link.geturl().startswith(place)
    assert link.geturl().endswith(f"{place.partition('/')[2].partition('/')[2].partition('/')[2]}?class=ABC")


def test_a_network_address_is_unchanged_in_a_link(monkeypatch):
    monkeypatch.setattr(type(st.context), "url", property(lambda _context: "https://school.example/hu/lesson"))
    assert addresses.link_for_others({}).geturl() == "https://school.example/hu/lesson"
    assert not addresses.is_only_for_this_computer()


def has_network() -> bool:
    """Return whether this computer has a network route. Without Linux's list of routes, assume one."""
    routes = Path("/proc/net/route")
    lines = routes.read_text(encoding="ascii").splitlines()[1:] if routes.exists() else ["any"]
    return any(not line.startswith("lo") for line in lines)
