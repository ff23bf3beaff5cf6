"""Experiments on the accuracy and the cost of the methods that compute the motion and the frequency.

    measurement      durations of calls, and 50-digit arithmetic for reference values
    exact            Ω² in exact arithmetic, and the phase without whole turns: alternatives to the app's own formulas
    runs             runs of the integrators on the oscillating mode, with their errors at each step
    work_precision   error and cost of the integrators and of the closed form; the cheapest run for a tolerance
    phase            error of the phase after 1 … 1e15 periods
    extremes         equivalent formulas for Ω² with very large and very small parameters
    digits           correct digits of two equivalent formulas, while a parameter moves to an extreme
    general_solvers  eigenvalue solvers that use only the matrices M and K
    arithmetics      time and error of Ω² in float64, float32, integers, fractions and 50 digits

Each experiment is a function that computes or measures its results when it is called. Results are frozen dataclasses.
The arguments are not validated, because a page offers only valid ones.
"""
