"""The identifiers of a class: a short public code, the lecturer's long key, and a random name for each student."""

import hashlib
import re
import secrets
import unicodedata
from urllib.parse import unquote

ALPHABET = "BCDFHJKLMNPRSTWXZ"
"""The letters of codes, without letters that look like digits or other letters, and without vowels to avoid words."""
LETTERS = 6
"""The length of a code, for 24 million codes. A stranger who guesses one gets one vote, which the desk counts."""

SECRET_BYTES, VOTER_BYTES = 24, 9
"""The lengths of a lecturer's secret, which is short enough for a URL, and of a student's random name."""
URL_PARAMETER = "class"
"""The URL parameter with the code of a class."""
LONGEST = 500
"""Number of characters of a typed code or a pasted link that are read."""

_IN_LINK = re.compile(rf"[?&]{URL_PARAMETER}=([^&#\s]*)")
_LOOK_ALIKES = str.maketrans("ВСНҺЈКМРЅТХ" + "ΒΗΚΜΝΡΤΧΖ", "BCHHJKMPSTX" + "BHKMNPTXZ")
"""Cyrillic and Greek capitals that look like letters of `ALPHABET`."""


def generate_code() -> str:
    """Return an unpredictable code."""
    return "".join(secrets.choice(ALPHABET) for _ in range(LETTERS))


def read_code(text: str, letters: int = LETTERS) -> str | None:
    """Return the code in a typed text or a pasted link, None without a code; ignore case, spaces and punctuation.

    >>> read_code(" bcd-fhj "), read_code("https://school.example/lesson?class=BCDFHJ&part=tasks")
    ('BCDFHJ', 'BCDFHJ')
    """
    code = read_letters(text)
    return code if len(code) == letters and set(code) <= set(ALPHABET) else None


def read_letters(text: str) -> str:
    """Return the letters and digits of a typed code, or of the code in a link, as Latin capitals where they look alike.

    >>> read_letters("ВСр нјк"), read_letters("ｂｃｄ")
    ('BCPHJK', 'BCD')
    """
    link = _IN_LINK.search(text[:LONGEST])
    code = unquote(link[1]) if link else text[:LONGEST]
    capitals = unicodedata.normalize("NFKC", code).upper().translate(_LOOK_ALIKES)
    return "".join(filter(str.isalnum, capitals))


def find_foreign_letter(text: str) -> str:
    """Return the first letter or digit of a typed code that is not in `ALPHABET`.

    The result is empty if all are in `ALPHABET`, or if the text does not have the length of a code.

    >>> find_foreign_letter("bcd-fae"), find_foreign_letter("bcd")
    ('A', '')
    """
    code = read_letters(text)
    if len(code) != LETTERS:
        return ""
    return next((letter for letter in code if letter not in ALPHABET), "")


def format_code(code: str) -> str:
    """Return a code in two groups, which are easy to read aloud.

    >>> format_code("BCDFHJ")
    'BCD FHJ'
    """
    half = len(code) // 2
    return f"{code[:half]} {code[half:]}"


def join_key(code: str, secret: str) -> str:
    """Return the lecturer's key to the class with this code."""
    return f"{code}-{secret}"


def split_key(key: str) -> tuple[str, str]:
    """Return the code and the secret of a key. For a code without a secret, the second string is empty."""
    code, _hyphen, secret = key.partition("-")
    return code, secret


def hash_secret(secret: str) -> str:
    """Return the hash of a secret. The database stores only this hash, so a leaked copy contains no key."""
    return hashlib.sha256(secret.encode()).hexdigest()


def hash_browser(browser: str, code: str) -> str:
    """Return the name of a browser in one class, a hash, so that the names in two classes cannot be linked."""
    return hashlib.sha256(f"{read_code(code)}:{browser}".encode()).hexdigest()[:16] if browser else ""
