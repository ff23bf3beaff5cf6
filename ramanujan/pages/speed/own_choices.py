"""What the app itself uses where, why, and the measurement behind it, in sentences for page 5."""

from collections.abc import Iterable

import numpy as np

from ramanujan.accuracy.choices import HEIGHT, STATES, Arithmetic, ClosedForm, Comparison, CurveSampling
from ramanujan.accuracy.extremes import FORMS, RIGHT, Sweep
from ramanujan.numerals import duration, filled
from ramanujan.pages.speed.downsampling import SCREEN_HEIGHT
from ramanujan.translation import _

_CHOICES = (
    _(
        "**Motion, stage and figures**: the closed form. For equal masses of 1 kg and k = 1 N/m its phase error is at "
        "most {phase_error:2} rad from {first} to {last:2} periods. A state takes {state}, however long after the "
        "release."
    ),
    _(
        "**Ω² of a machine**: {machine_formula}. For {machines:2} random machines over the whole range of float64, the "
        "error is at most {machine_error:2} ulp. A value takes {integers}. Fractions give the same digits in "
        "{fraction}."
    ),
    _(
        "**The curve of Ω²m/k**: {curve_formula}, for k = m. It computes whole arrays: a value takes {array} in an "
        "array and {float64} by itself. For the same machines its error is up to {curve_error:2} ulp, and it fails for "
        "{failed} of them."
    ),
    _(
        "**Formulas and steps of the derivation**: exact fractions. One value of Ω² takes {fraction} and has no "
        "error. With mpmath it takes {few} with {few_digits} digits and {many} with {many_digits} digits."
    ),
    _(
        "**Curves**: enough points for an error below half a pixel. In a figure {height} pixels high, {cosine} points "
        "draw one period to {cosine_error:2} pixel, and {frequency} points draw the curve of Ω² to "
        "{frequency_error:2} pixel."
    ),
    _(
        "**Numbers sent to the browser**: float32. They take half the bytes of float64. Rounding changes a number by "
        "at most one part in {part:2}, {finer:2} times less than half a pixel of a screen {screen} pixels high."
    ),
    _("**Ω** is stored with its machine. Reading it again is {kept_frequency:2} times faster than computing it."),
    _("**The solution** is stored with its machine. The next state is {kept_state:2} times faster than the first."),
    _("**Many states** are computed in one call. For {n} states this is {kept_states:2} times faster than one by one."),
)
"""What the app uses where, and why."""


def what_the_app_uses(
    states: list[ClosedForm],
    curves: list[CurveSampling],
    kinds: list[Arithmetic],
    comparisons: list[Comparison],
    sweeps: Iterable[Sweep],
) -> str:
    """List what the app uses where, why, and the measurement behind it."""
    drawn = {each.form: each for each in sweeps if (each.along, each.dtype) == ("machines", "float64")}
    machine, curve = drawn["integers"], drawn["partial_fractions"]
    few, *_others, many = (each for each in kinds if each.kind == "mpmath")
    enough = {name: next(c for c in curves if c.curve == name and c.pixels < 0.5) for name in ("cosine", "frequency")}
    rounding = float(np.finfo(np.float32).eps) / 2
    return filled(
        "\n".join(f"- {sentence}" for sentence in _CHOICES),
        first=states[0].periods,
        last=states[-1].periods,
        phase_error=max(each.phase_error for each in states),
        state=duration(float(np.median([each.seconds.median for each in states]))),
        machines=machine.x.size,
        machine_formula=FORMS[machine.form].formula,
        machine_error=machine.worst_right_ulp,
        curve_formula=FORMS[curve.form].formula,
        curve_error=curve.worst_right_ulp,
        failed=int(np.count_nonzero(curve.verdict != RIGHT)),
        **{each.kind: duration(each.seconds.median) for each in kinds},
        few=duration(few.seconds.median),
        few_digits=few.digits,
        many=duration(many.seconds.median),
        many_digits=many.digits,
        height=HEIGHT,
        **{name: each.points for name, each in enough.items()},
        **{f"{name}_error": each.pixels for name, each in enough.items()},
        part=1 / rounding,
        finer=0.5 / SCREEN_HEIGHT / rounding,
        screen=SCREEN_HEIGHT,
        **{f"kept_{each.name}": each.ratio for each in comparisons},
        n=STATES,
    )
