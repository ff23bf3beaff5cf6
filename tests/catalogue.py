"""Update the catalogues of the translations, and list the remaining work.

$ python -m tests.catalogue            update every catalogue
$ python -m tests.catalogue fr         begin a catalogue, or update one
"""

import sys
from collections.abc import Iterator
from functools import cache

from babel.core import Locale, UnknownLocaleError
from babel.messages.catalog import Catalog, Message
from babel.messages.extract import extract_from_dir
from babel.messages.pofile import read_po, write_po

from ramanujan.text.catalogue import LOCALE, Fault, catalogue_file, languages, translations

PACKAGE = LOCALE.parent.parent
KEYWORDS = {"_": None, "ngettext": (1, 2), "pgettext": ((1, "c"), 2)}
OPTIONS = {"keywords": KEYWORDS, "comment_tags": ["TRANSLATORS:"], "strip_comment_tags": True}
ORDER = (
    "text/translation",
    "text/numerals",
    "shell",
    "pages/oscillator",
    "browser",
    "figures/oscillator_page",
    "derivation",
    "pages",
)
"""Prefixes of file names in the order of translation. The texts of the first page come first."""


@cache
def template() -> Catalog:
    """Return the English messages in the order of translation."""
    catalogue = Catalog(project="Ramanujan’s oscillator")
    messages = extract_from_dir(PACKAGE, [("**.py", "python")], **OPTIONS)
    for file, line, message, comments, context in sorted(messages, key=lambda each: (_rank(each[0]), *each[:2])):
        catalogue.add(message, None, [(file, line)], auto_comments=comments, context=context)
    return catalogue


def _rank(file: str) -> int:
    """Return the place of a file in `ORDER`."""
    return next((rank for rank, start in enumerate(ORDER) if file.startswith(start)), len(ORDER))


def texts(message: Message) -> tuple[str, ...]:
    """Return a message in English: one text, or singular and plural."""
    return message.id if isinstance(message.id, tuple) else (message.id,)


def strings(message: Message) -> tuple[str, ...]:
    """Return the translation of a message: one text, or its plural forms."""
    return message.string if isinstance(message.string, tuple) else (message.string,)


def translated(language: str) -> Catalog:
    """Return the stored catalogue of a language."""
    with catalogue_file(language).open("rb") as file:
        return read_po(file, locale=language, charset="utf-8")


def merged(language: str) -> Catalog:
    """Return the catalogue of a language with the current English messages."""
    catalogue = translated(language)
    created = catalogue.creation_date
    catalogue.update(template())
    catalogue.creation_date = created
    # Remove obsolete messages without a translation.
    catalogue.obsolete = {key: message for key, message in catalogue.obsolete.items() if any(strings(message))}
    for message in catalogue:
        if message.fuzzy and message.id:
            _keep_only_an_edit(message)
    return catalogue


def _keep_only_an_edit(message: Message) -> None:
    """Remove a fuzzy translation that Babel copied from a similar message, because its meaning may differ."""
    if message.previous_id and any(message.previous_id[0] in texts(each) for each in template()):
        message.string = ("",) * len(strings(message)) if message.pluralizable else ""
        message.flags.discard("fuzzy")
        message.previous_id = []


def update(language: str) -> Catalog:
    """Update a catalogue with the English messages, or create it."""
    file = catalogue_file(language)
    if not file.exists():
        file.parent.mkdir(parents=True)
        with file.open("wb") as created:
            write_po(created, Catalog(locale=language, project=template().project, fuzzy=False))
    catalogue = merged(language)
    with file.open("wb") as written:
        # Line numbers would change with every edit of a program.
        write_po(written, catalogue, width=120, include_lineno=False)
    return catalogue


def remaining(catalogue: Catalog) -> dict[str, list[str]]:
    """Return the open work in a catalogue: kind → English texts, each with its file."""
    messages = [message for message in catalogue if message.id]
    return {
        "missing": [_placed(message) for message in messages if not message.fuzzy and not all(strings(message))],
        "fuzzy": [_placed(message) for message in messages if message.fuzzy],
        "obsolete": [texts(message)[0] for message in catalogue.obsolete.values()],
    }


def _placed(message: Message) -> str:
    files = {file for file, _line in message.locations}
    return f"{', '.join(sorted(files))}: {texts(message)[0]}"


def report(language: str, catalogue: Catalog) -> Iterator[str]:
    """Yield the lines of a report on a catalogue: its progress, missing messages, and faulty translations."""
    compiled = translations(language)
    yield f"{language}: {compiled.percentage} % translated"
    for kind, entries in remaining(catalogue).items():
        yield f"{language}: {len(entries)} {kind}"
        yield from (f"    {entry}" for entry in entries)
    yield f"{language}: {len(compiled.faults)} with a fault, shown in English"
    yield from (f"    {sentence(language, fault)}" for fault in compiled.faults)


def sentence(language: str, fault: Fault) -> str:
    """Return a fault with its place in the catalogue."""
    return f"{catalogue_file(language).relative_to(PACKAGE.parent)}:{fault.line}: {fault.english!r}. {fault.reason}"


def main(*names: str) -> None:
    """Update all existing and all named catalogues, and print the remaining work."""
    for language in sorted({*names, *languages()}):
        try:
            Locale.parse(language)
        except (UnknownLocaleError, ValueError):
            sys.exit(f"{language} is not the code of a language. Use a code such as fr or pt_BR.")
        try:
            print(*report(language, update(language)), sep="\n")
        except UnicodeDecodeError:
            sys.exit(f"{catalogue_file(language)} must be saved in the encoding UTF-8.")


if __name__ == "__main__":
    main(*sys.argv[1:])
