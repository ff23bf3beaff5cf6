"""Where the formulas come from: each route derives Ω² from the bodies and their rolling constraints, by SymPy.

`ROUTES` maps a name to a `Route`; a route is derived when it is first asked for, and then kept.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from importlib import import_module

from ramanujan.derivation.steps import Route, Step

__all__ = ["ROUTES", "Route", "Step"]


class _Routes(Mapping[str, Route]):
    """The routes by name, in the order in which a course would take them."""

    _names = ("euler_lagrange", "hamilton", "newton", "energy", "matrix")

    def __getitem__(self, name: str) -> Route:
        if name not in self._names:
            raise KeyError(name)
        return _build(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


@cache
def _build(name: str) -> Route:
    return import_module(f"{__name__}.{name}").build()


ROUTES: Mapping[str, Route] = _Routes()
