"""Reads LaTeX as the pages show it, and evaluates it with 60 digits: what a reader with pencil and paper would do.

It knows nothing of the package or of SymPy. A decimal that ends in dots is read as the number that is written.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache

import mpmath
import numpy as np

Number = mpmath.mpf | np.ndarray
"""A number of 60 digits, or a matrix of them."""

mpmath.mp.dps = 60

_LETTER = r"(?:\\mathcal\{[A-Z]\}|\\(?!frac|sqrt|left|right|begin|end|d?dot)[a-zA-Z]+|[a-zA-Z])"
_TOKEN = re.compile(
    r"(?P<space>(?:\\,|\\ |\\textstyle|\s)+)"
    r"|(?P<number>\d+(?:\.\d+)?)(?:\\ldots)?(?: \\times 10\^\{(?P<power>-?\d+)\})?"
    r"|(?P<mark>\\frac|\\sqrt|\\left|\\right|\\begin\{matrix\}|\\end\{matrix\}|\\\\|[-+^{}()\[\]|,&])"
    r"|(?P<name>\\Omega(?:_\{\\text\{clamped\}\})?\^\{2\}|M\^\{-1\}"
    rf"|(?:\\d?dot\{{{_LETTER}\}}|{_LETTER})'?(?:_\{{(?:\\text\{{\w+\}}|\\?[a-zA-Z0-9*]+)\}})?)"
)
_UNIT = re.compile(r"\\,\\mathrm\{(?:kg|s\^\{-2\})\}")


def tokens(text: str) -> Iterator[tuple[str, str]]:
    place = 0
    while place < len(text):
        found = _TOKEN.match(text, place)
        if found is None:
            raise ValueError(f"not understood: {text[place:]!r} in {text!r}")
        place = found.end()
        if found["number"]:
            yield "number", f"{found['number']}e{found['power'] or 0}"
        elif not found["space"]:
            yield ("mark", found["mark"]) if found["mark"] else ("name", found["name"])
    yield "end", ""


@lru_cache(maxsize=10_000)
def formula(text: str) -> Formula:
    """Return a formula that has been read; many machines share the sides that hold no number."""
    return Formula(text)


class Formula:
    """A formula as a tree; `value` evaluates it."""

    def __init__(self, text: str) -> None:
        self._tokens = list(tokens(text))
        self._place = 0
        self._tree = self._sum()
        if self._tokens[self._place][0] != "end":
            raise ValueError(f"not understood: {self._tokens[self._place :]} in {text!r}")

    def value(self, values: Mapping[str, Number], rough: bool = False) -> Number:
        """Return the value; a rough one leaves every sign out, so that it bounds the terms of all sums.

        Parameters
        ----------
        values : name as written in LaTeX → number, or matrix as an array of numbers
        """
        return _value(self._tree, values, rough)

    def _eat(self, *marks: str) -> bool:
        stretch = self._tokens[self._place : self._place + len(marks)]
        is_there = stretch == [("mark", mark) for mark in marks]
        self._place += len(marks) if is_there else 0
        return is_there

    def _must(self, *marks: str) -> None:
        if not self._eat(*marks):
            raise ValueError(f"{marks} expected at {self._tokens[self._place :]}")

    def _sum(self) -> tuple:
        terms = [("minus", self._product()) if self._eat("-") else self._product()]
        while True:
            if self._eat("+"):
                terms.append(self._product())
            elif self._eat("-"):
                terms.append(("minus", self._product()))
            else:
                return terms[0] if len(terms) == 1 else ("sum", *terms)

    def _product(self) -> tuple:
        factors = []
        while (factor := self._power()) is not None:
            factors.append(factor)
        if not factors:
            raise ValueError(f"a factor expected at {self._tokens[self._place :]}")
        return factors[0] if len(factors) == 1 else ("product", *factors)

    def _power(self) -> tuple | None:
        base = self._atom()
        if base is not None and self._eat("^", "{"):
            (_, exponent), self._place = self._tokens[self._place], self._place + 1
            self._must("}")
            return "power", base, int(exponent.removesuffix("e0"))
        return base

    def _group(self) -> tuple:
        self._must("{")
        inside = self._sum()
        self._must("}")
        return inside

    def _atom(self) -> tuple | None:
        kind, text = self._tokens[self._place]
        if kind in ("number", "name"):
            self._place += 1
            return (kind, mpmath.mpf(text)) if kind == "number" else (kind, text)
        if self._eat(r"\frac"):
            return "quotient", self._group(), self._group()
        if self._eat(r"\sqrt"):
            return "root", self._group()
        if self._eat(r"\left", "["):
            return self._matrix("]")
        if self._eat(r"\left", "|", "{"):
            return "determinant", self._matrix("}", "|")
        if self._eat(r"\left", "("):
            entries = [self._sum()]
            while self._eat(","):
                entries.append(self._sum())
            self._must(r"\right", ")")
            return entries[0] if len(entries) == 1 else ("tuple", *entries)
        return None

    def _matrix(self, *closing: str) -> tuple:
        self._must(r"\begin{matrix}")
        rows = [[self._sum()]]
        while not self._eat(r"\end{matrix}"):
            if self._eat("&"):
                rows[-1].append(self._sum())
            else:
                self._must(r"\\")
                rows.append([self._sum()])
        *braces, last = closing
        self._must(*braces, r"\right", last)
        return "array", *rows


def _value(tree: tuple, values: Mapping[str, Number], rough: bool) -> Number:
    kind, *parts = tree
    if kind == "number":
        return parts[0]
    if kind == "name":
        return abs(values[parts[0]]) if rough else values[parts[0]]
    if kind == "array":
        return np.array([[_value(entry, values, rough) for entry in row] for row in parts], dtype=object)
    if kind == "power":
        return _value(parts[0], values, rough) ** parts[1]
    first, *others = (_value(part, values, rough) for part in parts)
    if kind == "tuple":
        return np.array([first, *others], dtype=object)
    if kind == "minus":
        return first if rough else -first
    if kind == "quotient":
        return first / others[0]
    if kind == "root":
        return mpmath.sqrt(first)
    if kind == "determinant":
        return _determinant(first, rough)
    for other in others:
        if kind == "sum":
            first = first + other
        else:
            both = isinstance(first, np.ndarray) and isinstance(other, np.ndarray)
            first = first @ other if both else first * other
    return first


def _determinant(matrix: np.ndarray, rough: bool) -> Number:
    if len(matrix) == 1:
        return matrix[0, 0]
    minors = (np.delete(matrix[1:], column, axis=1) for column in range(len(matrix)))
    terms = [entry * _determinant(minor, rough) for entry, minor in zip(matrix[0], minors, strict=True)]
    return sum(term if rough or place % 2 == 0 else -term for place, term in enumerate(terms))


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
    """Return the left side, the right side, its decimal or "", all without units, and whether the decimal is exact."""
    left, right = _UNIT.sub("", equation).split(" = ", 1)
    right, sign, decimal = re.fullmatch(r"(.*?)(?: (=|\\approx) ([^=]*))?", right).groups(default="")
    return left, right, decimal, sign == "="


def holds(equation: str, values: Mapping[str, Number]) -> bool:
    """Tell whether an equation is true for some values: to 40 digits, or to the digits of a decimal that is written."""
    left, right, decimal, is_exact = sides(equation)
    left, right = formula(left), formula(right)
    exact = right.value(values)
    difference = np.abs(left.value(values) - exact)
    # What is exactly 0, such as the rate of a conserved momentum, has only its rounding as its scale.
    if not np.all(difference <= mpmath.mpf("1e-40")):
        scale = abs(left.value(values, rough=True)) + abs(right.value(values, rough=True))
        tolerance = mpmath.mpf("1e-6" if r"\ldots" in equation else "1e-40")
        if not np.all(difference <= tolerance * scale):
            return False
    tolerance = mpmath.mpf("1e-40" if is_exact else "1e-7")
    return not decimal or bool(abs(formula(decimal).value(values) - exact) <= abs(exact) * tolerance)
