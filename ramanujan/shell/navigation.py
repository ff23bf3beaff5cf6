"""The pages of the app, in their order: a new page is one line here and one folder in `pages`.

The page's file draws the page when Streamlit executes it (`if __name__ == "__main__":`). Its `URL_PARAMETERS` list what
the page writes into its address. Menu, tests and benchmarks read the list below.
"""

from collections.abc import Collection
from dataclasses import dataclass
from importlib import import_module
from typing import Any
from urllib.parse import urlsplit

import streamlit as st

from ramanujan.shell import display_mode
from ramanujan.shell.address import URLParameter
from ramanujan.translation import _

SIDEBAR_WIDTH = 272
"""The width of the open sidebar [px]."""


@dataclass(frozen=True)
class Page:
    """A page.

    Parameters
    ----------
    name : of its file in this folder
    title : in the navigation and in the browser's tab
    icon : one of the Material symbols
    path : its address; empty for the first page
    quick : the query with which a test or a benchmark opens the page, so that the page computes little
    """

    name: str
    title: str
    icon: str
    path: str = ""
    quick: str = ""

    @property
    def file(self) -> str:
        """The path of the file, for `st.page_link` and `AppTest.switch_page`."""
        return f"ramanujan/pages/{self.name}/page.py"

    @property
    def address(self) -> str:
        """The address for a test or a benchmark."""
        return f"{self.path}?{self.quick}" if self.quick else self.path

    @property
    def url_parameters(self) -> tuple[URLParameter, ...]:
        """What the page writes into its address, besides the machine."""
        return self._declared("URL_PARAMETERS")

    def lead(self) -> bool:
        """Draw the controls at the top of the page and return True, or return False to leave them to the sidebar.

        Call it outside of the page's script: Streamlit deletes the widgets of a script when another page opens.
        """
        return self._declared("lead", lambda: False)()

    def uses_sidebar(self) -> bool:
        """Tell whether the page in its present state depends on the sidebar; if not, the sidebar starts closed."""
        return self._declared("uses_sidebar", lambda: True)()

    def withheld(self) -> Collection[str]:
        """Return the presets that the sidebar leaves out, because they would give away an answer."""
        return self._declared("withheld", tuple)()

    def aside(self) -> Collection[str]:
        """Return the parameters whose sliders are folded, because they only change the motion of the picture."""
        return self._declared("ASIDE", ())

    def warm_up(self) -> None:
        """Import the page and compute what would delay its first visitor."""
        self._declared("warm_up", lambda: None)()

    def _declared(self, name: str, *default: Any) -> Any:
        """Return what the page's file defines under this name."""
        return getattr(import_module(f"ramanujan.pages.{self.name}.page"), name, *default)


PAGES = {
    page.name: page
    for page in (
        Page("oscillator", _("Oscillator"), "waves"),
        Page("derivation", _("Derivation"), "function", "derivation"),
        Page("motion", _("Motion"), "timeline", "motion"),
        Page("taxicab", _("1729"), "local_taxi", "1729"),
        Page("speed", _("Speed and accuracy"), "speed", "speed", "periods=1"),
        Page("lesson", _("Lesson"), "school", "lesson"),
        Page("worksheet", _("Worksheet"), "print", "worksheet"),
    )
}


def is_first_page() -> bool:
    """Tell whether the browser requests the first page; this needs no call of `navigate` before."""
    path = urlsplit(st.context.url or "").path.rpartition("/")[2]
    return path not in {page.path for page in PAGES.values() if page.path}


def navigate(hidden: bool) -> tuple[Page, st.Page]:
    """Draw the menu of pages, unless it is hidden; return the current page and its script."""
    pages = {
        st.Page(
            page.file,
            title=page.title,
            icon=f":material/{page.icon}:",
            url_path=page.path or None,
            default=not page.path,
        ): page
        for page in PAGES.values()
    }
    script = st.navigation(list(pages), position="hidden" if hidden else "top")
    return next(page for page in PAGES.values() if page.path == script.url_path), script


def configure(page: Page) -> None:
    """Set the title of the browser's tab, the layout, and whether the sidebar starts open."""
    has_sidebar = page.uses_sidebar() and not display_mode.is_projector()
    st.set_page_config(
        tab_title(page), layout="wide", initial_sidebar_state=SIDEBAR_WIDTH if has_sidebar else "collapsed"
    )


def tab_title(page: Page) -> str:
    """Return the title of the browser's tab."""
    app = _("Ramanujan’s oscillator")
    return _("{page} – {app}").format(page=page.title, app=app) if page.path else app
