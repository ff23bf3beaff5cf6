"""The menu *Share* and the choice of a language."""

from collections.abc import Sequence
from typing import Any

from ramanujan.browser import modules
from ramanujan.text.translation import MENU_LANGUAGES, _

STANDALONE_FILE = "ramanujans-oscillator.html"
"""The name of the standalone file, also in the address of the server."""


def mount(private: Sequence[str], keys: Sequence[str], host: str, is_only_here: bool) -> Any:
    """Put the menu *Share* and the choice of a language on the page.

    Parameters
    ----------
    private : keys of the address that a copied link omits
    keys : keys of the address that the standalone file accepts
    host : host and port in a copied address, or an empty text for those of the page
    is_only_here : whether other computers cannot open this address
    """
    data = {
        "copied": _("Copied. Only this computer can open the address.") if is_only_here else _("Copied."),
        "by_hand": _("Copy this text:"),
        "saved": _("Saved. Open the file with a double click."),
        "failed": _("The file could not be loaded. Try again when the server can be reached."),
        "title": _("Ramanujan’s oscillator"),
        "file": STANDALONE_FILE,
        "host": host,
        "private": list(private),
        "keys": list(keys),
        "languages": [language._asdict() for language in MENU_LANGUAGES],
    }
    return modules.component("components/link/link")(key="link", data=data)
