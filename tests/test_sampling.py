"""The number of points a curve is drawn with: the gap between chords and curve, measured."""

import numpy as np
import pytest

from ramanujan.sampling import points_for_half_pixel

CASES = [(1, 1080), (2, 450), (12, 1080), (40, 1080), (0.4, 300), (1000, 600), (3, 1)]


def largest_gap(periods, height_px, points, phases=64):
    """The largest vertical distance [px] between a cosine and its chords, over many phases of the first point."""
    end = 2 * np.pi * periods
    # 32 checks in each step, its middle among them.
    fine = np.linspace(0, end, 32 * (points - 1) + 1)
    knots = np.linspace(0, end, points)
    steps = end / (points - 1)
    worst = 0.0
    # Crests all over the first step, and for an even number of phases one in its middle.
    for shift in steps * np.arange(phases) / phases:
        drawn = np.interp(fine, knots, np.cos(knots - shift))
        worst = max(worst, np.max(np.abs(drawn - np.cos(fine - shift))))
    return worst * height_px / 2


@pytest.mark.parametrize(("periods", "height_px"), CASES)
def test_the_gap_stays_under_half_a_pixel(periods, height_px):
    # A rounding of the interpolated value, 1e-12 of the height, is no visible error.
    assert largest_gap(periods, height_px, points_for_half_pixel(periods, height_px), phases=8) < 0.5 + 1e-9


@pytest.mark.parametrize(("periods", "height_px"), [(1, 1080), (2, 450), (12, 1080), (3, 7)])
def test_not_one_point_is_given_away(periods, height_px):
    assert largest_gap(periods, height_px, points_for_half_pixel(periods, height_px) - 1) >= 0.5
    assert points_for_half_pixel(0.001, 0.01) == 2
