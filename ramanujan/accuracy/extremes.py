"""Ω² for very large and very small numbers: the error of each formula in ulp, and its value where it fails.

The FORMS of Ω² are algebraically equal, so all of them are exact in exact arithmetic. Two sweeps cover the range of
floating point. "mass ratio" has m = k = 1 and m′ = ε; "scale" has m = m′ = k = s, where Ω² = 104/99 for every s. The
reference value is computed with 50 digits from the same floats. A third sweep tests general eigenvalue solvers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import mpmath
import numpy as np
from numpy.typing import NDArray

from ramanujan.accuracy.progress import REFERENCE, Piece, exact_frequency_squared, float_type
from ramanujan.frequency import frequency_squared, normalized_frequency_squared
from ramanujan.oscillator import Oscillator
from ramanujan.quantities import integer, sequence, some_of
from ramanujan.words import _

RIGHT, INACCURATE, OVERFLOW, ZERO, PLAUSIBLE = "right", "inaccurate", "overflow/nan", "zero", "plausible wrong"
RIGHT_ULP = 4.0
"""Up to this error a value counts as right: the rounding errors of a few operations add up to it."""
PLAUSIBLE_ERROR = 1e-2
"""Relative error from which a finite nonzero value counts as wrong, although it looks like an answer."""
DECADES = {"float32": 37, "float64": 300}
"""The sweeps run from 10^−d to 10^d, so that m′ = ε and Ω² stay normal numbers."""

_CHUNK = 100

Values = NDArray[np.floating]
Eigenvalues = Callable[[NDArray[np.floating], NDArray[np.floating]], NDArray]


@dataclass(frozen=True)
class Form:
    """A form of Ω²: its title, the formula as text, and the function (m, m′, k) → Ω² for arrays of one dtype."""

    title: str
    formula: str
    evaluate: Callable[[Values, Values, Values], Values]


@dataclass(frozen=True)
class Stretch:
    """Consecutive samples with one verdict: both ends of the stretch, and the values of Ω² returned there."""

    verdict: str
    first: float
    last: float
    first_value: float
    last_value: float


@dataclass(frozen=True, eq=False)
class Sweep:
    """One form in one dtype along one sweep; arrays with one element per sample.

    Parameters
    ----------
    form, dtype, along : name in FORMS; "float32" or "float64"; "mass ratio" or "scale"
    x : ε or s
    value : Ω² as the form returns it
    error_ulp : |value − truth| in units of the truth's last place; NaN or ∞ where the value is
    verdict : RIGHT, INACCURATE, OVERFLOW, ZERO or PLAUSIBLE
    """

    form: str
    dtype: str
    along: str
    x: np.ndarray
    value: np.ndarray
    error_ulp: np.ndarray
    verdict: np.ndarray

    @property
    def worst_right_ulp(self) -> float:
        """The largest error among the samples that count as right; 0 if there are none."""
        return float(self.error_ulp[self.verdict == RIGHT].max(initial=0.0))

    @property
    def stretches(self) -> list[Stretch]:
        """The sweep as stretches of one verdict each, in ascending order of x."""
        starts = np.flatnonzero(np.r_[True, self.verdict[1:] != self.verdict[:-1]])
        ends = np.r_[starts[1:], self.x.size] - 1
        return [
            Stretch(str(self.verdict[a]), *map(float, (self.x[a], self.x[b], self.value[a], self.value[b])))
            for a, b in zip(starts, ends, strict=True)
        ]


@dataclass(frozen=True, eq=False)
class EigenSweep:
    """A general eigenvalue solver along the mass ratio; arrays with one row per sample.

    Parameters
    ----------
    solver, dtype : name in SOLVERS; "float32" or "float64"
    mass_ratio : ε
    error_ulp : error of the oscillating mode's eigenvalue Ω², in ulp; NaN where the solver gave up
    zero_modes : what it returns for the two eigenvalues that are exactly 0, shape (samples, 2), complex [rad²/s²]
    """

    solver: str
    dtype: str
    mass_ratio: np.ndarray
    error_ulp: np.ndarray
    zero_modes: np.ndarray

    @property
    def without_frequency(self) -> np.ndarray:
        """Whether a zero mode is negative or complex, so that its square root is not a frequency; shape (samples,)."""
        return np.any((self.zero_modes.real < 0) | (self.zero_modes.imag != 0), axis=1)


def extremes(
    forms: Iterable[str] | None = None, dtypes: Iterable[str] = tuple(DECADES), samples_per_decade: int = 3
) -> Iterator[Piece[Sweep]]:
    """Return an iterator over the sweeps: one `Sweep` per sweep, dtype and form.

    Parameters
    ----------
    forms : names in FORMS, all if None
    dtypes : "float32", "float64"
    samples_per_decade : samples between two powers of ten, from 1 to 20

    Returns
    -------
    iterator over pieces of work, some of which carry a `Sweep`

    Raises
    ------
    ValueError : an argument is outside its range.

    >>> [sweep] = [piece.result for piece in extremes(["paper"], ["float32"], 1) if piece.result][:1]
    >>> [stretch.verdict for stretch in sweep.stretches]
    ['right', 'zero']
    """
    names = list(FORMS) if forms is None else some_of("forms", forms, FORMS)
    kinds = [(dtype, float_type("dtypes", dtype)) for dtype in sequence("dtypes", dtypes)]
    density = integer("samples_per_decade", samples_per_decade, 1, 20)
    return _sweeps(names, kinds, density)


def eigen_solvers(dtypes: Iterable[str] = tuple(DECADES), samples_per_decade: int = 1) -> Iterator[Piece[EigenSweep]]:
    """Return an iterator over the eigen-solvers: one `EigenSweep` per dtype and solver, for m = k = R = 1 and m′ = ε.

    Parameters
    ----------
    dtypes : "float32", "float64"
    samples_per_decade : samples between two powers of ten, from 1 to 20

    Returns
    -------
    iterator over pieces of work, some of which carry an `EigenSweep`

    Raises
    ------
    ValueError : an argument is outside its range.

    >>> sweeps = [piece.result for piece in eigen_solvers(["float32"]) if piece.result]
    >>> len(sweeps) == len(SOLVERS)
    True
    """
    kinds = [(dtype, float_type("dtypes", dtype)) for dtype in sequence("dtypes", dtypes)]
    density = integer("samples_per_decade", samples_per_decade, 1, 20)
    return _eigen_sweeps(kinds, density)


def _paper(m: Values, m_prime: Values, k: Values) -> Values:
    return 8 * k / (7 * m_prime + 8 * m - 8 * (m_prime + m) ** 2 / (7 * m / 3 + 2 * m_prime))


def _scaled(m: Values, m_prime: Values, k: Values) -> Values:
    r, inverse = m_prime / m, m / m_prime
    light = k / m * (8 * (7 + 6 * r) / (32 + r * (49 + 18 * r)))
    heavy = k / m_prime * (8 * (6 + 7 * inverse) / (18 + inverse * (49 + 32 * inverse)))
    return np.where(m >= m_prime, light, heavy)


def _effective_mass(m: Values, m_prime: Values, k: Values) -> Values:
    return k / (3 * m_prime / 8 + m / 2 * ((8 * m + 7 * m_prime) / (7 * m + 6 * m_prime)))


def _app(m: Values, m_prime: Values, k: Values) -> Values:
    return k / m * normalized_frequency_squared(m_prime / m)


FORMS: dict[str, Form] = {
    "paper": Form(_("the paper’s form"), "8k/(7m′ + 8m − 8(m′ + m)²/(7m/3 + 2m′))", _paper),
    "polynomial": Form(_("two polynomials"), "8k(7m + 6m′)/(32m² + 49mm′ + 18m′²)", frequency_squared),
    "scaled": Form(
        _("scaled by the larger mass"),
        "r = m′/m ≤ 1: (k/m)·8(7 + 6r)/(32 + r(49 + 18r)); else r = m/m′: (k/m′)·8(6 + 7r)/(18 + r(49 + 32r))",
        _scaled,
    ),
    "effective mass": Form(_("effective mass"), "k/M_x, M_x = 3m′/8 + (m/2)·((8m + 7m′)/(7m + 6m′))", _effective_mass),
    "partial fractions": Form(_("the app’s form"), "(k/m)·(7/4)/(1 + 21ε/32 + 1/(48 + 56/ε)), ε = m′/m", _app),
}
"""The forms of Ω² by name; `normalized_frequency_squared` evaluates the last one."""


# q = (X, φ, Φ) from the displacements relative to the ground (block, slab, top cylinder), right positive, for R = 1.
_GROUND = np.array([[-1, 0, 0], [-0.5, 0.5, 0], [-1, 0, 1]], dtype=np.float32)


def _eigvals(M: np.ndarray, K: np.ndarray) -> np.ndarray:
    return np.linalg.eigvals(np.linalg.solve(M, K))


def _eigvals_over_ground(M: np.ndarray, K: np.ndarray) -> np.ndarray:
    """The same for the displacements of block, slab and top cylinder relative to the ground; K then has two columns."""
    return _eigvals(_GROUND.T @ M @ _GROUND, _GROUND.T @ K @ _GROUND)


def _eigh_cholesky(M: np.ndarray, K: np.ndarray) -> np.ndarray:
    """Eigenvalues of L⁻¹KL⁻ᵀ with M = LLᵀ: symmetric, so they are real."""
    L = np.linalg.cholesky(M)
    reduced = np.linalg.solve(L, np.linalg.solve(L, K).T)
    return np.linalg.eigvalsh((reduced + reduced.T) / 2)


SOLVERS: dict[str, Eigenvalues] = {
    "eigvals of M⁻¹K": _eigvals,
    "eigvals of M⁻¹K, ground displacements": _eigvals_over_ground,
    "eigh after Cholesky": _eigh_cholesky,
}
"""General eigenvalue solvers by name: (M, K) for R = 1 → the three eigenvalues Ω², in any order.

In the coordinates (X, φ, Φ) two columns of K are zero, so the first solver finds both zero modes exactly. The second
one shows that this depends on the coordinates.
"""


def _sweeps(names: list[str], kinds: list[tuple[str, type[np.floating]]], density: int) -> Iterator[Piece[Sweep]]:
    done, work = 0, 2 * sum(DECADES[dtype] for dtype, _kind in kinds) * (len(names) + 1)
    for along in ("mass ratio", "scale"):
        for dtype, kind in kinds:
            x = _samples(dtype, kind, density)
            one = np.ones_like(x)
            m, m_prime, k = (one, x, one) if along == "mass ratio" else (x, x, x)
            truth: list[mpmath.mpf] = []
            for start in range(0, x.size, _CHUNK):
                chunk = slice(start, start + _CHUNK)
                truth += map(exact_frequency_squared, m[chunk], m_prime[chunk], k[chunk])
                yield Piece((done + DECADES[dtype] * len(truth) / x.size) / work)
            done += DECADES[dtype]
            for name in names:
                with np.errstate(all="ignore"):
                    value = FORMS[name].evaluate(m, m_prime, k)
                error_ulp, relative = _errors(value, truth, kind)
                done += DECADES[dtype]
                verdict = _verdicts(value, error_ulp, relative)
                yield Piece(done / work, Sweep(name, dtype, along, x, value, error_ulp, verdict))


def _eigen_sweeps(kinds: list[tuple[str, type[np.floating]]], density: int) -> Iterator[Piece[EigenSweep]]:
    done, work = 0, sum(DECADES[dtype] for dtype, _kind in kinds) * len(SOLVERS)
    for dtype, kind in kinds:
        ratios = _samples(dtype, kind, density)
        truth = [exact_frequency_squared(1, ratio, 1) for ratio in ratios]
        machines = [Oscillator(m_prime=float(ratio), radius=1.0) for ratio in ratios]
        for name, solver in SOLVERS.items():
            modes, zeros = np.full(ratios.size, np.nan, kind), np.full((ratios.size, 2), np.nan, complex)
            for i, machine in enumerate(machines):
                modes[i], zeros[i] = _sorted_modes(solver, machine, kind)
                if i % _CHUNK == _CHUNK - 1:
                    yield Piece((done + DECADES[dtype] * i / ratios.size) / work)
            done += DECADES[dtype]
            yield Piece(done / work, EigenSweep(name, dtype, ratios, _errors(modes, truth, kind)[0], zeros))


def _sorted_modes(solver: Eigenvalues, machine: Oscillator, kind: type[np.floating]) -> tuple[float, np.ndarray]:
    """Return the oscillating mode's eigenvalue, the largest, and the other two; NaN where the solver gives up."""
    try:
        values = solver(machine.mass_matrix.astype(kind), machine.stiffness_matrix.astype(kind))
    except np.linalg.LinAlgError:
        return np.nan, np.full(2, np.nan)
    ordered = values[np.argsort(values.real)]
    return ordered[2].real, ordered[:2]


def _samples(dtype: str, kind: type[np.floating], density: int) -> np.ndarray:
    """Return the powers of ten from 10^−d to 10^d and density − 1 values between neighbours, rounded to the dtype."""
    decades = DECADES[dtype]
    return (10.0 ** (np.arange(-decades * density, decades * density + 1) / density)).astype(kind)


def _errors(value: np.ndarray, truth: list[mpmath.mpf], kind: type[np.floating]) -> tuple[np.ndarray, np.ndarray]:
    """Return |value − truth| in ulp of the truth and relative to it; NaN and ∞ pass through."""
    ulps = np.spacing(np.array([float(t) for t in truth]).astype(kind))
    errors = [_error(float(v), t, float(ulp)) for v, t, ulp in zip(value, truth, ulps, strict=True)]
    return tuple(np.array(errors).T)


def _error(value: float, truth: mpmath.mpf, ulp: float) -> tuple[float, float]:
    """Return the two errors of one value; they are divided with 50 digits, since an ulp may be subnormal."""
    if not np.isfinite(value):
        return abs(value), abs(value)
    gap = abs(REFERENCE.mpf(value) - truth)
    return float(gap / ulp), float(gap / truth)


def _verdicts(value: np.ndarray, error_ulp: np.ndarray, relative: np.ndarray) -> np.ndarray:
    """Return the verdict on each sample; the first condition that holds decides."""
    conditions = [~np.isfinite(value), error_ulp <= RIGHT_ULP, value == 0, relative < PLAUSIBLE_ERROR]
    return np.select(conditions, [OVERFLOW, RIGHT, ZERO, INACCURATE], PLAUSIBLE)
