"""Keys of worksheets and exercises: whoever makes one has its key, and its number, which others have, leads to no key.

The number is a hash of the key, so that the two need not be kept anywhere: a link works on every server and for ever.
"""

import secrets
from hashlib import sha256

from ramanujan.shell import address
from ramanujan.translation import _

MOST = 9999
"""The greatest number of a sheet."""
_REFUSED = _("The value of {name} in the address was ignored: it is not the key of a sheet.")


def parameter(name: str) -> address.Text:
    """Return the URL parameter of this name, which holds a key."""
    return address.Text(name, "[0-9a-f]{12}", _REFUSED)


def new() -> str:
    """Return a key that nobody can guess."""
    return secrets.token_hex(6)


def number(key: str) -> int:
    """Return the number of the sheet to which a key belongs, from 1 to `MOST`."""
    return 1 + int.from_bytes(sha256(key.encode()).digest(), "big") % MOST


def fits(held: address.Text, sheet: int) -> bool:
    """Tell whether a URL parameter holds the key of the sheet with this number."""
    key = address.keep(held)
    return bool(key) and number(key) == sheet
