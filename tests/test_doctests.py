"""Every public name has types without Any, and a docstring with its return value and a running example."""

import doctest
import importlib
import inspect
import pkgutil
import re

import numpy as np
import pytest

import ramanujan

PAGES = ("ramanujan.pages", "ramanujan.shell")
"""Pages, which run when they are imported."""
CORE = ("validation", "frequency", "oscillator", "motion", "energy", "contact", "record", "integrators")
ROOMS = (*CORE, "number_theory", "accuracy")
"""The numeric rooms, in which every public function has an example."""

_FOUND = [module.name for module in pkgutil.walk_packages(ramanujan.__path__, "ramanujan.")]
MODULES = ["ramanujan", *(name for name in _FOUND if not name.startswith(PAGES))]


def public():
    """Yield every public function, class and method of the numeric rooms."""
    for name in MODULES:
        if name.split(".")[1:2] and name.split(".")[1] in ROOMS:
            module = importlib.import_module(name)
            for attribute, value in vars(module).items():
                is_public = not attribute.startswith("_") and getattr(value, "__module__", None) == name
                if is_public and (inspect.isfunction(value) or inspect.isclass(value)):
                    yield pytest.param(value, id=f"{name}.{attribute}")


@pytest.mark.parametrize("name", MODULES)
def test_the_examples_in_the_docstrings_run(name):
    module = importlib.import_module(name)
    # Libraries of other tests change how arrays are printed.
    with np.printoptions(legacy=False):
        assert doctest.testmod(module).failed == 0


@pytest.mark.parametrize("value", list(public()))
def test_a_public_name_says_what_it_takes_and_gives(value):
    text = inspect.getdoc(value)
    assert text
    if inspect.isclass(value):
        own = (f for name, f in inspect.getmembers(value, inspect.isfunction) if f.__module__ == value.__module__)
        kinds = [*getattr(value, "__annotations__", {}).values(), *map(inspect.signature, own)]
        assert not any(re.search(r"\bAny\b", str(kind)) for kind in kinds)
        return
    assert ">>> " in text, "an example is missing"
    signature = inspect.signature(value)
    annotations = [*(p.annotation for p in signature.parameters.values()), signature.return_annotation]
    assert inspect.Signature.empty not in annotations
    assert not any(re.search(r"\bAny\b", str(annotation)) for annotation in annotations)
    # A long docstring has sections. A short one describes the result in its first lines.
    if "Parameters\n" in text:
        assert re.search(r"^Returns\n-------$", text, re.MULTILINE)
