"""The results of the experiments of page 5 in sentences and tables, with numbers from the results."""

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise

import numpy as np

from ramanujan.accuracy.choices import ClosedForm
from ramanujan.accuracy.extremes import FORMS, INACCURATE, OVERFLOW, PLAUSIBLE, RIGHT, ZERO, Stretch, Sweep
from ramanujan.accuracy.general_solvers import SOLVERS, EigenSweep
from ramanujan.accuracy.phase import PhaseErrors
from ramanujan.accuracy.work_precision import STEPS_PER_PERIOD, CheapestRun, WorkPrecision
from ramanujan.figures.speed import Part
from ramanujan.integrators import METHODS, Method
from ramanujan.numerals import at_least, distinct_from, duration, filled, number, quantity
from ramanujan.pages.speed.downsampling import Run
from ramanujan.translation import _, ngettext

_VISIBLE = 0.05
"""Phase error [rad] that is visible between two machines side by side: about a hundredth of a full turn."""
_ROUNDING, _SMALL, _STEEPER = 1e-12, 0.5, 0.3
"""Errors between which a curve has a slope, and the smallest excess over the order that gets a sentence."""

Table = list[tuple[str, ...]]


def describe_method(method: Method, steps: int) -> str:
    """Return the order of a method, its cost, and whether these steps are stable."""
    turn, limit = 2 * math.pi / steps, method.stability_limit
    cost = ngettext(
        "**{method}** has order {order} and takes one evaluation of the force per step of size h.",
        "**{method}** has order {order} and takes {n:word} evaluations of the force per step of size h.",
        method.evaluations,
    )
    if math.isinf(limit):
        stable = _("It is stable at every step size.")
    elif limit == 0:
        stable = _("Its energy grows at every step size, however small.")
    elif turn > limit:
        stable = _("It is **unstable here**: hΩ = {turn} is beyond its stability limit, {limit}.")
    else:
        stable = _("It is stable up to hΩ = {limit}; here it is {turn}.")
    title = method.title[0].upper() + method.title[1:]
    cost = filled(cost, method=title, order=method.order, n=method.evaluations)
    # The stable angle and the limit are rounded down in the same way, so the limit remains an upper bound.
    write = number if turn > limit else at_least
    turn_and_limit = {"turn": distinct_from(turn, limit, 3, write), "limit": distinct_from(limit, turn, 3, write)}
    return f"{cost} {stable.format(**turn_and_limit)}"


def describe_errors(run: Run) -> str:
    """Name a run, and state its error at the end and whether it is visible."""
    worst = float(np.max(run.energy))
    sentence = ngettext(
        "**{method}, {steps} steps per period, {precision}:** in one period the force was evaluated {cost} times.",
        "**{method}, {steps} steps per period, {precision}:** in {n:word} periods the force was evaluated {cost} "
        "times.",
        run.periods,
    )
    evaluated = filled(
        sentence,
        method=METHODS[run.method].title,
        steps=run.steps,
        precision=run.dtype,
        n=run.periods,
        cost=number(run.evaluations, 3),
    )
    grown = _("Its energy grew to **{factor} times** the true value.")
    if not math.isfinite(worst):
        return " ".join((evaluated, _("The energy has grown beyond the largest floating-point number.")))
    if worst > 1e6:
        return " ".join((evaluated, grown.format(factor=number(1 + worst))))
    turns = abs(run.phase_at_end) / math.tau
    off = (_("{turns} full turns") if turns > 1 else _("{turns} of a full turn")).format(turns=number(turns))
    phase = (
        # TRANSLATORS: {off} is 3 full turns, or 0.2 of a full turn.
        _("At the end the computed machine is **{off} ahead** ({phase}\u202frad).")
        if run.phase_at_end > 0
        else _("At the end the computed machine is **{off} behind** ({phase}\u202frad).")
    ).format(off=off, phase=number(abs(run.phase_at_end)))
    if worst > 1:
        energy = grown.format(factor=number(1 + worst))
    elif worst >= 1e-4:
        energy = filled(_("Its energy was off by up to **{share:2↑ %}**."), share=worst)
    else:
        energy = filled(_("Its relative energy error was at most **{error:2↑}**."), error=worst)
    seen = abs(run.phase_at_end) > _VISIBLE or worst > _VISIBLE
    verdict = _("The difference is visible.") if seen else _("The difference is too small to see.")
    return f"{evaluated} {phase} {energy} {verdict}"


def recommend_run(choices: Sequence[CheapestRun], tolerance: float, by: str, exact: ClosedForm | None) -> str:
    """Name the cheapest run within the tolerance, its cost, and the cost of the closed form."""
    sentences = [_cheapest(choices[0], tolerance, by) if choices else _none_reaches(tolerance)]
    if exact is not None:
        sentence = _("The closed form takes {time} for the last state, and its phase error is {error}\u202frad.")
        sentences.append(sentence.format(time=duration(exact.seconds.median), error=number(exact.phase_error)))
    return " ".join(sentences)


def _cheapest(best: CheapestRun, tolerance: float, by: str) -> str:
    named = (
        _(
            "For an error of at most {tolerance:1↑} of the amplitude, the fastest run on this server is **{method}** "
            "in {precision} with **{steps} steps per period**."
        )
        if by == "seconds"
        else _(
            "For an error of at most {tolerance:1↑} of the amplitude, the run with the fewest evaluations of the force "
            "is **{method}** in {precision} with **{steps} steps per period**."
        )
    )
    cost = _(
        "It takes {run.evaluations:3} evaluations and {time} on this server, and its largest error is {run.error:2}."
    )
    method, time = METHODS[best.method].title, duration(best.seconds)
    run = {"method": method, "precision": best.dtype, "steps": best.steps_per_period, "run": best, "time": time}
    return filled(f"{named} {cost}", tolerance=tolerance, **run)


def _none_reaches(tolerance: float) -> str:
    sentence = _(
        "None of the {methods:word} methods on this page stays within an error of {tolerance} with {most} steps per "
        "period or fewer."
    )
    return filled(sentence, methods=len(METHODS), tolerance=number(tolerance, 1), most=STEPS_PER_PERIOD[-1])


def explain_slope(curves: Sequence[WorkPrecision], run: Callable[[str, int, int, str], Run]) -> str:
    """State by how much each error falls faster than the method's order, and how the phase error falls."""
    fine, sentences = STEPS_PER_PERIOD[-1], []
    for curve in (curve for curve in curves if curve.dtype == "float64"):
        method, n = METHODS[curve.method], curve.steps_per_period
        coarse_error, fine_error = curve.error[n == fine // 2].item(), curve.error[n == fine].item()
        # Errors as large as the motion, and rounding errors, have no slope.
        if not _ROUNDING < fine_error < coarse_error < _SMALL:
            continue
        if math.log2(coarse_error / fine_error) > method.order + _STEEPER:
            coarse, end = (run(curve.method, each, curve.periods, "float64").phase_at_end for each in (fine // 2, fine))
            sentence = _(
                "The method {method} has order {order}, so twice as many steps should divide its error by {expected}. "
                "They divide it by {factor}. A part of it, the phase error, grows from period to period. They divide "
                "that part by {phase}."
            )
            factors = {"expected": 2**method.order, "factor": coarse_error / fine_error, "phase": coarse / end}
            shown = {name: number(factor, 2) for name, factor in factors.items()}
            sentences.append(sentence.format(method=method.title, order=method.order, **shown))
    return " ".join(sentences)


def choice_table(choices: Iterable[CheapestRun]) -> Table:
    """List the cheapest run of each method and precision."""
    rows: Table = [(_("Method"), _("Precision"), _("Steps per period"), _("Error"), _("Evaluations"), _("Time"))]
    for c in choices:
        cost = number(c.evaluations, 3), duration(c.seconds)
        rows.append((METHODS[c.method].title, c.dtype, str(c.steps_per_period), number(c.error), *cost))
    return rows


def failure_table(sweeps: Sequence[Sweep], symbol: str) -> Table:
    """List where and how each form fails; `symbol` is that of the variable of the sweep."""
    rows: Table = [(_("Form"), _("Where it fails"), _("What it returns there"))]
    for sweep in sweeps:
        failures = [
            (_describe_place(each, symbol), _describe_value(sweep, each))
            for each in sweep.stretches
            if each.verdict != RIGHT
        ]
        sound = _("nowhere"), _describe_value(sweep, sweep.stretches[0])
        rows += [(FORMS[sweep.form].title, *cells) for cells in failures or [sound]]
    return rows


def _describe_place(stretch: Stretch, symbol: str) -> str:
    place = _("{symbol} = {first}") if stretch.first == stretch.last else _("{symbol} from {first} to {last}")
    return place.format(symbol=symbol, first=number(float(stretch.first)), last=number(float(stretch.last)))


def describe_strip(sweep: Sweep) -> str:
    """Return the strip of a form in words, from left to right."""
    words = ", ".join(_describe_value(sweep, each) for each in sweep.stretches)
    return _("{form}: {words}").format(form=FORMS[sweep.form].title, words=words)


def strip(sweep: Sweep) -> list[Part]:
    """Return the stretches of a form as parts of its strip."""
    stretches = sweep.stretches
    ends = [*(each.first for each in stretches[1:]), stretches[-1].last]
    return [
        Part(math.log10(each.first), math.log10(end), each.verdict == RIGHT, _describe_value(sweep, each))
        for each, end in zip(stretches, ends, strict=True)
    ]


_RETURNS = {
    # TRANSLATORS: what a formula returns; a list of them follows the name of the formula and a colon.
    RIGHT: _("right to {error} ulp"),
    ZERO: "0",
    OVERFLOW: _("∞ or NaN"),
    PLAUSIBLE: _("{value}: wrong"),
    INACCURATE: _("loses digits"),
}
"""Verdict → description of the returned value."""


def _describe_value(sweep: Sweep, stretch: Stretch) -> str:
    """Return the value of a form in a stretch. −0 differs from 0, and wrong values are represented by their median."""
    inside = sweep.value[(sweep.x >= stretch.first) & (sweep.x <= stretch.last)]
    if stretch.verdict == ZERO and np.signbit(inside).all():
        return "−0"
    usual = number(float(np.median(inside)), 4) if stretch.verdict == PLAUSIBLE else ""
    return _RETURNS[stretch.verdict].format(value=usual, error=number(sweep.worst_right_ulp))


def describe_phases(errors: Sequence[PhaseErrors]) -> str:
    """State when each computation of the phase has lost it, and the largest error of the reduced phase."""
    sentences = [
        _(
            "In float32 the error of the plain product Ω·t reaches 1\u202frad between {before} and {after} periods. "
            "From there on the phase is meaningless and the curve is flat."
        ).format(before=number(before.periods), after=number(after.periods))
        for before, after in pairwise(errors)
        if before.float32 <= 1 < after.float32
    ][:1]
    reduced = _(
        "In float64 the error is {last.float64:2 rad} after {last.periods:2} periods. If Ω/2π is stored in two "
        "floating-point numbers and whole turns are subtracted first, the error never exceeds **{largest:2↑ rad}**."
    )
    sentences.append(filled(reduced, last=errors[-1], largest=max(each.reduced for each in errors)))
    return " ".join(sentences)


def describe_zero_modes(sweeps: Sequence[EigenSweep]) -> str:
    """Name the solvers that find both zero modes exactly, and state how often the others return no frequency."""
    sentences = [
        _("**{solver}** returns a negative or complex eigenvalue for a zero mode in {count} of {all} machines.").format(
            solver=SOLVERS[s.solver].title, count=int(s.lacks_real_frequency.sum()), all=s.error_ulp.size
        )
        for s in sweeps
        if s.dtype == "float64" and s.lacks_real_frequency.any()
    ]
    if sentences:
        sentences.append(
            _(
                "The square root of such a value is not a real number, so a program that computes with real numbers "
                "gets NaN."
            )
        )
    sentences += [
        _("**{solver}** returns exactly 0 for both zero modes, because only one entry of K is not zero.").format(
            solver=SOLVERS[s.solver].title
        )
        for s in sweeps
        if s.dtype == "float64" and np.all(s.zero_modes == 0)
    ]
    return " ".join(sentences)


def zero_mode_table(sweeps: Sequence[EigenSweep]) -> Table:
    """List the solvers with their errors."""
    of_zero = _("Largest eigenvalue that should be 0"), _("Negative or complex")
    rows: Table = [(_("Solver"), _("Precision"), _("Greatest error of Ω²"), *of_zero)]
    for s in sweeps:
        largest, error = (float(np.nanmax(np.abs(each))) for each in (s.zero_modes, s.error_ulp))
        zero = quantity(largest, "rad²/s²") if largest else _("exactly 0")
        count = _("{count} of {all}").format(count=int(s.lacks_real_frequency.sum()), all=s.error_ulp.size)
        rows.append((SOLVERS[s.solver].title, s.dtype, quantity(error, "ulp"), zero, count))
    return rows
