"""Experiments on the accuracy and the cost of each method to compute the machine.

    runs             runs of the integrators and their errors
    work_precision   error of the integrators against evaluations and seconds; the cheapest one for a tolerance
    history          one run and the exact motion, with the errors as they grow
    choices          the choices of the app itself: points of a curve, closed form, kind of arithmetic, caching
    extremes         the forms of Ω² for very large and very small numbers
    general_solvers  eigenvalue solvers that know only the machine's matrices
    phase            the phase after 1 … 1e15 periods
    progress         pieces of work, and timing
    __main__         the results as tables: python -m ramanujan.accuracy --help

Every experiment is an iterator of `Piece`. Each piece takes a few hundredths of a second, reports which share of the
work is done, and carries a result when one is complete. The caller may show progress or stop at any time. Every number
is measured or computed on request. Results are frozen dataclasses.
"""

from ramanujan.accuracy.choices import arithmetics, caching, closed_form, curve_sampling
from ramanujan.accuracy.extremes import FORMS, extremes
from ramanujan.accuracy.general_solvers import SOLVERS, eigen_solvers
from ramanujan.accuracy.history import error_history
from ramanujan.accuracy.phase import phase_errors
from ramanujan.accuracy.progress import Piece, Timing, measure, results
from ramanujan.accuracy.work_precision import cheapest, work_precision

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
