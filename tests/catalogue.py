"""The catalogues of the translations: `python -m tests.catalogue` updates and compiles them, and lists what is left.

$ python -m tests.catalogue            every catalogue: what is missing, fuzzy or obsolete
$ python -m tests.catalogue fr         begins another one
"""

import io
import sys
from functools import cache

from babel.messages.catalog import Catalog, Message
from babel.messages.extract import extract_from_dir
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

from ramanujan.translation import LOCALE

PACKAGE = LOCALE.parent
KEYWORDS = {"_": None, "ngettext": (1, 2), "pgettext": ((1, "c"), 2)}
EXTRACTED = {"keywords": KEYWORDS, "comment_tags": ["TRANSLATORS:"], "strip_comment_tags": True}
NAME = "LC_MESSAGES/ramanujan"


@cache
def template() -> Catalog:
    """Return the English messages, as a translator gets them."""
    made = Catalog(project="Ramanujan’s oscillator")
    for file, line, message, comments, context in extract_from_dir(PACKAGE, [("**.py", "python")], **EXTRACTED):
        made.add(message, None, [(file, line)], auto_comments=comments, context=context)
    return made


def texts(message: Message) -> tuple[str, ...]:
    """Return a message in English: one text, or singular and plural."""
    return message.id if isinstance(message.id, tuple) else (message.id,)


def strings(message: Message) -> tuple[str, ...]:
    """Return the translation of a message: one text, or its plural forms."""
    return message.string if isinstance(message.string, tuple) else (message.string,)


def translated(language: str) -> Catalog:
    """Return the catalogue of a language as its translators have left it."""
    with (LOCALE / language / f"{NAME}.po").open("rb") as file:
        return read_po(file, locale=language, charset="utf-8")


def compiled(catalogue: Catalog) -> bytes:
    """Return what the app reads of a catalogue: no message that is fuzzy."""
    written = io.BytesIO()
    write_mo(written, catalogue)
    return written.getvalue()


def update(language: str) -> Catalog:
    """Bring a catalogue up to date with the English messages and compile it; a new one is begun."""
    file = LOCALE / language / f"{NAME}.po"
    if file.exists():
        catalogue = translated(language)
    else:
        file.parent.mkdir(parents=True)
        catalogue = Catalog(locale=language, project=template().project, fuzzy=False)
    begun = catalogue.creation_date
    catalogue.update(template())
    catalogue.creation_date = begun
    # What nobody has translated is not kept for the day when it comes back.
    catalogue.obsolete = {key: message for key, message in catalogue.obsolete.items() if any(strings(message))}
    with file.open("wb") as written:
        # Without numbers of lines: they would change with every edit of a program.
        write_po(written, catalogue, width=120, sort_by_file=True, include_lineno=False)
    file.with_suffix(".mo").write_bytes(compiled(catalogue))
    return catalogue


def left(catalogue: Catalog) -> dict[str, list[str]]:
    """Return what is left to do in a catalogue: kind → the English texts."""
    messages = [message for message in catalogue if message.id]
    return {
        "missing": [texts(each)[0] for each in messages if not each.fuzzy and not all(strings(each))],
        "fuzzy": [texts(each)[0] for each in messages if each.fuzzy],
        "obsolete": [texts(each)[0] for each in catalogue.obsolete.values()],
    }


def main(*begun: str) -> None:
    """Update every catalogue and those that are begun, and print what is left to do."""
    for language in sorted({*begun, *(path.name for path in LOCALE.iterdir())}):
        for kind, found in left(update(language)).items():
            print(f"{language}: {len(found)} {kind}", *found, sep="\n    ")


if __name__ == "__main__":
    main(*sys.argv[1:])
