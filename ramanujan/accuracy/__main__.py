"""The experiments as tables: `python -m ramanujan.accuracy --help`.

This module reads the arguments and writes each table as text or CSV; the numbers come from the experiments.
"""

from __future__ import annotations

import argparse
import csv
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import NoReturn

import numpy as np

from ramanujan.accuracy import (
    arithmetics,
    caching,
    cheapest,
    closed_form,
    curve_sampling,
    eigen_solvers,
    extremes,
    phase_errors,
    results,
    work_precision,
)
from ramanujan.accuracy.work_precision import DTYPES, STEPS_PER_PERIOD, WorkPrecision
from ramanujan.integrators import METHODS
from ramanujan.oscillator import Oscillator

Cell = str | float | int


@dataclass(frozen=True)
class Table:
    """A title, the names of the columns with their units, and the rows: text or numbers."""

    title: str
    columns: tuple[str, ...]
    rows: list[tuple[Cell, ...]]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the experiments that the arguments name, print each table when it is ready, and return the exit status.

    >>> main(["--experiment", "phase", "--csv"])  # doctest: +ELLIPSIS
    table,periods,"fl(Ω)·t, float32 [rad]",...
    0
    """
    parser = _parser()
    options = parser.parse_args(arguments)
    write = _write_csv if options.csv else _write_text
    try:
        oscillator = Oscillator(m=options.m, m_prime=options.m_prime, k=options.k)
        for name in EXPERIMENTS if options.experiment == "all" else [options.experiment]:
            for table in EXPERIMENTS[name](oscillator, options):
                write(table)
    except ValueError as error:
        parser.error(str(error))
    except BrokenPipeError:
        # Whoever reads has enough; what is still in the buffer must not complain at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


def _work_precision(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    # A bad tolerance is refused before the long work, not after it.
    cheapest([], options.tolerance)
    curves = results(work_precision(oscillator, options.periods, options.steps, dtypes=_dtypes(options)))
    columns = ("method", "dtype", "steps/period", "state error", "phase error [rad]", "energy error at the end")
    columns += ("largest energy error", "evaluations", "seconds", "lower quartile [s]", "upper quartile [s]")
    rows = [row for curve in curves for row in _curve_rows(curve)]
    yield Table(f"Error and cost after {options.periods} periods", columns, rows)
    for by in ("evaluations", "seconds"):
        choices = cheapest(curves, options.tolerance, by)
        title = f"Cheapest run of each method with state and phase errors up to {options.tolerance:g}, by {by}"
        columns = ("method", "dtype", "steps/period", "state error", "evaluations", "seconds")
        fields = ("dtype", "steps_per_period", "state_error", "evaluations", "seconds")
        rows = [(METHODS[c.method].title, *(getattr(c, field) for field in fields)) for c in choices]
        yield Table(title, columns, rows)


def _curve_rows(curve: WorkPrecision) -> Iterable[tuple[Cell, ...]]:
    arrays = (curve.steps_per_period, curve.state_error, curve.phase_error, curve.energy_error)
    arrays += (curve.largest_energy_error, curve.evaluations, curve.seconds, curve.seconds_low, curve.seconds_high)
    return ((METHODS[curve.method].title, curve.dtype, *row) for row in zip(*arrays, strict=True))


def _choices(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    yield Table(
        "Points of a curve, 400 pixels high",
        ("curve", "points", "error on screen [pixels]", "bytes", "seconds"),
        [(c.curve, c.points, c.pixels, c.bytes, c.seconds.median) for c in results(curve_sampling())],
    )
    yield Table(
        "Closed form",
        ("periods", "phase error [rad]", "seconds for a state"),
        [(c.periods, c.phase_error, c.seconds.median) for c in results(closed_form(oscillator))],
    )
    yield Table(
        "Ω²m/k in several kinds of arithmetic",
        ("arithmetic", "relative error", "seconds"),
        [(a.name, a.relative_error, a.seconds.median) for a in results(arithmetics(oscillator.mass_ratio))],
    )
    yield Table(
        "Computed anew, kept, or asked at once",
        ("slow", "slow [s]", "fast", "fast [s]", "ratio"),
        [(c.slow, c.slow_seconds.median, c.fast, c.fast_seconds.median, c.ratio) for c in results(caching(oscillator))],
    )


def _extremes(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    columns = ("form", "dtype", "along", "verdict", "from", "to", "Ω² at from", "Ω² at to", "worst right [ulp]")
    yield Table(
        "Forms of Ω² over the range of floating point",
        columns,
        [
            (s.form, s.dtype, s.along, x.verdict, x.first, x.last, x.first_value, x.last_value, s.worst_right_ulp)
            for s in results(extremes(dtypes=_dtypes(options)))
            for x in s.stretches
        ],
    )
    yield Table(
        "General eigen-solvers over the mass ratio",
        ("solver", "dtype", "worst mode [ulp]", "largest zero mode", "samples", "with a negative or complex zero mode"),
        [
            (
                s.solver,
                s.dtype,
                np.nanmax(s.error_ulp),
                np.nanmax(np.abs(s.zero_modes)),
                s.error_ulp.size,
                int(s.without_frequency.sum()),
            )
            for s in results(eigen_solvers(dtypes=_dtypes(options)))
        ],
    )


def _phase(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    yield Table(
        "Phase error after many periods",
        ("periods", "fl(Ω)·t, float32 [rad]", "fl(Ω)·t, float64 [rad]", "reduced [rad]"),
        [(p.periods, p.float32, p.float64, p.reduced) for p in results(phase_errors(oscillator))],
    )


EXPERIMENTS: dict[str, Callable[[Oscillator, argparse.Namespace], Iterator[Table]]] = {
    "work-precision": _work_precision,
    "choices": _choices,
    "extremes": _extremes,
    "phase": _phase,
}


class _Parser(argparse.ArgumentParser):
    """A parser whose complaint is one sentence."""

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"Error: {message.rstrip('.')}.\n")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="python -m ramanujan.accuracy",
        description="Measure how exact each way to compute Ramanujan's oscillator is, and what it costs here and now.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    add = parser.add_argument
    add("--experiment", choices=["all", *EXPERIMENTS], default="all", help="which tables to measure")
    add("--periods", type=int, default=10, help="length of each integration, in periods")
    add("--steps", type=int, nargs="+", default=list(STEPS_PER_PERIOD), metavar="N", help="steps per period, from 3 on")
    add("--tolerance", type=float, default=1e-3, help="state and phase error that the cheapest integration may have")
    add("--dtype", choices=["both", *DTYPES], default="both", help="precision of integrations and formulas")
    add("--m", type=float, default=1.0, help="mass m of block, slab and top cylinder [kg]")
    add("--m-prime", type=float, default=1.0, help="mass m′ of hoop and lower cylinder [kg]")
    add("--k", type=float, default=1.0, help="stiffness k of the spring [N/m]")
    add("--csv", action="store_true", help="write CSV; the first column names the table")
    return parser


def _dtypes(options: argparse.Namespace) -> tuple[str, ...]:
    return DTYPES if options.dtype == "both" else (options.dtype,)


def _write_text(table: Table) -> None:
    """Print a title and columns of equal width, numbers with four significant digits."""
    lines = [table.columns, *(tuple(map(_short, row)) for row in table.rows)]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    print(table.title)
    for line in lines:
        print("  " + "  ".join(f"{cell:>{width}}" for cell, width in zip(line, widths, strict=True)))
    print(flush=True)


def _write_csv(table: Table) -> None:
    """Print a header and the rows, numbers with all their digits."""
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(("table", *table.columns))
    writer.writerows((table.title, *row) for row in table.rows)
    sys.stdout.flush()


def _short(cell: Cell) -> str:
    return f"{cell:.4g}" if isinstance(cell, float | np.floating) else str(cell)


if __name__ == "__main__":
    sys.exit(main())
