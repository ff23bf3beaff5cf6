"""The services of every page."""

from collections.abc import Callable

from ramanujan.browser import modules
from ramanujan.text.translation import _


def mount(theme: str, needs_second_run: bool, on_moving: Callable[[], None]) -> bool:
    """Mount the services of every page, before all other elements. Return whether the page's machine moves.

    services.js lists the services. Among them are:

    - the page's live region for the topic `announce`
    - a notice while the page has no connection to the server
    - keyboard access to boxes that scroll sideways
    - a new run of the page after a switch of the theme, because the server draws the figures
    - a ring at the current machine on a curve. The `meta` of the figure's layout contains the ring's colour, and its
      axes are the mass ratio ε and Ω²m/k.

    Parameters
    ----------
    theme : theme of this run, light or dark
    needs_second_run : whether the page requests a second run once the machine has drawn its first frame
    on_moving : called before the second run
    """
    data = {
        "theme": theme,
        "needs_second_run": needs_second_run,
        "away": _("Reconnecting to the server. The page keeps everything that you set."),
        "label": _("Wide content: scroll it with the arrow keys"),
        "ring": {"stage": "oscillator", "label": _("Your machine: ε = {ratio}, Ω²m/k = {normalized}")},
    }
    services = modules.component("components/services/services")
    return bool(
        services(key="unseen-services", data=data, on_switched_change=lambda: None, on_moving_change=on_moving).moving
    )
