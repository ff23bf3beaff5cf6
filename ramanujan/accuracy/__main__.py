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
from typing import Any, NoReturn

import numpy as np

from ramanujan.accuracy import choices, work_precision
from ramanujan.accuracy.extremes import extremes
from ramanujan.accuracy.general_solvers import eigen_solvers
from ramanujan.accuracy.measurement import Timing
from ramanujan.accuracy.phase import phase_errors
from ramanujan.accuracy.runs import LONGEST_RUN, steps_within
from ramanujan.accuracy.work_precision import DTYPES, SHOWN_STEPS, STEPS_PER_PERIOD, WorkPrecision
from ramanujan.integrators import METHODS
from ramanujan.numerals import number
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _, ngettext
from ramanujan.validation import integer

Row = dict[str, Any]
"""Name of a column → text or number."""
Table = tuple[str, Iterable[Row]]
"""A title, and the rows below it."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the experiments that the arguments name, print each table when it is ready, and return the exit status.

    >>> main(["--experiment", "phase", "--csv"])  # doctest: +ELLIPSIS
    table,periods,float32,float64,reduced
    ...
    0
    """
    parser = _parser()
    options = parser.parse_args(arguments)
    options.dtypes = DTYPES if options.dtype == "both" else (options.dtype,)
    write = _write_csv if options.csv else _write_text
    try:
        oscillator = Oscillator(m=options.m, m_prime=options.m_prime, k=options.k)
        for name in EXPERIMENTS if options.experiment == "all" else [options.experiment]:
            for title, rows in EXPERIMENTS[name](oscillator, options):
                write(title, list(rows))
    except ValueError as error:
        parser.error(str(error))
    except BrokenPipeError:
        # The reader has closed the pipe; what is still in the buffer must not raise an error at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


def _work_precision(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    # Bad settings are refused before the long work, not after it.
    work_precision.cheapest([], options.tolerance)
    n = options.periods
    shown = [steps_within(each, integer("periods", n, 1, LONGEST_RUN // 3)) for each in options.steps]
    searched = [*shown, *(each for each in STEPS_PER_PERIOD if each < max(shown))]
    pairs = [(method, dtype) for dtype in options.dtypes for method in METHODS]
    curves = [work_precision.timed(work_precision.work_precision(*pair, n, searched)) for pair in pairs]
    title = ngettext("Error and cost over {n} period", "Error and cost over {n} periods", n).format(n=n)
    yield title, (row for curve in curves for row in _runs(curve, shown))
    titles = {
        "evaluations": _("Run of each method with the fewest evaluations for errors of at most {tolerance}"),
        "seconds": _("Fastest run of each method for errors of at most {tolerance}"),
    }
    for by, title in titles.items():
        yield (
            title.format(tolerance=_short(options.tolerance)),
            _rows(work_precision.cheapest(curves, options.tolerance, by)),
        )


def _runs(curve: WorkPrecision, shown: Sequence[int]) -> Iterator[Row]:
    costs = ("steps_per_period", "error", "evaluations", "seconds")
    for run in np.flatnonzero(np.isin(curve.steps_per_period, shown)):
        row = {"method": curve.method, "dtype": curve.dtype} | {name: getattr(curve, name)[run] for name in costs}
        steps = row["seconds"] / curve.step.median
        yield row | {"lower_quartile": curve.step.low * steps, "upper_quartile": curve.step.high * steps}


def _choices(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    yield _("Points of a curve 400 pixels high"), _rows(choices.curve_sampling())
    yield _("Closed form"), _rows(choices.closed_form(oscillator))
    yield _("Ω²m/k in several kinds of arithmetic"), _rows(choices.arithmetics(oscillator.mass_ratio))
    kept = _(
        "Ω and a state of a new machine (slow) and of the same one again (fast); {n} states singly (slow) and in one "
        "call (fast)"
    )
    yield kept.format(n=choices.STATES), _rows(choices.caching(oscillator), "ratio")


def _extremes(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    sweeps = [sweep for sweep in extremes(dtypes=options.dtypes) if sweep.along != "machines"]
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
            for sweep in eigen_solvers(dtypes=options.dtypes)
        ),
    )


def _phase(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    title = _("Phase error [rad] after many periods: of fl(Ω)·t in float32 and in float64, and of the reduced phase")
    yield title, _rows(phase_errors(oscillator))


EXPERIMENTS: dict[str, Callable[[Oscillator, argparse.Namespace], Iterator[Table]]] = {
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


class _Parser(argparse.ArgumentParser):
    """A parser that reports an error in one sentence."""

    def error(self, message: str) -> NoReturn:
        sentence = _("Error: {problem}.").format(problem=message.rstrip("."))
        self.exit(2, f"{sentence}\n")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="python -m ramanujan.accuracy",
        description=_(
            "Measure the accuracy and the cost of each method to compute Ramanujan’s oscillator on this computer."
        ),
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    add = parser.add_argument
    add("--experiment", choices=["all", *EXPERIMENTS], default="all", help=_("the tables to measure"))
    add("--periods", type=int, default=10, help=_("length of each integration in periods"))
    add(
        "--steps",
        type=int,
        nargs="+",
        default=list(SHOWN_STEPS),
        metavar="N",
        help=_("steps per period in the table, at least 3"),
    )
    add(
        "--tolerance",
        type=float,
        default=1e-3,
        help=_("largest error of the cheapest integration, relative to the amplitude"),
    )
    add("--dtype", choices=["both", *DTYPES], default="both", help=_("precision of integrations and formulas"))
    add("--m", type=float, default=1.0, help=_("mass m of block, slab and top cylinder [kg]"))
    add("--m-prime", type=float, default=1.0, help=_("mass m′ of hoop and lower cylinder [kg]"))
    add("--k", type=float, default=1.0, help=_("stiffness k of the spring [N/m]"))
    add("--csv", action="store_true", help=_("write CSV; the first column names the table"))
    return parser


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
