"""Random tests of the app: seeded pages, widgets, links and answers. No action may cause an error.

With RAMANUJAN_DEEP, 5,000 actions of a new seed, which a failing test names.
"""

import logging
import random
from collections.abc import Callable

import pytest
from streamlit.testing.v1 import AppTest

from ramanujan.pages.used_by_shell import ENTRIES
from ramanujan.shell import parameters
from ramanujan.shell.menu import PAGES
from tests.checks.answers import HOSTILE, RIGHT
from tests.checks.scenes import HOSTILE as NO_NUMBERS
from tests.checks.scenes import INVALID_TEXTS
from tests.settings import DEEP

ACTIONS = 5000 if DEEP else 60
SEED = random.randrange(10**6) if DEEP else 1729

_OF_PAGES = [parameter for entry in ENTRIES.values() for parameter in entry.url_parameters]
KEYS = sorted(parameter.name for parameter in (*parameters.URL_PARAMETERS, *_OF_PAGES))
ANSWERS = (*(texts[0] for texts in RIGHT.values()), *HOSTILE, "m*v^2/2", "φ̇·R")
TEXTS = ("1", "9/8", "1/3", "٣", *NO_NUMBERS)
LINKED = (*INVALID_TEXTS.values(), "1", "3", "0.75", "energy", "reading", "hoop")

Action = tuple[str, Callable[[], object]]


def actions(app: AppTest, chance: random.Random) -> list[Action]:
    """Return the monkey's possible actions, at most one of each kind."""
    possible: list[Action] = [("open", lambda: app.switch_page(chance.choice(list(PAGES.values())).file))]
    key = chance.choice(KEYS)
    text = chance.choice(LINKED)

    def link() -> None:
        app.query_params.clear()
        app.query_params[key] = text

    possible.append((f"link {key}={str(text)[:20]!r}", link))
    kinds = {
        "slider": lambda w: w.set_value(round(chance.uniform(w.min, w.max), chance.choice([1, 2, 9]))),
        "select_slider": lambda w: w.set_value(chance.choice(w.options)),
        "text_input": lambda w: w.set_value(chance.choice(ANSWERS if "answer" in (w.key or "") else TEXTS)),
        "number_input": lambda w: w.set_value(chance.randint(int(w.min), int(w.max))),
        "selectbox": lambda w: w.set_value(chance.choice(w.options)),
        "pills": lambda w: w.set_value(chance.choice(w.options)),
        "segmented_control": lambda w: w.set_value(chance.choice(w.options)),
        "toggle": lambda w: w.set_value(not w.value),
        "checkbox": lambda w: w.set_value(not w.value),
        "button": lambda w: w.click(),
    }
    for kind, act in kinds.items():
        widgets = [widget for widget in getattr(app, kind, ()) if not widget.disabled]
        if widgets:
            widget = chance.choice(widgets)
            possible.append((f"{kind} {widget.key}", lambda act=act, widget=widget: act(widget)))
    return possible


def test_no_action_ends_in_an_error(app: AppTest, caplog: pytest.LogCaptureFixture) -> None:
    chance = random.Random(SEED)
    caplog.set_level(logging.ERROR)
    app.query_params["periods"] = "1"
    for page in PAGES.values():
        app.switch_page(page.file).run()
    history: list[str] = []
    for _ in range(ACTIONS):
        name, act = chance.choice(actions(app, chance))
        history.append(name)
        act()
        app.run()
        assert not app.exception, f"{history[-12:]}: {app.exception[0].message}"
        assert not caplog.records, f"{history[-12:]}: {caplog.text[-2000:]}"
