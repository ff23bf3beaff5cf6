"""Keys and names of worksheets: the author has the key, and students have the name.

The name is a hash of the key, so neither is stored: a link works on every server and does not expire. A signature would
require a secret of the server. With another secret, for example on another server, the links would be invalid.

There are 17¹⁰ ≈ 2 × 10¹² names, and scrypt takes about 50 ms and 16 MB for each key. A search for a key with a given
name takes about three years on a thousand cores.
"""

import hashlib
import secrets
from functools import lru_cache

from ramanujan.classroom.codes import ALPHABET, read_code
from ramanujan.shell import address
from ramanujan.text.translation import _

LETTERS = 10
"""Number of letters in a name; they are 41 bits."""
_COST = {"n": 2**14, "r": 8, "p": 1}
"""Parameters of scrypt that its author recommends for interactive use (C. Percival, 2009)."""
KEY = address.Text(
    "key", "[0-9a-f]{16}", _("The value of {name} in the address was ignored: it is not the key of a worksheet.")
)
SEED = address.Text(
    "seed",
    f"[{ALPHABET}]{{{LETTERS}}}",
    _("The value of {name} in the address was ignored: it is not the name of a worksheet."),
    default="BCDFHJKLMN",
)
"""URL parameters: the key and the name of a worksheet."""


def new() -> str:
    """Return a new random key."""
    return secrets.token_hex(8)


@lru_cache(maxsize=1024)
def name(key: str) -> str:
    """Return the name of the worksheet with this key."""
    hashed = int.from_bytes(hashlib.scrypt(key.encode(), salt=b"Ramanujan's oscillator", **_COST))
    return "".join(ALPHABET[hashed // len(ALPHABET) ** place % len(ALPHABET)] for place in range(LETTERS))


def read_name(text: str) -> str | None:
    """Parse a typed name of a worksheet, in upper or lower case and with any separators; return None if it is invalid.

    >>> read_name(" bcdfh-jklmn ")
    'BCDFHJKLMN'
    """
    return read_code(text, LETTERS)


def has_key() -> bool:
    """Return whether the address contains the key of the current worksheet."""
    key = address.update(KEY)
    return bool(key) and name(key) == address.current(SEED)
