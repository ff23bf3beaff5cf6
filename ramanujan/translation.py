"""The language of the app, with the standard functions of gettext.

    from ramanujan.translation import _, ngettext, pgettext

    _("The old value, {value}, was kept.").format(value=...)
    ngettext("{n} period", "{n} periods", n).format(n=n)
    pgettext("of the lesson", "Stop")

A server has one language, the value of the environment variable RAMANUJAN_LANGUAGE. Its translations are in a GNU
gettext catalogue below `locale/`, which `python -m tests.catalogue` updates. A message without a translation appears in
English. The pseudo-language adds accents and 40 % to the length of every message, and encloses it in ⟪ and ⟫. So it
shows words that do not pass through gettext, and boxes that are too narrow for German.
"""

import gettext
import os
from functools import cache
from typing import NamedTuple

from ramanujan import catalogue
from ramanujan.catalogue import NOT_WORDS

# The pseudo-language: its letters, the added part of the length, and its values of messages that are settings.
_ACCENTS = str.maketrans("aeiouyAEIOUYcnsz", "áéíóúýÁÉÍÓÚÝćńśź")
_PADDING_PER_LETTER = 0.4
_PSEUDO_SETTINGS = {"decimal mark": ",", "LaTeX package babel": "english"}


class PseudoLanguage(gettext.NullTranslations):
    """Every message with accents and padding; formulas, slots and Markdown marks are unchanged."""

    def gettext(self, message: str) -> str:
        if not message.strip():
            return message
        # `split` also returns the formulas and slots, at the odd indices.
        parts = NOT_WORDS.split(message)
        letters = sum(len(words) for words in parts[::2])
        parts[::2] = [words.translate(_ACCENTS) for words in parts[::2]]
        accented = "".join(parts)
        padding = "·" * round(_PADDING_PER_LETTER * letters)
        return f"⟪{accented} {padding}⟫" if len(padding) > 1 else f"⟪{accented}⟫"

    def ngettext(self, singular: str, plural: str, n: int) -> str:
        return self.gettext(singular if n == 1 else plural)

    def pgettext(self, context: str, message: str) -> str:
        return _PSEUDO_SETTINGS.get(context) or self.gettext(message)


def language_ids() -> list[str]:
    """Return the ids of all languages of the app."""
    return sorted(["en", "pseudo", *catalogue.languages()])


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
    if name == "pseudo":
        return PseudoLanguage()
    if name == "en":
        return gettext.NullTranslations()
    return catalogue.translations(name)


class MenuLanguage(NamedTuple):
    """A language in the page's menu: its id, its name in its own words, its URL path, and whether it is active."""

    lang: str
    name: str
    url_path: str
    is_active: bool


@cache
def menu_languages() -> list[MenuLanguage]:
    """Return the languages of the page's menu.

    The environment variable RAMANUJAN_LANGUAGES lists them with the URL paths of their servers, such as en:/,hu:/hu/.
    """
    entries = filter(None, os.environ.get("RAMANUJAN_LANGUAGES", "").split(","))
    languages = []
    for entry in entries:
        lang, url_path = entry.split(":", 1)
        # TRANSLATORS: what your language calls itself.
        own_name = language(lang).pgettext("own name of the language", "English")
        languages.append(MenuLanguage(lang, own_name, url_path, lang == LANGUAGE))
    return languages


LANGUAGE = os.environ.get("RAMANUJAN_LANGUAGE") or "en"
_translations = language(LANGUAGE)
_, ngettext, pgettext = _translations.gettext, _translations.ngettext, _translations.pgettext
TRANSLATED = getattr(_translations, "percentage", 100)
"""The percentage of translated messages in the language of this server."""
