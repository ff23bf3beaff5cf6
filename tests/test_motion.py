"""Where the motion begins, its shapes and its times; its values are in test_whole_range.py."""

import numpy as np
import pytest

from ramanujan import Oscillator
from ramanujan.energy import energies
from ramanujan.motion import InitialState, motion

PUSHED = InitialState(X=0.4, phi=0.3, Phi=-1.0, X_dot=0.2, phi_dot=-0.7, Phi_dot=1.5)
"""Neither momentum is zero, and both zero modes are excited."""


@pytest.mark.parametrize("shape", [(), (5,), (2, 3), (0,)])
def test_any_shape_of_times_goes_through(shape):
    t = np.arange(np.prod(shape), dtype=float).reshape(shape)
    q, q_dot = motion(Oscillator(), PUSHED, t)
    assert q.shape == q_dot.shape == (3, *shape)
    # It begins where it is told, to the last digit.
    assert np.array_equal(np.concatenate(motion(Oscillator(), PUSHED, 0.0)), [0.4, 0.3, -1.0, 0.2, -0.7, 1.5])
    assert energies(Oscillator(), q, q_dot)["spring"].shape == shape
    for index in np.ndindex(*shape):
        # A single time goes another way through the code.
        single = motion(Oscillator(), PUSHED, float(t[index]))
        assert np.allclose(np.concatenate([q, q_dot])[:, *index], np.concatenate(single), rtol=0, atol=1e-15)


@pytest.mark.parametrize("t", [1.001e18, -1e30, 1e300, [0.0, 1e308]])
def test_farther_out_the_time_is_refused(t):
    with pytest.raises(ValueError, match=r"^t must not exceed 10¹⁸ periods"):
        motion(Oscillator(k=1e3), PUSHED, t)
