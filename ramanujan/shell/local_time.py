"""Dates and times as the visitor's clock and language have them."""

from datetime import UTC, datetime, tzinfo
from zoneinfo import ZoneInfo

import streamlit as st

from ramanujan.translation import _


def time_zone() -> tzinfo:
    """Return the visitor's time zone, or UTC if the browser or the server does not know it."""
    try:
        return ZoneInfo(st.context.timezone or "")
    except (ValueError, OSError):
        return UTC


def date(seconds: float) -> str:
    """Return a moment [s since 1970] as a date."""
    # TRANSLATORS: the format of a date, as Python's strftime reads it: 2026-11-25.
    return datetime.fromtimestamp(seconds, time_zone()).strftime(_("%Y-%m-%d"))
