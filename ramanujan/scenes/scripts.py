"""The pages' own JavaScript, one component's files put together: Components v2 takes one script each."""

from __future__ import annotations

from pathlib import Path


def script(*names: str) -> str:
    """Return the files of that name in this folder, one after the other."""
    return "\n".join((Path(__file__).parent / name).read_text(encoding="utf-8") for name in names)
