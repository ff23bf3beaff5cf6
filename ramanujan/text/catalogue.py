"""Read a catalogue of translations and reject unusable translations.

A translation that lacks or adds a slot, a formula or a Markdown mark is unusable. The app shows the English text
instead, and `python -m tests.catalogue` lists the message. A fuzzy translation, whose English text was edited later, is
usable.
"""

import gettext
import re
from collections import Counter
from io import BytesIO
from pathlib import Path
from typing import NamedTuple

import polib

LOCALE = Path(__file__).parent / "locale"
"""The folder of the catalogues, with a folder for each language."""
COMPLETE = ("de", "hu")
"""The languages whose catalogues must be complete."""
_NOT_WORDS = re.compile(
    r"(\$\$.*?\$\$|\$.*?\$|\{[^{}]*\}|`[^`]*`|</?[a-z][^>]*>|&\w+;|\]\([^)]*\)|:[a-z-]+\[|:material/\w+:)", re.DOTALL
)
"""Formulas, slots, code, HTML, URLs of links, colours and icons, which are the same in every language."""
_MARKDOWN = re.compile(r"\*+|\n|^#+ |^- ", re.MULTILINE)


class Fault(NamedTuple):
    """An unusable translation: the line in the catalogue, the English text, the reason."""

    line: int
    english: str
    reason: str


class Translations(gettext.GNUTranslations):
    """The usable translations of a catalogue.

    Attributes
    ----------
    faults : the unusable translations
    percentage : percentage of translated messages
    """

    def __init__(self, catalogue: polib.POFile) -> None:
        self.faults = _remove_faults(catalogue)
        self.percentage = catalogue.percent_translated()
        super().__init__(BytesIO(catalogue.to_binary()))


def languages() -> list[str]:
    """Return the names of the languages that have a catalogue."""
    return sorted(path.name for path in LOCALE.iterdir() if catalogue_file(path.name).exists())


def catalogue_file(language: str) -> Path:
    """Return the path of the catalogue of a language."""
    return LOCALE / language / "LC_MESSAGES" / "ramanujan.po"


def translations(language: str) -> Translations:
    """Return the translations into a language."""
    return Translations(polib.pofile(str(catalogue_file(language))))


def difference(english: str, translation: str) -> str:
    """Return a sentence about the slots, formulas and marks that a translation lacks or adds; empty if there are none.

    >>> difference("Exactly {exactly} of $x$", "Pile {exactement} pour $x$")
    'It lacks {exactly} and has {exactement} instead.'
    """
    english_parts, parts = _count_fixed_parts(english), _count_fixed_parts(translation)
    lost, added = english_parts - parts, parts - english_parts
    if lost and added:
        return f"It lacks {_join_fixed_parts(lost)} and has {_join_fixed_parts(added)} instead."
    if lost:
        return f"It lacks {_join_fixed_parts(lost)}."
    if added:
        return f"It has {_join_fixed_parts(added)}, which the English text has not."
    return ""


def _count_fixed_parts(text: str) -> Counter[str]:
    """Count the formulas, slots and marks of a text, which a translation must keep.

    Two differences are allowed: a decimal comma in LaTeX, and words in a formula.
    """
    normalized = text.replace("{,}", ".")
    normalized = re.sub(r"\\text\{+[^{}]*\}+", "", normalized)
    # `str.format` raises an error for a single brace, and does not fill a slot in double braces.
    other_braces = re.findall("[{}]", _NOT_WORDS.sub("", normalized))
    return Counter([*_NOT_WORDS.findall(normalized), *_MARKDOWN.findall(text), *other_braces])


def _join_fixed_parts(parts: Counter[str]) -> str:
    """Return the parts, each once, as a list for the sentence of `difference`."""
    return ", ".join(part.replace("\n", "a line break") for part in parts)


def _remove_faults(catalogue: polib.POFile) -> list[Fault]:
    """Remove the unusable translations, accept the fuzzy ones, and return the faults."""
    faults = []
    for entry in catalogue:
        reason = _find_reason(entry)
        if reason:
            faults.append(Fault(entry.linenum, entry.msgid, reason))
            entry.msgstr, entry.msgstr_plural = "", {}
        if entry.fuzzy:
            entry.flags.remove("fuzzy")
    return faults


def _find_reason(entry: polib.POEntry) -> str:
    """Return the reason why a translation is unusable, or an empty string if it is usable."""
    strings = [entry.msgstr, *entry.msgstr_plural.values()]
    if entry.msgid_plural and any(strings) and not all(entry.msgstr_plural.values()):
        return "One of its plural forms is empty."
    # A plural form may have the slots of either English form: "one period" may be translated without the number.
    english_forms = (entry.msgid, entry.msgid_plural or entry.msgid)
    for string in filter(None, strings):
        differences = [difference(english, string) for english in english_forms]
        differs_from_every_form = all(differences)
        if differs_from_every_form:
            return differences[0]
        if string != string.strip():
            return "It begins or ends with a space."
    return ""
