"""The parameters with sliders: names, units and ranges; and the parser of typed numbers."""

import math
import re
from dataclasses import dataclass, fields
from fractions import Fraction
from typing import Any, ClassVar

import streamlit as st

from ramanujan import Oscillator
from ramanujan.numerals import number, quantity
from ramanujan.shell.address import URLParameter, has_valid_value, strip_punctuation
from ramanujan.translation import _


@dataclass(frozen=True)
class Parameter(URLParameter):
    """A real number with a slider that Streamlit binds to the address.

    Parameters
    ----------
    name : key in the session state and in the address
    symbol, meaning, unit : parts of the label
    least, most, default, step, format : arguments of the slider, in this unit
    scale : the unit in SI units
    short : short form of the meaning, for the label of a box
    is_folded : whether the slider is in an expander
    """

    is_bound: ClassVar[bool] = True
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
    is_folded: bool = False

    def read(self, text: str) -> float:
        """Return the number, as Streamlit's sliders parse it. Raise `ValueError` for an invalid text."""
        value = float(text)
        if not (math.isfinite(value) and self.least <= value <= self.most):
            raise ValueError(self.name)
        return value

    def tidy(self, text: str) -> str:
        """Return a number as text for Streamlit's sliders, also for a text that only the box accepts, such as 9/8."""
        tidied = super().tidy(text)
        if self._fits(tidied):
            return tidied
        value = read_number(strip_punctuation(text))
        return tidied if value is None else repr(value)

    def message(self) -> str:
        """Return the error message for an invalid text."""
        sentence = _("The value of {name} in the address was ignored: it must be a number from {least} to {most}.")
        return sentence.format(name=self.name, least=number(self.least, strip=True), most=self.with_unit(self.most))

    @property
    def label(self) -> str:
        """Label of the slider for screen readers."""
        unit = f"\u00a0[{self.unit}]" if self.unit else ""
        return f"{self.meaning}, {self.symbol}{unit}"

    @property
    def value(self) -> float:
        """The value in this unit. Before the slider is drawn, it is the value in the address."""
        if self.name not in st.session_state and self.name in st.query_params and has_valid_value(self):
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

    def with_unit(self, value: float) -> str:
        """Return the text of a value with its unit."""
        return quantity(value, self.unit, 7, strip=True)

    def equation(self, value: float) -> str:
        """Return the text "symbol = value unit" for a value."""
        return f"{self.symbol}\u00a0=\u00a0{self.with_unit(value)}"

    def clamp(self, value: float) -> float:
        """Return the nearest value within the range."""
        return min(max(value, self.least), self.most)


_BLOCK, _ROLLER = _("mass of block, slab and top cylinder"), _("mass of each lower roller")
_COMPRESSION, _RADIUS = _("compression at release"), _("radius of the rollers")
PARAMETERS = {
    parameter.name: parameter
    for parameter in (
        # Name, symbol, meaning, unit, least, most, default, step, format, scale.
        Parameter("m", "m", _BLOCK, "kg", 0.5, 5.0, 1.0, 0.01, "%.2f", short=_("block, slab, top")),
        Parameter("m_prime", "m′", _ROLLER, "kg", 0.05, 10.0, 1.0, 0.01, "%.2f", short=_("each lower roller")),
        Parameter("k", "k", _("stiffness of the spring"), "N/m", 1.0, 200.0, 10.0, 0.5, "%.1f", short=_("stiffness")),
        Parameter("compression", "x₀", _COMPRESSION, "cm", 0.5, 12.0, 8.0, 0.1, "%.1f", 0.01, _("compression")),
        Parameter("radius", "R", _RADIUS, "cm", 5.0, 20.0, 10.0, 0.5, "%.1f", 0.01, _("roller radius"), is_folded=True),
    )
}
"""Name → parameter in the sidebar and in the address of every page, in the order of the sliders."""

GLIDE = Parameter("glide", "−Ẋ₀", _("Initial velocity of the machine"), "cm/s", -20.0, 20.0, 0.0, 0.5, "%.1f", 0.01)
SPIN = Parameter("spin", "Φ̇₀", _("Initial spin of the top cylinder"), "rad/s", -3.0, 3.0, 0.0, 0.1, "%.1f")
"""Parameters of a push at release, on the motion page and in tasks."""

MACHINE = tuple(field.name for field in fields(Oscillator) if field.name in PARAMETERS)
"""Names of the parameters of `Oscillator`."""

URL_PARAMETERS = tuple(PARAMETERS.values())
WATCH: dict[str, dict[str, Any]] = {
    name: {"parameter": name, "scale": PARAMETERS[name].scale, "step": PARAMETERS[name].step}
    for name in (*MACHINE, "compression")
}
"""Key of a slider → the parameter of the stage that the slider changes, in the format of `stage.mount(watch=…)`."""

SENTENCES = {
    "unreadable": _(
        "Type {symbol} as a number such as 1.25 or as a fraction such as 9/8. The old value, {old}, was kept."
    ),
    "outside": _("{symbol} must be between {least} and {most}. The old value, {old}, was kept."),
    "lighter": _("m was changed from {old} to {new}, because m′ can be at most {bound}."),
    "heavier": _("m was changed from {old} to {new}, because m′ must be at least {bound}."),
}
"""Messages at a slider: not a number, outside of the range, or m changed because of the mass ratio."""

LONGEST = 60
"""Largest length of a typed number."""
_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d{1,3})?(/\d+([.,]\d*)?)?", re.ASCII)


def read_number(text: str) -> float | None:
    """Parse a decimal number or a fraction, with a point or a comma as decimal mark; return None if invalid."""
    text = text.strip()
    if len(text) > LONGEST or not _NUMBER.fullmatch(text):
        return None
    numerator, _slash, denominator = text.replace(",", ".").partition("/")
    try:
        return float(Fraction(numerator) / Fraction(denominator or "1"))
    except (ZeroDivisionError, OverflowError):
        return None
