"""Errors of general eigenvalue solvers for (K − Ω²M)q = 0, which use only the matrices M and K.

The sweep is over the mass ratio ε, for m = k = R = 1.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ramanujan.accuracy.exact import exact_frequency_squared
from ramanujan.accuracy.extremes import DECADES, powers_of_ten, ulp_errors
from ramanujan.physics.oscillator import Oscillator
from ramanujan.text.translation import _

Eigenvalues = Callable[[NDArray[np.floating], NDArray[np.floating]], NDArray[np.number]]


@dataclass(frozen=True)
class Solver:
    """A general eigenvalue solver: its title, and the function (M, K) → the three eigenvalues Ω², for R = 1."""

    title: str
    eigenvalues: Eigenvalues


@dataclass(frozen=True, eq=False)
class EigenSweep:
    """The results of one eigenvalue solver in one dtype. Arrays have one row per sample.

    Parameters
    ----------
    solver : name in SOLVERS
    dtype : "float32" or "float64"
    mass_ratio : ε
    error_ulp : error of the eigenvalue Ω² of the oscillating mode [ulp]; NaN if the solver raised an error
    zero_modes : computed eigenvalues of both zero modes, shape (samples, 2), complex [rad²/s²]; exactly they are 0
    """

    solver: str
    dtype: str
    mass_ratio: np.ndarray
    error_ulp: np.ndarray
    zero_modes: np.ndarray

    @property
    def lacks_real_frequency(self) -> np.ndarray:
        """Whether Ω of a zero mode is not real, because Ω² is negative or complex; shape (samples,)."""
        is_negative, is_complex = self.zero_modes.real < 0, self.zero_modes.imag != 0
        return np.any(is_negative | is_complex, axis=1)


def sweep_solvers() -> list[EigenSweep]:
    """Return the results of all eigenvalue solvers over the mass ratio.

    Returns
    -------
    one `EigenSweep` for each dtype and solver, in this order

    >>> len(sweep_solvers()) == len(DECADES) * len(SOLVERS)
    True
    """
    sweeps: list[EigenSweep] = []
    for dtype in DECADES:
        sweeps += _evaluate_solvers(dtype)
    return sweeps


# Matrix that converts the displacements of block, slab and top cylinder to q = (X, φ, Φ), for R = 1. The displacements
# are relative to the ground, positive to the right. Its entries are exact as float32, which does not change the
# precision of a product.
_Q_FROM_GROUND = np.array([[-1, 0, 0], [-0.5, 0.5, 0], [-1, 0, 1]], dtype=np.float32)


def _eigvals(M: np.ndarray, K: np.ndarray) -> np.ndarray:
    """Return the eigenvalues of M⁻¹K."""
    return np.linalg.eigvals(np.linalg.solve(M, K))


def _eigvals_relative_to_ground(M: np.ndarray, K: np.ndarray) -> np.ndarray:
    """Return the eigenvalues of M⁻¹K for coordinates relative to the ground, in which K has two nonzero columns."""
    M_ground = _Q_FROM_GROUND.T @ M @ _Q_FROM_GROUND
    K_ground = _Q_FROM_GROUND.T @ K @ _Q_FROM_GROUND
    return _eigvals(M_ground, K_ground)


def _eigh_cholesky(M: np.ndarray, K: np.ndarray) -> np.ndarray:
    """Return the eigenvalues of the symmetric matrix L⁻¹KL⁻ᵀ with M = LLᵀ. They are real."""
    L = np.linalg.cholesky(M)
    reduced = np.linalg.solve(L, np.linalg.solve(L, K).T)
    return np.linalg.eigvalsh((reduced + reduced.T) / 2)


SOLVERS: dict[str, Solver] = {
    "eigvals": Solver(_("eigvals of M⁻¹K"), _eigvals),
    "eigvals_ground": Solver(_("eigvals of M⁻¹K, displacements relative to the ground"), _eigvals_relative_to_ground),
    "eigh_cholesky": Solver(_("eigh after a Cholesky factorization"), _eigh_cholesky),
}
"""Name → eigenvalue solver. The order of its eigenvalues is arbitrary.

In the coordinates (X, φ, Φ) two columns of K are zero, so the first solver finds both zero modes exactly. The second
solver shows that this depends on the coordinates.
"""


def _evaluate_solvers(dtype: str) -> Iterator[EigenSweep]:
    """Yield one `EigenSweep` for each solver."""
    ratios = powers_of_ten(dtype, 1)
    truth = [exact_frequency_squared(1, ratio, 1) for ratio in ratios]
    machines = [Oscillator(m_prime=float(ratio), radius=1.0) for ratio in ratios]
    for name, solver in SOLVERS.items():
        results = [_solve_modes(solver.eigenvalues, machine, dtype) for machine in machines]
        oscillating_modes = np.array([oscillating for oscillating, _zero in results], dtype)
        zero_modes = np.array([zero for _oscillating, zero in results], complex)
        errors_ulp, _relative_errors = ulp_errors(oscillating_modes, truth)
        yield EigenSweep(solver=name, dtype=dtype, mass_ratio=ratios, error_ulp=errors_ulp, zero_modes=zero_modes)


def _solve_modes(solver: Eigenvalues, machine: Oscillator, dtype: str) -> tuple[float, np.ndarray]:
    """Return the largest eigenvalue, which is that of the oscillating mode, and the other two; NaN on failure."""
    try:
        values = solver(machine.mass_matrix.astype(dtype), machine.stiffness_matrix.astype(dtype))
    except np.linalg.LinAlgError:
        return np.nan, np.full(2, np.nan)
    ordered = values[np.argsort(values.real)]
    return ordered[2].real, ordered[:2]
