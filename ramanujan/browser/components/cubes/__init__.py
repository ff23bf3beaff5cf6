"""Stacks of cubes, made of unit cubes."""

from collections.abc import Sequence
from typing import Any

from ramanujan.browser import modules
from ramanujan.text.translation import _


def mount(sums: Sequence[Sequence[int]], alternatives: Sequence[str], captions: Sequence[str], total: int) -> Any:
    """Put stacks of cubes, made of unit cubes, side by side on the page. The reader can turn them and pull them apart.

    Parameters
    ----------
    sums : for each stack, the sides of its cubes in unit cubes
    alternatives, captions : for each stack, its text alternative and its caption
    total : the number of unit cubes of each stack, which ends its caption
    """
    data = {
        "sums": [list(sides) for sides in sums],
        "alternatives": list(alternatives),
        "captions": list(captions),
        "total": str(total),
        "words": {"degrees": _("{angle} degrees")},
    }
    return modules.component("components/cubes/cubes")(key="cubes", data=data)
