"""The sidebar: sliders, exact entries, presets, link; what a person has set, as an `Oscillator`.

Each quantity is one slider, bound to the address, and the slider is the only holder of its value. The box above it
shows that value in full, and what is typed into it comes as one message: the box holds nothing itself. What cannot be
used, from wherever it comes, is answered with one sentence, and the last good value stays.
"""

from __future__ import annotations

import math
from collections.abc import Collection

import streamlit as st

from ramanujan import UNIT_MASS_RATIO, Oscillator
from ramanujan.browser import page
from ramanujan.shell import address, cache, display_mode, messages, pending_updates, widgets
from ramanujan.shell.parameters import QUANTITIES, Quantity, read_number
from ramanujan.translation import _

_STAGES = ("oscillator", "motion", "stage_bodies")
"""Names of the stages whose slab can be dragged: while it is held, the box of x₀ follows it."""
BOXES = {key: widgets.box(each, _STAGES if key == "compression" else ()) for key, each in QUANTITIES.items()}
"""What the page must know of the sliders' boxes."""

PRESETS = {
    "equal": _("Equal masses"),
    "unit": _("Unit frequency (1729)"),
    "light": _("Light rollers"),
    "heavy": _("Heavy rollers"),
    "reset": _("Reset"),
}
_RATIOS = {"equal": 1.0, "unit": UNIT_MASS_RATIO, "light": 0.1, "heavy": 5.0}
_PRESET = "preset"
_TYPED = "typed"
"""Session state: key of a quantity → the text typed into its box, until the run that follows has judged it."""
_JUDGED = "judged"
_FIRST = "first_run"
_FOLLOW = "follow"
"""Session state: the keys of the fragments that follow the machine, if the page was drawn to its end."""
_MOVED = "moved"
"""Session state: key of a quantity → the value of its slider, until what follows it is drawn."""
_LINKED = "linked"
"""Session state: key of a quantity → its value when the session began."""


def draw(withheld: Collection[str] = ()) -> None:
    """Draw the sidebar. Called once a run, before the page.

    Parameters
    ----------
    withheld : presets that are not offered, because they would tell what the page asks
    """
    with st.sidebar:
        page.sheet()
        if offered := [name for name in PRESETS if name not in withheld]:
            st.pills(
                _("Presets"),
                offered,
                format_func=PRESETS.__getitem__,
                key=_PRESET,
                on_change=_take_preset,
                label_visibility="collapsed",
            )
        values = {key: _slider(QUANTITIES[key]) for key in ("m", "m_prime", "k", "compression")}
        with st.expander(_("More")):
            st.caption(_("The radius R sets the size of the machine. Does it change the frequency? Try it."))
            values["radius"] = _slider(QUANTITIES["radius"])
        # The list is sent to those who open it: on the first page it would be a twentieth of every change.
        with st.expander(_("Symbols"), key="symbols", on_change="rerun") as symbols:
            if symbols.open:
                st.markdown(cache.symbols())
        page.feed("boxes_feed", _boxes())
        page.link(address.PRIVATE)
        display_mode.switch()
        pending_updates.receipt()
    # What the sliders show in the first run is what the link has set, without what it got wrong.
    st.session_state.setdefault(_LINKED, values)


def follow(*fragments: str) -> None:
    """Let a slider rerun only these fragments of the page; call it when all of the page has been drawn.

    Parameters
    ----------
    fragments : the keys of the fragments with all that depends on the machine; one of them calls `followed`
    """
    st.session_state[_FOLLOW] = fragments


def followed() -> dict[str, object]:
    """Take in what the sliders hold, and return what their boxes are told: topics of the page's bus."""
    st.session_state.pop(_MOVED, None)
    return _boxes()


def _boxes() -> dict[str, object]:
    judged = st.session_state.get(_JUDGED, 0)
    held = {key: quantity.present for key, quantity in QUANTITIES.items()}
    return {f"exact/{key}": {"value": value, "text": repr(value), "judged": judged} for key, value in held.items()}


def _moved(key: str) -> None:
    """Rerun what follows the machine alone, unless more has changed or a page that was broken off is still due."""
    pending_updates.hold()
    moved = {name: value for name, value in st.session_state.pop(_MOVED, {}).items() if name != key}
    fragments = st.session_state.get(_FOLLOW)
    # AppTest would lose sight of the rest of the page.
    if fragments and pending_updates.in_browser() and not pending_updates.waits() and not messages.are_shown():
        st.session_state[_MOVED] = {**moved, key: st.session_state[key]}
        st.rerun(fragments)


def take_typed() -> None:
    """Judge what was typed into the boxes. Called once a run, before anything is drawn."""
    st.session_state.pop(_FOLLOW, None)
    st.session_state[_FIRST] = _FIRST not in st.session_state
    pending_updates.hold()
    # If another message has asked for the whole page meanwhile, Streamlit takes the sliders from an old address.
    for key, value in st.session_state.pop(_MOVED, {}).items():
        pending_updates.give(key, value)
    for key, text in st.session_state.pop(_TYPED, {}).items():
        _take_exact(QUANTITIES[key], text)


def oscillator() -> Oscillator:
    """Return the machine that the sliders describe."""
    return Oscillator(**{name: QUANTITIES[name].in_si for name in ("m", "m_prime", "k", "radius")})


def compression() -> float:
    """Return x₀ [m]."""
    return QUANTITIES["compression"].in_si


def set_compression(metres: float) -> None:
    """Set x₀ [m] from the slab that was dragged."""
    pending_updates.hold()
    quantity = QUANTITIES["compression"]
    # Ten digits are finer than any pointer, and keep 7.9 cm from turning into 7.900000000000001 cm.
    pending_updates.give("compression", quantity.clamp(round(metres / quantity.scale, 10)))


def enter(key: str, text: str) -> None:
    """Take what was typed into the box of a quantity; the next run judges it."""
    st.session_state[_TYPED] = {**st.session_state.get(_TYPED, {}), key: text}


def take_ratio(ratio: float, digits: int = 17) -> None:
    """Set m′ = εm; where m′ would leave its range, m gives way, and the page says so.

    Parameters
    ----------
    ratio : ε = m′/m
    digits : significant digits of m′ that are wanted, where round values matter more than the exact ratio
    """
    pending_updates.hold()
    rollers, others = QUANTITIES["m_prime"], QUANTITIES["m"]
    m = others.present
    m_prime = _times(ratio, m, digits)
    if rollers.least <= m_prime <= rollers.most:
        pending_updates.give("m_prime", m_prime)
        return
    bound = rollers.clamp(m_prime)
    # The m nearest to the old one, on the slider's steps, with which the ratio can be had.
    steps = round(bound / ratio / others.step, 6)
    nearest = (math.floor if m_prime > bound else math.ceil)(steps) * others.step
    new_m = others.clamp(round(nearest, 10))
    pending_updates.give("m", new_m)
    pending_updates.give("m_prime", rollers.clamp(_times(ratio, new_m, digits)))
    sentences = []
    if new_m != m:
        sentences.append(_gave_way(m, new_m, bound, too_heavy=m_prime > bound))
    if not math.isclose(new_m, nearest):
        sentences.append(
            _("The mass ratio is now {ratio}, the nearest possible value.").format(ratio=f"{bound / new_m:.3g}")
        )
    messages.note("m", " ".join(sentences))


def take_machine(machine: Oscillator, metres: float) -> None:
    """Set all sliders to a machine and its x₀ [m]. Call it in a callback, before the sliders are drawn."""
    pending_updates.hold()
    for key, value in _on_sliders(machine, metres).items():
        pending_updates.give(key, value)


def ask_for_machine(machine: Oscillator, metres: float) -> None:
    """Set all sliders to a machine and its x₀ [m] in the run that follows."""
    for key, value in _on_sliders(machine, metres).items():
        enter(key, repr(value))


def linked() -> bool:
    """Tell whether this run is the first of its session and the link says something of the machine."""
    return st.session_state[_FIRST] and not set(QUANTITIES).isdisjoint(st.query_params)


def holds(machine: Oscillator, metres: float) -> bool:
    """Tell whether the sliders hold this machine and this x₀ [m]."""
    return all(math.isclose(QUANTITIES[key].present, x) for key, x in _on_sliders(machine, metres).items())


def _on_sliders(machine: Oscillator, metres: float) -> dict[str, float]:
    """Return what each slider says of a machine, in its own unit."""
    values = {"m": machine.m, "m_prime": machine.m_prime, "k": machine.k, "radius": machine.radius}
    # Ten digits keep 8 cm from turning into 8.000000000000002 cm; what is in SI units keeps all of its digits.
    return {
        key: value if QUANTITIES[key].scale == 1 else round(value / QUANTITIES[key].scale, 10)
        for key, value in {**values, "compression": metres}.items()
    }


def reset() -> None:
    """Put every quantity back to what the link has set, or from there to its default; say so where the two differ."""
    pending_updates.hold()
    defaults = {quantity.key: quantity.default for quantity in QUANTITIES.values()}
    linked = st.session_state.get(_LINKED, defaults)
    there = all(QUANTITIES[key].present == value for key, value in linked.items())
    for key, value in (defaults if there else linked).items():
        pending_updates.give(key, value)
    if linked == defaults:
        return
    if there:
        messages.note("m", _("All values are the app’s own now. Reset again, and the values of your link return."))
    else:
        messages.note("m", _("All values are those of your link again. Reset once more for the app’s own values."))


def _gave_way(old: float, new: float, bound: float, too_heavy: bool) -> str:
    """Return the sentence that says why m was changed."""
    sentence = (
        _("m was changed from {old} to {new}, because m′ can be at most {bound}.")
        if too_heavy
        else _("m was changed from {old} to {new}, because m′ must be at least {bound}.")
    )
    m, m_prime = QUANTITIES["m"], QUANTITIES["m_prime"]
    return sentence.format(old=m.written(old), new=m.written(new), bound=m_prime.written(bound))


def _take_preset() -> None:
    """Do what was asked for, and leave no choice standing: the next slider would belie it."""
    if preset := st.session_state[_PRESET]:
        if preset in _RATIOS:
            take_ratio(_RATIOS[preset])
        else:
            reset()
    st.session_state[_PRESET] = None


def _slider(quantity: Quantity) -> float:
    return widgets.slider_with_box(quantity, enter, _moved)


def _take_exact(quantity: Quantity, text: str) -> None:
    """Take what was typed, or say what would do and that the old value stays."""
    # The box shows its value again whether it has changed or not, so that it must hear of every text that was judged.
    st.session_state[_JUDGED] = st.session_state.get(_JUDGED, 0) + 1
    number = read_number(text)
    if number is not None and quantity.least <= number <= quantity.most:
        pending_updates.give(quantity.key, number)
        return
    sentence = (
        _("Type {symbol} as a number such as 1.25 or as a fraction such as 9/8. The old value, {old}, was kept.")
        if number is None
        else _("{symbol} must be between {least} and {most}. The old value, {old}, was kept.")
    )
    sentence = sentence.format(
        symbol=quantity.symbol,
        least=f"{quantity.least:g}",
        most=quantity.written(quantity.most),
        old=quantity.written(quantity.present),
    )
    messages.note(quantity.key, sentence, complaint=True)


def _times(ratio: float, m: float, digits: int) -> float:
    """Return εm to so many digits; a short ratio gives a product without the noise of binary fractions."""
    short = ratio == float(f"{ratio:.6g}")
    return float(f"{ratio * m:.{min(digits, 12) if short else digits}g}")
