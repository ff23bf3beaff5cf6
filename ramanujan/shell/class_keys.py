"""The URL parameters of a class. They are in the address of every page, so that a reload does not leave the class:

    class       the code of the class; a link with only this parameter is for students
    lecturer    the lecturer's key, only in the lecturer's address
    wall        together with the code: a large, read-only page that follows the lecturer
    frame       whether the page is in a frame (browser/frame.js)

*Copy link* omits the parameters in `address.PRIVATE`.
"""

from ramanujan.classroom import codes
from ramanujan.shell.address import Choice, Text
from ramanujan.text.translation import _


class Code(Text):
    """The code of a class."""

    def read(self, text: str) -> str:
        """Return the letters in capitals, without separators such as the space in a code on the wall."""
        return super().read(codes.read_letters(text))


_NO_CLASS = _("The value of {name} in the address was ignored: it belongs to no class.")
CLASS = Code(codes.URL_PARAMETER, "[A-Z]{6}", _NO_CLASS)
LECTURER = Text("lecturer", "[A-Z]{6}-[A-Za-z0-9_-]{20,60}", _NO_CLASS)
WALL = Choice("wall", ("on",))
FRAME = Choice("frame", ("on",))
COOKIE = "ramanujan_browser"
"""Name of the cookie with the browser's random name."""
URL_PARAMETERS = (CLASS, LECTURER, WALL, FRAME)
