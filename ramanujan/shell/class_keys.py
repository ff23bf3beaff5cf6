"""What the address of every page says of a class, so that a reload anywhere loses nobody:

    class       the code, in everybody's address; alone it is the link that students get
    lecturer    the lecturer's key, in the lecturer's own address
    wall        beside the code: a large, read-only page that follows the lecturer

*Copy link* leaves out what `address.PRIVATE` names.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import ClassVar

from ramanujan.shell.address import Choice
from ramanujan.translation import _


@dataclass(frozen=True)
class Word:
    """A key of the address that holds a code, or what nobody else can guess; the class itself knows what it opens."""

    bound: ClassVar[bool] = False
    name: str
    form: str
    default: str = ""

    def read(self, text: str) -> str:
        """Return the text; ValueError if it cannot belong to any class."""
        if not re.fullmatch(self.form, text, re.ASCII):
            raise ValueError(self.name)
        return text

    def write(self, text: str) -> str:
        """Return the text as the address has it."""
        return text

    def complaint(self) -> str:
        """Return the sentence for a text that does not fit."""
        return _("The value of {name} in the address was ignored: it belongs to no class.").format(name=self.name)


CLASS = Word("class", "[A-Za-z]{6}")
LECTURER = Word("lecturer", "[A-Z]{6}-[A-Za-z0-9_-]{20,60}")
WALL = Choice("wall", ("on",))
KEYS = (CLASS, LECTURER, WALL)
