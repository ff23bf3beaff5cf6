"""What the app itself uses where, why, and the measurement behind it, in sentences for page 5."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ramanujan.accuracy.choices import HEIGHT, STATES, Arithmetic, ClosedForm, Comparison, CurveSampling
from ramanujan.accuracy.extremes import FORMS, RIGHT, Sweep
from ramanujan.numerals import duration, number
from ramanujan.pages.speed.downsampling import SCREEN_HEIGHT
from ramanujan.translation import _


def what_the_app_uses(found: Sequence[object], sweeps: Sequence[Sweep]) -> str:
    """List what the app uses where, why, and the measurement behind it."""
    kinds = [f for f in found if isinstance(f, Arithmetic)]
    items = [
        _motion([f for f in found if isinstance(f, ClosedForm)]),
        *_frequency(kinds, {s.form: s for s in sweeps if (s.along, s.dtype) == ("machines", "float64")}),
        _formulas(kinds),
        _curves([f for f in found if isinstance(f, CurveSampling)]),
        _bytes(),
        *(_kept(f) for f in found if isinstance(f, Comparison)),
    ]
    return "\n".join(f"- {item}" for item in items)


def _motion(states: Sequence[ClosedForm]) -> str:
    return _(
        "**Motion, stage and figures**: the closed form. For equal masses of 1 kg and k = 1 N/m its phase error is at "
        "most {error} rad from {first} to {last} periods. A state takes {time}, however long after the release."
    ).format(
        first=states[0].periods,
        last=number(states[-1].periods),
        error=number(max(s.phase_error for s in states)),
        time=duration(float(np.median([s.seconds.median for s in states]))),
    )


def _only(kinds: Sequence[Arithmetic], name: str) -> Arithmetic:
    return next(each for each in kinds if each.kind == name)


def _frequency(kinds: Sequence[Arithmetic], drawn: Mapping[str, Sweep]) -> tuple[str, str]:
    machine, curve = drawn["integers"], drawn["partial_fractions"]
    right = curve.verdict == RIGHT
    return (
        _(
            "**Ω² of a machine**: {formula}. For {count} random machines over the whole range of float64, the "
            "error is at most {error} ulp. A value takes {integers}. Fractions give the same digits in {fractions}."
        ).format(
            formula=FORMS["integers"].formula,
            count=machine.x.size,
            error=number(machine.worst_right_ulp),
            integers=duration(_only(kinds, "integers").seconds.median),
            fractions=duration(_only(kinds, "fraction").seconds.median),
        ),
        _(
            "**The curve of Ω²m/k**: {formula}, for k = m. It computes whole arrays: a value takes {many} in an array "
            "and {one} by itself. For the same machines its error is up to {error} ulp, and it fails for {failed} of "
            "them."
        ).format(
            formula=FORMS["partial_fractions"].formula,
            many=duration(_only(kinds, "array").seconds.median),
            one=duration(_only(kinds, "float64").seconds.median),
            error=number(curve.worst_right_ulp),
            failed=int(np.count_nonzero(~right)),
        ),
    )


def _formulas(kinds: Sequence[Arithmetic]) -> str:
    digits = [each for each in kinds if each.kind == "mpmath"]
    return _(
        "**Formulas and steps of the derivation**: exact fractions. One value of Ω² takes {fraction} and has no "
        "error. With mpmath it takes {few} with {few_digits} digits and {many} with {many_digits} digits."
    ).format(
        fraction=duration(_only(kinds, "fraction").seconds.median),
        few=duration(digits[0].seconds.median),
        few_digits=digits[0].digits,
        many=duration(digits[-1].seconds.median),
        many_digits=digits[-1].digits,
    )


def _curves(curves: Sequence[CurveSampling]) -> str:
    enough = {name: next(c for c in curves if c.curve == name and c.pixels < 0.5) for name in ("cosine", "frequency")}
    return _(
        "**Curves**: enough points for an error below half a pixel. In a figure {height} pixels high, {cosine} points "
        "draw one period to {cosine_error} pixel, and {curve} points draw the curve of Ω² to {curve_error} "
        "pixel."
    ).format(
        height=HEIGHT,
        cosine=enough["cosine"].points,
        cosine_error=number(enough["cosine"].pixels),
        curve=enough["frequency"].points,
        curve_error=number(enough["frequency"].pixels),
    )


def _bytes() -> str:
    rounding = float(np.finfo(np.float32).eps) / 2
    return _(
        "**Numbers sent to the browser**: float32. They take half the bytes of float64. Rounding changes a number by "
        "at most one part in {part}, {finer} times less than half a pixel of a screen {height} pixels high."
    ).format(part=number(1 / rounding), finer=number(0.5 / SCREEN_HEIGHT / rounding), height=SCREEN_HEIGHT)


def _kept(compared: Comparison) -> str:
    sentences = {
        "frequency": _("**Ω** is stored with its machine. Reading it again is {ratio} times faster than computing it."),
        "state": _(
            "**The solution** is stored with its machine. The next state is {ratio} times faster than the first."
        ),
        "states": _(
            "**Many states** are computed in one call. For {n} states this is {ratio} times faster than one by one."
        ),
    }
    return sentences[compared.name].format(ratio=number(compared.ratio), n=STATES)
