"""The parameters that sliders set: name, symbol, words, unit, range and step; how a typed number is read."""

import math
import re
from dataclasses import dataclass, fields
from fractions import Fraction
from typing import Any, ClassVar

import streamlit as st

from ramanujan import Oscillator
from ramanujan.numerals import number, quantity, two_readings
from ramanujan.shell.address import URLParameter, bare, fits
from ramanujan.translation import _


@dataclass(frozen=True)
class Parameter(URLParameter):
    """A real number that a slider sets; Streamlit binds the slider to the address.

    Parameters
    ----------
    name : of the slider, in the session state and in the address
    symbol, meaning, unit : what the slider is called
    least, most, default, step, format : its range, in this unit
    scale : this unit in SI units
    short : the meaning in as few words as fit beside a box
    aside : whether its slider is among those that are folded away
    """

    bound: ClassVar[bool] = True
    name: str
    symbol: str
    meaning: str
    unit: str
    least: float
    most: float
    default: float
    step: float
    format: str
    scale: float = 1.0
    short: str = ""
    aside: bool = False

    def read(self, text: str) -> float:
        """Return the number, written as Streamlit's sliders read it; ValueError if it does not fit."""
        value = float(text)
        if not (math.isfinite(value) and self.least <= value <= self.most):
            raise ValueError(self.name)
        return value

    def tidied(self, text: str) -> str:
        """Return a number as Streamlit's sliders read it, also from a text that only the slider's box accepts: 9/8."""
        tidied, typed = super().tidied(text), bare(text)
        if self._fits(tidied) or two_readings(typed) or (number := read_number(typed)) is None:
            return tidied
        return repr(number)

    def message(self) -> str:
        """Return the sentence for a text that does not fit."""
        sentence = _("The value of {name} in the address was ignored: it must be a number from {least} to {most}.")
        return sentence.format(name=self.name, least=number(self.least, strip=True), most=self.written(self.most))

    @property
    def label(self) -> str:
        """The name of the slider for screen readers."""
        unit = f"\u00a0[{self.unit}]" if self.unit else ""
        return f"{self.meaning}, {self.symbol}{unit}"

    @property
    def value(self) -> float:
        """The value in this unit; before the slider is drawn, that of the address."""
        if self.name not in st.session_state and self.name in st.query_params and fits(self):
            return self.read(st.query_params[self.name])
        return st.session_state.get(self.name, self.default)

    @property
    def in_si(self) -> float:
        """The value in SI units."""
        return self.value * self.scale

    @property
    def limits(self) -> tuple[float, float]:
        """The range in SI units."""
        return self.least * self.scale, self.most * self.scale

    def written(self, value: float) -> str:
        """Return a value with its unit, for a sentence."""
        return quantity(value, self.unit, 7, strip=True)

    def equation(self, value: float) -> str:
        """Return that the parameter has this value, in one line, for a sentence."""
        return f"{self.symbol}\u00a0=\u00a0{self.written(value)}"

    def clamp(self, value: float) -> float:
        """Return the value of the range that is nearest."""
        return min(max(value, self.least), self.most)


_BLOCK, _ROLLER = _("mass of block, slab and top cylinder"), _("mass of each lower roller")
_SQUEEZED, _RADIUS = _("compression at release"), _("radius of the rollers")
PARAMETERS = {
    parameter.name: parameter
    for parameter in (
        Parameter("m", "m", _BLOCK, "kg", 0.5, 5.0, 1.0, 0.01, "%.2f", short=_("block, slab, top")),
        Parameter("m_prime", "m′", _ROLLER, "kg", 0.05, 10.0, 1.0, 0.01, "%.2f", short=_("each lower roller")),
        Parameter("k", "k", _("stiffness of the spring"), "N/m", 1.0, 200.0, 10.0, 0.5, "%.1f", short=_("stiffness")),
        Parameter("compression", "x₀", _SQUEEZED, "cm", 0.5, 12.0, 8.0, 0.1, "%.1f", 0.01, _("compression")),
        Parameter("radius", "R", _RADIUS, "cm", 5.0, 20.0, 10.0, 0.5, "%.1f", 0.01, _("roller radius"), aside=True),
    )
}
"""What every page has in its sidebar and keeps in its address, in the order of the sliders."""
GLIDE = Parameter("glide", "−Ẋ₀", _("Initial velocity of the machine"), "cm/s", -20.0, 20.0, 0.0, 0.5, "%.1f", 0.01)
SPIN = Parameter("spin", "Φ̇₀", _("Initial spin of the top cylinder"), "rad/s", -3.0, 3.0, 0.0, 0.1, "%.1f")
"""What a person may give the machine at release: on page 3, and in tasks."""
MACHINE = tuple(field.name for field in fields(Oscillator) if field.name in PARAMETERS)
"""The parameters that make an `Oscillator`."""
URL_PARAMETERS = tuple(PARAMETERS.values())
WATCH: dict[str, dict[str, Any]] = {
    name: {"parameter": name, "scale": PARAMETERS[name].scale, "step": PARAMETERS[name].step}
    for name in (*MACHINE, "compression")
}
"""The contract of the stage: which slider moves which parameter."""

SENTENCES = {
    "unreadable": _(
        "Type {symbol} as a number such as 1.25 or as a fraction such as 9/8. The old value, {old}, was kept."
    ),
    "outside": _("{symbol} must be between {least} and {most}. The old value, {old}, was kept."),
    "ambiguous": _("{text} can mean {decimal} or {whole}. Type one of these two. The old value, {old}, was kept."),
    "lighter": _("m was changed from {old} to {new}, because m′ can be at most {bound}."),
    "heavier": _("m was changed from {old} to {new}, because m′ must be at least {bound}."),
}
"""Sentences at a slider: an entry that is no number, outside of the range, ambiguous; m changed for a mass ratio."""

LONGEST = 60
"""Characters of a number that are read."""
_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d{1,3})?(/\d+([.,]\d*)?)?", re.ASCII)


def read_number(text: str) -> float | None:
    """Return the value of a decimal or a fraction in a short text, or None; the decimal mark is a point or a comma."""
    text = text.strip()
    if len(text) > LONGEST or not _NUMBER.fullmatch(text):
        return None
    numerator, _slash, denominator = text.replace(",", ".").partition("/")
    try:
        return float(Fraction(numerator) / Fraction(denominator or "1"))
    except (ZeroDivisionError, OverflowError):
        return None
