"""The results of the experiments as tables, as text or CSV: `python -m ramanujan.accuracy --help`."""

from __future__ import annotations

import argparse
import csv
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import astuple, dataclass
from typing import NoReturn

import numpy as np

from ramanujan.accuracy import (
    FORMS,
    SOLVERS,
    arithmetics,
    caching,
    cheapest,
    closed_form,
    curve_sampling,
    eigen_solvers,
    extremes,
    phase_errors,
    timed,
    work_precision,
)
from ramanujan.accuracy.choices import ARRAY, STATES, Arithmetic, Comparison
from ramanujan.accuracy.extremes import INACCURATE, OVERFLOW, PLAUSIBLE, RIGHT, ZERO, Stretch
from ramanujan.accuracy.runs import LONGEST_RUN, steps_within
from ramanujan.accuracy.work_precision import DTYPES, SHOWN_STEPS, STEPS_PER_PERIOD, WorkPrecision
from ramanujan.integrators import METHODS
from ramanujan.numerals import number
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _, ngettext
from ramanujan.validation import integer

Cell = str | float | int

_VERDICTS = {
    RIGHT: _("right"),
    INACCURATE: _("inaccurate"),
    OVERFLOW: _("overflow or NaN"),
    ZERO: _("zero"),
    PLAUSIBLE: _("wrong but plausible"),
}
_ALONG = {"ratio": _("mass ratio"), "scale": _("scale")}
_CURVES = {"cosine": _("a cosine"), "frequency": _("Ω² over the mass ratio")}
_KINDS = {
    "float32": _("float32"),
    "float64": _("float64"),
    "array": _("float64, one of {n} values in an array"),
    "integers": _("exact integers, rounded once"),
    "fraction": _("exact fraction"),
    "mpmath": _("mpmath, {n} digits"),
}
_COMPARED = {
    "frequency": (_("Ω of a new machine"), _("Ω of the same machine again")),
    "state": (_("one state of a new machine"), _("another state of the same machine")),
    "states": (_("{n} states one by one"), _("{n} states in one call")),
}
"""Comparison → its slow and its fast way."""


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
        # The reader has closed the pipe; what is still in the buffer must not raise an error at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


def _work_precision(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    # Bad settings are refused before the long work, not after it.
    cheapest([], options.tolerance)
    shown = [steps_within(n, integer("periods", options.periods, 1, LONGEST_RUN // 3)) for n in options.steps]
    searched = [*shown, *(n for n in STEPS_PER_PERIOD if n < max(shown))]
    pairs = [(method, dtype) for dtype in _dtypes(options) for method in METHODS]
    curves = [timed(work_precision(method, dtype, options.periods, searched)) for method, dtype in pairs]
    columns = (_("method"), "dtype", _("steps per period"), _("largest error"), _("evaluations"), _("seconds"))
    n = options.periods
    title = ngettext("Error and cost over {n} period", "Error and cost over {n} periods", n).format(n=n)
    quartiles = (_("lower quartile [s]"), _("upper quartile [s]"))
    yield Table(title, columns + quartiles, [row for curve in curves for row in _curve_rows(curve, shown)])
    titles = {
        "evaluations": _("Run of each method with the fewest evaluations for errors of at most {tolerance}"),
        "seconds": _("Fastest run of each method for errors of at most {tolerance}"),
    }
    for by, title in titles.items():
        choices = (astuple(choice) for choice in cheapest(curves, options.tolerance, by))
        rows = [(METHODS[method].title, *costs) for method, *costs in choices]
        yield Table(title.format(tolerance=_short(options.tolerance)), columns, rows)


def _curve_rows(curve: WorkPrecision, shown: Sequence[int]) -> Iterable[tuple[Cell, ...]]:
    at = np.isin(curve.steps_per_period, shown)
    spread = (curve.seconds * each / curve.step.median for each in (curve.step.median, curve.step.low, curve.step.high))
    arrays = (curve.steps_per_period, curve.error, curve.evaluations, *spread)
    rows = zip(*(array[at] for array in arrays), strict=True)
    return ((METHODS[curve.method].title, curve.dtype, *row) for row in rows)


def _choices(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    yield Table(
        _("Points of a curve 400 pixels high"),
        (_("curve"), _("points"), _("error on screen [pixels]"), _("bytes"), _("seconds")),
        [(_CURVES[c.curve], c.points, c.pixels, c.bytes, c.seconds.median) for c in curve_sampling()],
    )
    yield Table(
        _("Closed form"),
        (_("periods"), _("phase error [rad]"), _("seconds for a state")),
        [(c.periods, c.phase_error, c.seconds.median) for c in closed_form(oscillator)],
    )
    yield Table(
        _("Ω²m/k in several kinds of arithmetic"),
        (_("arithmetic"), _("relative error"), _("seconds")),
        [(_kind(a), a.relative_error, a.seconds.median) for a in arithmetics(oscillator.mass_ratio)],
    )
    yield Table(
        _("Time saved by keeping results or computing many at once"),
        (_("slow way"), _("slow way [s]"), _("fast way"), _("fast way [s]"), _("ratio")),
        [_compared(comparison) for comparison in caching(oscillator)],
    )


def _kind(evaluated: Arithmetic) -> str:
    return _KINDS[evaluated.kind].format(n=ARRAY if evaluated.digits is None else evaluated.digits)


def _compared(comparison: Comparison) -> tuple[Cell, ...]:
    slow, fast = (words.format(n=STATES) for words in _COMPARED[comparison.name])
    return slow, comparison.slow_seconds.median, fast, comparison.fast_seconds.median, comparison.ratio


def _extremes(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    ends = (_("from"), _("to"), _("Ω² at the lower end"), _("Ω² at the upper end"))
    worst = _("largest error of a right value [ulp]")
    yield Table(
        _("Forms of Ω² over the range of floating point"),
        (_("form"), "dtype", _("along"), _("verdict"), *ends, worst),
        [
            (FORMS[sweep.form].title, sweep.dtype, _ALONG[sweep.along], *_stretch_cells(stretch), sweep.worst_right_ulp)
            for sweep in extremes(dtypes=_dtypes(options))
            if sweep.along in _ALONG
            for stretch in sweep.stretches
        ],
    )
    yield Table(
        _("General eigenvalue solvers over the mass ratio"),
        (
            _("solver"),
            "dtype",
            _("largest error of the mode [ulp]"),
            _("largest zero mode"),
            _("samples"),
            _("samples with a negative or complex zero mode"),
        ),
        [
            (
                SOLVERS[s.solver].title,
                s.dtype,
                np.nanmax(s.error_ulp),
                np.nanmax(np.abs(s.zero_modes)),
                s.error_ulp.size,
                int(s.without_frequency.sum()),
            )
            for s in eigen_solvers(dtypes=_dtypes(options))
        ],
    )


def _stretch_cells(stretch: Stretch) -> tuple[Cell, ...]:
    return _VERDICTS[stretch.verdict], stretch.first, stretch.last, stretch.first_value, stretch.last_value


def _phase(oscillator: Oscillator, options: argparse.Namespace) -> Iterator[Table]:
    yield Table(
        _("Phase error after many periods"),
        (_("periods"), "fl(Ω)·t, float32 [rad]", "fl(Ω)·t, float64 [rad]", _("reduced phase [rad]")),
        [(p.periods, p.float32, p.float64, p.reduced) for p in phase_errors(oscillator)],
    )


EXPERIMENTS: dict[str, Callable[[Oscillator, argparse.Namespace], Iterator[Table]]] = {
    "work-precision": _work_precision,
    "choices": _choices,
    "extremes": _extremes,
    "phase": _phase,
}


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
    return number(cell, 4, strip=True) if isinstance(cell, float | np.floating) else str(cell)


if __name__ == "__main__":
    sys.exit(main())
