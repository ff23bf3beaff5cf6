"""The sidebar: sliders, exact entries, presets, link; what a person has set, as an `Oscillator`.

Each quantity is one slider, bound to the URL; the slider is the only holder of its value. The box beside it shows that
value in full and takes any number or fraction. What is no good, from wherever it comes, is answered with one sentence,
and the last good value stays.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

import streamlit as st

from ramanujan import UNIT_MASS_RATIO, Oscillator, page
from ramanujan.scenes import links


@dataclass(frozen=True)
class Control:
    """A quantity that a person sets: its key (also in the URL), words, unit, range, and scale to SI units."""

    key: str
    symbol: str
    meaning: str
    unit: str
    least: float
    most: float
    default: float
    step: float
    format: str
    parameter: str
    scale: float = 1.0

    @property
    def range(self) -> str:
        """The range in words."""
        return f"from {self.least:g} to {self.most:g} {self.unit}".rstrip()

    @property
    def in_links(self) -> links.Key:
        """What a link may say of it."""
        return links.number(self.key, self.least, self.most, self.range)


CONTROLS = {
    control.key: control
    for control in (
        Control("m", "m", "block, slab, top", "kg", 0.5, 5.0, 1.0, 0.01, "%.2f", "m"),
        Control("m_prime", "m′", "each lower roller", "kg", 0.05, 10.0, 1.0, 0.01, "%.2f", "m_prime"),
        Control("k", "k", "stiffness", "N/m", 1.0, 200.0, 10.0, 0.5, "%.1f", "k"),
        Control("compression", "x₀", "compression", "cm", 0.5, 12.0, 8.0, 0.1, "%.1f", "compression", 0.01),
        Control("radius", "R", "roller radius", "cm", 5.0, 20.0, 10.0, 0.5, "%.1f", "radius", 0.01),
    )
}
WATCH = {control.key: {"parameter": control.parameter, "scale": control.scale} for control in CONTROLS.values()}
"""For the stage: which slider moves which parameter."""

_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d{1,3})?(/\d+([.,]\d*)?)?", re.ASCII)
_LONGEST = 60
_PRESET = "preset"
_COMPLAINT = "complaint"
_SAID = "said"
_RUN_AGAIN = "run_again"


def sidebar() -> None:
    """Draw the sidebar. Called once a run, before the page."""
    nothing: tuple[list[str], str | None] = ([], None)
    # A page that runs itself again has not been answered yet: what was said stays.
    again = st.session_state.pop(_RUN_AGAIN, False)
    said, said_in_sidebar = st.session_state.get(_SAID, nothing) if again else nothing
    # What is wrong with the link is said on the page itself: on a phone the sidebar is closed at first.
    complaints = [*said, *links.complaints(control.in_links for control in CONTROLS.values()), *links.unknown(CONTROLS)]
    if complaints:
        st.warning(" ".join(complaints))
    with st.sidebar:
        st.pills("Presets", list(PRESETS), key=_PRESET, on_change=_take_preset, label_visibility="collapsed")
        for key in ("m", "m_prime", "k", "compression"):
            _slider(CONTROLS[key])
        with st.expander("More"):
            st.caption("The radius sets the size of the machine. Watch: it changes no frequency.")
            _slider(CONTROLS["radius"])
        page.link()
        complaint = st.session_state.pop(_COMPLAINT, None) or said_in_sidebar
        if complaint:
            st.warning(complaint)
    st.session_state[_SAID] = (complaints, complaint)


def complain(sentences: list[str]) -> None:
    """Say on the page what of its link it cannot use."""
    if sentences:
        st.warning(" ".join(sentences))
        complaints, complaint = st.session_state[_SAID]
        st.session_state[_SAID] = ([*complaints, *sentences], complaint)


def run_again() -> None:
    """Run the page again by itself, to show what has come in; what has been said to the person stays."""
    st.session_state[_RUN_AGAIN] = True
    st.rerun()


def oscillator() -> Oscillator:
    """Return the machine that the sliders describe."""
    return Oscillator(**{name: _value(name) for name in ("m", "m_prime", "k", "radius")})


def compression() -> float:
    """Return x₀ [m]."""
    return _value("compression")


def limits(key: str) -> tuple[float, float]:
    """Return the range of a quantity in SI units."""
    control = CONTROLS[key]
    return control.least * control.scale, control.most * control.scale


def set_compression(metres: float) -> None:
    """Set x₀ [m] from the slab that was dragged."""
    control = CONTROLS["compression"]
    # Ten digits are finer than any pointer, and keep 7.9 cm from turning into 7.900000000000001 cm.
    st.session_state["compression"] = _clamp(control, round(metres / control.scale, 10))


def take_ratio(ratio: float) -> None:
    """Set m′ = εm; where m′ would leave its range, m gives way instead."""
    rollers, others = CONTROLS["m_prime"], CONTROLS["m"]
    m = st.session_state.get("m", others.default)
    m_prime = _clamp(rollers, ratio * m)
    st.session_state["m_prime"] = m_prime
    st.session_state["m"] = m if m_prime == ratio * m else _clamp(others, m_prime / ratio)


def reset() -> None:
    """Put every quantity back to its default."""
    for control in CONTROLS.values():
        st.session_state[control.key] = control.default


PRESETS: dict[str, Callable[[], None]] = {
    "Equal masses": lambda: take_ratio(1.0),
    "Unit frequency (1729)": lambda: take_ratio(UNIT_MASS_RATIO),
    "Light rollers": lambda: take_ratio(0.1),
    "Heavy rollers": lambda: take_ratio(5.0),
    "Reset": reset,
}


def _take_preset() -> None:
    """Do what was asked for, and leave no choice standing: the next slider would belie it."""
    if preset := st.session_state[_PRESET]:
        PRESETS[preset]()
    st.session_state[_PRESET] = None


def _slider(control: Control) -> None:
    label = f"{control.symbol}, {control.meaning} [{control.unit}]"
    heading = st.container(horizontal=True, vertical_alignment="center")
    heading.markdown(f"**{control.symbol}** [{control.unit}]  \n:small[{control.meaning}]", width=118)
    value = st.slider(
        label,
        control.least,
        control.most,
        control.default,
        control.step,
        format=control.format,
        key=control.key,
        bind="query-params",
        label_visibility="collapsed",
    )
    # The box stands above its slider but is made after it, so that it shows what the slider holds.
    st.session_state[_exact(control)] = repr(value)
    heading.text_input(
        f"{label}, exactly",
        key=_exact(control),
        label_visibility="collapsed",
        max_chars=_LONGEST,
        on_change=_take_exact,
        args=(control,),
    )


def _take_exact(control: Control) -> None:
    """Take what was typed, or say in one sentence what would do."""
    text = st.session_state[_exact(control)]
    number = read_number(text)
    if number is None:
        st.session_state[_COMPLAINT] = (
            f"{control.symbol} takes a number such as 1.25 or a fraction such as 9/8; it stays as it was."
        )
    elif not control.least <= number <= control.most:
        st.session_state[_COMPLAINT] = f"{control.symbol} goes {control.range}; it stays as it was."
    else:
        st.session_state[control.key] = number


def read_number(text: str) -> float | None:
    """Return the number that a short text writes as a decimal or a fraction, or None."""
    text = text.strip()
    if len(text) > _LONGEST or not _NUMBER.fullmatch(text):
        return None
    numerator, _, denominator = text.replace(",", ".").partition("/")
    try:
        return float(Fraction(numerator) / Fraction(denominator or "1"))
    except (ZeroDivisionError, OverflowError):
        return None


def page_slider(control: Control) -> float:
    """Draw a slider that only the present page has, bound to the URL, and return its value in SI units."""
    value = st.slider(
        f"{control.meaning}, {control.symbol}" + (f" [{control.unit}]" if control.unit else ""),
        control.least,
        control.most,
        control.default,
        control.step,
        format=control.format,
        key=control.key,
        bind="query-params",
    )
    return (value if control.least <= value <= control.most else control.default) * control.scale


def _value(key: str) -> float:
    control = CONTROLS[key]
    return st.session_state.get(key, control.default) * control.scale


def _exact(control: Control) -> str:
    return f"{control.key}_exact"


def _clamp(control: Control, value: float) -> float:
    return min(max(value, control.least), control.most)
