"""The sidebar: sliders, exact entries, presets, link; what a person has set, as an `Oscillator`.

Each quantity is one slider, bound to the URL; the slider is the only holder of its value. The box above it shows that
value in full, and what is typed into it comes as one message: the box holds nothing itself. What cannot be used, from
wherever it comes, is answered with one sentence, and the last good value stays.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

import streamlit as st

from ramanujan import UNIT_MASS_RATIO, Oscillator, page
from ramanujan.scenes import given, links, view
from ramanujan.words import _


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

    def written(self, value: float) -> str:
        """Return a value with its unit, for a sentence."""
        return f"{value:.7g} {self.unit}".rstrip()

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
STAGES = ("oscillator", "motion", "stage_bodies")
"""Names of the stages whose slab can be dragged: while it is held, the box of x₀ follows it."""

_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d{1,3})?(/\d+([.,]\d*)?)?", re.ASCII)
_LONGEST = 60
_PRESET = "preset"
_TYPED = "typed"
"""Session state: key of a control → the text typed into its box, until the run that follows has judged it."""
_NOTES = "notes"
"""Session state: key of a control → what is to be said at its box, and whether it is a complaint."""
_JUDGED = "judged"
_TOO_HEAVY = "m was changed from {old} to {new}, because m′ can be at most {bound}."
_TOO_LIGHT = "m was changed from {old} to {new}, because m′ must be at least {bound}."
_OUT_OF_REACH = "The mass ratio is now {ratio:.3g}, the nearest that can be had."
_SAID = "said"
_RUN_AGAIN = "run_again"
_LINKED = "linked"
"""Session state: key of a control → its value when the session began."""


def sidebar() -> None:
    """Draw the sidebar. Called once a run, before the page."""
    given.hold()
    for key, text in st.session_state.pop(_TYPED, {}).items():
        _take_exact(CONTROLS[key], text)
    # A page that runs itself again has not been answered yet: what was said stays.
    again = st.session_state.pop(_RUN_AGAIN, False)
    said, notes = st.session_state.get(_SAID, ([], {})) if again else ([], {})
    notes = notes | st.session_state.pop(_NOTES, {})
    # What is wrong with the link is said on the page itself: on a phone the sidebar is closed at first.
    complaints = [
        *said,
        *links.complaints(control.in_links for control in CONTROLS.values()),
        *links.unknown(CONTROLS),
        *view.complaints(),
    ]
    if complaints:
        st.warning(" ".join(complaints))
    with st.sidebar:
        page.sheet()
        st.pills("Presets", list(PRESETS), key=_PRESET, on_change=_take_preset, label_visibility="collapsed")
        keys = ("m", "m_prime", "k", "compression")
        values = {key: _slider(CONTROLS[key], notes.get(key)) for key in keys}
        with st.expander("More"):
            st.caption("The radius sets the size of the machine. Watch: it changes no frequency.")
            values["radius"] = _slider(CONTROLS["radius"], notes.get("radius"))
        judged = st.session_state.get(_JUDGED, 0)
        boxes = {
            f"exact/{key}": {"value": value, "text": repr(value), "judged": judged} for key, value in values.items()
        }
        page.feed("boxes_feed", boxes)
        page.link()
        view.switch()
        given.receipt()
    st.session_state[_SAID] = (complaints, notes)
    # What the sliders show in the first run is what the link has set, without what it got wrong.
    st.session_state.setdefault(_LINKED, {control.key: st.session_state[control.key] for control in CONTROLS.values()})


def complain(sentences: list[str]) -> None:
    """Say on the page what of its link it cannot use."""
    if sentences:
        st.warning(" ".join(sentences))
        complaints, notes = st.session_state[_SAID]
        st.session_state[_SAID] = ([*complaints, *sentences], notes)


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
    given.hold()
    control = CONTROLS["compression"]
    # Ten digits are finer than any pointer, and keep 7.9 cm from turning into 7.900000000000001 cm.
    given.give("compression", _clamp(control, round(metres / control.scale, 10)))


def enter(key: str, text: str) -> None:
    """Take what was typed into the box of a control; the next run judges it."""
    st.session_state[_TYPED] = {**st.session_state.get(_TYPED, {}), key: text}


def take_ratio(ratio: float, digits: int = 17) -> None:
    """Set m′ = εm; where m′ would leave its range, m gives way, and the page says so.

    Parameters
    ----------
    ratio : ε = m′/m
    digits : significant digits of m′ that are wanted, where round values matter more than the exact ratio
    """
    given.hold()
    rollers, others = CONTROLS["m_prime"], CONTROLS["m"]
    m = st.session_state.get("m", others.default)
    m_prime = _times(ratio, m, digits)
    if rollers.least <= m_prime <= rollers.most:
        given.give("m_prime", m_prime)
        return
    bound = _clamp(rollers, m_prime)
    # The m nearest to the old one, on the slider's steps, with which the ratio can be had.
    steps = round(bound / ratio / others.step, 6)
    nearest = (math.floor if m_prime > bound else math.ceil)(steps) * others.step
    new_m = _clamp(others, round(nearest, 10))
    given.give("m", new_m)
    given.give("m_prime", _clamp(rollers, _times(ratio, new_m, digits)))
    sentences = [] if new_m == m else [_TOO_HEAVY if m_prime > bound else _TOO_LIGHT]
    if not math.isclose(new_m, nearest):
        sentences.append(_OUT_OF_REACH)
    words = {"old": m, "new": new_m, "bound": bound}
    written = {name: others.written(value) for name, value in words.items()}
    _note("m", " ".join(sentences).format(**written, ratio=bound / new_m))


def take_machine(machine: Oscillator, metres: float) -> None:
    """Set all sliders to a machine and its x₀ [m]. Call it in a callback, before the sliders are drawn."""
    given.hold()
    for key, value in _on_sliders(machine, metres).items():
        given.give(key, value)


def ask_for_machine(machine: Oscillator, metres: float) -> None:
    """Set all sliders to a machine and its x₀ [m] in the run that follows."""
    for key, value in _on_sliders(machine, metres).items():
        enter(key, repr(value))


def holds(machine: Oscillator, metres: float) -> bool:
    """Tell whether the sliders hold this machine and this x₀ [m]."""
    held = {key: st.session_state.get(key, CONTROLS[key].default) for key in CONTROLS}
    return all(math.isclose(held[key], value) for key, value in _on_sliders(machine, metres).items())


def _on_sliders(machine: Oscillator, metres: float) -> dict[str, float]:
    """Return what each slider says of a machine, in its own unit."""
    values = {"m": machine.m, "m_prime": machine.m_prime, "k": machine.k, "radius": machine.radius}
    # Ten digits keep 8 cm from turning into 8.000000000000002 cm; what is in SI units keeps all of its digits.
    return {
        key: value if CONTROLS[key].scale == 1 else round(value / CONTROLS[key].scale, 10)
        for key, value in {**values, "compression": metres}.items()
    }


def reset() -> None:
    """Put every quantity back to what the link has set, or from there to its default; say so where the two differ."""
    given.hold()
    defaults = {control.key: control.default for control in CONTROLS.values()}
    linked = st.session_state.get(_LINKED, defaults)
    there = all(st.session_state[key] == value for key, value in linked.items())
    for key, value in (defaults if there else linked).items():
        given.give(key, value)
    if linked == defaults:
        return
    if there:
        _note("m", _("All values are the app’s own now. Reset again, and the values of your link return."))
    else:
        _note("m", _("All values are those of your link again. Reset once more for the app’s own values."))


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


def _slider(control: Control, note: tuple[str, bool] | None) -> float:
    """Draw a slider with its box, and return its value."""
    label = f"{control.symbol}, {control.meaning} [{control.unit}]"
    # The box stands above its slider but is made after it, so that it shows what the slider holds.
    head = st.container(key=f"head_{control.key}")
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
    with head:
        page.exact(
            f"{control.key}_exact",
            {
                "key": control.key,
                "symbol": control.symbol,
                "unit": control.unit,
                "meaning": control.meaning,
                "label": f"{label}, exactly",
                "longest": _LONGEST,
                "scale": control.scale,
                "stages": STAGES if control.key == "compression" else (),
            },
            partial(enter, control.key),
        )
        if note:
            sentence, complaint = note
            (st.warning if complaint else st.info)(sentence)
    return value


def _take_exact(control: Control, text: str) -> None:
    """Take what was typed, or say what would do and that the old value stays."""
    # The box shows its value again whether it has changed or not, so that it must hear of every text that was judged.
    st.session_state[_JUDGED] = st.session_state.get(_JUDGED, 0) + 1
    number = read_number(text)
    old = f"The old value, {control.written(st.session_state.get(control.key, control.default))}, was kept."
    if number is None:
        _note(control.key, f"Type {control.symbol} as a number such as 1.25 or as a fraction such as 9/8. {old}", True)
    elif not control.least <= number <= control.most:
        least, most = f"{control.least:g}", control.written(control.most)
        _note(control.key, f"{control.symbol} must be between {least} and {most}. {old}", True)
    else:
        given.give(control.key, number)


def _note(key: str, sentence: str, complaint: bool = False) -> None:
    """Say a sentence at the box of a control in the run that follows."""
    st.session_state[_NOTES] = {**st.session_state.get(_NOTES, {}), key: (sentence, complaint)}


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


def _times(ratio: float, m: float, digits: int) -> float:
    """Return εm to so many digits; a short ratio gives a product without the noise of binary fractions."""
    short = ratio == float(f"{ratio:.6g}")
    return float(f"{ratio * m:.{min(digits, 12) if short else digits}g}")


def _clamp(control: Control, value: float) -> float:
    return min(max(value, control.least), control.most)
