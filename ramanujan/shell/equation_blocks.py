"""Blocks of equations next to the machine."""

from ramanujan.derivation.rows import Row, align

LINE_WIDTH, ROOM = 34, 37
"""Number of characters in a line next to the machine: without and with an operation at its end."""
_LONG_BLOCK = 6
"""Number of lines from which a block has less space between its lines."""


def typeset_beside_machine(rows: list[Row], room: float = ROOM) -> str:
    """Return equations as one block of LaTeX, aligned at the equals signs. Equations “… = 0” are at the left.

    Parameters
    ----------
    rows : the equations
    room : the largest number of characters of an equation with its operation beside it instead of below
    """
    lines = sum(len(row.lines(LINE_WIDTH)) for row in rows)
    space = ".5em" if lines < _LONG_BLOCK else ".3em"
    return align(rows, LINE_WIDTH, space, room)
