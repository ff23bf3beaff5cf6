"""The parameters with sliders: names, units and ranges, and the messages at a slider."""

from dataclasses import dataclass, fields
from typing import Any, ClassVar

import streamlit as st

from ramanujan import UNIT_MASS_RATIO, Oscillator
from ramanujan.shell.address import URLParameter, read_value
from ramanujan.text.numerals import number, quantity
from ramanujan.text.reading import read_number, two_readings
from ramanujan.text.translation import _

_DECIMAL_MARK = "."
"""The decimal mark of the app's links, in every language."""


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
    shown_ratio : the slider shows values up to this multiple of m, and all values while its own value is larger
    snap_ratios : multiples of m to which the slider snaps
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
    shown_ratio: float | None = None
    snap_ratios: tuple[float, ...] = ()

    def read(self, text: str) -> float:
        """Return the number in a text that a box or a slider accepts. Raise `ValueError` for an invalid text."""
        value = read_number(text, _DECIMAL_MARK)
        if value is None:
            # Streamlit reads every text of Python's `float` from the address, such as 1_0.
            value = float(text)
        if not self.least <= value <= self.most:
            raise ValueError(self.name)
        return value

    def message(self, text: str = "") -> str:
        """Return the error message for an invalid text."""
        readings = two_readings(text, _DECIMAL_MARK)
        if readings:
            return SENTENCES["ambiguous_link"].format(name=self.name, **readings)
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
        if self.name in st.session_state:
            return st.session_state[self.name]
        value = read_value(self)
        return self.default if value is None else value

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


# A name for screen readers begins with the short form, which is seen: voice control finds a slider by these words.
_BLOCK, _ROLLER = _("block, slab, top cylinder: mass"), _("each lower roller: mass")
_COMPRESSION, _RADIUS = _("compression at release"), _("roller radius")
PARAMETERS = {
    parameter.name: parameter
    for parameter in (
        # Name, symbol, meaning, unit, least, most, default, step, format, scale.
        Parameter("m", "m", _BLOCK, "kg", 0.5, 5.0, 1.0, 0.01, "%.2f", short=_("block, slab, top")),
        Parameter(
            "m_prime",
            "m′",
            _ROLLER,
            "kg",
            0.05,
            10.0,
            1.0,
            0.01,
            "%.2f",
            short=_("each lower roller"),
            shown_ratio=2.2,
            snap_ratios=(1.0, UNIT_MASS_RATIO),
        ),
        Parameter("k", "k", _("stiffness of the spring"), "N/m", 1.0, 200.0, 10.0, 0.5, "%.1f", short=_("stiffness")),
        Parameter("compression", "x₀", _COMPRESSION, "cm", 0.5, 12.0, 8.0, 0.1, "%.1f", 0.01, _("compression")),
        Parameter("radius", "R", _RADIUS, "cm", 5.0, 20.0, 10.0, 0.5, "%.1f", 0.01, _RADIUS, is_folded=True),
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
    "ambiguous": _(
        "{text} can mean {decimal} or {whole}. Type one of these two for {symbol}. The old value, {old}, was kept."
    ),
    "ambiguous_link": _("The value of {name} in the address was ignored: {text} can mean {decimal} or {whole}."),
    "outside": _("{symbol} must be between {least} and {most}. The old value, {old}, was kept."),
    "lighter": _("m was changed from {old} to {new}, because m′ can be at most {bound}."),
    "heavier": _("m was changed from {old} to {new}, because m′ must be at least {bound}."),
}
"""Messages at a slider: not a number, two readings (box, link), outside of the range, m changed with the ratio."""
