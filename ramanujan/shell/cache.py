"""The only caches of the app: each is bounded, and each page has a file of its own.

A page asks here for anything that costs more than a moment. Keys are plain numbers. What only one page needs is
imported in that page's file, so that the first page does not pay for the others.
"""

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import streamlit as st

from ramanujan.derivation import ROUTES, Route
from ramanujan.derivation.nomenclature import nomenclature

_USUALLY, _WHILE_COMPUTING = sys.getswitchinterval(), 5e-4
"""Seconds after which Python lets another thread run."""
_computing: list[None] = []
_counting = threading.Lock()


@contextmanager
def giving_way() -> Iterator[None]:
    """Compute so that other visitors are answered meanwhile.

    Python runs one thread at a time. An answer waits for its turn many times, each time as long as Python usually lets
    a thread compute.
    """
    with _counting:
        _computing.append(None)
        sys.setswitchinterval(_WHILE_COMPUTING)
    try:
        yield
    finally:
        with _counting:
            _computing.pop()
            if not _computing:
                sys.setswitchinterval(_USUALLY)


@st.cache_resource(show_spinner=False)
@giving_way()
def route(name: str, equal_masses: bool = False) -> Route:
    """Return a route of the derivation, for any masses or for m′ = m."""
    return ROUTES.with_equal_masses(name) if equal_masses else ROUTES[name]


@st.cache_data(show_spinner=False)
def symbols(name: str, **more: str) -> list[str]:
    """Return the symbols of a route, and more, with their meanings as Markdown."""
    entries = (nomenclature(route(name)) | more).items()
    # A square bracket before a round one would be read as a link.
    return [f"${symbol}$: {meaning}".replace("[", "\\[").replace("]", "\\]") for symbol, meaning in entries]
