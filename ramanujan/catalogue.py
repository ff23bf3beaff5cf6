"""Read a catalogue of translations and reject unusable translations.

A translation without a slot, a formula or a Markdown mark of the English text is unusable. The app shows the English
text instead, and `python -m tests.catalogue` lists the message. A fuzzy translation, whose English text was edited
later, is usable.
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
NOT_WORDS = re.compile(
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
    """Return a sentence about the slots, formulas and marks in which a translation differs; empty if none do.

    >>> difference("Exactly {exactly} of $x$", "Pile {exactement} pour $x$")
    'It lacks {exactly} and has {exactement} instead.'
    """
    lost, added = _marks(english) - _marks(translation), _marks(translation) - _marks(english)
    if lost and added:
        return f"It lacks {_listed(lost)} and has {_listed(added)} instead."
    if lost:
        return f"It lacks {_listed(lost)}."
    if added:
        return f"It has {_listed(added)}, which the English text has not."
    return ""


def _marks(text: str) -> Counter[str]:
    """Count the parts of a text that must not be translated; decimal marks and words in formulas do not count."""
    formulas = re.sub(r"\\text\{+[^{}]*\}+", "", text.replace("{,}", "."))
    # The word for a number depends on its place in the sentence.
    formulas = re.sub(r":(Word|alone|Alone)\}", ":word}", formulas)
    # `str.format` raises an error for a single brace, and does not fill a slot in double braces.
    other_braces = re.findall("[{}]", NOT_WORDS.sub("", formulas))
    return Counter([*NOT_WORDS.findall(formulas), *_MARKDOWN.findall(text), *other_braces])


def _listed(marks: Counter[str]) -> str:
    return ", ".join(mark.replace("\n", "a line break") for mark in marks)


def _remove_faults(catalogue: polib.POFile) -> list[Fault]:
    """Remove the unusable translations, accept the fuzzy ones, and return the faults."""
    faults = []
    for entry in catalogue:
        reason = _reason(entry)
        if reason:
            faults.append(Fault(entry.linenum, entry.msgid, reason))
            entry.msgstr, entry.msgstr_plural = "", {}
        if entry.fuzzy:
            entry.flags.remove("fuzzy")
    return faults


def _reason(entry: polib.POEntry) -> str:
    """Return the reason why a translation is unusable, empty for a usable one."""
    strings = [entry.msgstr, *entry.msgstr_plural.values()]
    if entry.msgid_plural and any(strings) and not all(entry.msgstr_plural.values()):
        return "One of its plural forms is empty."
    for string in filter(None, strings):
        # Like the English singular, a plural form may omit the number.
        english_forms = (entry.msgid, entry.msgid_plural or entry.msgid)
        differences = [difference(english, string) for english in english_forms]
        if all(differences):
            return differences[0]
        if string != string.strip():
            return "It begins or ends with a space."
    return ""
