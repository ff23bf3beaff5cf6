"""Figures with words so large that a lecture hall can read them: the room that these words need."""

from typing import Any

from plotly.basedatatypes import BaseFigure

from ramanujan.figures.drawn import Drawn

_LEAST = 400
"""Pixels: the height that a figure has at least; where a sheet has more room, it takes it."""
_LINE = 16
"""Letters of an axis title that fit beside one of two panels."""


def in_large_print(figure: BaseFigure) -> Drawn:
    """Return the figure with room for large words, in any height: its axis titles apart.

    >>> from ramanujan.figures import drawn
    >>> sent = drawn([], {"height": 620, "yaxis": {"title": {"text": "displacement relative to the block"}}})
    >>> layout = in_large_print(sent).to_dict()["layout"]
    >>> layout["height"], layout["yaxis"]["title"]["text"]
    (400, 'displacement relative<br>to the block')
    """
    sent = figure.to_dict()
    layout = {**sent["layout"], "height": min(_LEAST, sent["layout"].get("height", _LEAST))}
    for name in [name for name in layout if name.startswith(("xaxis", "yaxis"))]:
        layout[name] = _axis(layout[name], upright=name.startswith("yaxis"))
    return Drawn({**sent, "layout": layout})


def _axis(axis: dict[str, Any], upright: bool) -> dict[str, Any]:
    # The first label of one axis must not touch that of the other.
    axis = {**axis, "ticklabelstandoff": 6}
    if text := axis.get("title", {}).get("text", ""):
        lines = _in_lines(text) if upright else text
        # Plotly measures a power of ten as if its exponent were not there, and a second line as small.
        powers = axis.get("type") == "log" or any("<sup>" in label for label in axis.get("ticktext", ()))
        standoff = 12 + (18 if upright and powers else 0) + (20 if "<br>" in lines else 0)
        axis["title"] = {**axis["title"], "text": lines, "standoff": standoff}
    return axis


def _in_lines(text: str) -> str:
    """Break a long title once, at the space nearest to its middle."""
    if len(text) <= _LINE or "<br>" in text:
        return text
    spaces = [at for at, letter in enumerate(text) if letter == " "]
    middle = min(spaces, key=lambda at: abs(at - len(text) / 2), default=None)
    return text if middle is None else f"{text[:middle]}<br>{text[middle + 1 :]}"
