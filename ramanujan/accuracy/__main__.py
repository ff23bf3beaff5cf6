"""The results of the experiments as tables, as text or CSV: `python -m ramanujan.accuracy --help`.

A column is a field of a result, under that field's name; the class of the result says what it means.
"""

from __future__ import annotations

import argparse
import csv
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import fields
from typing import Any

import numpy as np

from ramanujan.accuracy import choices, work_precision
from ramanujan.accuracy.extremes import extremes
from ramanujan.accuracy.general_solvers import eigen_solvers
from ramanujan.accuracy.measurement import Timing
from ramanujan.accuracy.phase import phase_errors
from ramanujan.accuracy.work_precision import DTYPES, SHOWN_STEPS, WorkPrecision
from ramanujan.integrators import METHODS
from ramanujan.numerals import number
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

MACHINE, PERIODS, TOLERANCE = Oscillator(), 10, 1e-3
"""The machine, the length of each integration [periods], and the largest error relative to the amplitude."""

Row = dict[str, Any]
"""Name of a column → text or number."""
Table = tuple[str, Iterable[Row]]
"""A title, and the rows below it."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one experiment or all, print each table when it is ready, and return the exit status.

    >>> main(["phase", "--csv"])  # doctest: +ELLIPSIS
    table,periods,float32,float64,reduced
    ...
    0
    """
    parser = argparse.ArgumentParser(
        prog="python -m ramanujan.accuracy",
        description=_(
            "Measure the accuracy and the cost of each method to compute Ramanujan’s oscillator on this computer."
        ),
    )
    parser.add_argument("experiment", nargs="?", choices=EXPERIMENTS, help=_("the one to run; all by default"))
    parser.add_argument("--csv", action="store_true", help=_("write CSV; the first column names the table"))
    options = parser.parse_args(arguments)
    write = _write_csv if options.csv else _write_text
    try:
        for name in [options.experiment] if options.experiment else EXPERIMENTS:
            for title, rows in EXPERIMENTS[name]():
                write(title, list(rows))
    except BrokenPipeError:
        # The reader has closed the pipe; what is still in the buffer must not raise an error at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


def _work_precision() -> Iterator[Table]:
    curves = [
        work_precision.timed(work_precision.work_precision(method, dtype, PERIODS))
        for dtype in DTYPES
        for method in METHODS
    ]
    yield _("Error and cost over {n} periods").format(n=PERIODS), (row for curve in curves for row in _runs(curve))
    titles = {
        "evaluations": _("Run of each method with the fewest evaluations for errors of at most {tolerance}"),
        "seconds": _("Fastest run of each method for errors of at most {tolerance}"),
    }
    for by, title in titles.items():
        yield title.format(tolerance=_short(TOLERANCE)), _rows(work_precision.cheapest(curves, TOLERANCE, by))


def _runs(curve: WorkPrecision) -> Iterator[Row]:
    costs = ("steps_per_period", "error", "evaluations", "seconds")
    for run in np.flatnonzero(np.isin(curve.steps_per_period, SHOWN_STEPS)):
        row = {"method": curve.method, "dtype": curve.dtype} | {name: getattr(curve, name)[run] for name in costs}
        steps = row["seconds"] / curve.step.median
        yield row | {"lower_quartile": curve.step.low * steps, "upper_quartile": curve.step.high * steps}


def _choices() -> Iterator[Table]:
    yield _("Points of a curve 400 pixels high"), _rows(choices.curve_sampling())
    yield _("Closed form"), _rows(choices.closed_form(MACHINE))
    yield _("Ω²m/k in several kinds of arithmetic"), _rows(choices.arithmetics(MACHINE.mass_ratio))
    kept = _(
        "Ω and a state of a new machine (slow) and of the same one again (fast); {n} states singly (slow) and in one "
        "call (fast)"
    )
    yield kept.format(n=choices.STATES), _rows(choices.caching(MACHINE), "ratio")


def _extremes() -> Iterator[Table]:
    sweeps = [sweep for sweep in extremes() if sweep.along != "machines"]
    of_form = ("form", "dtype", "along", "worst_right_ulp")
    yield (
        _("Forms of Ω² over the range of floating point"),
        ({name: getattr(s, name) for name in of_form} | row for s in sweeps for row in _rows(s.stretches)),
    )
    yield (
        _("General eigenvalue solvers over the mass ratio"),
        (
            {
                "solver": sweep.solver,
                "dtype": sweep.dtype,
                "error_ulp": np.nanmax(sweep.error_ulp),
                "largest_zero_mode": np.nanmax(np.abs(sweep.zero_modes)),
                "samples": sweep.error_ulp.size,
                "without_frequency": sweep.without_frequency.sum(),
            }
            for sweep in eigen_solvers()
        ),
    )


def _phase() -> Iterator[Table]:
    title = _("Phase error [rad] after many periods: of fl(Ω)·t in float32 and in float64, and of the reduced phase")
    yield title, _rows(phase_errors(MACHINE))


EXPERIMENTS: dict[str, Callable[[], Iterator[Table]]] = {
    "work-precision": _work_precision,
    "choices": _choices,
    "extremes": _extremes,
    "phase": _phase,
}


def _rows(results: Iterable[Any], *properties: str) -> Iterator[Row]:
    """Yield the fields of each result, and some of its properties; of seconds that were measured, the median."""
    for result in results:
        row = {name: getattr(result, name) for name in (*(field.name for field in fields(result)), *properties)}
        yield {name: value.median if isinstance(value, Timing) else value for name, value in row.items()}


def _write_text(title: str, rows: list[Row]) -> None:
    """Print a title and columns of equal width, numbers with four significant digits."""
    lines = [list(rows[0]), *(list(map(_short, row.values())) for row in rows)] if rows else [[_("none")]]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    print(title)
    for line in lines:
        print("  " + "  ".join(f"{cell:>{width}}" for cell, width in zip(line, widths, strict=True)))
    print(flush=True)


def _write_csv(title: str, rows: list[Row]) -> None:
    """Print a header and the rows, numbers with all their digits."""
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerows([("table", *row) for row in rows[:1]])
    writer.writerows((title, *row.values()) for row in rows)
    sys.stdout.flush()


def _short(cell: object) -> str:
    return number(cell, 4, strip=True) if isinstance(cell, float | np.floating) else str(cell)


if __name__ == "__main__":
    sys.exit(main())
