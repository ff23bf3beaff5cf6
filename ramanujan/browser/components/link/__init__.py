"""The menu *Share* and the choice of a language."""

from collections.abc import Sequence
from typing import Any

from ramanujan.browser import modules
from ramanujan.text.translation import MENU_LANGUAGES, _

STANDALONE_FILE = "ramanujans-oscillator.html"
"""The name of the standalone file, also in the address of the server."""


def mount(private: Sequence[str], keys: Sequence[str]) -> Any:
    """Put the menu *Share* and the choice of a language on the page.

    Parameters
    ----------
    private : keys of the address that a copied link omits
    keys : keys of the address that the standalone file accepts
    """
    data = {
        "copied": _("Copied."),
        "by_hand": _("Copy this text:"),
        "saved": _("Saved. Open the file with a double click."),
        "failed": _("The file could not be loaded. Try again when the server can be reached."),
        "title": _("Ramanujan’s oscillator"),
        "file": STANDALONE_FILE,
        "private": list(private),
        "keys": list(keys),
        "languages": [language._asdict() for language in MENU_LANGUAGES],
    }
    return modules.component("components/link/link")(key="link", data=data)
