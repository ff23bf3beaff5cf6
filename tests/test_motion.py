"""The shapes of the motion; its values are in test_whole_range.py."""

import numpy as np
import pytest

from ramanujan import Oscillator
from ramanujan.motion import InitialState, motion

PUSHED = InitialState(X=0.4, phi=0.3, Phi=-1.0, X_dot=0.2, phi_dot=-0.7, Phi_dot=1.5)
"""Neither momentum is zero, and both zero modes are excited."""


@pytest.mark.parametrize("shape", [(), (5,), (2, 3), (0,)])
def test_times_of_any_shape(shape):
    t = np.arange(np.prod(shape), dtype=float).reshape(shape)
    q, q_dot = motion(Oscillator(), PUSHED, t)
    assert q.shape == q_dot.shape == (3, *shape)
    assert np.array_equal(np.concatenate(motion(Oscillator(), PUSHED, 0.0)), [0.4, 0.3, -1.0, 0.2, -0.7, 1.5])
    for index in np.ndindex(*shape):
        # A single time uses the sine of Python, an array that of NumPy.
        single = motion(Oscillator(), PUSHED, float(t[index]))
        assert np.allclose(np.concatenate([q, q_dot])[:, *index], np.concatenate(single), rtol=0, atol=1e-15)
