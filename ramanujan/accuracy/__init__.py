"""Experiments: how exact is each way to compute the machine, and what does it cost?

    work_precision   error of the integrators against evaluations and seconds; the cheapest one for a tolerance
    choices          what the app itself chooses: points per curve, closed form, kind of arithmetic, caching
    extremes         the forms of Ω² and the general eigen-solvers where numbers are very large or very small
    phase            the phase after 1 … 1e15 periods
    progress         pieces of work and measured seconds
    __main__         the same as tables: python -m ramanujan.accuracy --help

Every experiment is an iterator of `Piece`: it works for a few hundredths of a second, then says how much is done and
hands over a result whenever one is complete. Whoever iterates may show progress or simply stop. Every number is
measured or computed when it is asked for. Results are frozen dataclasses; nothing here draws.
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
