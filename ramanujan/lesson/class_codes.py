"""What opens a class: a short code for everybody, a long key for the lecturer, a random voter for each student."""

import hashlib
import ipaddress
import secrets

ALPHABET = "BCDFHJKLMNPRSTWXZ"
"""Letters of a code: none looks like a digit or like another letter, and without vowels they spell no word."""
LETTERS = 6
"""The letters of a code; 17⁶ is 24 million. A stranger who guesses a code gets one vote, and the desk sees it."""

SECRET_BYTES, VOTER_BYTES = 24, 9
"""The length of a lecturer’s key, which fits into an address, and of a student’s random name."""
_LONGEST = 60


def new_code() -> str:
    """Return a code that nobody can foresee."""
    return "".join(secrets.choice(ALPHABET) for _ in range(LETTERS))


def read_code(text: str, letters: int = LETTERS) -> str | None:
    """Return the code that was typed, in whatever case and with whatever between its letters, or None.

    >>> read_code(" bcd-fhj ")
    'BCDFHJ'
    """
    code = _bare(text)
    return code if len(code) == letters and set(code) <= set(ALPHABET) else None


def foreign_to_codes(text: str) -> str:
    """Return the first letter or digit that occurs in no code, of a text that is as long as one; otherwise nothing.

    >>> foreign_to_codes("bcd-fae"), foreign_to_codes("bcd")
    ('A', '')
    """
    code = _bare(text)
    return next((letter for letter in code if letter not in ALPHABET), "") if len(code) == LETTERS else ""


def spaced(code: str) -> str:
    """Return a code as it is read aloud, in two groups.

    >>> spaced("BCDFHJ")
    'BCD FHJ'
    """
    return f"{code[: len(code) // 2]} {code[len(code) // 2 :]}"


def key_of(code: str, secret: str) -> str:
    """Return the lecturer's key to the class of this code."""
    return f"{code}-{secret}"


def parts_of(key: str) -> tuple[str, str]:
    """Return the code and the secret of a key; the secret of a mere code is empty."""
    code, _hyphen, secret = key.partition("-")
    return code, secret


def hash_of(secret: str) -> str:
    """Return what is kept of a secret: who reads the database cannot make the key from it."""
    return hashlib.sha256(secret.encode()).hexdigest()


def voter_of(browser: str, code: str) -> str:
    """Return the random name of a browser in one class: no class can be told from it what another one got."""
    return _in_class(code, browser) if browser else ""


def network_of(address: str, code: str) -> str:
    """Return what a class knows of a visitor’s IP address while it counts who joins from one network.

    A provider gives a household a whole range of version 6 addresses, so those that agree in 64 bits count as one.
    """
    try:
        at = ipaddress.ip_address(address)
    except ValueError:
        return _in_class(code, address)
    # A server that listens to both versions sees a version 4 address inside one of version 6.
    at = getattr(at, "ipv4_mapped", None) or at
    return _in_class(code, f"{at.version}:{int(at) >> (64 if at.version == 6 else 0)}")


def _in_class(code: str, text: str) -> str:
    return hashlib.sha256(f"{read_code(code)}:{text}".encode()).hexdigest()[:16]


def _bare(text: str) -> str:
    return "".join(filter(str.isalnum, text[:_LONGEST].upper()))
