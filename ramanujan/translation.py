"""The language of the app: standard gettext calls around whole sentences.

    from ramanujan.translation import _, ngettext, pgettext

    _("The old value, {value}, was kept.").format(value=...)
    ngettext("{n} period", "{n} periods", n).format(n=n)
    pgettext("of the lesson", "Stop")

A server speaks one language, that of the environment variable RAMANUJAN_LANGUAGE. Its words are in a catalogue of GNU
gettext below `locale/`, which `python -m tests.catalogue` keeps up to date; a message without a translation is shown in
English. The pseudo-language shows which words never reach gettext: it has the same sentences with accents, 40 % longer,
between ⟪ and ⟫. A box that is too narrow for it is too narrow for German.
"""

import gettext
import os
from functools import cache
from typing import NamedTuple

from ramanujan import catalogue
from ramanujan.catalogue import NOT_WORDS

_ACCENTS = str.maketrans("aeiouyAEIOUYcnsz", "áéíóúýÁÉÍÓÚÝćńśź")
_LONGER = 0.4
_PSEUDO_SETTINGS = {"decimal mark": ",", "LaTeX package babel": "english"}


class PseudoLanguage(gettext.NullTranslations):
    """Every sentence accented and stretched, what is not words left as it is."""

    def gettext(self, message: str) -> str:
        if not message.strip():
            return message
        parts = NOT_WORDS.split(message)
        words = "".join(part if index % 2 else part.translate(_ACCENTS) for index, part in enumerate(parts))
        letters = sum(map(len, parts[::2]))
        padding = "·" * round(_LONGER * letters)
        return f"⟪{words} {padding}⟫" if len(padding) > 1 else f"⟪{words}⟫"

    def ngettext(self, singular: str, plural: str, n: int) -> str:
        return self.gettext(singular if n == 1 else plural)

    def pgettext(self, context: str, message: str) -> str:
        return _PSEUDO_SETTINGS.get(context) or self.gettext(message)


def known() -> list[str]:
    """Return the names of the languages that the app speaks."""
    return sorted(["en", "pseudo", *catalogue.languages()])


def language(name: str) -> gettext.NullTranslations:
    """Return the translations into a language.

    Parameters
    ----------
    name : one of `known`

    >>> language("tlh")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    LookupError: RAMANUJAN_LANGUAGE must be one of ... It is tlh.
    """
    if name not in known():
        raise LookupError(f"RAMANUJAN_LANGUAGE must be one of {', '.join(known())}. It is {name}.")
    if name == "pseudo":
        return PseudoLanguage()
    if name == "en":
        return gettext.NullTranslations()
    return catalogue.translations(name)


class Offered(NamedTuple):
    """A language that the page offers: its name, its own name, its server's place, and whether it is spoken here."""

    lang: str
    name: str
    place: str
    spoken: bool


@cache
def offered() -> list[Offered]:
    """Return the languages that RAMANUJAN_LANGUAGES names with the places of their servers, such as en:/,hu:/hu/."""
    named = [each.split(":", 1) for each in filter(None, os.environ.get("RAMANUJAN_LANGUAGES", "").split(","))]
    # TRANSLATORS: what your language calls itself.
    return [
        Offered(lang, language(lang).pgettext("own name of the language", "English"), place, lang == LANGUAGE)
        for lang, place in named
    ]


LANGUAGE = os.environ.get("RAMANUJAN_LANGUAGE") or "en"
_spoken = language(LANGUAGE)
_, ngettext, pgettext = _spoken.gettext, _spoken.ngettext, _spoken.pgettext
TRANSLATED = getattr(_spoken, "percentage", 100)
"""Percentage of the messages that are translated into the language of this server."""
