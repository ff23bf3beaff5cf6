"""The quantities that a person sets: key, words, unit, range and scale of each, and how a typed number is read."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import streamlit as st

from ramanujan.shell import address
from ramanujan.translation import _


@dataclass(frozen=True)
class Quantity:
    """A quantity that a slider sets.

    Parameters
    ----------
    key : of the slider, in the session state and in the address
    symbol, meaning, unit : what the slider is called
    short : the meaning in as few words as fit beside a box
    least, most, default, step, format : its range, in this unit
    parameter : what the stage calls it; empty where the stage does not follow the slider
    scale : this unit in SI units
    """

    key: str
    symbol: str
    meaning: str
    unit: str
    least: float
    most: float
    default: float
    step: float
    format: str
    parameter: str = ""
    scale: float = 1.0
    short: str = ""

    @property
    def label(self) -> str:
        """The name of the slider, for those who do not see what stands above it."""
        if not self.unit:
            return _("{meaning}, {symbol}").format(meaning=self.meaning, symbol=self.symbol)
        return _("{meaning}, {symbol} [{unit}]").format(meaning=self.meaning, symbol=self.symbol, unit=self.unit)

    @property
    def in_links(self) -> address.Measure:
        """The key of the address."""
        return address.Measure(self.key, self.least, self.most, self.unit)

    @property
    def present(self) -> float:
        """The present value, in this unit."""
        return st.session_state.get(self.key, self.default)

    @property
    def in_si(self) -> float:
        """The present value in SI units."""
        return self.present * self.scale

    @property
    def limits(self) -> tuple[float, float]:
        """The range in SI units."""
        return self.least * self.scale, self.most * self.scale

    def written(self, value: float) -> str:
        """Return a value with its unit, for a sentence."""
        return f"{value:.7g}\u202f{self.unit}".rstrip()

    def clamp(self, value: float) -> float:
        """Return the value of the range that is nearest."""
        return min(max(value, self.least), self.most)


def _masses(key: str, symbol: str, least: float, most: float, meaning: str, short: str) -> Quantity:
    return Quantity(key, symbol, meaning, "kg", least, most, 1.0, 0.01, "%.2f", key, short=short)


def _length(key: str, symbol: str, least: float, most: float, default: float, step: float, **words: str) -> Quantity:
    return Quantity(key, symbol, words["meaning"], "cm", least, most, default, step, "%.1f", key, 0.01, words["short"])


QUANTITIES = {
    quantity.key: quantity
    for quantity in (
        _masses("m", "m", 0.5, 5.0, _("mass of block, slab and top cylinder"), _("block, slab, top")),
        _masses("m_prime", "m′", 0.05, 10.0, _("mass of each lower roller"), _("each lower roller")),
        Quantity(
            "k", "k", _("stiffness of the spring"), "N/m", 1.0, 200.0, 10.0, 0.5, "%.1f", "k", short=_("stiffness")
        ),
        _length("compression", "x₀", 0.5, 12.0, 8.0, 0.1, meaning=_("compression at release"), short=_("compression")),
        _length("radius", "R", 5.0, 20.0, 10.0, 0.5, meaning=_("radius of the rollers"), short=_("roller radius")),
    )
}
KEYS = tuple(quantity.in_links for quantity in QUANTITIES.values())
"""What every page keeps in its address."""
WATCH: dict[str, dict[str, Any]] = {
    quantity.key: {"parameter": quantity.parameter, "scale": quantity.scale, "step": quantity.step}
    for quantity in QUANTITIES.values()
}
"""For the stage: which slider moves which parameter."""

LONGEST = 60
"""Characters of a number that are read."""
_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d{1,3})?(/\d+([.,]\d*)?)?", re.ASCII)


def read_number(text: str) -> float | None:
    """Return the number that a short text writes as a decimal or a fraction, or None."""
    text = text.strip()
    if len(text) > LONGEST or not _NUMBER.fullmatch(text):
        return None
    numerator, _slash, denominator = text.replace(",", ".").partition("/")
    try:
        return float(Fraction(numerator) / Fraction(denominator or "1"))
    except (ZeroDivisionError, OverflowError):
        return None
