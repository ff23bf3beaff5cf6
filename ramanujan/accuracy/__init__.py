"""Experiments on the accuracy and the cost of each method to compute the machine.

    runs             runs of the integrators and their errors
    work_precision   error of the integrators against evaluations and seconds; the cheapest one for a tolerance
    history          one run, with its errors as they grow
    choices          the choices of the app itself: points of a curve, closed form, kind of arithmetic, caching
    extremes         the forms of Ω² for very large and very small numbers
    general_solvers  eigenvalue solvers that know only the machine's matrices
    phase            the phase after 1 … 1e15 periods
    measurement      timing, and the reference arithmetic
    __main__         the results as tables: python -m ramanujan.accuracy --help

Every experiment is a plain function, which measures or computes every number when it is called. Results are frozen
dataclasses.
"""

from ramanujan.accuracy.choices import arithmetics, caching, closed_form, curve_sampling
from ramanujan.accuracy.extremes import FORMS, extremes
from ramanujan.accuracy.general_solvers import SOLVERS, eigen_solvers
from ramanujan.accuracy.history import error_history
from ramanujan.accuracy.measurement import Timing, measure
from ramanujan.accuracy.phase import phase_errors
from ramanujan.accuracy.runs import seconds_per_step
from ramanujan.accuracy.work_precision import cheapest, timed, work_precision

__all__ = [
    "FORMS",
    "SOLVERS",
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
    "seconds_per_step",
    "timed",
    "work_precision",
]
