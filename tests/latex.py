"""Reads LaTeX as the pages show it, and evaluates it with 60 digits: what a reader with pencil and paper would do.

It knows nothing of the package or of SymPy. A decimal that ends in dots is read as the number that is written.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

import mpmath
import numpy as np

Number = mpmath.mpf | np.ndarray
"""A number of 60 digits, or a matrix of them."""

mpmath.mp.dps = 60

_SPACE = re.compile(r"(?:\\,|\\ |\\quad|\\qquad|\\textstyle|\\cdot(?! 10)|\s)+")
_NUMBER = re.compile(r"(\d+(?:\.\d+)?)(\\ldots)?(?: \\cdot 10\^\{(-?\d+)\})?")
_OMEGA = re.compile(r"\\Omega(?:_\{\\mathrm\{clamped\}\})?\^\{2\}|M\^\{-1\}")
_LETTER = r"(?:\\mathcal\{[A-Z]\}|\\(?!frac|sqrt|left|right|begin|end|dot|ddot)[a-zA-Z]+|[a-zA-Z])"
_NAME = re.compile(
    rf"(?:\\d?dot\{{{_LETTER}\}}|{_LETTER})'?"
    r"(?:_\{(?:\\mathrm\{\w+\}|\\?[a-zA-Z0-9*]+)\})?"
)
_MATRIX = re.compile(r"\\left(\[|\|)\{?\\begin\{matrix\}(.*?)\\end\{matrix\}\}?\\right(\]|\|)")
_UNIT = re.compile(r"\\,\\mathrm\{(?:kg|s\^\{-2\})\}")


class Reader:
    """Evaluates one formula.

    Parameters
    ----------
    values : name as written in LaTeX → number, or matrix as an array of numbers
    rough : leave every sign out, so that the result bounds the terms of all sums
    """

    def __init__(self, values: Mapping[str, Number], rough: bool = False) -> None:
        self.values, self.rough = values, rough
        self.text, self.place = "", 0

    def read(self, text: str) -> Number:
        """Return the value of a formula, all of which must be understood."""
        outer, self.text, self.place = (self.text, self.place), text, 0
        value = self._sum()
        if self.place != len(text):
            raise ValueError(f"not understood: {text[self.place :]!r} in {text!r}")
        self.text, self.place = outer
        return value

    def _take(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        if space := _SPACE.match(self.text, self.place):
            self.place = space.end()
        if found := pattern.match(self.text, self.place):
            self.place = found.end()
        return found

    def _eat(self, text: str) -> bool:
        return bool(self._take(re.compile(re.escape(text))))

    def _must(self, text: str) -> None:
        if not self._eat(text):
            raise ValueError(f"{text!r} expected at {self.text[self.place :]!r}")

    def _sum(self) -> Number:
        minus = self._eat("-")
        total = self._signed(self._product(), minus)
        while sign := self._take(re.compile(r"[+-]")):
            total = total + self._signed(self._product(), sign[0] == "-")
        return total

    def _signed(self, value: Number, minus: bool) -> Number:
        return -value if minus and not self.rough else value

    def _product(self) -> Number:
        value = self._power()
        if value is None:
            raise ValueError(f"a factor expected at {self.text[self.place :]!r} in {self.text!r}")
        while (factor := self._power()) is not None:
            both = isinstance(value, np.ndarray) and isinstance(factor, np.ndarray)
            value = value @ factor if both else value * factor
        return value

    def _power(self) -> Number | None:
        base = self._atom()
        if base is not None and self._eat("^{"):
            exponent = self._sum()
            self._must("}")
            return base ** int(exponent)
        return base

    def _group(self) -> Number:
        self._must("{")
        value = self._sum()
        self._must("}")
        return value

    def _atom(self) -> Number | None:
        if self._eat(r"\frac"):
            above = self._group()
            return above / self._group()
        if self._eat(r"\sqrt"):
            return mpmath.sqrt(self._group())
        if found := self._take(_MATRIX):
            rows = [[self.read(cell) for cell in row.split("&")] for row in found[2].split(r"\\")]
            matrix = np.array(rows, dtype=object)
            return self._determinant(matrix) if found[1] == "|" else matrix
        if self._eat(r"\left("):
            entries = [self._sum()]
            while self._eat(","):
                entries.append(self._sum())
            self._must(r"\right)")
            return entries[0] if len(entries) == 1 else np.array(entries, dtype=object)
        if found := self._take(_NUMBER):
            return mpmath.mpf(f"{found[1]}e{found[3] or 0}")
        if found := self._take(_OMEGA) or self._take(_NAME):
            value = self.values[found[0]]
            return abs(value) if self.rough else value
        return None

    def _determinant(self, matrix: np.ndarray) -> Number:
        if len(matrix) == 1:
            return matrix[0, 0]
        minors = (np.delete(matrix[1:], column, axis=1) for column in range(len(matrix)))
        terms = [entry * self._determinant(minor) for entry, minor in zip(matrix[0], minors, strict=True)]
        return sum(term if self.rough or place % 2 == 0 else -term for place, term in enumerate(terms))


def equations(display: str) -> list[str]:
    """Return the equations of one display, the lines of a broken one put together again."""
    inside = display.removeprefix(r"\begin{aligned}").removesuffix(r"\end{aligned}")
    found: list[str] = []
    for line in re.split(r"\\\\\[[\d.]+em\]", inside):
        for part in re.split(r"&\\qquad", line):
            text = part.strip()
            if text.startswith(r"&\quad"):
                found[-1] += " " + text.removeprefix(r"&\quad")
            else:
                found.append(text.removeprefix("&").replace("&=", "="))
    return [each.strip() for each in found]


def sides(equation: str) -> tuple[str, str, str]:
    """Return the left side, the right side, and the decimal after ≈ or "", without units."""
    left, right = _UNIT.sub("", equation).split(" = ")
    right, _, decimal = right.partition(r" \approx ")
    return left, right, decimal


def holds(equation: str, values: Mapping[str, Number]) -> bool:
    """Tell whether an equation is true for some values: to 40 digits, or to the digits of a decimal that is written."""
    left, right, decimal = sides(equation)
    reader, rough = Reader(values), Reader(values, rough=True)
    exact = reader.read(right)
    scale = abs(rough.read(left)) + abs(rough.read(right))
    tolerance = mpmath.mpf("1e-6" if r"\ldots" in equation else "1e-40")
    # What is exactly 0, such as the rate of a conserved momentum, has only its rounding as its scale.
    if not np.all(np.abs(reader.read(left) - exact) <= tolerance * scale + mpmath.mpf("1e-40")):
        return False
    return not decimal or bool(abs(reader.read(decimal) - exact) <= abs(exact) * mpmath.mpf("1e-7"))
