"""The limit of open files, which limits the number of visitors."""

import logging
import sys
from contextlib import suppress

_LOG = logging.getLogger(__name__)

NEEDED = 2_500
"""The open files of 200 visitors.

A session needs four, a browser that loads the page six for a moment, and each of up to 128 left sessions three.
"""
_MACOS_LIMIT = 10_240
"""The largest limit on macOS, which reports infinity instead."""


def raise_limit() -> None:
    """Raise the limit of this process to the largest that the system allows, and log a sentence if it is too low.

    Many systems allow 256 or 1024 files by default, and a process may raise this limit. Windows has no such limit.
    """
    if sys.platform == "win32":
        return
    import resource

    limit, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = min(most, _MACOS_LIMIT) if sys.platform == "darwin" else most
    if limit < wanted:
        # The app also works with a low limit.
        with suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, most))
            limit = wanted
    if limit < NEEDED:
        _LOG.warning(
            "This process can open %d files, but 200 visitors need %d. Raise the limit of the system.", limit, NEEDED
        )
