"""Experiments on the accuracy and the cost of each method to compute the machine.

    runs             runs of the integrators, and one of them with its errors as they grow
    work_precision   error of the integrators against evaluations and seconds; the cheapest one for a tolerance
    choices          the choices of the app itself: points of a curve, closed form, kind of arithmetic, caching
    extremes         the forms of Ω² for very large and very small numbers
    exact            Ω² by exact integers and a phase without whole turns: what the app's own formulas are compared with
    general_solvers  eigenvalue solvers that know only the machine's matrices
    phase            the phase after 1 … 1e15 periods
    measurement      timing, and the reference arithmetic

Every experiment is a plain function, which measures or computes every number when it is called. Results are frozen
dataclasses. An experiment trusts its arguments: they come from the choices of a page.
"""
