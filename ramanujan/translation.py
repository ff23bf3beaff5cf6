"""The language of the app: standard gettext calls around whole sentences.

    from ramanujan.translation import _, ngettext

    _("The old value, {value}, was kept.").format(value=...)
    ngettext("{n} period", "{n} periods", n).format(n=n)

Every sentence is one template with named slots; xgettext or Babel collects them into a catalogue. English is the only
language so far. Started with the environment variable RAMANUJAN_LANGUAGE=pseudo, the app speaks a pseudo-language: the
same sentences with accents, 40 % longer, between ⟪ and ⟫. Words without them were never handed to gettext,
and a box that is too narrow for it is too narrow for German.
"""

import gettext
import os
import re

_ACCENTS = str.maketrans("aeiouyAEIOUYcnsz", "áéíóúýÁÉÍÓÚÝćńśź")
# What is no word and must survive: formulas, slots, code, HTML, the address of a Markdown link, colours, icons.
_KEPT = re.compile(
    r"(\$\$.*?\$\$|\$.*?\$|\{[^{}]*\}|`[^`]*`|</?[a-z][^>]*>|&\w+;|\]\([^)]*\)|:[a-z-]+\[|:material/\w+:)", re.DOTALL
)
_LONGER = 0.4


class PseudoLanguage(gettext.NullTranslations):
    """Every sentence accented and stretched, what is not words left as it is."""

    def gettext(self, message: str) -> str:
        if not message.strip():
            return message
        parts = _KEPT.split(message)
        words = "".join(part if index % 2 else part.translate(_ACCENTS) for index, part in enumerate(parts))
        letters = sum(map(len, parts[::2]))
        padding = "·" * round(_LONGER * letters)
        return f"⟪{words} {padding}⟫" if len(padding) > 1 else f"⟪{words}⟫"

    def ngettext(self, singular: str, plural: str, n: int) -> str:
        return self.gettext(singular if n == 1 else plural)


def language(name: str | None) -> gettext.NullTranslations:
    """The translations of a language by its name; English for None and for every name that is not known."""
    return PseudoLanguage() if name == "pseudo" else gettext.NullTranslations()


_SPOKEN = language(os.environ.get("RAMANUJAN_LANGUAGE"))
_ = _SPOKEN.gettext
ngettext = _SPOKEN.ngettext
