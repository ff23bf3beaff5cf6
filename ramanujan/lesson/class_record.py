"""The votes of a class as a file for its lecturer, which contains numbers of votes and no names."""

import csv
import io
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from typing import NamedTuple

from ramanujan import lesson
from ramanujan.lesson.class_states import ClassResult
from ramanujan.spreadsheet import Cell, spreadsheet
from ramanujan.translation import _, pgettext

HEADER = ("stop", "question", "asked_at", "present", "option", "label", "right", "first_vote", "second_vote")


def write_csv(results: Iterable[ClassResult]) -> str:
    """Return the results of a class as CSV for programs, with one row for each option.

    Times are UTC. `second_vote` is empty if the class voted once.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for row in _rows(results):
        answer = {True: "yes", False: "no", None: ""}[row.is_right]
        at = row.at.isoformat(timespec="seconds")
        # The writer leaves the cell of None empty.
        writer.writerow((row.stop, row.heading, at, row.present, row.option, row.label, answer, row.first, row.second))
    return text.getvalue()


def write_spreadsheet(results: Iterable[ClassResult]) -> str:
    """Return the results of a class as a file for a spreadsheet, with one row for each option."""
    header = (
        pgettext("of the lesson", "Stop"),
        # TRANSLATORS: the head of a column with dates and times.
        _("Asked at (UTC)"),
        _("Students present"),
        _("Option"),
        _("Right answer"),
        _("Votes"),
        _("Votes after the discussion"),
    )
    rows: list[tuple[Cell, ...]] = [header]
    for row in _rows(results):
        asked_at = f"{row.at:%Y-%m-%d %H:%M:%S}"
        is_right = "" if row.is_right is None else row.is_right
        second = "" if row.second is None else row.second
        rows.append((row.heading, asked_at, row.present, row.label, is_right, row.first, second))
    return spreadsheet(rows)


class _Row(NamedTuple):
    """The votes for one option of a question, with the fields of HEADER.

    `is_right` is None for an unknown stop, `second` is None if the class voted once.
    """

    stop: str
    heading: str
    at: datetime
    present: int
    option: str
    label: str
    is_right: bool | None
    first: int
    second: int | None


def _rows(results: Iterable[ClassResult]) -> Iterator[_Row]:
    """Yield a row for each option of each question.

    The class may have begun in another version of the app, with other stops. For an unknown stop the ids replace
    heading and labels.
    """
    for result in results:
        at = datetime.fromtimestamp(result.at, UTC)
        stop = lesson.find_stop(result.stop) if lesson.has_stop(result.stop) else None
        for option, first in result.first.items():
            yield _Row(
                stop=result.stop,
                heading=stop.heading if stop else result.stop,
                at=at,
                present=result.present,
                option=option,
                label=stop.options[option] if stop else option,
                is_right=option == stop.right if stop else None,
                first=first,
                second=None if result.second is None else result.second[option],
            )
