"""The results of the experiments on accuracy as CSV: python -m tests.benchmarks.accuracy.

Each table has a title. A column is a field of a result; the class of the result says what it means. Of the seconds
that were measured, the median is printed.
"""

import argparse
import csv
import sys
from dataclasses import fields

from ramanujan import Oscillator
from ramanujan.accuracy import choices
from ramanujan.accuracy.extremes import extremes
from ramanujan.accuracy.measurement import Timing
from ramanujan.accuracy.phase import phase_errors
from ramanujan.accuracy.work_precision import DTYPES, cheapest, timed, work_precision
from ramanujan.integrators import METHODS

TOLERANCE = 1e-3
"""The largest error relative to the amplitude."""


def tables():
    """Yield the title and the results of every experiment."""
    machine = Oscillator()
    curves = [timed(work_precision(method, dtype, periods=10)) for dtype in DTYPES for method in METHODS]
    yield f"Fewest evaluations for errors of at most {TOLERANCE:g}", cheapest(curves, TOLERANCE)
    yield f"Points of a curve {choices.HEIGHT} pixels high", choices.curve_sampling()
    yield "Closed form", choices.closed_form(machine)
    yield "Ω²m/k in several kinds of arithmetic", choices.arithmetics(machine.mass_ratio)
    yield "What is kept", choices.caching(machine)
    for sweep in extremes():
        if sweep.along != "machines":
            yield f"{sweep.form} in {sweep.dtype} along {sweep.along}", sweep.stretches
    yield "Phase errors [rad] after many periods", phase_errors(machine)


def main():
    """Run every experiment, and print each table when it is ready."""
    argparse.ArgumentParser(prog="python -m tests.benchmarks.accuracy", description=__doc__).parse_args()
    writer = csv.writer(sys.stdout, lineterminator="\n")
    for title, results in tables():
        names = [field.name for field in fields(results[0])]
        writer.writerows([[title], names])
        for values in ([getattr(result, name) for name in names] for result in results):
            writer.writerow([value.median if isinstance(value, Timing) else value for value in values])


if __name__ == "__main__":
    main()
