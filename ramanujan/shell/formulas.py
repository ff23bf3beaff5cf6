"""Blocks of equations next to the machine."""

from ramanujan.derivation.rows import Row, aligned

LINE_WIDTH, ROOM = 34, 37
"""Number of characters of a formula that fit next to the machine, without and with an operation behind it."""
_MANY = 6
"""Style of equations with less space between the lines."""


def beside_the_machine(shown: list[Row], room: float = ROOM) -> str:
    """Return the equations as one block, aligned at the equals signs; those of the form … = 0 at the left."""
    lines = sum(len(each.lines(LINE_WIDTH)) for each in shown)
    return aligned(shown, LINE_WIDTH, ".5em" if lines < _MANY else ".3em", room)
