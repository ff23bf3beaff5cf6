"""The URL parameters of a class. Every page keeps them, so that a reload loses nobody:

    class       the code, in everybody's address; alone it is the link that students get
    lecturer    the lecturer's key, in the lecturer's own address
    wall        beside the code: a large, read-only page that follows the lecturer
    frame       the browser's random name in a frame of another site, or NOTHING_STORED (browser/frame.js)

*Copy link* leaves out what `address.PRIVATE` names.
"""

from ramanujan.shell.address import Choice, Text
from ramanujan.translation import _

_LONGEST = 60


class Code(Text):
    """The code of a class."""

    def tidied(self, text: str) -> str:
        """Return a code without what separates its letters, such as the space that the wall shows between them."""
        return super().tidied("".join(filter(str.isalnum, text[:_LONGEST])))


_NO_CLASS = _("The value of {name} in the address was ignored: it belongs to no class.")
CLASS = Code("class", "[A-Za-z]{6}", _NO_CLASS)
LECTURER = Text("lecturer", "[A-Z]{6}-[A-Za-z0-9_-]{20,60}", _NO_CLASS)
WALL = Choice("wall", ("on",))
NOTHING_STORED = "none"
FRAME = Text(
    "frame",
    f"[0-9a-f]{{24}}|{NOTHING_STORED}",
    _("The value of {name} in the address was ignored: it is not the name of a browser."),
)
URL_PARAMETERS = (CLASS, LECTURER, WALL, FRAME)
