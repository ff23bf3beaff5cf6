"""The identifiers of a class: a short public code, the lecturer's long key, and a random name for each student."""

import hashlib
import ipaddress
import secrets

ALPHABET = "BCDFHJKLMNPRSTWXZ"
"""The letters of codes, without letters that look like digits or other letters, and without vowels to avoid words."""
LETTERS = 6
"""The length of a code, for 24 million codes. A stranger who guesses one gets one vote, which the desk counts."""

SECRET_BYTES, VOTER_BYTES = 24, 9
"""The lengths of a lecturer's secret, which is short enough for a URL, and of a student's random name."""
_LONGEST = 60


def generate_code() -> str:
    """Return an unpredictable code."""
    return "".join(secrets.choice(ALPHABET) for _ in range(LETTERS))


def read_code(text: str, letters: int = LETTERS) -> str | None:
    """Return the code in a typed text, None without a code; ignore case, spaces and punctuation.

    >>> read_code(" bcd-fhj ")
    'BCDFHJ'
    """
    code = _keep_letters(text)
    return code if len(code) == letters and set(code) <= set(ALPHABET) else None


def find_foreign_letter(text: str) -> str:
    """Return the first letter or digit of a typed code that is not in `ALPHABET`.

    The result is empty if there is none, or if the text does not have the length of a code.

    >>> find_foreign_letter("bcd-fae"), find_foreign_letter("bcd")
    ('A', '')
    """
    code = _keep_letters(text)
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
    return _hash_in_class(code, browser) if browser else ""


def hash_network(address: str, code: str = "") -> str:
    """Return the hash of a visitor's network in one class, or without a code the hash for all classes.

    The hash serves to count the seats or the classes of one network. A provider assigns a household a whole range of
    IPv6 addresses, so only the first 64 bits count.
    """
    try:
        parsed = ipaddress.ip_address(address)
    except ValueError:
        return _hash_in_class(code, address)
    # A dual-stack server receives an IPv4 address as an IPv4-mapped IPv6 address.
    parsed = getattr(parsed, "ipv4_mapped", None) or parsed
    host_bits = 64 if parsed.version == 6 else 0
    return _hash_in_class(code, f"{parsed.version}:{int(parsed) >> host_bits}")


def _hash_in_class(code: str, text: str) -> str:
    return hashlib.sha256(f"{read_code(code)}:{text}".encode()).hexdigest()[:16]


def _keep_letters(text: str) -> str:
    """Return the letters and digits of a text, in capitals."""
    return "".join(filter(str.isalnum, text[:_LONGEST].upper()))
