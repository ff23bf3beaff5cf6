"""Caches that several pages share. The caches of a single page are in its cache.py.

`functools.cache` stores constants. `st.cache_data` stores results for a visitor's values; such a cache is bounded, and
its keys are plain numbers.
"""

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

from ramanujan.derivation import ROUTES, Route
from ramanujan.derivation.nomenclature import nomenclature

_DEFAULT_INTERVAL, _SHORT_INTERVAL = sys.getswitchinterval(), 5e-4
"""Switch intervals of Python's threads [s]: the default, and that during a long computation."""
_computations: list[None] = []
"""An entry for each long computation that is running. Only the number of entries matters."""
_lock = threading.Lock()
"""Protects `_computations` and the switch interval."""


@contextmanager
def responsive() -> Iterator[None]:
    """Shorten the switch interval of threads during a long computation, so that other visitors get fast answers.

    Python runs one thread at a time. Another thread waits for up to one switch interval, many times for each answer.
    """
    with _lock:
        _computations.append(None)
        sys.setswitchinterval(_SHORT_INTERVAL)
    try:
        yield
    finally:
        with _lock:
            _computations.pop()
            if not _computations:
                sys.setswitchinterval(_DEFAULT_INTERVAL)


def route(name: str, equal_masses: bool = False) -> Route:
    """Return a route of the derivation, for any masses or for m′ = m. The first call derives it."""
    with responsive():
        return ROUTES.with_equal_masses(name) if equal_masses else ROUTES[name]


@cache
def symbols(name: str, **more: str) -> tuple[str, ...]:
    """Return a line of Markdown for each symbol of a route and each symbol in `more`, with its meaning."""
    entries = (nomenclature(route(name)) | more).items()
    # Markdown would parse a square bracket before a round bracket as a link.
    return tuple(f"${symbol}$: {meaning}".replace("[", "\\[").replace("]", "\\]") for symbol, meaning in entries)
