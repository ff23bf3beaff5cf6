"""The widgets of the pages. Most belong to a URL parameter (`address`): the value is an id, and a label is shown."""

import string
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

import streamlit as st

from ramanujan.browser.containers import container
from ramanujan.shell import address
from ramanujan.shell.address import Choice, Count
from ramanujan.shell.parameters import Parameter
from ramanujan.text.reading import LONGEST
from ramanujan.text.translation import _

Labels = Mapping[Any, str]
"""Labels of options: option → label. They are only passed for a parameter that does not define labels itself."""


def segmented_control(parameter: Choice, label: str, labels: Labels | None = None, **more: Any) -> Any:
    """Draw the options in a row. Exactly one of them is selected."""
    return _choice(st.segmented_control, parameter, label, labels, default=parameter.default, required=True, **more)


def pills(parameter: Choice, label: str, labels: Labels | None = None, **more: Any) -> Any:
    """Draw the options in a row. At most one of them is selected."""
    return _choice(st.pills, parameter, label, labels, **more)


def selectbox(parameter: Choice, label: str, labels: Labels | None = None, **more: Any) -> Any:
    """Draw the options as a menu."""
    return _choice(
        st.selectbox, parameter, label, labels, index=list(parameter.options).index(parameter.default), **more
    )


def select_slider(parameter: Choice, label: str, **more: Any) -> Any:
    """Draw the options as the marks of a slider."""
    return _choice(st.select_slider, parameter, label, labels=None, value=parameter.default, **more)


def _choice(draw: Callable[..., object], parameter: Choice, label: str, labels: Labels | None, **more: Any) -> Any:
    labels = labels or _labels(parameter)
    # A page that remained open may send an option that no longer exists.
    options = {"options": list(parameter.options), "format_func": lambda option: labels.get(option, str(option))}
    draw(label, **options, key=parameter.name, persist_state="session", **more)
    return address.update(parameter)


def _labels(parameter: Choice) -> Labels:
    """Return option → label; an empty mapping if the parameter defines no labels."""
    return parameter.options if isinstance(parameter.options, Mapping) else {}


def count(parameter: Count, label: str, *, width: int | Literal["stretch"] = "stretch") -> int:
    """Draw a box for a whole number, with its range. Streamlit's own box shows the range only after it is left."""
    label = _("{label} ({least}\u00a0to\u00a0{most})").format(label=label, least=parameter.least, most=parameter.most)
    st.number_input(
        label,
        parameter.least,
        parameter.most,
        parameter.default,
        key=parameter.name,
        persist_state="session",
        width=width,
    )
    return address.update(parameter)


def table(rows: Sequence[Sequence[str]], key: str) -> None:
    """Draw a table that scrolls separately on a narrow page. Cells are Markdown; the first row names the columns."""
    head, *others = rows
    rule = ["---"] * len(head)
    lines = [f"| {' | '.join(row)} |" for row in (head, rule, *others)]
    with container("table", key):
        st.markdown("\n".join(lines))


def equations(key: str, wide: str, narrow: str) -> None:
    """Draw equations for a wide window and for a phone. page.css shows one of the two."""
    if wide == narrow:
        st.latex(wide)
        return
    # The server does not know the width of a window.
    with container("equations", key):
        st.latex(wide)
    with container("narrow", key):
        st.latex(narrow)


def download(label: str, content: str, name: str, mime: str, **more: Any) -> None:
    """Draw a download button. The content of the file is computed before the click.

    Streamlit can also compute it at the click, but deletes it after two more runs of any session. In a class, a slow
    browser would not have loaded it by then.
    """
    st.download_button(label, content, name, mime, on_click="ignore", **more)


def escape(text: str) -> str:
    """Escape a text, so that Markdown shows it unchanged."""
    return "".join(f"\\{character}" if character in string.punctuation else character for character in text)


def draw_hints(name: str, sentences: Sequence[str], last: str = "") -> bool:
    """Draw the requested hints, and a button for the next one.

    Parameters
    ----------
    name : name of the question or task
    sentences : hints in Markdown, with increasing detail
    last : label of an additional last button, if any; the function returns whether it was pressed
    """
    shown = count_shown_hints(name)
    for sentence in sentences[:shown]:
        st.markdown(f":material/lightbulb: {sentence}")
    # The nth label is that of the button for the nth hint.
    labels = [_("Hint ({n} left)").format(n=left) for left in range(len(sentences), 0, -1)]
    if last:
        labels.append(last)
    if shown < len(labels):
        one_more = {f"hints_shown_{name}": shown + 1}
        st.button(labels[shown], key=f"hint_{name}", on_click=st.session_state.update, args=(one_more,))
    return shown > len(sentences)


def count_shown_hints(name: str) -> int:
    """Return the number of requested hints."""
    return st.session_state.get(f"hints_shown_{name}", 0)


def tabs(parameter: Choice) -> dict[str, Any]:
    """Draw tabs and return them by the ids of their options. Only the open tab needs content."""
    # Streamlit identifies a tab only by its label, the app by the id of its option.
    labels = _labels(parameter)
    ids = {label: option for option, label in labels.items()}
    widget = f"{parameter.name}_tabs"

    def store_option() -> None:
        st.session_state[parameter.name] = ids.get(st.session_state[widget], parameter.default)

    current_label = labels[address.current(parameter)]
    if st.session_state.get(widget, labels[parameter.default]) != current_label:
        st.session_state[widget] = current_label
    tabs = st.tabs(list(labels.values()), key=widget, on_change=store_option)
    address.update(parameter)
    return dict(zip(labels, tabs, strict=True))


def slider(parameter: Parameter, **more: Any) -> float:
    """Draw a slider, bound to the address, and return its value in this parameter's unit."""
    return st.slider(
        parameter.label,
        parameter.least,
        parameter.most,
        parameter.default,
        parameter.step,
        # components/services/slider_values.js writes the value in the language of the page.
        format=parameter.format,
        key=parameter.name,
        bind="query-params",
        **more,
    )


def page_slider(parameter: Parameter) -> float:
    """Draw a slider of the current page only, and return its value in SI units."""
    value = slider(parameter)
    if not parameter.least <= value <= parameter.most:
        value = parameter.default
    return value * parameter.scale


def box_settings(parameter: Parameter) -> dict[str, Any]:
    """Return the names of a parameter and the settings of the box above its slider, for `exact.mount`."""
    return {
        "symbol": parameter.symbol,
        "unit": parameter.unit,
        "meaning": parameter.short,
        "label": _("{parameter}, exact value").format(parameter=parameter.label),
        "longest": LONGEST,
        "default": parameter.default,
        "shown_ratio": parameter.shown_ratio,
        "snap_ratios": parameter.snap_ratios,
    }
