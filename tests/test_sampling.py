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


@pytest.mark.parametrize(("periods", "height_px"), CASES)
def test_half_the_points_would_not_do(periods, height_px):
    points = points_for_half_pixel(periods, height_px)
    assert largest_gap(periods, height_px, (points + 1) // 2, phases=8) > 0.5


@pytest.mark.parametrize(("periods", "height_px"), [(1, 1080), (2, 450), (12, 1080), (3, 7)])
def test_not_one_point_is_given_away(periods, height_px):
    assert largest_gap(periods, height_px, points_for_half_pixel(periods, height_px) - 1) >= 0.5


def test_a_sum_of_drift_and_oscillation_needs_no_more():
    points = points_for_half_pixel(5, 800)
    fine = np.linspace(0, 5, 20 * (points - 1) + 1)
    knots = np.linspace(0, 5, points)

    def curve(t):
        return 400 * np.cos(2 * np.pi * t) + 3000 * t

    assert np.max(np.abs(np.interp(fine, knots, curve(knots)) - curve(fine))) < 0.5 + 1e-9


def test_a_closed_orbit_keeps_within_half_a_pixel_of_the_ellipse():
    half_width, half_height = 960, 400
    angle = np.linspace(0, 2 * np.pi, points_for_half_pixel(1, 2 * half_width))
    middle = (angle[1:] + angle[:-1]) / 2
    gap_x = half_width * (np.cos(middle) - (np.cos(angle[1:]) + np.cos(angle[:-1])) / 2)
    gap_y = half_height * (np.sin(middle) - (np.sin(angle[1:]) + np.sin(angle[:-1])) / 2)
    assert np.max(np.hypot(gap_x, gap_y)) < 0.5


def test_it_grows_with_periods_and_with_the_root_of_the_height():
    assert points_for_half_pixel(100, 1000) / points_for_half_pixel(10, 1000) == pytest.approx(10, rel=0.01)
    assert points_for_half_pixel(100, 4000) / points_for_half_pixel(100, 1000) == pytest.approx(2, rel=0.01)
    assert points_for_half_pixel(0.001, 0.01) == 2


@pytest.mark.parametrize("bad", [0, -1, np.nan, np.inf, None, "many"])
def test_bad_input_is_named(bad):
    with pytest.raises(ValueError, match="periods"):
        points_for_half_pixel(bad)
    with pytest.raises(ValueError, match="height_px"):
        points_for_half_pixel(1, bad)
