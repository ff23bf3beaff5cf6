"""The pages of the app, in the order of the menu. A new page requires one line here and one folder in `pages`.

A page's file draws the page when Streamlit executes it (`if __name__ == "__main__":`). Its `URL_PARAMETERS` are the
parameters of its address. Menu, tests and benchmarks use PAGES.
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
    quick : query for tests and benchmarks, with which the page computes little
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
        """Path and query for a test or a benchmark."""
        return f"{self.path}?{self.quick}" if self.quick else self.path

    @property
    def url_parameters(self) -> tuple[URLParameter, ...]:
        """The page's own URL parameters, without those of every page."""
        return self._attribute("URL_PARAMETERS", ())

    def draw_header(self) -> bool:
        """Draw the sliders and presets at the top of the page, and return True; False if the sidebar has to draw them.

        Call it outside of the page's script: Streamlit deletes the widgets of a script when another page opens.
        """
        return self._attribute("draw_header", lambda: False)()

    def uses_sidebar(self) -> bool:
        """Return whether the page in its current state uses the sidebar; if not, the sidebar is closed at first."""
        return self._attribute("uses_sidebar", lambda: True)()

    def withheld_presets(self) -> Collection[str]:
        """Return the presets that the sidebar omits, because they would reveal an answer."""
        return self._attribute("withheld_presets", tuple)()

    def folded_parameters(self) -> Collection[str]:
        """Return the parameters with sliders in an expander, because they only change the motion of the picture."""
        return self._attribute("FOLDED_PARAMETERS", ())

    def warm_up(self) -> None:
        """Import the page, and fill the caches that its first visitor needs."""
        self._attribute("warm_up", lambda: None)()

    def _attribute(self, name: str, *default: Any) -> Any:
        """Return the attribute with this name of the page's module, or the default."""
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
