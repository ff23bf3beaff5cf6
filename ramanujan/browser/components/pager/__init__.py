"""The slides of a page on a projector."""

from collections.abc import Callable
from typing import Any

from ramanujan.browser import mounting
from ramanujan.text.translation import _


def mount(on_turned: Callable[[str], None]) -> Any:
    """Show one slide of the page at a time, for a projector, with a control that turns the slides.

    A slide is a container with the key "slide-NAME". Its title is the attribute `data-slide` of a node in it.

    Parameters
    ----------
    on_turned : called with the name of the slide, a moment after the last of several turns; with "" for the first slide
    """
    # The closed list shows the numbers, the open one the titles, too. A lecture counts its steps beside them.
    # TRANSLATORS: the number of the present slide of a projector, and the number of all slides.
    data = {"place": _("Slide {now}/{count}") + "\u2003\u2003\u2003{title}"}
    return mounting.mount("components/pager/pager", "pager", data, event="at", on_value=on_turned, type_example="")
