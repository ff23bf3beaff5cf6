"""The pages of the app, in their order: a new page is one line here and one folder in `pages`.

The file draws its page where Streamlit runs it (`if __name__ == "__main__":`), and declares as `URL_PARAMETERS` what it
keeps in the address. Navigation, tests and benchmarks take everything from here.
"""

from collections.abc import Collection
from dataclasses import dataclass
from importlib import import_module
from typing import Any
from urllib.parse import urlsplit

import streamlit as st

from ramanujan.shell.address import URLParameter
from ramanujan.translation import _


@dataclass(frozen=True)
class Page:
    """A page.

    Parameters
    ----------
    name : of its file in this folder
    title : in the navigation and in the browser's tab
    icon : one of the Material symbols
    path : its address; empty for the first page
    quick : what a test or a benchmark adds to the address so that the page computes little
    """

    name: str
    title: str
    icon: str
    path: str = ""
    quick: str = ""

    @property
    def file(self) -> str:
        """The file as `st.page_link` and `AppTest.switch_page` take it."""
        return f"ramanujan/pages/{self.name}/page.py"

    @property
    def address(self) -> str:
        """The address as a test or a benchmark opens it."""
        return f"{self.path}?{self.quick}" if self.quick else self.path

    @property
    def url_parameters(self) -> tuple[URLParameter, ...]:
        """What the page keeps in the address beside the machine."""
        return self._says("URL_PARAMETERS")

    def lead(self) -> bool:
        """Draw the controls with what the page shows above all, and return whether it did; else the sidebar has them.

        Streamlit forgets the sliders of a page's own script when another page comes: this is called outside of it.
        """
        return self._says("lead", lambda: False)()

    def uses_sidebar(self) -> bool:
        """Tell whether the page, as it is now, depends on the sidebar; else the sidebar is folded."""
        return self._says("uses_sidebar", lambda: True)()

    def withheld(self) -> Collection[str]:
        """Return the presets of the sidebar that would tell what the page asks."""
        return self._says("withheld", tuple)()

    def aside(self) -> Collection[str]:
        """Return the parameters that only change how a machine on the page moves: their sliders are folded."""
        return self._says("ASIDE", ())

    def warm_up(self) -> None:
        """Import the page, and let it derive what its first visitor would wait for."""
        self._says("warm_up", lambda: None)()

    def _says(self, name: str, *otherwise: Any) -> Any:
        return getattr(import_module(f"ramanujan.pages.{self.name}.page"), name, *otherwise)


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
    """Tell whether the browser asks for the first page; `navigate` needs not have been called."""
    asked = urlsplit(st.context.url or "").path.rpartition("/")[2]
    return asked not in {page.path for page in PAGES.values() if page.path}


def navigate(hidden: bool) -> tuple[Page, st.Page]:
    """Draw the navigation, unless it is hidden; return the page that was asked for, and what runs it."""
    offered = {
        st.Page(
            page.file,
            title=page.title,
            icon=f":material/{page.icon}:",
            url_path=page.path or None,
            default=not page.path,
        ): page
        for page in PAGES.values()
    }
    runner = st.navigation(list(offered), position="hidden" if hidden else "top")
    page = next(page for page in PAGES.values() if page.path == runner.url_path)
    return page, runner


def tab_title(page: Page) -> str:
    """Return the title of the browser's tab."""
    app = _("Ramanujan’s oscillator")
    return _("{page} – {app}").format(page=page.title, app=app) if page.path else app
