"""General eigenvalue solvers, which know the machine only by its matrices M and K, over the mass ratio."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ramanujan.accuracy.exact import exact_frequency_squared
from ramanujan.accuracy.extremes import DECADES, powers_of_ten, ulp_errors
from ramanujan.oscillator import Oscillator
from ramanujan.translation import _

Eigenvalues = Callable[[NDArray[np.floating], NDArray[np.floating]], NDArray]


@dataclass(frozen=True)
class Solver:
    """A general eigenvalue solver: its title, and the function (M, K) for R = 1 → the three eigenvalues Ω²."""

    title: str
    eigenvalues: Eigenvalues


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


def eigen_solvers(dtypes: Iterable[str] = tuple(DECADES)) -> list[EigenSweep]:
    """Return the eigen-solvers: one `EigenSweep` per dtype and solver, for m = k = R = 1 and m′ = ε.

    Parameters
    ----------
    dtypes : "float32", "float64"

    Returns
    -------
    an `EigenSweep` for each

    >>> len(eigen_solvers(["float32"])) == len(SOLVERS)
    True
    """
    return [sweep for dtype in dtypes for sweep in _eigen_sweeps(dtype)]


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


SOLVERS: dict[str, Solver] = {
    "eigvals": Solver(_("eigvals of M⁻¹K"), _eigvals),
    "eigvals_ground": Solver(_("eigvals of M⁻¹K, displacements relative to the ground"), _eigvals_over_ground),
    "eigh_cholesky": Solver(_("eigh after a Cholesky factorization"), _eigh_cholesky),
}
"""General eigenvalue solvers by name; each returns its eigenvalues in any order.

In the coordinates (X, φ, Φ) two columns of K are zero, so the first solver finds both zero modes exactly. The second
one shows that this depends on the coordinates.
"""


def _eigen_sweeps(dtype: str) -> Iterator[EigenSweep]:
    ratios = powers_of_ten(dtype, 1)
    truth = [exact_frequency_squared(1, ratio, 1) for ratio in ratios]
    machines = [Oscillator(m_prime=float(ratio), radius=1.0) for ratio in ratios]
    for name, solver in SOLVERS.items():
        found = [_sorted_modes(solver.eigenvalues, machine, dtype) for machine in machines]
        modes = np.array([mode for mode, _zeros in found], dtype)
        zeros = np.array([zeros for _mode, zeros in found], complex)
        yield EigenSweep(name, dtype, ratios, ulp_errors(modes, truth)[0], zeros)


def _sorted_modes(solver: Eigenvalues, machine: Oscillator, dtype: str) -> tuple[float, np.ndarray]:
    """Return the oscillating mode's eigenvalue, the largest, and the other two; NaN where the solver gives up."""
    try:
        values = solver(machine.mass_matrix.astype(dtype), machine.stiffness_matrix.astype(dtype))
    except np.linalg.LinAlgError:
        return np.nan, np.full(2, np.nan)
    ordered = values[np.argsort(values.real)]
    return ordered[2].real, ordered[:2]
