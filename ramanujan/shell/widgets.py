"""The widgets of the pages. Each belongs to a URL parameter (`address`), has an id as its value, and shows a label."""

import string
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

import streamlit as st

from ramanujan.shell import address
from ramanujan.shell.address import Choice, Count
from ramanujan.shell.parameters import LONGEST, Parameter
from ramanujan.translation import _

Words = Mapping[Any, str]
"""Option → its label, for parameters whose options have no labels."""


def segmented_control(key: Choice, label: str, words: Words | None = None, **more: Any) -> Any:
    """Draw the options in a row. Exactly one of them is selected."""
    return _choice(st.segmented_control, key, label, words, default=key.default, required=True, **more)


def pills(key: Choice, label: str, words: Words | None = None, **more: Any) -> Any:
    """Draw the options in a row. At most one of them is selected."""
    return _choice(st.pills, key, label, words, **more)


def selectbox(key: Choice, label: str, words: Words | None = None, **more: Any) -> Any:
    """Draw the options as a menu."""
    return _choice(st.selectbox, key, label, words, index=list(key.options).index(key.default), **more)


def select_slider(key: Choice, label: str, words: Words | None = None, **more: Any) -> Any:
    """Draw the options as the marks of a slider."""
    return _choice(st.select_slider, key, label, words, value=key.default, **more)


def _choice(draw: Callable[..., object], key: Choice, label: str, words: Words | None, **more: Any) -> Any:
    words = words or _labels(key)
    # A page that remained open may send an option that no longer exists.
    options = {"options": list(key.options), "format_func": lambda option: words.get(option, str(option))}
    draw(label, **options, key=key.name, persist_state="session", **more)
    return address.keep(key)


def _labels(key: Choice) -> Words:
    """Return option → label, without content if the options have no labels."""
    return key.options if isinstance(key.options, Mapping) else {}


def beside(
    widths: int | Sequence[float],
    *draw: Callable[[], Any],
    alignment: Literal["top", "center", "bottom"] = "top",
) -> list[Any]:
    """Draw widgets in columns, or below each other in a single column, and return their values."""
    columns = st.columns(widths, vertical_alignment=alignment)
    values = []
    for column, each in zip(columns if len(columns) > 1 else columns * len(draw), draw, strict=True):
        with column:
            values.append(each())
    return values


def count(key: Count, label: str, *, step: int = 1, width: int | Literal["stretch"] = "stretch") -> int:
    """Draw a box for a whole number, with its range. Streamlit's own box shows the range only after it is left."""
    label = _("{label} ({least}\u00a0to\u00a0{most})").format(label=label, least=key.least, most=key.most)
    st.number_input(label, key.least, key.most, key.default, step, key=key.name, persist_state="session", width=width)
    return address.keep(key)


def table(rows: Sequence[Sequence[str]], key: str) -> None:
    """Draw a table that scrolls separately on a narrow page. Cells are Markdown; the first row names the columns."""
    head, *others = rows
    lines = (" | ".join(row) for row in (head, ["---"] * len(head), *others))
    with st.container(key=f"table_{key}"):
        st.markdown("\n".join(f"| {line} |" for line in lines))


def equations(key: str, wide: str, narrow: str) -> None:
    """Draw equations for a wide window and for a phone. page.css shows one of the two."""
    if wide == narrow:
        st.latex(wide)
        return
    # The server does not know the width of a window.
    with st.container(key=f"equations_{key}"):
        st.latex(wide)
    with st.container(key=f"narrow_{key}"):
        st.latex(narrow)


def download(label: str, content: str, name: str, mime: str, **more: Any) -> None:
    """Offer a file that is written before the click.

    Streamlit deletes a file that is written at a click after two more runs of any session. In a class, a slow browser
    would not have loaded it by then.
    """
    st.download_button(label, content, name, mime, on_click="ignore", **more)


def plain(text: str) -> str:
    """Return a text that Markdown shows unchanged."""
    return "".join(f"\\{character}" if character in string.punctuation else character for character in text)


def hints(name: str, sentences: Sequence[str], last: str = "") -> bool:
    """Draw the requested hints, and a button for the next one.

    Parameters
    ----------
    name : name of the question or task
    sentences : hints in Markdown, with increasing detail
    last : label of an additional last button, if any; the function returns whether it was pressed
    """
    shown = hints_shown(name)
    for sentence in sentences[:shown]:
        st.markdown(f":material/lightbulb: {sentence}")
    labels = [*(_("Hint ({n} left)").format(n=n) for n in range(len(sentences), 0, -1)), *([last] if last else [])]
    if shown < len(labels):
        one_more = {f"hints_shown_{name}": shown + 1}
        st.button(labels[shown], key=f"hint_{name}", on_click=st.session_state.update, args=(one_more,))
    return shown > len(sentences)


def hints_shown(name: str) -> int:
    """Return the number of requested hints."""
    return st.session_state.get(f"hints_shown_{name}", 0)


def tabs(key: Choice) -> dict[str, Any]:
    """Draw tabs and return them by the ids of their options. Only the open tab needs content."""
    words = _labels(key)
    widget, ids = f"{key.name}_tabs", {label: option for option, label in words.items()}

    def chosen() -> None:
        st.session_state[key.name] = ids.get(st.session_state[widget], key.default)

    # Streamlit identifies a tab only by its label.
    if st.session_state.get(widget, words[key.default]) != words[address.current(key)]:
        st.session_state[widget] = words[address.current(key)]
    drawn = st.tabs(list(words.values()), key=widget, on_change=chosen)
    address.keep(key)
    return dict(zip(words, drawn, strict=True))


def slider(parameter: Parameter, **more: Any) -> float:
    """Draw a slider, bound to the address, and return its value in this parameter's unit."""
    return st.slider(
        parameter.label,
        parameter.least,
        parameter.most,
        parameter.default,
        parameter.step,
        # components/slider_values.js writes the value in the language of the page.
        format=parameter.format,
        key=parameter.name,
        bind="query-params",
        **more,
    )


def page_slider(parameter: Parameter) -> float:
    """Draw a slider of the current page only, and return its value in SI units."""
    value = slider(parameter)
    return (value if parameter.least <= value <= parameter.most else parameter.default) * parameter.scale


def head(parameter: Parameter) -> dict[str, Any]:
    """Return the head of a slider: its names, and the settings of its box."""
    return {
        "symbol": parameter.symbol,
        "unit": parameter.unit,
        "meaning": parameter.short,
        "label": _("Exact value: {parameter}").format(parameter=parameter.label),
        "longest": LONGEST,
        "default": parameter.default,
    }
