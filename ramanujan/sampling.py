"""The number of points of a curve on the screen: as many as its error requires, and no more."""

from __future__ import annotations

import math

from ramanujan.numerals import number
from ramanujan.translation import _
from ramanujan.validation import positive

MOST_POINTS = 2**53
"""A curve may not have more points than a float can count."""


def points_for_half_pixel(periods: float, height_px: float = 1080) -> int:
    """Return the fewest equally spaced points that draw a cosine to under half a pixel by straight lines.

        A (1 − cos(Ωh/2)) < ½ px,   nearly  A (Ωh)²/8 < ½ px,   with A = height/2 and h the step

    The left side is the distance between chord and arc at a crest in the middle of a step, the worst case. A steady
    drift adds no error, since straight lines draw it exactly. With `periods` counted in cycles of the curve itself (an
    energy has two in each period of the machine), the bound holds for every curve of this app.

    Parameters
    ----------
    periods : cycles of the curve on screen, positive
    height_px : peak to peak height of the curve [px]; for a closed orbit, the larger of its width and height.
        The default is a curve that fills a screen of 1920×1080.

    Returns
    -------
    the number of points, both ends included: at least 2

    Raises
    ------
    ValueError : a parameter is not a finite positive number, or the curve needs more than 2⁵³ points.

    Source: exact error of linear interpolation of a cosine.

    >>> points_for_half_pixel(periods=2, height_px=450)
    96
    """
    cycles, height = positive("periods", periods), positive("height_px", height_px)
    # 1 − cos δ = 2 sin²(δ/2), solved without the cancellation; a curve under half a pixel high needs no crest at all.
    half_step = 2 * math.asin(min(1.0, math.sqrt(0.5) / math.sqrt(height)))
    intervals = math.pi * cycles / half_step
    if not intervals < MOST_POINTS:
        sentence = _("periods and height_px are too large: the curve would need more than {most} points")
        raise ValueError(sentence.format(most=number(MOST_POINTS)))
    return math.floor(intervals) + 2
