"""A stopwatch."""

from ramanujan.browser import modules
from ramanujan.browser.mounting import has_type_of
from ramanujan.text.translation import _


def mount(key: str) -> float | None:
    """Put a stopwatch on the page. Return its last measured time [s], or None.

    Parameters
    ----------
    key : Streamlit's key of the element
    """
    data = {"start": _("Start"), "stop": _("Stop"), "seconds": _("{seconds}\u202fs")}
    element = modules.component("components/stopwatch/stopwatch")(key=key, data=data, on_seconds_change=lambda: None)
    return element.seconds if has_type_of(element.seconds, 0.0) else None
