"""Parse the LaTeX of the pages, and evaluate it with 100 digits.

The parser uses neither the package nor SymPy. It replaces each LaTeX command by the equivalent Python operator. It
ignores the dots at the end of a decimal.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache

import mpmath
import numpy as np

Number = mpmath.mpf | np.ndarray
"""A number of 100 digits, or a matrix of them."""

mpmath.mp.dps = 100

_LETTER = r"(?:\\mathcal\{[A-Z]\}|\\(?!frac|sqrt|left|right|begin|end|cdot|d?dot|underline)[a-zA-Z]+|[a-zA-Z])"
_PYTHON = {
    r"\left[\begin{matrix}": "matrix([[",
    r"\end{matrix}\right] \left[\begin{matrix}": "]])@matrix([[",
    r" \left[\begin{matrix}": "*matrix([[",
    r"\end{matrix}\right]": "]])",
    r"\left|{\begin{matrix}": "det([[",
    r"\end{matrix}}\right|": "]])",
    r"\underline{": "(",
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
_SIDE_BY_SIDE = re.compile(r"\d(?:\\,| )+\d")
"""Two adjacent numbers, which look like one."""
MARGIN = re.compile(
    r"(?: &&| \\\\\[\.15em\] &| \\\\\n  &)?\\quad\\footnotesize\\vert\\ .*?(?= \\\\|\\end\{aligned|\n|$)"
)
"""The operation in the margin of an equation."""
_UNIT = re.compile(r"\\,\\mathrm\{(?:kg|s\^\{-2\})\}")


@lru_cache(maxsize=10_000)
def formula(text: str) -> Formula:
    """Return a parsed formula. The cache helps because many machines share sides without numbers."""
    return Formula(text)


class Formula:
    """A formula as Python; `names` are its symbols as written in LaTeX, `value` evaluates it."""

    def __init__(self, text: str) -> None:
        if _SIDE_BY_SIDE.search(text):
            raise ValueError(f"numbers side by side: {text!r}")
        place, python, self._numbers, self._cut_off, self.names = 0, "", [], {}, []
        while place < len(text):
            match = _TOKEN.match(text, place)
            if match is None:
                raise ValueError(f"not understood: {text[place:]!r} in {text!r}")
            place = match.end()
            if match["number"]:
                python += f"numbers[{len(self._numbers)}]"
                if r"\ldots" in match[0]:
                    self._cut_off[len(self._numbers)] = last_place(match[0])
                self._numbers.append(mpmath.mpf(f"{match['number']}e{match['power'] or 0}"))
            elif match["name"]:
                python += f"names[{len(self.names)}]"
                self.names.append(match["name"])
            else:
                python += _PYTHON[match["mark"]]
        self._python = compile(python, text, "eval")

    def cut_off(self, values: Mapping[str, Number]) -> Number:
        """Return the largest error of the value due to truncated decimals."""
        numbers, plain, total = list(self._numbers), self.value(values), 0
        for place, unit in self._cut_off.items():
            self._numbers = [*numbers[:place], numbers[place] + unit, *numbers[place + 1 :]]
            total += abs(self.value(values) - plain)
        self._numbers = numbers
        return total

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
        value = eval(self._python, known)
        return np.array(value, dtype=object) if isinstance(value, tuple) else value


def last_place(decimal: str) -> mpmath.mpf:
    """Return the unit in the last place of a decimal."""
    digits, _, power = decimal.replace(r"\ldots", "").partition(r" \times 10^{")
    return mpmath.mpf(10) ** (int(power.rstrip("}") or 0) - len(digits.partition(".")[2]))


def equations(display: str, newline: str = "") -> list[str]:
    """Return the equations of one display, with the lines of a broken equation joined."""
    inside = MARGIN.sub("", display).removeprefix(r"\begin{aligned}").removesuffix(r"\end{aligned}")
    joined: list[str] = []
    for line in inside.split(newline) if newline else re.split(r"\\\\\[[\d.]+em\]", inside):
        text = line.strip()
        if text.startswith(r"&\quad"):
            joined[-1] += " " + text.removeprefix(r"&\quad").strip()
        else:
            joined.append(text.removeprefix("&").replace("&=", "="))
    return [each.strip() for each in joined]


def sides(equation: str) -> tuple[str, str, str, bool]:
    """Return left side, right side, its decimal or "", without units and label, and whether the decimal is exact."""
    left, right = _UNIT.sub("", equation).rpartition(r":\ ")[2].split(" = ", 1)
    right, sign, decimal = re.fullmatch(r"(.*?)(?: (=|\\approx) ([^=]*))?", right).groups(default="")
    return left, right, decimal, sign == "="
