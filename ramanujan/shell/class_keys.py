"""The URL parameters of a class. They are in the address of every page, so that a reload does not leave the class:

    class       the code of the class; a link with only this parameter is for students
    lecturer    the lecturer's key, only in the lecturer's address
    wall        together with the code: a large, read-only page that follows the lecturer
    frame       the browser's random name in a frame of another site, or NOTHING_STORED (browser/frame.js)

*Copy link* omits the parameters in `address.PRIVATE`.
"""

from ramanujan.shell.address import Choice, Text
from ramanujan.translation import _

_LONGEST = 60
"""Number of characters of a typed code that are read."""


class Code(Text):
    """The code of a class."""

    def tidy(self, text: str) -> str:
        """Remove separators between the letters, such as the space in a code on the wall."""
        letters = "".join(filter(str.isalnum, text[:_LONGEST]))
        return super().tidy(letters)


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
