"""The pages of the app, in the order of the menu.

A page's file draws the page when Streamlit executes it (`if __name__ == "__main__":`). Menu, links, tests and
benchmarks use PAGES. The shell imports no page. So app.py passes it the parts of a page that it uses, an `Entry`.
"""

from collections.abc import Callable, Collection
from dataclasses import dataclass
from urllib.parse import urlsplit

import streamlit as st

from ramanujan.shell import class_keys, display_mode, parameters, stages
from ramanujan.shell.address import URLParameter
from ramanujan.text.translation import _

EVERY_PAGE = (*display_mode.URL_PARAMETERS, *class_keys.URL_PARAMETERS)
"""URL parameters of every page that app.py updates. Scripts in the page update those of sliders and stages."""

SIDEBAR_WIDTH = 272
"""Width of the open sidebar [px]."""


@dataclass(frozen=True)
class Page:
    """A page.

    Parameters
    ----------
    name : name of its folder in `pages`
    title : title in the menu and in the browser's tab
    icon : name of a Material symbol
    path : path of its address; empty for the first page
    folded_parameters : parameters with sliders in an expander, because they only change the motion of the picture
    """

    name: str
    title: str
    icon: str
    path: str = ""
    folded_parameters: tuple[str, ...] = ()

    @property
    def file(self) -> str:
        """The path of the file, for `st.page_link` and `AppTest.switch_page`."""
        return f"ramanujan/pages/{self.name}/page.py"


@dataclass(frozen=True)
class Entry:
    """The URL parameters and functions of a page that the shell uses.

    Parameters
    ----------
    url_parameters : the page's own URL parameters, without those of every page
    draw_header : draws the sliders and presets at the top of the page, and returns whether it has drawn them. If not,
        the sidebar draws them. It is called outside of the page's script, because Streamlit deletes the widgets of a
        script when another page opens.
    uses_sidebar : returns whether the page in its current state uses the sidebar; if not, it is closed at first
    withheld_presets : returns the presets that the sidebar omits, because they would reveal an answer
    """

    url_parameters: tuple[URLParameter, ...] = ()
    draw_header: Callable[[], bool] = lambda: False
    uses_sidebar: Callable[[], bool] = lambda: True
    withheld_presets: Callable[[], Collection[str]] = tuple

    @property
    def all_url_parameters(self) -> tuple[URLParameter, ...]:
        """The URL parameters of the page, with those of every page."""
        return (*parameters.URL_PARAMETERS, *EVERY_PAGE, *stages.URL_PARAMETERS, *self.url_parameters)


PAGES = {
    page.name: page
    for page in (
        Page("oscillator", _("Oscillator"), "waves"),
        Page("derivation", _("Derivation"), "function", "derivation", folded_parameters=("compression",)),
        Page("motion", _("Motion"), "timeline", "motion"),
        Page("taxicab", _("1729"), "local_taxi", "1729", folded_parameters=("k", "compression")),
        Page("speed", _("Speed and accuracy"), "speed", "speed", folded_parameters=("compression",)),
        Page("lesson", _("Lesson"), "school", "lesson"),
        Page("worksheet", _("Worksheet"), "print", "worksheet"),
    )
}


def is_first_page() -> bool:
    """Return whether the browser requests the first page. The answer is available before `navigate` is called."""
    path = urlsplit(st.context.url or "").path.rpartition("/")[2]
    return path not in {page.path for page in PAGES.values() if page.path}


def navigate(hidden: bool) -> tuple[Page, st.Page]:
    """Draw the menu, unless `hidden`; return the current page and its script."""
    scripts = [
        st.Page(
            page.file,
            title=page.title,
            icon=f":material/{page.icon}:",
            url_path=page.path or None,
            default=not page.path,
        )
        for page in PAGES.values()
    ]
    script = st.navigation(scripts, position="hidden" if hidden else "top")
    return next(page for page in PAGES.values() if page.path == script.url_path), script


def configure(page: Page, uses_sidebar: bool) -> None:
    """Set the title of the browser's tab, the layout, and whether the sidebar starts open."""
    has_sidebar = uses_sidebar and not display_mode.is_projector()
    st.set_page_config(
        tab_title(page), layout="wide", initial_sidebar_state=SIDEBAR_WIDTH if has_sidebar else "collapsed"
    )


def tab_title(page: Page) -> str:
    """Return the title of the browser's tab."""
    app = _("Ramanujan’s oscillator")
    return _("{page} – {app}").format(page=page.title, app=app) if page.path else app
