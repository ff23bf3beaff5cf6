"""Blocks of equations beside the machine."""

from ramanujan.derivation.rows import Row, aligned

LINE_WIDTH, ROOM = 34, 37
"""Characters of a formula that fit beside the machine, longer sums are broken; and with an operation behind it."""
_MANY = 6
"""Lines of equations that stand closer together."""


def beside_the_machine(shown: list[Row], room: float = ROOM) -> str:
    """Return the equations as one block, aligned at the equals signs; those that say … = 0, at the left."""
    lines = sum(len(each.lines(LINE_WIDTH)) for each in shown)
    return aligned(shown, LINE_WIDTH, ".5em" if lines < _MANY else ".3em", room)
