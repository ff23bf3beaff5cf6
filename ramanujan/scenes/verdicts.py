"""What the experiments of page 5 found, in sentences and tables: every number in them is looked up in the results.

Lives here: words for numbers and findings. Does not live here: widgets, experiments, any number of its own.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from ramanujan.accuracy import FORMS
from ramanujan.accuracy.choices import Arithmetic, ClosedForm, Comparison, CurveSampling
from ramanujan.accuracy.extremes import INACCURATE, OVERFLOW, PLAUSIBLE, RIGHT, ZERO, EigenSweep, Stretch, Sweep
from ramanujan.accuracy.phase import PhaseErrors
from ramanujan.accuracy.work_precision import Choice
from ramanujan.integrators import METHODS, Method
from ramanujan.scenes.thinned import FIGURE_HEIGHT, SCREEN_HEIGHT, Run

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_UNITS = ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns"))
_SEEN = 0.05
"""Phase error [rad] that an eye can see between two machines side by side: about a hundredth of a turn."""

Table = list[tuple[str, ...]]


def number(value: float, digits: int = 2) -> str:
    """Return a number as people write it: 0.033, 12 300, 4.6·10¹⁵³."""
    if not math.isfinite(value):
        return "not a number" if math.isnan(value) else ("∞" if value > 0 else "−∞")
    if value == 0:
        return "0"
    if isinstance(value, int | np.integer) and abs(value) < 10**6:
        return f"{value:,}".replace(",", "\u202f").replace("-", "−")
    mantissa, _, exponent = f"{value:.{digits - 1}e}".partition("e")
    power = int(exponent)
    if -4 < power < 6:
        places = max(digits - 1 - power, 0)
        text = f"{round(value, digits - 1 - power):,.{places}f}".replace(",", "\u202f")
    else:
        mantissa = f"{float(mantissa):g}"
        power_text = f"10{str(power).translate(_SUPERSCRIPTS)}"
        text = power_text if mantissa == "1" else f"{mantissa}·{power_text}"
    return text.replace("-", "−")


def seconds(value: float) -> str:
    """Return a time in the unit that keeps it between 1 and 1000."""
    size, unit = next(((size, unit) for size, unit in _UNITS if value >= size), _UNITS[-1])
    return f"{number(value / size)} {unit}"


def share(value: float) -> str:
    """Return a share of the whole, in percent where that is readable."""
    return f"{number(100 * value)} %" if value >= 1e-4 else f"{number(value)} of it"


def table(rows: Table) -> str:
    """Return rows as a Markdown table; the first row names the columns."""
    lines = [" | ".join(row) for row in rows]
    return "\n".join([lines[0], " | ".join(["---"] * len(rows[0])), *lines[1:]])


def method_facts(method: Method, steps: int) -> str:
    """Say of what order a method is, what it costs, and whether these steps are stable."""
    turn = 2 * math.pi / steps
    evaluations = f"{method.evaluations} evaluation{'s' if method.evaluations > 1 else ''} of the force per step"
    if math.isinf(method.stability_limit):
        stable = "stable at every step"
    elif method.stability_limit == 0:
        stable = "its energy grows at every step, however small"
    elif turn > method.stability_limit:
        stable = f"**unstable here**: hΩ = {number(turn, 3)} is beyond its limit of {number(method.stability_limit, 3)}"
    else:
        stable = f"stable up to hΩ = {number(method.stability_limit, 3)}; here hΩ = {number(turn, 3)}"
    return f"Order {method.order}, {evaluations}, {stable}."


def errors_of(run: Run) -> str:
    """Say how far a run is off at its end, and whether it shows."""
    worst = float(np.max(run.energy))
    evaluations = number(run.evaluations, 3)
    if not math.isfinite(run.energy_at_end) or worst > 1e6:
        return f"After {run.periods} periods and {evaluations} evaluations the energy has grown beyond all measure."
    if worst > 1:
        energy = f"its energy grew to **{number(1 + worst)} times** what it was"
    else:
        energy = f"its energy was off by up to **{share(worst)}**"
    side = "ahead" if run.phase_at_end > 0 else "behind"
    seen = abs(run.phase_at_end) > _SEEN or worst > _SEEN
    verdict = "You see it." if seen else "No eye sees it."
    return (
        f"After {run.periods} periods and {evaluations} evaluations it is **{number(abs(run.phase_at_end))} rad "
        f"{side}**, {energy}. {verdict}"
    )


def what_to_take(choices: Sequence[Choice], tolerance: float, by: str, exact: ClosedForm | None) -> str:
    """Name the cheapest run within the tolerance, its cost, and the closed form's."""
    if choices:
        best = choices[0]
        sentence = (
            f"For an error up to {number(tolerance, 1)} of the amplitude, by {by}: take "
            f"**{METHODS[best.method].title}** in {best.dtype} with **{best.steps_per_period} steps a period**. It "
            f"reaches {number(best.state_error)} with {number(best.evaluations, 3)} evaluations in "
            f"{seconds(best.seconds)} on this server."
        )
    else:
        sentence = f"No method reaches {number(tolerance, 1)} with the steps that were tried."
    if exact is None:
        return sentence
    periods = "1 period" if exact.periods == 1 else f"{exact.periods} periods"
    return (
        f"{sentence} The closed form needs {seconds(exact.seconds.median)} for a state after {periods}, and its phase "
        f"is off by {number(exact.phase_error)} rad."
    )


def choice_table(choices: Iterable[Choice]) -> Table:
    """List the cheapest run of each method and precision."""
    rows: Table = [("method", "precision", "steps a period", "error", "evaluations", "time")]
    for c in choices:
        cells = (METHODS[c.method].title, c.dtype, str(c.steps_per_period), number(c.state_error))
        rows.append((*cells, number(c.evaluations, 3), seconds(c.seconds)))
    return rows


def where_forms_fail(sweeps: Sequence[Sweep], symbol: str) -> str:
    """Say of each form where it fails and what it then returns, and name those that never do."""
    sound = [sweep for sweep in sweeps if set(sweep.verdict) == {RIGHT}]
    lines = [
        f"- **{_form(sweep)}**: " + "; ".join(_failure(sweep, s, symbol) for s in sweep.stretches if s.verdict != RIGHT)
        for sweep in sweeps
        if sweep not in sound
    ]
    if sound:
        worst = max(sweep.worst_right_ulp for sweep in sound)
        names = ", ".join(_form(sweep) for sweep in sound)
        lines.append(f"- **Right over the whole range**, within {number(worst)} ulp: {names}.")
    return "\n".join(lines)


def _form(sweep: Sweep) -> str:
    return FORMS[sweep.form].title


def _failure(sweep: Sweep, stretch: Stretch, symbol: str) -> str:
    low, high = float(sweep.x[0]), float(sweep.x[-1])
    if stretch.first == low:
        where = f"up to {symbol} = {number(stretch.last)}"
    elif stretch.last == high:
        where = f"from {symbol} = {number(stretch.first)} on"
    elif stretch.first == stretch.last:
        where = f"at {symbol} = {number(stretch.first)}"
    else:
        where = f"from {symbol} = {number(stretch.first)} to {number(stretch.last)}"
    inside = sweep.value[(sweep.x >= stretch.first) & (sweep.x <= stretch.last)]
    if stretch.verdict == ZERO:
        zero = "−0" if np.signbit(inside).all() else "0"
        return f"{where} it returns {zero}"
    if stretch.verdict == OVERFLOW:
        return f"{where} it returns no number"
    if stretch.verdict == PLAUSIBLE:
        usual = float(np.median(inside))
        return f"{where} it returns a plausible wrong value, such as {number(usual, 4)}"
    assert stretch.verdict == INACCURATE
    return f"{where} it loses digits"


def how_phases_grow(errors: Sequence[PhaseErrors]) -> str:
    """Say when each way to compute the phase has lost it, and how small the reduced one's error stays."""
    single = next((e.periods for e in errors if e.float32 > 1), None)
    last = errors[-1]
    lost = (
        f"In float32 the plain product Ω·t is off by more than 1 rad from {number(single)} periods on: then it names "
        "any phase at all, and the curve lies flat. "
        if single
        else ""
    )
    return (
        f"{lost}In float64 it is off by {number(last.float64)} rad after {number(last.periods)} periods. Reduced in "
        f"turns, with Ω/2π carried in two doubles, the phase is never off by more than "
        f"**{number(max(e.reduced for e in errors))} rad**."
    )


def zero_modes(sweeps: Sequence[EigenSweep]) -> str:
    """Say which solvers find both zero modes exactly, and how often the others return what is no frequency."""
    exact = [s.solver for s in sweeps if s.dtype == "float64" and np.all(s.zero_modes == 0)]
    others = [s for s in sweeps if s.dtype == "float64" and s.without_frequency.any()]
    lines = [
        f"**{s.solver}** returns a zero mode that is negative or complex in {int(s.without_frequency.sum())} of "
        f"{s.error_ulp.size} machines: its square root is no frequency, and a program that takes it goes on with NaN."
        for s in others
    ]
    if exact:
        lines.append(f"**{' and '.join(exact)}** finds both exactly 0, since K fills only one column there.")
    return " ".join(lines)


def zero_mode_table(sweeps: Sequence[EigenSweep]) -> Table:
    """List the solvers with their errors."""
    rows: Table = [("solver", "precision", "Ω² off by up to", "largest zero mode", "negative or complex")]
    for s in sweeps:
        largest = float(np.nanmax(np.abs(s.zero_modes)))
        rows.append(
            (
                s.solver,
                s.dtype,
                f"{number(float(np.nanmax(s.error_ulp)))} ulp",
                f"{number(largest)} rad²/s²" if largest else "exactly 0",
                f"{int(s.without_frequency.sum())} of {s.error_ulp.size}",
            )
        )
    return rows


def what_the_app_uses(found: Sequence[object], sweeps: Sequence[Sweep]) -> str:
    """List what the app uses where, why, and the measurement behind it."""
    states = [f for f in found if isinstance(f, ClosedForm)]
    curves = [f for f in found if isinstance(f, CurveSampling)]
    kinds = {f.name: f for f in found if isinstance(f, Arithmetic)}
    again = [f for f in found if isinstance(f, Comparison)]
    form = [s for s in sweeps if s.form == list(FORMS)[-1] and s.dtype == "float64"]
    fraction, double, many = kinds["fraction"], kinds["float64"], _many(kinds)
    digits = [kind for name, kind in kinds.items() if name.startswith("mpmath")]
    rounding = float(np.finfo(np.float32).eps) / 2
    rows = [
        (
            "motion, the stage, every figure",
            "the closed form",
            f"from {states[0].periods} to {number(states[-1].periods)} periods its phase is off by at most "
            f"{number(max(s.phase_error for s in states))} rad, and a state takes "
            f"{seconds(float(np.median([s.seconds.median for s in states])))} however late it is",
        ),
        (
            "Ω²",
            FORMS[list(FORMS)[-1]].formula,
            f"one pass over the numbers, right to {number(max(s.worst_right_ulp for s in form))} ulp over the whole "
            f"range of float64; {seconds(many.seconds.median)} a value in an array, "
            f"{seconds(double.seconds.median)} by itself",
        ),
        (
            "formulas and steps of the derivation",
            "exact arithmetic",
            f"a fraction has no error and takes {seconds(fraction.seconds.median)}; mpmath takes "
            f"{seconds(digits[0].seconds.median)} with {digits[0].name.split()[1]} digits and "
            f"{seconds(digits[-1].seconds.median)} with {digits[-1].name.split()[1]}",
        ),
        ("curves on screen", "as many points as half a pixel asks for", _points(curves)),
        (
            "numbers sent to the browser",
            "float32",
            f"half the bytes of float64; rounding moves a number by one part in {number(1 / rounding)} at most, "
            f"{number(0.5 / SCREEN_HEIGHT / rounding)} times finer than half a pixel of a screen "
            f"{SCREEN_HEIGHT} pixels high",
        ),
    ]
    rows += [(c.fast, "kept, or asked at once", f"{number(c.ratio)} times faster than {c.slow}") for c in again]
    return "\n".join(f"- **{where[0].upper()}{where[1:]}**: {what}; {why}." for where, what, why in rows)


def _many(kinds: dict[str, Arithmetic]) -> Arithmetic:
    return next(kind for name, kind in kinds.items() if name.startswith("float64, one of"))


def _points(curves: Sequence[CurveSampling]) -> str:
    """Say how many points each curve needs."""
    words = {"cosine": "a swing", "frequency": "the curve of Ω²"}
    needs = []
    for curve, word in words.items():
        enough = next((c for c in curves if c.curve == curve and c.pixels < 0.5), None)
        if enough:
            needs.append(f"{enough.points} points draw {word} to {number(enough.pixels)} pixel")
    return "; ".join(needs) + f", in a figure {FIGURE_HEIGHT} pixels high"
