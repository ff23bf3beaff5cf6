"""Experiments on the accuracy and the cost of each method to compute the machine.

    work_precision   error of the integrators against evaluations and seconds; the cheapest one for a tolerance
    choices          the choices of the app itself: points of a curve, closed form, kind of arithmetic, caching
    extremes         the forms of Ω² and the general eigenvalue solvers for very large and very small numbers
    phase            the phase after 1 … 1e15 periods
    progress         pieces of work, and timing
    __main__         the results as tables: python -m ramanujan.accuracy --help

Every experiment is an iterator of `Piece`. Each piece takes a few hundredths of a second, reports which share of the
work is done, and carries a result when one is complete. The caller may show progress or stop at any time. Every number
is measured or computed on request. Results are frozen dataclasses.
"""

from ramanujan.accuracy.choices import arithmetics, caching, closed_form, curve_sampling
from ramanujan.accuracy.extremes import FORMS, SOLVERS, eigen_solvers, extremes
from ramanujan.accuracy.phase import phase_errors
from ramanujan.accuracy.progress import Piece, Timing, measure, results
from ramanujan.accuracy.work_precision import cheapest, error_history, work_precision

__all__ = [
    "FORMS",
    "SOLVERS",
    "Piece",
    "Timing",
    "arithmetics",
    "caching",
    "cheapest",
    "closed_form",
    "curve_sampling",
    "eigen_solvers",
    "error_history",
    "extremes",
    "measure",
    "phase_errors",
    "results",
    "work_precision",
]
