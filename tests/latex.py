"""Reads LaTeX as the pages show it, and evaluates it with 60 digits: what a reader with pencil and paper would do.

It knows nothing of the package or of SymPy: each mark becomes the one of Python that means the same. A decimal that
ends in dots is read as the number that is written.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache

import mpmath
import numpy as np

Number = mpmath.mpf | np.ndarray
"""A number of 60 digits, or a matrix of them."""

mpmath.mp.dps = 60

_LETTER = r"(?:\\mathcal\{[A-Z]\}|\\(?!frac|sqrt|left|right|begin|end|cdot|d?dot)[a-zA-Z]+|[a-zA-Z])"
_PYTHON = {
    r"\left[\begin{matrix}": "matrix([[",
    r"\end{matrix}\right] \left[\begin{matrix}": "]])@matrix([[",
    r" \left[\begin{matrix}": "*matrix([[",
    r"\end{matrix}\right]": "]])",
    r"\left|{\begin{matrix}": "det([[",
    r"\end{matrix}}\right|": "]])",
    r"\left(": "(",
    r"\right)": ")",
    r"\frac{": "frac(",
    r"\sqrt{": "sqrt(",
    r"\\": "],[",
    r"\ ": "",
    r"\,": "*",
    r"\cdot": "*",
    "{": "(",
    "}": ")",
    "^{": "**(",
    "^": "**",
    "&": ",",
    **{mark: mark for mark in ",+-()"},
    " ": "",
}
_TOKEN = re.compile(
    r"(?P<number>\d+(?:\.\d+)?)(?:\\ldots)?(?: \\times 10\^\{(?P<power>-?\d+)\})?"
    rf"|(?P<mark>{'|'.join(re.escape(mark) for mark in sorted(_PYTHON, key=len, reverse=True))})"
    r"|(?P<name>\\Omega(?:_\{\\text\{clamped\}\})?\^\{2\}|M\^\{-1\}"
    rf"|(?:\\d?dot\{{{_LETTER}\}}|{_LETTER})'?(?:_\{{(?:\\text\{{\w+\}}|\\?[a-zA-Z0-9*]+)\}})?)"
)
_UNIT = re.compile(r"\\,\\mathrm\{(?:kg|s\^\{-2\})\}")


@lru_cache(maxsize=10_000)
def formula(text: str) -> Formula:
    """Return a formula that has been read; many machines share the sides that hold no number."""
    return Formula(text)


class Formula:
    """A formula as Python; `names` are its symbols as written in LaTeX, `value` evaluates it."""

    def __init__(self, text: str) -> None:
        place, python, self._numbers, self.names = 0, "", [], []
        while place < len(text):
            found = _TOKEN.match(text, place)
            if found is None:
                raise ValueError(f"not understood: {text[place:]!r} in {text!r}")
            place = found.end()
            if found["number"]:
                python += f"numbers[{len(self._numbers)}]"
                self._numbers.append(mpmath.mpf(f"{found['number']}e{found['power'] or 0}"))
            elif found["name"]:
                python += f"names[{len(self.names)}]"
                self.names.append(found["name"])
            else:
                python += _PYTHON[found["mark"]]
        self._python = compile(python, text, "eval")

    def value(self, values: Mapping[str, Number]) -> Number:
        """Return the value.

        Parameters
        ----------
        values : name as written in LaTeX → number, or matrix as an array of numbers
        """
        known = {
            "names": [values[name] for name in self.names],
            "numbers": self._numbers,
            "frac": lambda above: lambda below: above / below,
            "sqrt": mpmath.sqrt,
            "matrix": lambda rows: np.array(rows, dtype=object),
            "det": lambda rows: mpmath.det(mpmath.matrix(rows)),
        }
        found = eval(self._python, known)
        return np.array(found, dtype=object) if isinstance(found, tuple) else found


def equations(display: str) -> list[str]:
    """Return the equations of one display, the lines of a broken one put together again."""
    inside = display.removeprefix(r"\begin{aligned}").removesuffix(r"\end{aligned}")
    found: list[str] = []
    for line in re.split(r"\\\\\[[\d.]+em\]", inside):
        for part in re.split(r"&\\qquad", line):
            text = part.strip()
            if text.startswith(r"&\quad"):
                found[-1] += " " + text.removeprefix(r"&\quad").strip()
            else:
                found.append(text.removeprefix("&").replace("&=", "="))
    return [each.strip() for each in found]


def sides(equation: str) -> tuple[str, str, str, bool]:
    """Return left side, right side, its decimal or "", without units and label, and whether the decimal is exact."""
    left, right = _UNIT.sub("", equation).rpartition(r":\quad ")[2].split(" = ", 1)
    right, sign, decimal = re.fullmatch(r"(.*?)(?: (=|\\approx) ([^=]*))?", right).groups(default="")
    return left, right, decimal, sign == "="
