"""Display options: the projector view with one slide at a time, and the parts that a lecturer's link hides.

They are URL parameters of every page, such as `view=projector`, `slide=curve` and `hide=numbers,curve,clocks`. Thus a
link contains them. A page declares a slide where it draws it: `with slide("curve", _("The curve")):`.
"""

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from html import escape
from typing import Any

import streamlit as st

from ramanujan.browser import stage
from ramanujan.browser.components import link, pager
from ramanujan.browser.containers import container
from ramanujan.shell import address
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.text.translation import _

PARTS = {**stage.PARTS, "curve": "the curve of Ω²m/k over the mass ratio", "steps": "the derivation in six steps"}
"""Part that a link can hide → its description."""
VIEW = address.Choice("view", ("projector",))
HIDE = address.Several("hide", tuple(PARTS), gone=stage.GONE_LAYERS)
SLIDE = address.Text(
    "slide", "[a-z0-9_]{1,40}", _("The value of {name} in the address was ignored: it must be a short name.")
)
STANDALONE = (*PARAMETERS, "layers", "speed", "from", "paused")
"""URL parameters of the standalone file."""
URL_PARAMETERS = (VIEW, HIDE, SLIDE)
"""Display options in the address of every page."""

_PAGE = "display_page"
"""Session state: name of the page that the last run drew."""
_SWITCH = "projector"
"""Key of the switch for the projector view."""


def is_browser() -> bool:
    """Return whether the client is a browser. A test that runs the script sends no HTTP headers."""
    return bool(st.context.headers)


def is_projector() -> bool:
    """Return whether the projector view is on: large text, one slide at a time, the sidebar closed."""
    return address.current(VIEW) == "projector"


def slide(name: str, title: str, heading: str = "") -> AbstractContextManager[Any]:
    """Return a context manager for a slide of the projector view. In the normal view it has no effect.

    Elements outside of all slides are shown on each slide.

    Parameters
    ----------
    name : name of the slide in the address
    title : title in the list of slides
    heading : heading at the top of the slide
    """
    if not is_projector():
        return nullcontext()
    slide_container = container("slide", name)
    slide_container.html(f'<i data-slide="{escape(title)}"></i>')
    if heading:
        slide_container.header(heading, anchor=False)
    return slide_container


def columns(name: str, *, has_slides: bool = False) -> Sequence[AbstractContextManager[Any]]:
    """Return two columns: a left one for text, and a right one for the figure or formula that the text explains.

    On a narrow screen the text is above (page.css). In the projector view there are only columns with slides.

    Parameters
    ----------
    name : name of the columns, unique on the page
    has_slides : whether the right column contains slides, so that the left one is beside each of them
    """
    if is_projector() and not has_slides:
        return nullcontext(), nullcontext()
    row = container("columns", name)
    return row.container(), row.container()


def picture_and_words(picture_width: float = 3) -> Sequence[AbstractContextManager[Any]]:
    """Return columns for picture and text of a slide; no columns in the normal view.

    Parameters
    ----------
    picture_width : width of the picture's column, relative to 2 for the text
    """
    if is_projector():
        return st.columns([picture_width, 2], gap="medium")
    return nullcontext(), nullcontext()


def fold(name: str, title: str, **options: Any) -> Any:
    """Return a line that expands; `options` are those of `st.expander`.

    After a change of the theme, an expander with a border keeps its whole page in the browser's memory. This one has
    no border.
    """
    return st.expander(title, key=f"fold_{name}", type="compact", **options)


@st.fragment
def folded(name: str, title: str, *parts: Callable[[], None]) -> None:
    """Draw an expander, and its parts while it is open. The projector view leaves it out."""
    if is_projector():
        return
    line = fold(name, title, on_change="rerun")
    if line.open:
        with line:
            for draw in parts:
                draw()


def begin(name: str) -> None:
    """Begin a run of the page with this name. After another page, select the first slide."""
    if st.session_state.get(_PAGE, name) != name:
        st.session_state[SLIDE.name] = ""
    st.session_state[_PAGE] = name


@st.fragment
def draw_pager() -> None:
    """Draw the controls that select a slide. A selection reruns only this fragment."""
    address.update(SLIDE)
    pager.mount(lambda name: st.session_state.update({SLIDE.name: name}))


def hides(*parts: str) -> bool:
    """Return whether the link hides at least one of these parts."""
    return not set(parts).isdisjoint(address.current(HIDE))


def hidden_stage_parts() -> tuple[str, ...]:
    """Return the parts of a stage that the link hides."""
    return tuple(part for part in address.current(HIDE) if part in stage.PARTS)


def draw_bar() -> None:
    """Draw the bar with the link and the projector switch. It is above the page, or below (page.css)."""
    st.session_state[_SWITCH] = is_projector()
    with st.container(horizontal=True, vertical_alignment="center", key="bar"):
        host = address.link_for_others({}).netloc
        link.mount(address.PRIVATE, STANDALONE, host, address.is_only_for_this_computer())
        st.toggle(_("Projector"), key=_SWITCH, on_change=_store_view)


def _store_view() -> None:
    st.session_state[VIEW.name] = "projector" if st.session_state[_SWITCH] else None
