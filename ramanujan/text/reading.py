"""Read numbers that a person has typed or pasted: a decimal or a fraction, with a point or a comma, in any spelling.

    read_number("9/8"), read_number("1:2"), read_number("½")        1.125, 0.5, 0.5
    read_number("12,5"), read_number("12,500")                      12.5, None
    two_readings("12,500")                                          12.500 and 12500

The boxes, the links and the judge use these rules. In the browser, `browser/numbers.js` uses those of the boxes.
"""

import re
import unicodedata
from fractions import Fraction

from ramanujan.text.numerals import DECIMAL, FROM_SUPERSCRIPTS
from ramanujan.text.translation import _

FRACTIONS = "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"
DIVISION_SIGNS = "÷∕⁄:∶"
"""Signs for a division apart from the slash. Schools in half of Europe write a division with a colon."""

LONGEST = 60
"""Largest length of a typed number."""

_UNSIGNED = r"(?:\d+(?:[.,]\d*)?|[.,]\d+)"
_NUMBER = re.compile(rf"([+-]?{_UNSIGNED}(?:[eE][+-]?\d{{1,3}})?)(?: */ *({_UNSIGNED}))?", re.ASCII)
_MAYBE_THOUSANDS = {
    mark: re.compile(rf"(?:^|[^0-9.,])([1-9]\d{{0,2}})[{other}](\d{{3}})(?![0-9.,])", re.ASCII)
    for mark, other in ((".", ","), (",", "."))
}
"""Decimal mark → a number with the other mark, which may separate thousands."""

_QUOTES = str.maketrans({**dict.fromkeys("′’ʼʹ´`‘‛", "'"), **dict.fromkeys('″“”"', "''")})
# Digits above the line would become digits on the line. A narrow space between groups of digits would end the number.
_BEFORE_NORMALIZATION = (
    (re.compile("⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+"), lambda match: f"^({match[0].translate(FROM_SUPERSCRIPTS)})"),
    (re.compile("(?<=[0-9])\u202f(?=[0-9]{3})"), ""),
)


def normalize(text: str) -> str:
    """Return a pasted text in plain letters and signs, with accents and dots as characters of their own.

    Invisible characters are dropped. Each dash is a minus sign, and each quotation mark a prime.
    """
    text = text.translate(_QUOTES)
    for pattern, replacement in _BEFORE_NORMALIZATION:
        text = pattern.sub(replacement, text)
    return "".join(map(_normalize_character, text))


def _normalize_character(character: str) -> str:
    if character in FRACTIONS:
        return character
    category = unicodedata.category(character)
    if category == "Cf":
        return ""
    if category == "Pd" or character == "−":
        return "-"
    return unicodedata.normalize("NFKD", character).translate(_QUOTES)


def read_number(text: str, decimal_mark: str = DECIMAL) -> float | None:
    """Return the value of a decimal or a fraction; None if the text is something else or has two readings.

    Parameters
    ----------
    text : a number with a point or a comma
    decimal_mark : the mark that never separates thousands: that of the language, or the point of the app's links

    >>> read_number("9/8"), read_number("1 : 2"), read_number("1,5"), read_number("1½")
    (1.125, 0.5, 1.5, None)
    """
    if len(text) > LONGEST or two_readings(text, decimal_mark):
        return None
    # The spaces separate the digits of a mixed number, such as 1½.
    spaced = re.sub(f"[{FRACTIONS}]", lambda match: f" {unicodedata.normalize('NFKD', match[0])} ", normalize(text))
    match = _NUMBER.fullmatch(re.sub(f"[{DIVISION_SIGNS}]", "/", spaced).strip())
    if match is None:
        return None
    numerator, denominator = (Fraction((part or "1").replace(",", ".")) for part in match.groups())
    try:
        return float(numerator / denominator)
    except (ZeroDivisionError, OverflowError):
        return None


def two_readings(text: str, decimal_mark: str = DECIMAL) -> dict[str, str] | None:
    """Return the first ambiguous number in a text with its two readings, or None if all numbers are clear.

    The other decimal mark before three digits may be meant as a decimal mark or as a thousands separator.

    >>> two_readings("k/12,500 + 0,125m")
    {'text': '12,500', 'decimal': '12.500', 'whole': '12500'}
    >>> two_readings("0,500"), two_readings("12.500k + 1234,500")
    (None, None)
    """
    match = _MAYBE_THOUSANDS[decimal_mark].search(normalize(text))
    if match is None:
        return None
    before, after = match.groups()
    other_mark = "," if decimal_mark == "." else "."
    readings = {"text": other_mark, "decimal": decimal_mark, "whole": ""}
    return {name: f"{before}{mark}{after}" for name, mark in readings.items()}


def explain_ambiguous_number(text: str) -> str | None:
    """Return a sentence about the first ambiguous number of a text, or None if all numbers are clear.

    >>> explain_ambiguous_number("k/12,500")
    '12,500 can mean 12.500 or 12500. Type one of these two.'
    """
    readings = two_readings(text)
    return _("{text} can mean {decimal} or {whole}. Type one of these two.").format(**readings) if readings else None
