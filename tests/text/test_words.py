"""Every visible sentence is a whole template that gettext tools find. test_browser_language checks the browser."""

import ast
import re
import string
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import polib
import pytest
from babel.messages.catalog import Message

from ramanujan.shell.parameters import PARAMETERS
from ramanujan.shell.widgets import box_settings
from ramanujan.text import catalogue
from ramanujan.text.catalogue import COMPLETE, Translations, difference, languages, translations
from tests.catalogue import KEYWORDS, PACKAGE, merged, remaining, sentence, strings, template, texts, translated, update

SHORTEST_LIMIT = 30
"""Largest number of words in a sentence."""

_FORMULA = re.compile(r"\$[^$]*\$|`[^`]*`")


def messages() -> list[Message]:
    return [message for message in template() if message.id]


def every_text() -> list[str]:
    return sorted({text for message in messages() for text in texts(message)})


def fields(text: str) -> list[str | None]:
    """Return the names of the slots of a template in their order. Single braces of LaTeX would count as slots."""
    return [name for _text, name, _form, _conversion in string.Formatter().parse(text) if name is not None]


@cache
def sources() -> list[tuple[Path, ast.Module]]:
    return [(path, ast.parse(path.read_text(encoding="utf-8"))) for path in sorted(PACKAGE.rglob("*.py"))]


def calls(tree: ast.AST, *names: str) -> Iterator[ast.Call]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and name_of(node) in names:
            yield node


def name_of(call: ast.Call) -> str:
    """Return the name of a called function or method."""
    return getattr(call.func, "id", getattr(call.func, "attr", ""))


# The catalogue


def test_the_template_contains_every_message():
    """Extraction tools skip messages that are not literals, and the expressions of f-strings."""
    # The template contains each message once, with all its places.
    extracted = Counter(file for file, _line in {place for message in messages() for place in message.locations})
    for path, tree in sources():
        written = list(calls(tree, *KEYWORDS))
        assert len({call.lineno for call in written}) == extracted[str(path.relative_to(PACKAGE))], path
        for call in written:
            literals = call.args[: 1 if name_of(call) == "_" else 2]
            for literal in literals:
                assert isinstance(literal, ast.Constant), path
                assert isinstance(literal.value, str), path
    assert extracted.total() > 300


def test_numbers_have_singular_and_plural():
    plurals = [message.id for message in messages() if message.pluralizable]
    assert plurals
    for singular, plural in plurals:
        assert singular != plural
        # "One period" is a singular without its number.
        assert set(fields(plural)) - set(fields(singular)) <= {"n"}
        assert set(fields(singular)) <= set(fields(plural))
    # Plurals without gettext: "(s)", or "1 period" next to "{n} periods".
    assert not [text for text in every_text() if re.search(r"\w\(s\)|\{\w+\}(s|es)\b", text)]


def test_slots_have_names():
    for text in every_text():
        for name in fields(text):
            # A slot may contain an attribute or an item, as in {machine.period} and {terms[0]}.
            assert re.fullmatch(r"[^\W\d]\w*(\.[^\W\d]\w*|\[\d\])*", name), text


# Translations


@pytest.mark.parametrize("language", languages())
def test_a_catalogue_has_no_fault(language):
    faults = [sentence(language, fault) for fault in translations(language).faults]
    assert not faults, "\n".join(["Correct these translations:", *faults])


BREAKING = re.compile(r"(?<=[^\s–−])-(?=(?!egy\b)[a-záéíóöőúüű]{1,3}\b|ként\b|sz[eoö]r|gyel\b|[áé]v[ae]l\b)")
"""An ordinary hyphen before a Hungarian suffix; compounds such as Lagrange-függvény may break."""


def test_no_line_breaks_before_a_hungarian_suffix():
    """A line may end after an ordinary hyphen, but not after U+2011."""
    for broken in ("26 %-a", "m′-t", "X-től", "CSV-ként", "R-szerese", "{off}-ával", "1-gyel"):
        assert BREAKING.search(broken.format(off="2")), broken
    broken_lines = []
    for message in translated("hu"):
        for text in strings(message) if message.id else ():
            # A suffix may follow a formula or a slot. A minus sign in a formula is not a hyphen.
            prose = re.sub(r"\{[^}]*\}", "x", _FORMULA.sub("x", text))
            broken_lines += [text for _each in BREAKING.finditer(prose)]
    assert broken_lines == []


QUOTED = re.compile(r"[“„]([^“„”]+)[”“]")
"""Text in English, Hungarian or German quotation marks."""


@pytest.mark.parametrize("language", COMPLETE)
def test_a_quoted_label_is_the_label_of_the_page(language):
    """A sentence about a button quotes its label, in every language."""
    catalogue = {text: message for message in translated(language) if message.id for text in texts(message)[:1]}
    checked = 0
    for text, message in catalogue.items():
        for label in QUOTED.findall(text):
            if label in catalogue:
                checked += 1
                own = strings(catalogue[label])[0]
                assert all(own in QUOTED.findall(string) for string in strings(message)), (label, own)
    assert checked


@pytest.mark.parametrize("language", ["en", *COMPLETE])
def test_the_spoken_name_of_a_slider_begins_with_the_words_beside_it(language):
    """Voice control finds a slider and its box by the words that are seen (WCAG 2.5.3)."""
    translate = str if language == "en" else translations(language).gettext
    for parameter in PARAMETERS.values():
        assert translate(parameter.meaning).startswith(translate(parameter.short))
        assert parameter.label.startswith(parameter.meaning)
        assert box_settings(parameter)["label"].startswith(parameter.label)
    assert translate("{parameter}, exact value").startswith("{parameter}")


@pytest.mark.parametrize("language", COMPLETE)
def test_a_complete_language_has_every_message(language):
    missing = remaining(merged(language))["missing"]
    work = f"Run python -m tests.catalogue, then translate these messages into {language}."
    otherwise = (
        "If you do not know the language, see “An English sentence is new, or changes” in .github/CONTRIBUTING.md."
    )
    assert not missing, "\n".join([work, otherwise, *missing])


ENTRY = """
#{flags}
msgid "{{n:3 s}} of $x$, **exactly** {{exactly}}"
msgstr "{translation}"
"""


@pytest.mark.parametrize("flags", ["", ", fuzzy"])
@pytest.mark.parametrize(
    ("translation", "reason"),
    [
        ("**Pile** {exactly} : {n:3 s} de $x$", ""),
        ("**Pile** {exactement} : {n:3 s} de $x$", "It lacks {exactly} and has {exactement} instead."),
        ("**Pile** {exactly} : {n} de $x$", "It lacks {n:3 s} and has {n} instead."),
        ("**Pile** {exactly} : {n:3 s} de x", "It lacks $x$."),
        ("**Pile** {exactly} : {n:3 s} de $x$ }", "It has }, which the English text has not."),
        ("**Pile** {{exactly}} : {n:3 s} de $x$", "It has {, }, which the English text has not."),
        ("Pile {exactly} : {n:3 s} de $x$", "It lacks **."),
        ("**Pile** {exactly} : {n:3 s} de $x$ ", "It begins or ends with a space."),
    ],
)
def test_an_unusable_translation_is_shown_in_english(flags, translation, reason):
    """A renamed slot once caused a KeyError on the first page."""
    head = 'msgid ""\nmsgstr "Content-Type: text/plain; charset=utf-8\\n"\n'
    catalogue = Translations(polib.pofile(head + ENTRY.format(flags=flags, translation=translation)))
    english = "{n:3 s} of $x$, **exactly** {exactly}"
    assert [fault.reason for fault in catalogue.faults] == [reason] * bool(reason)
    assert catalogue.gettext(english) == (english if reason else translation)


def test_the_translation_of_an_edited_sentence_is_shown_and_listed_as_fuzzy(tmp_path, monkeypatch):
    """An old English text of several lines once made the catalogue unreadable."""
    contents = catalogue.catalogue_file("de").read_text(encoding="utf-8")
    monkeypatch.setattr(catalogue, "LOCALE", tmp_path)
    file = catalogue.catalogue_file("de")
    file.parent.mkdir(parents=True)
    entries = polib.pofile(contents)
    entry = max((each for each in entries if not each.msgid_plural), key=lambda each: len(each.msgid))
    today, translation = entry.msgid, entry.msgstr
    entry.msgid = today.replace("the", "every", 1)
    entries.save(str(file))
    for _run in range(2):
        assert len(remaining(update("de"))["fuzzy"]) == 1
        assert translations("de").gettext(today) == translation


def test_negative_control_a_lost_slot_formula_or_mark_is_detected():
    english = "**{n:3 s}** is $x = 0.5\\,\\text{turns}$, `k` <b>m</b> [here](page) &nbsp; :material/check:"
    hungarian = "$x = 0{,}5\\,\\text{fordulat}$ &nbsp; **{n:3 s}**: :material/check: <b>m</b>, `k` [itt](page)"
    assert not difference(english, hungarian)
    for lost in ("{n:3 s}", "**", "0.5", "`k`", "</b>", "(page)", "&nbsp;", ":material/check:"):
        assert difference(english, english.replace(lost, "x", 1)), lost


# Whole sentences


NUMERIC = {"physics", "number_theory"}
"""Rooms with errors for programmers, which are English in every language."""


def test_no_error_message_is_concatenated():
    """The text of each visible error, including the parser's, is a gettext template."""
    for path, tree in sources():
        is_numeric = path.relative_to(PACKAGE).parts[0] in NUMERIC
        for call in calls(tree, "ValueError", "UnreadableError"):
            if is_numeric:
                assert not list(calls(call, "_")), f"{path}:{call.lineno}"
                continue
            assert not isinstance(call.args[0], ast.JoinedStr | ast.BinOp | ast.Constant), f"{path}:{call.lineno}"


# Style


def test_every_sentence_is_short_and_well_punctuated():
    for text in every_text():
        prose = _FORMULA.sub("x", text)
        # The apostrophe is ’, the dash –.
        assert not re.search("'|  |--", prose.replace("m'", "")), text
        assert text == text.strip()
        for part in re.split(r"(?<=[.?!:;])\s+|\n+", prose):
            assert len(re.findall(r"[\w’{}]+", part)) <= SHORTEST_LIMIT, part


# Bounds

BOUND = re.compile(
    r"\b(at most|at least|up to|within|below|never exceeds|must exceed|(?:less|more|fewer|larger) than)"
    r"\s+(?:one part in |an error of |x₀\s=\s|hΩ\s=\s|μ\s=\s|2R, |\*\*)*\{([^{}:]*)(?::([^{}]*))?\}",
    re.IGNORECASE,
)
"""A phrase that states a bound, and the slot after it with its format."""
ROUNDED_DOWN = ("at least", "more than", "one part in", "x₀", "less than {light")
"""Lower bounds, a reciprocal, and two sufficient conditions; all other bounds are rounded up."""
EXACT = {"most", "least", "bound", "within", "tolerance", "cost", "periods", "mu", "machine.m", "limit", "largest"}
"""Slots of integers, of values set by users, and of limits written with all digits."""


def bounds() -> list[tuple[str, str, str]]:
    """Return each phrase with a bound, such as “at most {x:3↑}”, its slot, and the format of the slot."""
    return [(match[0], match[2], match[3] or "") for text in every_text() for match in BOUND.finditer(text)]


def test_every_bound_is_rounded_to_its_own_side():
    assert len(bounds()) > 20
    for phrase, slot, form in bounds():
        arrow = "↓" if any(start in phrase for start in ROUNDED_DOWN) else "↑"
        assert slot in EXACT or arrow in form, phrase
        assert {"↑": "↓", "↓": "↑"}[arrow] not in form, phrase


# The page


def scripts() -> dict[str, str]:
    """Yield every JavaScript and HTML file without its comments."""
    files = [*PACKAGE.rglob("*.js"), *PACKAGE.rglob("*.html")]
    return {
        str(file.relative_to(PACKAGE)): re.sub(
            r"/\*.*?\*/|(?<![:\w])//[^\n]*", "", file.read_text(encoding="utf-8"), flags=re.DOTALL
        )
        for file in files
    }


def find_visible_words(name: str, text: str) -> list[str]:
    """Return visible texts: two quoted words that begin with a capital, or any text in HTML."""
    pattern = r">\s*([A-Za-z]{3,}[^<>]*)<" if name.endswith("html") else r"[\"'`]([A-Z][a-z]+ [a-z][^\"'`]*)[\"'`]"
    return re.findall(pattern, text)


def test_no_visible_words_are_in_scripts_or_html():
    assert find_visible_words("a.js", 'node.textContent = "Both hands start together."')
    assert find_visible_words("a.html", "<button>Copy link</button>")
    words = {name: find_visible_words(name, text) for name, text in scripts().items()}
    assert {name: texts for name, texts in words.items() if texts} == {}
