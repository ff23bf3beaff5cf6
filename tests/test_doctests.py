"""The examples in the docstrings run."""

import doctest
import importlib
import pkgutil

import numpy as np
import pytest

import ramanujan

PAGES = ("ramanujan.pages", "ramanujan.shell", "ramanujan.server")
"""Pages, which run when they are imported."""
_FOUND = [module.name for module in pkgutil.walk_packages(ramanujan.__path__, "ramanujan.")]
MODULES = ["ramanujan", *(name for name in _FOUND if not name.startswith(PAGES))]


@pytest.mark.parametrize("name", MODULES)
def test_the_examples_in_the_docstrings_run(name):
    module = importlib.import_module(name)
    # Libraries of other tests change how arrays are printed.
    with np.printoptions(legacy=False):
        assert doctest.testmod(module).failed == 0
