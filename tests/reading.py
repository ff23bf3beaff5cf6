"""A parser, independent of the package, for numbers on the pages: 0.033, 12 300, −4.6×10¹⁵³, 10⁻⁶."""

import base64
from typing import Any

import numpy as np

NUMBER = "([−0-9.\u202f×⁻⁰¹²³⁴⁵⁶⁷⁸⁹]*[0-9⁰¹²³⁴⁵⁶⁷⁸⁹])"
"""A regular expression for a number on a page."""

_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def read(text: str) -> float:
    plain = text.replace("\u202f", "").replace("−", "-")
    digits = plain.rstrip("⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
    if digits == plain:
        return float(plain)
    assert digits.endswith("10")
    size = digits.removesuffix("10").removesuffix("×")
    return float(f"{size if size.strip('-') else size + '1'}e{plain[len(digits) :].translate(_RAISED)}")


def wide_formulas(block: Any) -> list[Any]:
    """Return AppTest's texts and formulas, without the formulas that only a phone shows."""
    narrow = [
        id(each) for inner in block if (getattr(inner, "key", None) or "").startswith("narrow_") for each in inner.latex
    ]
    return [each for each in block if each.type in ("markdown", "latex") and id(each) not in narrow]


def array(given: Any) -> np.ndarray:
    """Return the values of a figure's array, which may be stored as bytes."""
    if isinstance(given, dict):
        return np.frombuffer(base64.b64decode(given["bdata"]), dtype=given["dtype"]).astype(float)
    return np.array(given, dtype=float)
