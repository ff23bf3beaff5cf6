"""The results of the experiments of page 5 in sentences and tables, with numbers from the results."""

import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise

import numpy as np

from ramanujan.accuracy.arithmetics import ARITHMETICS, Price
from ramanujan.accuracy.extremes import FORMS, INACCURATE, OVERFLOW, RIGHT, Stretch, Sweep
from ramanujan.accuracy.general_solvers import SOLVERS, EigenSweep
from ramanujan.accuracy.phase import PhaseErrors
from ramanujan.accuracy.work_precision import STEPS_PER_PERIOD, ClosedForm, Run
from ramanujan.pages.speed.downsampling import SampledRun
from ramanujan.physics.integrators import METHODS, Method
from ramanujan.text.numerals import at_least, distinct_from, duration, filled, length, number, quantity
from ramanujan.text.translation import _, ngettext

_VISIBLE = 0.05
"""Phase error [rad] that is visible between two machines side by side: about a hundredth of a full turn."""

_DAY = 86400.0
"""[s]"""
_YEAR = 365.25 * _DAY
"""[s]"""

Table = list[tuple[str, ...]]


def describe_method(method: Method) -> str:
    """Return the idea of a method, its cost, and what its order means."""
    sentence = ngettext(
        "**{method}** {idea}. It evaluates the force once per step. It has order {order}: if steps are small, half the "
        "step size leaves about 1/{factor} of the error.",
        "**{method}** {idea}. It evaluates the force {n} times per step. It has order {order}: if steps are small, "
        "half the step size leaves about 1/{factor} of the error.",
        method.evaluations,
    )
    title = method.title[0].upper() + method.title[1:]
    more = {"order": method.order, "factor": 2**method.order, "n": method.evaluations}
    return filled(sentence, method=title, idea=method.idea, **more)


def method_table() -> Table:
    """List the methods with their ideas, costs, orders and least numbers of steps."""
    head = (
        _("Method"),
        _("In a step, it"),
        _("Evaluations of the force"),
        _("Half the step size leaves"),
        _("Stable with steps per period"),
    )
    rows: Table = [head]
    for method in METHODS.values():
        limit = method.stability_limit
        stable = _("at least {least}").format(least=math.ceil(math.tau / limit)) if limit else _("never")
        if math.isinf(limit):
            stable = _("always")
        factor = _("1/{factor} of the error (order {order})").format(factor=2**method.order, order=method.order)
        rows.append((method.title, method.idea, str(method.evaluations), factor, stable))
    return rows


def explain_equal_phases() -> str:
    """Explain why the phase errors of two methods end at the same point."""
    sentence = _(
        "The phase errors of {euler} and {verlet} meet after many periods: on average, both turn by the same angle in "
        "each step."
    )
    euler, verlet = (METHODS[name].title for name in ("symplectic_euler", "velocity_verlet"))
    return sentence.format(euler=euler, verlet=verlet)


def describe_stability(method: Method, steps: int) -> str:
    """Return whether a method with these steps per period is stable."""
    step_angle = 2 * math.pi / steps  # hΩ
    limit = method.stability_limit
    if math.isinf(limit):
        stable = _("It is stable at every step size.")
    elif limit == 0:
        stable = _("Its energy grows at every step size, however small.")
    elif step_angle > limit:
        stable = _("It is **unstable here**: hΩ = {turn} is beyond its stability limit, {limit}.")
    else:
        stable = _("It is stable up to hΩ = {limit}; here it is {turn}.")
    # Below the limit both numbers are rounded down, so the limit remains an upper bound of stable angles.
    write = number if step_angle > limit else at_least
    angle_text = distinct_from(step_angle, limit, 3, write)
    limit_text = distinct_from(limit, step_angle, 3, write)
    return stable.format(turn=angle_text, limit=limit_text)


def describe_errors(run: SampledRun) -> str:
    """Name a run, and state its error at the end and whether it is visible."""
    energy_error = float(np.max(run.energy))
    sentence = ngettext(
        "**{method}, {steps} steps per period:** in one period the force was evaluated {cost} times.",
        "**{method}, {steps} steps per period:** in {n} periods the force was evaluated {cost} times.",
        run.periods,
    )
    evaluated = filled(
        sentence,
        method=METHODS[run.method].title,
        steps=run.steps,
        n=run.periods,
        cost=number(run.evaluations, 3),
    )
    grown = _("Its energy grew to **{factor} times** the true value.")
    if not math.isfinite(energy_error):
        return " ".join((evaluated, _("The energy has grown beyond the largest floating-point number.")))
    if energy_error > 1e6:
        return " ".join((evaluated, grown.format(factor=number(1 + energy_error))))
    phase = _describe_phase(run.phase_at_end)
    if energy_error > 1:
        energy = grown.format(factor=number(1 + energy_error))
    elif energy_error >= 1e-4:
        energy = filled(_("Its energy was off by up to **{share:2↑ %}**."), share=energy_error)
    else:
        energy = filled(_("Its relative energy error was at most **{error:2↑}**."), error=energy_error)
    is_visible = abs(run.phase_at_end) > _VISIBLE or energy_error > _VISIBLE
    verdict = _("The difference is visible.") if is_visible else _("The difference is too small to see.")
    return f"{evaluated} {phase} {energy} {verdict}"


def _describe_phase(error: float) -> str:
    """Describe the phase error [rad] at the end of a run, in turns."""
    turns = abs(error) / math.tau
    off = _("{turns} full turns") if turns > 1 else _("{turns} of a full turn")
    if error > 0:
        # TRANSLATORS: {off} is 3 full turns, or 0.2 of a full turn.
        sentence = _("At the end the computed machine is **{off} ahead**.")
    else:
        sentence = _("At the end the computed machine is **{off} behind**.")
    return sentence.format(off=off.format(turns=number(turns)))


def recommend_run(choices: Sequence[Run], tolerance: float, by: str) -> str:
    """Name the cheapest run within the tolerance, and its cost.

    Parameters
    ----------
    choices : the cheapest run of each method and precision, the cheapest of all first
    tolerance : largest error [turns]
    by : kind of cost, "evaluations" or "seconds"
    """
    if not choices:
        return _none_reaches(tolerance)
    sentences = [_recommend(choices[0], tolerance, by)]
    if len(choices) > 1:
        sentences.append(_compare_costs(choices[0], choices[-1], by))
    return " ".join(sentences)


def describe_tolerance(tolerance: float, compression: float) -> str:
    """State the error of the spring's length for a phase error of `tolerance` turns.

    The lengths x₀ cos Ωt and x₀ cos(Ωt + 2πδ) differ by at most 2x₀ sin πδ.

    Parameters
    ----------
    tolerance : phase error δ [turns]
    compression : x₀ [m]
    """
    sentence = _("With {tolerance:1} of a turn, the length of the spring can be off by {length}.")
    return filled(sentence, tolerance=tolerance, length=length(2 * compression * math.sin(math.pi * tolerance)))


def describe_closed_form(exact: ClosedForm) -> str:
    """State the cost and the error of the closed form."""
    sentence = _("The closed form, one formula for every time, takes {time}, and it is off by {error} of a turn.")
    return sentence.format(time=duration(exact.seconds), error=number(exact.error))


def describe_tried_run(run: Run, tolerance: float) -> str:
    """Name the visitor's own run, its cost, and whether its error is within the tolerance [turns]."""
    if run.error > tolerance:
        sentence = _(
            "◆ **Your run**, {method} with {steps} steps per period, takes {cost:3} evaluations. Its error, {error:2↑} "
            "of a turn, is too large."
        )
    else:
        sentence = _(
            "◆ **Your run**, {method} with {steps} steps per period, takes {cost:3} evaluations. Its error, {error:2↑} "
            "of a turn, is small enough."
        )
    method, steps = METHODS[run.method].title, run.steps_per_period
    return filled(sentence, method=method, steps=steps, cost=run.evaluations, error=run.error)


def _recommend(best: Run, tolerance: float, by: str) -> str:
    """Name the cheapest run by a kind of cost, with its cost."""
    if by == "seconds":
        sentence = _(
            "For an error of at most {tolerance:1↑} of a turn, **{method}** with **{steps} steps per period** is the "
            "fastest: it takes **{time}** on this server."
        )
    else:
        sentence = _(
            "For an error of at most {tolerance:1↑} of a turn, **{method}** with **{steps} steps per period** is the "
            "cheapest: it takes **{evaluations} evaluations** of the force."
        )
    names = {"method": METHODS[best.method].title, "steps": best.steps_per_period}
    costs = {"evaluations": best.evaluations, "time": duration(best.seconds)}
    return filled(sentence, tolerance=tolerance, **names, **costs)


def _compare_costs(best: Run, dearest: Run, by: str) -> str:
    """State how many times the cost of the best run the dearest one has."""
    sentence = _("{method} takes {times:2} times as many.")
    if by == "seconds":
        sentence = _("{method} takes {times:2} times as long.")
    name = METHODS[dearest.method].title
    return filled(sentence, method=name[0].upper() + name[1:], times=getattr(dearest, by) / getattr(best, by))


def _none_reaches(tolerance: float) -> str:
    """State that no run has an error within the tolerance."""
    sentence = _(
        "None of the {methods} methods on this page stays within {tolerance} of a turn with {most} steps per "
        "period or fewer."
    )
    return filled(sentence, methods=len(METHODS), tolerance=number(tolerance, 1), most=STEPS_PER_PERIOD[-1])


def choice_table(choices: Iterable[Run]) -> Table:
    """List the cheapest run of each method and precision."""
    rows: Table = [
        (
            _("Method"),
            _("Digits"),
            _("Steps per period"),
            _("Largest error [turns]"),
            _("Evaluations of the force"),
            _("Time on this server"),
        )
    ]
    for choice in choices:
        row = (
            METHODS[choice.method].title,
            str(np.finfo(choice.dtype).precision + 1),
            str(choice.steps_per_period),
            number(choice.error),
            number(choice.evaluations, 3),
            duration(choice.seconds),
        )
        rows.append(row)
    return rows


def failure_table(sweeps: Sequence[Sweep], symbol: str) -> Table:
    """List where and how each form fails; `symbol` is that of the variable of the sweep."""
    rows: Table = [(_("Form of Ω²"), _("Precision"), _("Where it fails"), _("What it returns there"))]
    for sweep in sweeps:
        form = FORMS[sweep.form]
        head = f"**{form.title}:** {form.formula}", sweep.dtype
        failures = [stretch for stretch in sweep.stretches if stretch.verdict != RIGHT]
        for stretch in failures:
            rows.append((*head, _describe_range(stretch, symbol), _describe_value(sweep, stretch)))
        if not failures:
            rows.append((*head, _("nowhere"), _describe_value(sweep, sweep.stretches[0])))
    return rows


def _describe_range(stretch: Stretch, symbol: str) -> str:
    """Return the range of a stretch in words."""
    template = _("{symbol} = {first}") if stretch.first == stretch.last else _("{symbol} from {first} to {last}")
    return template.format(symbol=symbol, first=number(float(stretch.first)), last=number(float(stretch.last)))


def _describe_value(sweep: Sweep, stretch: Stretch) -> str:
    """Describe the values of a form in a stretch. Of wrong numbers, the median is named."""
    if stretch.verdict == RIGHT:
        digits = count_digits(sweep.worst_right_ulp, sweep.dtype)
        return _("right to {digits} digits").format(digits=digits)
    if stretch.verdict == INACCURATE:
        return _("loses digits")
    values = sweep.value[(sweep.x >= stretch.first) & (sweep.x <= stretch.last)]
    if stretch.verdict == OVERFLOW:
        kinds = {"NaN": np.isnan(values), "∞": np.isinf(values)}
        returned = "/".join(kind for kind, is_kind in kinds.items() if is_kind.any())
    else:
        returned = number(abs(float(np.median(values))), 4)  # a form may return −0
    # TRANSLATORS: what a formula returns wrongly: 0, ∞, NaN or another number.
    return _("gives {value}").format(value=returned)


def count_digits(ulp: float, dtype: str) -> int:
    """Return the number of correct decimal digits of a value whose error is at most `ulp` units in its last place.

    >>> count_digits(1.5, "float64"), count_digits(1.5, "float32"), count_digits(1e20, "float64")
    (15, 6, 0)
    """
    # A unit in the last place is at most the machine epsilon times the value.
    relative_error = max(ulp, 0.5) * float(np.finfo(dtype).eps)
    return max(0, math.floor(-math.log10(relative_error)))


def describe_phases(errors: Sequence[PhaseErrors], period: float) -> str:
    """State when the phase in float32 becomes meaningless, and its errors in float64 with and without reduction.

    Parameters
    ----------
    errors : after 1, 10, 100, … periods
    period : of the machine [s]
    """
    sentences = [_("The phase Ω·t counts the whole turns. The more turns, the fewer digits remain for the position.")]
    for before, after in pairwise(errors):
        if before.float32 <= 1 < after.float32:
            sentence = _(
                "With **7 digits**, it is lost between {before:1} and {after:1} periods, within **{days:1↑} days** of "
                "motion."
            )
            # The sentence has a plural. “Within 2 days” is also true of a shorter time.
            days = max(2.0, after.periods * period / _DAY)
            sentences.append(filled(sentence, before=before.periods, after=after.periods, days=days))
            break
    reduced = _(
        "With **16 digits**, it lasts longer: after {last.periods:2} periods, or **{years:2} million years**, it is "
        "off by {last.float64:1 rad}. Subtract whole turns first, with twice as many digits of Ω: it stays within "
        "**{largest:1↑ rad}**."
    )
    years = errors[-1].periods * period / (1e6 * _YEAR)
    largest = max(entry.reduced for entry in errors)
    sentences.append(filled(reduced, last=errors[-1], years=years, largest=largest))
    return " ".join(sentences)


def describe_zero_modes(sweeps: Sequence[EigenSweep]) -> str:
    """Name the solvers that find both zero modes exactly, and state how often the others return no frequency."""
    float64_sweeps = [sweep for sweep in sweeps if sweep.dtype == "float64"]
    sentences = []
    for sweep in float64_sweeps:
        count = int(sweep.lacks_real_frequency.sum())
        if count:
            sentence = _(
                "**{solver}** returns a negative or complex eigenvalue for a zero mode in {count} of {all} machines."
            )
            title = SOLVERS[sweep.solver].title
            sentences.append(sentence.format(solver=title, count=count, all=sweep.error_ulp.size))
    if sentences:
        sentences.append(
            _(
                "The square root of such a value is not a real number, so a program that computes with real numbers "
                "gets NaN."
            )
        )
    for sweep in float64_sweeps:
        if np.all(sweep.zero_modes == 0):
            sentence = _("**{solver}** returns exactly 0 for both zero modes, because only one entry of K is not zero.")
            sentences.append(sentence.format(solver=SOLVERS[sweep.solver].title))
    return " ".join(sentences)


def zero_mode_table(sweeps: Sequence[EigenSweep]) -> Table:
    """List the solvers with their errors."""
    head = (
        _("Solver"),
        _("Precision"),
        _("Correct digits of Ω²"),
        _("Largest eigenvalue that should be 0"),
        _("Negative or complex"),
    )
    rows: Table = [head]
    for sweep in sweeps:
        digits = str(count_digits(float(np.nanmax(np.abs(sweep.error_ulp))), sweep.dtype))
        largest = float(np.nanmax(np.abs(sweep.zero_modes)))
        zero = quantity(largest, "rad²/s²") if largest else _("exactly 0")
        count = _("{count} of {all}").format(count=int(sweep.lacks_real_frequency.sum()), all=sweep.error_ulp.size)
        rows.append((SOLVERS[sweep.solver].title, sweep.dtype, digits, zero, count))
    return rows


def arithmetic_table(prices: Mapping[str, Price]) -> Table:
    """List the kinds of arithmetic with their times and errors."""
    rows: Table = [(_("Arithmetic"), _("Time for one Ω²"), _("Largest relative error"))]
    for name, price in prices.items():
        rows.append((ARITHMETICS[name].title, duration(price.seconds), number(price.error)))
    return rows
