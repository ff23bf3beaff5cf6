"""Blocks of equations next to the machine."""

import math

from ramanujan.derivation.rows import Row, align, measure_width

LINE_WIDTH, ROOM = 34, 37
"""Number of characters in a line next to the machine: without and with an operation at its end."""
_LONG_BLOCK = 6
"""Number of lines from which a block has less space between its lines."""


_BELOW_MACHINE = 100
"""Number of characters of an equation that is certainly below the machine, where operations have room beside it."""


def typeset_beside_machine(rows: list[Row], room: float = ROOM) -> str:
    """Return equations as one block of LaTeX, aligned at the equals signs. Equations “… = 0” are at the left.

    Parameters
    ----------
    rows : the equations
    room : the largest number of characters of an equation with its operation beside it instead of below
    """
    lines = [line for row in rows for line in row.lines(LINE_WIDTH)]
    space = ".5em" if len(lines) < _LONG_BLOCK else ".3em"
    if max(map(measure_width, lines), default=0) > _BELOW_MACHINE:
        room = math.inf
    return align(rows, LINE_WIDTH, space, room)
