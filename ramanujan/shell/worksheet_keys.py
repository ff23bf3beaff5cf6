"""Keys of worksheets and exercises: the author has the key, the others have the name, and a name leads to no key.

The name is a hash of the key, so that the two need not be kept anywhere: a link works on every server and for ever. A
signature would need a secret of the server: with another one, after a move or on the laptop in the classroom, no link
would lead to its key any more.

A worksheet has one of 17¹⁰ ≈ 2 × 10¹² names, and scrypt takes some 50 ms and 16 MB for each key that somebody tries. On
a thousand cores one finds a key that fits after three years.
"""

import hashlib
import secrets
from functools import lru_cache

from ramanujan.lesson.class_codes import ALPHABET, read_code
from ramanujan.shell import address
from ramanujan.translation import _

LETTERS = 10
"""Letters of a worksheet's name: 41 bits."""
_COST = {"n": 2**14, "r": 8, "p": 1}
"""The parameters of scrypt that its author recommends for a person who waits (C. Percival, 2009)."""
_REFUSED = _("The value of {name} in the address was ignored: it is not the key of a worksheet.")
_NO_NAME = _("The value of {name} in the address was ignored: it is not the name of a worksheet.")


def key_parameter(name: str) -> address.Text:
    """Return the URL parameter of this name, which holds a key."""
    return address.Text(name, "[0-9a-f]{16}", _REFUSED)


def name_parameter(name: str, default: str = "") -> address.Text:
    """Return the URL parameter of this name, which holds the name of a worksheet."""
    return address.Text(name, f"[{ALPHABET}]{{{LETTERS}}}", _NO_NAME, default)


def new() -> str:
    """Return a key that nobody can guess."""
    return secrets.token_hex(8)


@lru_cache(maxsize=1024)
def name(key: str) -> str:
    """Return the name of the worksheet to which a key belongs."""
    hashed = int.from_bytes(hashlib.scrypt(key.encode(), salt=b"Ramanujan's oscillator", **_COST))
    return "".join(ALPHABET[hashed // len(ALPHABET) ** place % len(ALPHABET)] for place in range(LETTERS))


def read_name(text: str) -> str | None:
    """Return the name of a worksheet that was typed, in whatever case and with whatever between its letters, or None.

    >>> read_name(" bcdfh-jklmn ")
    'BCDFHJKLMN'
    """
    return read_code(text, LETTERS)


def fits(held: address.Text, worksheet: str) -> bool:
    """Tell whether a URL parameter holds the key of the worksheet with this name."""
    key = address.keep(held)
    return bool(key) and name(key) == worksheet
