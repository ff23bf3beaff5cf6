"""Dates and times in the visitor's time zone and language."""

from datetime import UTC, datetime, tzinfo
from zoneinfo import ZoneInfo

import streamlit as st

from ramanujan.text.translation import _


def time_zone() -> tzinfo:
    """Return the visitor's time zone, or UTC if the browser or the server does not know it."""
    try:
        return ZoneInfo(st.context.timezone or "")
    except (KeyError, ValueError, OSError):
        return UTC


def date(seconds: float) -> str:
    """Return a moment [s since 1970] as a date."""
    # TRANSLATORS: the format of a date, as Python's strftime reads it: 2026-11-25.
    return datetime.fromtimestamp(seconds, time_zone()).strftime(_("%Y-%m-%d"))


def date_and_time(seconds: float) -> str:
    """Return a moment [s since 1970] as a date and a time of day, with the name of the time zone."""
    # TRANSLATORS: the format of a date and a time, as Python's strftime reads it: 2026-11-25, 14:05 CET.
    return datetime.fromtimestamp(seconds, time_zone()).strftime(_("%Y-%m-%d, %H:%M %Z"))
