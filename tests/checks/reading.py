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
    on_phone = []
    for inner in block:
        key = getattr(inner, "key", None) or ""
        if key.startswith("narrow-"):
            on_phone += [id(formula) for formula in inner.latex]
    return [element for element in block if element.type in ("markdown", "latex") and id(element) not in on_phone]


def array(stored: Any) -> np.ndarray:
    """Return the values of a figure's array, which may be stored as bytes."""
    if isinstance(stored, dict):
        return np.frombuffer(base64.b64decode(stored["bdata"]), dtype=stored["dtype"]).astype(float)
    return np.array(stored, dtype=float)
