"""The controls: sliders with boxes for exact values, presets, the list of symbols; and the resulting `Oscillator`.

They are in the sidebar, and on the first page in the page itself.

Each parameter has one slider, which is bound to the address and contains its value. The box of the slider shows the
value, with all digits while it has the focus, and sends a typed text as one message. An invalid value from any source
causes a message, and the last valid value remains.
"""

import math
from collections.abc import Collection
from functools import partial
from typing import Any

import streamlit as st

from ramanujan import UNIT_MASS_RATIO, Oscillator
from ramanujan.browser import topics
from ramanujan.browser.components import drawer, exact
from ramanujan.browser.containers import container
from ramanujan.shell import address, display_mode, messages, pending_updates, shared_cache, stages, widgets
from ramanujan.shell.parameters import MACHINE, PARAMETERS, SENTENCES
from ramanujan.text.numerals import number as format_number
from ramanujan.text.reading import read_number, two_readings
from ramanujan.text.translation import _, pgettext

PRESETS = {
    "equal": _("Equal masses"),
    "unit": _("In step (1729)"),
    "light": _("Light rollers"),
    "heavy": _("Heavy rollers"),
    "reset": _("Reset"),
}
_RATIOS = {"equal": 1.0, "unit": UNIT_MASS_RATIO, "light": 0.1, "heavy": 5.0}
_FIRST_BOX = "m"
"""Key of the first slider, where a message about several sliders is shown."""
_PRESET = "preset"
_REQUESTS = "requests"
"""Session state: requests from a box, a preset or a button, for the next run.

Each request is a `partial`, because `begin` sorts the requests by their function. The list is changed in place, so that
an interrupted run loses no request.
"""
_PROCESSED = "processed_texts"
"""Session state: number of texts of the boxes that `set_number` has processed."""
_IS_FIRST = "is_first_run"
"""Session state: whether this run is the first of the session."""
_FRAGMENTS = "machine_fragments"
"""Session state: the page, and the keys of its fragments that depend on the machine, if it was completely drawn."""
_LINKED = "linked"
"""Session state: key of a parameter → its value when the session began."""


def draw(withheld_presets: Collection[str], folded_parameters: Collection[str], placed: Collection[str] = ()) -> None:
    """Draw the sidebar. Call it once in each run, after `begin` and before the page.

    Parameters
    ----------
    withheld_presets : presets to omit, because they would reveal an answer
    folded_parameters : keys of parameters of minor importance on this page, whose sliders are in an expander
    placed : keys of parameters whose sliders the page has drawn
    """
    with st.sidebar, st.container(key="controls"):
        drawer.mount()
        folded = [key for key, parameter in PARAMETERS.items() if parameter.is_folded or key in folded_parameters]
        for key in PARAMETERS:
            if key not in folded and key not in placed:
                # A slider that snaps would reveal the ratio, too.
                draw_slider(key, snaps=not withheld_presets)
        draw_more([name for name in PRESETS if name not in withheld_presets], folded)
        if display_mode.is_projector():
            display_mode.draw_bar()
        end()


def draw_more(offered: Collection[str], folded: Collection[str]) -> None:
    """Draw the less frequent controls in an expander whose label describes them.

    Parameters
    ----------
    offered : ids of the presets
    folded : keys of the parameters in the expander
    """
    with st.expander(_("More: ready machines, radius, symbols"), key="more_controls"):
        if offered:
            draw_presets(offered)
        for key in folded:
            if key == "radius":
                st.caption(_("The radius R sets the size of the machine. Does it change the frequency? Try it."))
            draw_slider(key)
        draw_symbols()


def draw_presets(offered: Collection[str]) -> None:
    """Draw a button for each offered preset: an interesting machine, or the default values."""
    st.pills(
        _("Presets"),
        offered,
        format_func=PRESETS.__getitem__,
        key=_PRESET,
        on_change=_request_preset,
        required=True,  # Otherwise the second press of a double click reverts the first one.
        label_visibility="collapsed",
    )


def draw_symbols() -> None:
    """Draw the list of symbols. A closed expander sends no list, which saves a twentieth of the data of a rerun."""
    with st.expander(pgettext("list of them", "Symbols"), key="symbols", on_change="rerun") as opened:
        if opened.open:
            entries = shared_cache.symbols("euler_lagrange", x_0=_("compression of the spring at release [m]"))
            with container("list", "symbols"):
                st.markdown("\n".join(f"- {entry}" for entry in entries))


def end() -> None:
    """Publish the values of the sliders to the boxes, after all sliders are drawn."""
    topics.publish("boxes", collect_box_messages())
    pending_updates.draw()


def set_dependent_fragments(*fragments: str) -> None:
    """Let a slider rerun only these fragments of the page. Call this function after the whole page is drawn.

    Parameters
    ----------
    fragments : keys of the fragments that depend on the machine. At least one fragment must publish the result of
        `collect_box_messages`: the boxes of the sliders are outside of all fragments, so only a message updates them.
    """
    st.session_state[_FRAGMENTS] = address.current_page(), fragments


def collect_box_messages() -> dict[str, object]:
    """Return topic → value to publish in the browser (bus.js) for the number box of each slider."""
    processed = st.session_state.get(_PROCESSED, 0)
    values = {key: parameter.value for key, parameter in PARAMETERS.items()}
    return {
        f"exact/{key}": {"value": value, "text": repr(value), "processed": processed} for key, value in values.items()
    }


def _rerun_fragments() -> None:
    """Rerun only the fragments that depend on the machine, unless there are other changes or a run was interrupted.

    A link to another page can also change a slider. Streamlit's page ends with an error if it receives fragments of the
    page before. Only a browser keeps the rest of the page. In a test without a browser, the whole page reruns.
    """
    pending_updates.repeat_unreceived()
    page, fragments = st.session_state.get(_FRAGMENTS, ("", ()))
    if (
        fragments
        and page == address.current_page()
        and display_mode.is_browser()
        and not (_requests() or pending_updates.are_waiting() or messages.are_shown())
    ):
        st.rerun(fragments)


def _requests() -> list[partial[None]]:
    """Return the requests that set the sliders: a text in a box, a preset, a click on a curve, a stop."""
    return st.session_state.setdefault(_REQUESTS, [])


def begin(problems: list[str]) -> None:
    """Carry out the requests since the last run, and show the messages. Call it once in each run, before any slider.

    Typed numbers come first, because a box sends its number before any other element receives the click.

    Parameters
    ----------
    problems : a sentence about each problem of the address
    """
    st.session_state.pop(_FRAGMENTS, None)
    st.session_state[_IS_FIRST] = _IS_FIRST not in st.session_state
    # Store the valid values of the link for `_reset`. The sliders have these values in the first run.
    st.session_state.setdefault(_LINKED, {key: parameter.value for key, parameter in PARAMETERS.items()})
    pending_updates.repeat_unreceived()
    for request in sorted(_requests(), key=lambda request: request.func is not set_number):
        request()
        _requests().remove(request)
    messages.begin(problems)


def oscillator() -> Oscillator:
    """Return the machine with the values of the sliders."""
    return Oscillator(**{name: PARAMETERS[name].in_si for name in MACHINE})


def compression() -> float:
    """Return x₀ [m]."""
    return PARAMETERS["compression"].in_si


def request_number(key: str, text: str) -> None:
    """Callback: request the text in the box of a parameter. The next run parses it."""
    _requests().append(partial(set_number, key, text))


def request_ratio(ratio: float, digits: int = 17) -> None:
    """Set m′ = εm in the next run. If m′ would leave its range, change m and show a message.

    Parameters
    ----------
    ratio : ε = m′/m
    digits : number of significant digits of m′, if round values matter more than the exact ratio
    """
    _requests().append(partial(_set_ratio, ratio, digits))


def _set_ratio(ratio: float, digits: int) -> None:
    """Set m′ = εm, with this number of significant digits of m′.

    If no m′ in its range fits, also change m, as little as possible, and show a message.
    """
    # m′ is the mass of the lower rollers, m that of the other bodies.
    rollers, others = PARAMETERS["m_prime"], PARAMETERS["m"]
    ratio = min(max(ratio, rollers.least / others.most), rollers.most / others.least)
    m = others.value
    m_prime = _multiply(ratio, m, digits)
    if rollers.least <= m_prime <= rollers.most:
        pending_updates.set_widgets({"m_prime": m_prime})
        return
    bound = rollers.clamp(m_prime)
    # Choose the m nearest to the old one, on the slider's steps, that allows the ratio.
    steps = round(bound / ratio / others.step, 6)
    nearest = (math.floor if m_prime > bound else math.ceil)(steps) * others.step
    new_m = others.clamp(round(nearest, 10))
    pending_updates.set_widgets({"m": new_m, "m_prime": rollers.clamp(_multiply(ratio, new_m, digits))})
    sentences = []
    if new_m != m:
        sentence = SENTENCES["lighter" if m_prime > bound else "heavier"]
        values = {"old": others.with_unit(m), "new": others.with_unit(new_m), "bound": rollers.with_unit(bound)}
        sentences.append(sentence.format(**values))
    if not math.isclose(new_m, nearest):
        sentences.append(
            _("The mass ratio is now {ratio}, the nearest possible value.").format(
                ratio=format_number(bound / new_m, 3)
            )
        )
    messages.note(others.name, " ".join(sentences))


def request_machine(machine: Oscillator, metres: float) -> None:
    """Set all sliders to a machine and its x₀ [m] in the next run."""
    _requests().append(partial(pending_updates.set_widgets, _slider_values(machine, metres)))


def has_linked_machine() -> bool:
    """Return whether this run is the first of its session and the link contains a parameter of the machine."""
    return st.session_state[_IS_FIRST] and not set(PARAMETERS).isdisjoint(st.query_params)


def shows_machine(machine: Oscillator, metres: float) -> bool:
    """Return whether the sliders have the values of this machine and this x₀ [m]."""
    return all(math.isclose(PARAMETERS[key].value, x) for key, x in _slider_values(machine, metres).items())


def _slider_values(machine: Oscillator, metres: float) -> dict[str, float]:
    """Return the value of each slider for a machine, in the unit of the slider."""
    # Ten digits avoid 8.000000000000002 cm instead of 8 cm. Values in SI units keep all of their digits.
    in_si = {name: getattr(machine, name) for name in MACHINE}
    in_si["compression"] = metres
    values = {}
    for name, value in in_si.items():
        scale = PARAMETERS[name].scale
        values[name] = value if scale == 1 else round(value / scale, 10)
    return values


def _reset() -> None:
    """Reset all parameters to the values in the link, or to the defaults if they have the values in the link.

    A message names the new values, if the link sets a parameter.
    """
    defaults, linked = _defaults(), st.session_state[_LINKED]
    has_linked_values = all(PARAMETERS[key].value == value for key, value in linked.items())
    pending_updates.set_widgets(defaults if has_linked_values else linked)
    if linked == defaults:
        return
    if has_linked_values:
        messages.note(_FIRST_BOX, _("All values are now the app’s own. Press Reset again for the values of your link."))
    else:
        sentence = _("All values are now those of your link. Press Reset again for the app’s own values.")
        messages.note(_FIRST_BOX, sentence)


def _defaults() -> dict[str, float]:
    return {parameter.name: parameter.default for parameter in PARAMETERS.values()}


def _request_preset() -> None:
    """Request the selected preset, and clear the selection, which a moved slider would invalidate."""
    pending_updates.repeat_unreceived()
    preset = st.session_state[_PRESET]
    stages.release()
    if preset in _RATIOS:
        request_ratio(_RATIOS[preset])
    elif preset == "reset":
        _requests().append(partial(_reset))
    pending_updates.set_widgets({_PRESET: None})


def draw_slider(key: str, snaps: bool = True) -> None:
    """Draw the slider of a parameter with its box, in one place in each run, before `end`.

    Parameters
    ----------
    key : key of the parameter
    snaps : whether the slider snaps to the parameter's `snap_ratios`
    """
    head = widgets.box_settings(PARAMETERS[key]) | _describe_presets(key)
    if not snaps:
        head["snap_ratios"] = ()
    exact.mount(key, head, partial(request_number, key))
    messages.show_note(key)
    widgets.slider(PARAMETERS[key], label_visibility="collapsed", on_change=_rerun_fragments)


def _describe_presets(key: str) -> dict[str, Any]:
    """Return the presets that set this slider for its box, which moves the thumb before the server answers."""
    ratios = {PRESETS[name]: ratio for name, ratio in _RATIOS.items()}
    # After a link, the values of a reset depend on those of all sliders.
    is_default = st.session_state[_LINKED] == _defaults()
    reset = {"label": PRESETS["reset"], "value": PARAMETERS[key].default if is_default else None}
    return {"ratios": ratios if key == "m_prime" else None, "reset": reset}


def set_number(key: str, text: str) -> None:
    """Set a parameter to the number in its box. For an invalid text, show the valid range and keep the old value."""
    parameter = PARAMETERS[key]
    # The count makes the box show its value again, changed or not.
    st.session_state[_PROCESSED] = st.session_state.get(_PROCESSED, 0) + 1
    number = read_number(text)
    if number is not None and parameter.least <= number <= parameter.most:
        pending_updates.set_widgets({parameter.name: number})
        return
    names = {"symbol": parameter.symbol, "old": parameter.with_unit(parameter.value)}
    readings = two_readings(text)
    if readings:
        sentence = SENTENCES["ambiguous"].format(**names, **readings)
    elif number is None:
        sentence = SENTENCES["unreadable"].format(**names)
    else:
        least, most = format_number(parameter.least, strip=True), parameter.with_unit(parameter.most)
        sentence = SENTENCES["outside"].format(**names, least=least, most=most)
    messages.note(parameter.name, sentence, is_warning=True)


def _multiply(ratio: float, m: float, digits: int) -> float:
    """Return εm with this number of significant digits.

    For a ratio with at most six digits, twelve digits remove the rounding error of binary fractions.
    """
    has_few_digits = ratio == float(f"{ratio:.6g}")
    return float(f"{ratio * m:.{min(digits, 12) if has_few_digits else digits}g}")
