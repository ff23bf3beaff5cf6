"""The language of the app, with the standard functions of gettext.

    from ramanujan.text.translation import _, ngettext, pgettext

    _("The old value, {value}, was kept.").format(value=...)
    ngettext("{n} period", "{n} periods", n).format(n=n)
    pgettext("of the lesson", "Stop")

A server has one language, the value of the environment variable RAMANUJAN_LANGUAGE. Its translations are in a GNU
gettext catalogue below `locale/`, which `python -m tests.catalogue` updates. A message without a translation appears in
English.
"""

import gettext
import os
from typing import NamedTuple

from ramanujan.text import catalogue


def language_ids() -> list[str]:
    """Return the ids of all languages of the app."""
    return sorted(["en", *catalogue.languages()])


def language(name: str) -> gettext.NullTranslations:
    """Return the translations into a language.

    Parameters
    ----------
    name : one of `language_ids`

    >>> language("tlh")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    LookupError: RAMANUJAN_LANGUAGE must be one of ... It is tlh.
    """
    if name not in language_ids():
        raise LookupError(f"RAMANUJAN_LANGUAGE must be one of {', '.join(language_ids())}. It is {name}.")
    if name == "en":
        return gettext.NullTranslations()
    return catalogue.translations(name)


class MenuLanguage(NamedTuple):
    """A language in the page's menu: its id, its name in its own words, its URL path, and whether it is active."""

    lang: str
    name: str
    url_path: str
    is_active: bool


def _read_menu_languages(text: str) -> list[MenuLanguage]:
    """Return the languages in a list with the URL paths of their servers, such as en:/,hu:/hu/."""
    languages = []
    for entry in filter(None, text.split(",")):
        lang, colon, url_path = entry.partition(":")
        if not colon or lang not in language_ids():
            raise LookupError(f"RAMANUJAN_LANGUAGES must be a list such as en:/,hu:/hu/. It is {text}.")
        # TRANSLATORS: what your language calls itself.
        own_name = language(lang).pgettext("own name of the language", "English")
        languages.append(MenuLanguage(lang, own_name, url_path, lang == LANGUAGE))
    return languages


LANGUAGE = os.environ.get("RAMANUJAN_LANGUAGE") or "en"
_translations = language(LANGUAGE)
_, ngettext, pgettext = _translations.gettext, _translations.ngettext, _translations.pgettext
TRANSLATED = getattr(_translations, "percentage", 100)
"""The percentage of translated messages in the language of this server."""
MENU_LANGUAGES = _read_menu_languages(os.environ.get("RAMANUJAN_LANGUAGES", ""))
"""The languages in the menu of a page."""
