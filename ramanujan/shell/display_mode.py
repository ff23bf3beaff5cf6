"""How the app is shown: on a projector, one slide at a time, and without the parts that a lecturer's link hides.

All of it stands in the address of every page, as `view=projector`, `slide=curve` and `hide=numbers,curve,clocks`, so
that it can be passed on. A page declares its slides where it draws them: `with slide("curve", _("The curve")):`.
"""

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from html import escape

import streamlit as st

from ramanujan.browser import components, stage
from ramanujan.shell import address
from ramanujan.translation import _

PARTS = {**stage.PARTS, "curve": "the curve of Ω²m/k over the mass ratio", "steps": "the derivation in six steps"}
"""Part that a link can hide → what it is."""
VIEW = address.Choice("view", ("projector",))
HIDE = address.Several("hide", tuple(PARTS))
SLIDE = address.Text(
    "slide", "[a-z0-9_]{1,40}", _("The value of {name} in the address was ignored: it must be a short name.")
)
STANDALONE = ("m", "m_prime", "k", "compression", "radius", "layers", "speed", "from", "paused")
"""Keys of the address that the standalone file knows."""
_PAGE = "display_page"
URL_PARAMETERS = (VIEW, HIDE, SLIDE)
"""What every page keeps in its address beside the machine."""

_SWITCH = "projector"


def in_browser() -> bool:
    """Tell whether a browser shows the page; a test or another program that runs the app sends no HTTP headers."""
    return bool(st.context.headers)


def is_projector() -> bool:
    """Tell whether the app is shown on a projector: large words, one picture at a time, the sidebar folded."""
    return address.held(VIEW) == "projector"


def slide(name: str, title: str) -> AbstractContextManager:
    """Return one slide of the projector, for all that is drawn in a with-block; on another screen this changes nothing.

    What a page draws outside of its slides is seen beside each of them.

    Parameters
    ----------
    name : of the slide, as the address has it
    title : in the list of slides
    """
    if not is_projector():
        return nullcontext()
    drawn = st.container(key=f"slide-{name}")
    drawn.html(f'<i data-slide="{escape(title)}"></i>')
    return drawn


def columns(name: str) -> Sequence[AbstractContextManager]:
    """Return the columns of the page's grid: words, and to their right the figure or formula of which they speak.

    On a narrow screen the words come first (page.css), and on a slide all is as it is drawn.

    Parameters
    ----------
    name : of these columns, unique on the page
    """
    if is_projector():
        return nullcontext(), nullcontext()
    row = st.container(key=f"columns_{name}")
    return row.container(), row.container()


def picture_and_words(wide: int = 3) -> Sequence[AbstractContextManager]:
    """Return the places of a slide's picture, so wide, and to its right of words, 2 wide; elsewhere all is as drawn."""
    return st.columns([wide, 2], gap="medium") if is_projector() else (nullcontext(), nullcontext())


@st.fragment
def folded(name: str, title: str, draw: Callable[[], None], *, expanded: bool = False) -> None:
    """Draw something on a slide of the projector; on another screen in a fold, once that is opened."""
    if is_projector():
        with slide(name, title):
            draw()
        return
    fold = st.expander(title, expanded, key=f"fold_{name}", on_change="rerun")
    if fold.open:
        with fold:
            draw()


def begin(name: str) -> None:
    """Begin another page than the last one with its first slide, unless its address names a slide."""
    if st.session_state.get(_PAGE, name) != name and SLIDE.name not in st.query_params:
        st.session_state[SLIDE.name] = ""
    st.session_state[_PAGE] = name


@st.fragment
def pager() -> None:
    """Draw what turns the slides; a turn reruns nothing else."""
    address.keep(SLIDE)
    components.pager(lambda name: st.session_state.update({SLIDE.name: name}))


def hides(*parts: str) -> bool:
    """Tell whether the link hides one of these parts."""
    return not set(parts).isdisjoint(address.held(HIDE))


def on_stage() -> tuple[str, ...]:
    """Return the hidden parts that belong to a stage."""
    return tuple(part for part in address.held(HIDE) if part in stage.PARTS)


def bar() -> None:
    """Draw what belongs to the page as a whole: in the bar above it, or on a narrow screen below it (page.css)."""
    st.session_state[_SWITCH] = is_projector()
    with st.container(horizontal=True, vertical_alignment="center", key="bar"):
        components.link(address.PRIVATE, STANDALONE)
        st.toggle(_("Projector"), key=_SWITCH, on_change=_switched)


def _switched() -> None:
    st.session_state[VIEW.name] = "projector" if st.session_state[_SWITCH] else None
