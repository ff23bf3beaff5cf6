"""The handle of the sidebar."""

from typing import Any

from ramanujan.browser import modules


def mount() -> Any:
    """Put a handle on the sidebar, which is a drawer at the bottom of a narrow screen."""
    return modules.component("components/drawer/drawer")(key="handle")
