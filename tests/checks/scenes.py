"""Pages under AppTest, and texts that must not break them."""

import json

from google.protobuf.json_format import MessageToDict
from streamlit.testing.v1 import AppTest

from ramanujan.shell.menu import PAGES
from ramanujan.shell.parameters import PARAMETERS
from tests.checks.browser import ROOT
from tests.checks.reading import wide_formulas
from tests.settings import PATIENCE

CODE = {"jsContent", "htmlContent", "cssContent"}
"""Fields with a component's code, which is the same for every machine."""


def walked(block):
    """Yield every element of a block, at every depth."""
    for child in block.children.values():
        yield child
        if hasattr(child, "children"):
            yield from walked(child)


def without_code(data):
    if isinstance(data, dict):
        return {key: without_code(value) for key, value in data.items() if key not in CODE}
    return [without_code(each) for each in data] if isinstance(data, list) else data


def sent(app) -> str:
    """Return all messages of a run as text, without the components' code."""
    elements = [each for block in (app.main, app.sidebar) for each in walked(block) if getattr(each, "proto", None)]
    # The app's style sheet is not a text of the lesson.
    messages = [without_code(MessageToDict(each.proto)) for each in elements]
    visible = [message for message in messages if not str(message.get("body", "")).startswith("<style>")]
    return "\n".join(json.dumps(message, ensure_ascii=False) for message in visible)


KEYS = list(PARAMETERS)


def unbroken(app):
    """Return the app after a check for no exception."""
    assert not app.exception
    return app


def sound(app):
    """Return the app after checks for a title, no exception and no error box."""
    assert not app.exception
    assert not app.error
    assert app.title[0].value
    return app


def values(app) -> dict[str, float]:
    return {key: app.slider(key=key).value for key in KEYS}


DEFAULTS = {key: parameter.default for key, parameter in PARAMETERS.items()}


def steps(app):
    """Open the six steps and return their texts, each below its label."""
    for number in range(1, 7):
        app.session_state[f"summary_{number}"] = True
    app.run()
    texts = []
    for number in range(1, 7):
        expander = app.expander(key=f"summary_{number}")
        texts += [expander.label, *(text.value for text in wide_formulas(expander))]
    return "\n".join(texts)


HOSTILE = ["", "-1", "0", "nan", "inf", "1/0", "9" * 60, "__import__('os')", "<b>$x$</b>", "1e9999999"]
HOSTILE += ["1/2/3", "--1", "1_000", "1 2", "\x00"]

INVALID_TEXTS = {
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


def opened(name: str, address: dict[str, str | list[str]]) -> AppTest:
    """Open a page at an address as a new visitor."""
    app = AppTest.from_file(str(ROOT / "app.py"), default_timeout=PATIENCE)
    # AppTest needs a first run before it finds a page whose address differs from its file name.
    if name != "oscillator":
        app.run().switch_page(PAGES[name].file)
    app.query_params.update(address)
    app.run()
    assert not app.exception, (name, app.exception[0].message)
    assert not app.error
    assert app.title[0].value
    return app
