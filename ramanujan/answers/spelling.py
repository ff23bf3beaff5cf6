"""Split a text into tokens, with the spellings of the derivation's symbols in ASCII, Unicode and LaTeX.

A token is a number, a name of `SYMBOLS` or a sign of the grammar. Any other text raises an error whose message shows
the unknown character or name.
"""

import re
import unicodedata
from collections.abc import Iterator
from typing import TypeAlias

import sympy as sp

from ramanujan.derivation.model import ACCELERATIONS, COORDINATES, VELOCITIES, R, epsilon, k, m, m_prime
from ramanujan.text.reading import DIVISION_SIGNS, FRACTIONS
from ramanujan.text.translation import _

MAX_DIGITS = 20
"""The most digits of a number."""

_MOTION = {
    f"{name}{primes}": q
    for name, *states in zip(("X", "phi", "Phi"), COORDINATES, VELOCITIES, ACCELERATIONS, strict=True)
    for primes, q in zip(("", "'", "''"), states, strict=True)
}
SYMBOLS: dict[str, sp.Expr] = {"m": m, "m'": m_prime, "k": k, "R": R, **_MOTION, "eps": epsilon}
"""The typed name of each symbol of the derivation."""

MOTION = tuple(_MOTION)
"""The names of coordinates, velocities and accelerations."""

TEXTBOOK = {name: sp.Symbol(name) for name in ("v", "omega", "I", "x")}
"""The letters of the textbook's ½mv² + ½Iω² and ½kx². The judge answers them with a question about their meaning."""

_ALL = {**SYMBOLS, **TEXTBOOK}


class UnreadableError(ValueError):
    """The text is not a formula of the grammar; the message explains the reason to the student."""


class UnknownNameError(UnreadableError):
    """A formula contains an unknown name."""

    def __init__(self, name: str) -> None:
        super().__init__(_("“{name}” is not known here.").format(name=name))


class TooLargeError(UnreadableError):
    """The computation with a formula would take too long."""

    def __init__(self) -> None:
        super().__init__(_("This is too large to check here. Write it shorter or with smaller exponents."))


_SPELLINGS = str.maketrans(
    {
        **dict.fromkeys("·×⋅∙∗•", "*"),
        **dict.fromkeys(DIVISION_SIGNS, "/"),
        **dict.fromkeys("εɛ", "eps"),
        **dict.fromkeys("\t\n\r", " "),
        **dict.fromkeys("[{", "("),
        **dict.fromkeys("]}", ")"),
        "φ": "phi",
        "Φ": "Phi",
        "ω": "omega",
        "√": "sqrt",
    }
)
_REPLACEMENTS = [
    (re.compile(pattern), replacement)
    for pattern, replacement in (
        # The Ẋ of a textbook is decomposed into X and a dot above.
        ("(?<=[XφΦ])\u0307", "'"),
        ("(?<=[XφΦ])\u0308", "''"),
        # A tablet turns two hyphens into a dash.
        ("--+", "-"),
        # A decimal comma
        (r"(\{,\}|(?<!\\),)(?=[0-9])", "."),
        # LaTeX
        (r"\$|\\[()\[\]]", " "),
        (r"\\math[a-z]+\s*\{([^{}]*)\}", r"\1"),
        (r"(?<=[0-9])\\,(?=[0-9]{3})", ""),
        (r"\\(left|right|displaystyle|quad|[,;:! ])", " "),
        (r"\\(cdot|times)(?![A-Za-z])", "*"),
        (r"\\dot\s*(\{\s*)?(\\?[A-Za-zφΦ]+)\s*(?(1)\})", r" \2'"),
        (r"\\ddot\s*(\{\s*)?(\\?[A-Za-zφΦ]+)\s*(?(1)\})", r" \2''"),
        (r"\^\s*(\{\s*)?\\prime\s*(?(1)\})", "'"),
        (r"_\s*\{\s*([A-Za-z0-9]+)\s*\}", r"_\1"),
        (r"\\[dt]?frac\s*([0-9])\s*([0-9])", r" frac(\1)(\2)"),
        (r"\\[dt]?frac(?![A-Za-z])", " frac"),
        (r"\\(?=(sqrt|varphi|phi|Phi|varepsilon|epsilon|omega)(?![A-Za-z]))", " "),
    )
]
_RATES = (
    (re.compile(r"\bd ?(X|phi|Phi) ?/ ?dt\b"), r"\1'"),
    (re.compile(r"\bd ?\^ ?(?:2|\(2\)) ?(X|phi|Phi) ?/ ?dt ?\^ ?(?:2|\(2\))"), r"\1''"),
    (re.compile("(X|phi|Phi)_?ddot"), r"\1''"),
    (re.compile("(X|phi|Phi)_?dot|d(X|phi|Phi)"), r"\1\2'"),
)
_TOKEN = re.compile(
    rf"(?P<number>[0-9]+(?:\.[0-9]*)?|\.[0-9]+)|(?P<fraction>[{FRACTIONS}])"
    # An accented letter is two characters after decomposition; a subscript may be a number.
    "|(?P<word>[A-Za-z_](?:[A-Za-z_'\u0300-\u036f]|(?<=_)[0-9]+)*)"
    r"|(?P<sign>[-+*/^()])"
)
_ALIASES = {
    **{"epsilon": "eps", "varepsilon": "eps", "m_prime": "m'", "m_p": "m'"},
    **{"varphi": "phi", "varphi'": "phi'", "varphi''": "phi''"},
    # On a keyboard without Greek letters.
    "w": "omega",
}
# Longest first, so that m' is not read as m.
_NAME = re.compile("|".join(sorted(("sqrt", "frac", *_ALL, *_ALIASES), key=len, reverse=True)))


def to_ascii(text: str) -> str:
    """Return a normalized text in ASCII spelling, apart from fractions such as ½."""
    for pattern, replacement in _REPLACEMENTS:
        text = pattern.sub(replacement, text)
    text = text.translate(_SPELLINGS).replace("**", "^")
    for pattern, replacement in _RATES:
        text = pattern.sub(replacement, text)
    return text


Token: TypeAlias = str | sp.Expr


def split_into_tokens(text: str) -> Iterator[tuple[Token, bool]]:
    """Yield each number, name and sign, and whether a space precedes it."""
    position = 0
    follows_space = False
    while position < len(text):
        if text[position] == " ":
            position += 1
            follows_space = True
            continue
        match = _TOKEN.match(text, position)
        if match is None:
            raise UnreadableError(_explain_character(text[position]))
        position = match.end()
        if match["number"]:
            yield _read_number(match["number"]), follows_space
        elif match["fraction"]:
            yield sp.Rational(unicodedata.numeric(match[0])).limit_denominator(10), follows_space
        elif match["word"]:
            for name in _split_names(match["word"]):
                yield _ALL.get(name, name), follows_space
                follows_space = False
        else:
            yield match["sign"], follows_space
        follows_space = False


def _explain_character(character: str) -> str:
    """Return the message about a character that no formula contains."""
    if character == "Ω":
        return _("Type only the right side of the equation: a formula without Ω.")
    if character in "<>":
        return _("Type a formula, not a comparison.")
    shown = f"◌{character}" if unicodedata.combining(character) else character
    if not shown.isprintable():
        return _("The formula contains a character that cannot be shown. Delete it, or type the formula again.")
    return _("The character “{character}” does not belong in a formula.").format(character=shown)


def _read_number(digits: str) -> sp.Expr:
    if len(digits.replace(".", "")) > MAX_DIGITS:
        raise UnreadableError(_("A number may have at most {most} digits.").format(most=MAX_DIGITS))
    return sp.Symbol(digits) if "." in digits else sp.Integer(digits)


def _split_names(word: str) -> list[str]:
    """Split a run of letters into names: mR becomes m and R."""
    names, position = [], 0
    while position < len(word):
        match = _NAME.match(word, position)
        if match is None:
            raise UnknownNameError(unicodedata.normalize("NFC", word)[:MAX_DIGITS])
        names.append(_ALIASES.get(match[0], match[0]))
        position = match.end()
    return names
