"""The votes of a class as a file for its lecturer, which contains numbers of votes and no names."""

import csv
import io
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime

from ramanujan import lesson
from ramanujan.lesson.class_states import ClassResult
from ramanujan.spreadsheet import Cell, spreadsheet
from ramanujan.translation import _, pgettext

HEADER = ("stop", "question", "asked_at", "present", "option", "label", "right", "first_vote", "second_vote")


def as_csv(results: Iterable[ClassResult]) -> str:
    """Return the results of a class as CSV for programs, with one row for each option.

    Times are UTC. `second_vote` is empty if the class voted once.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for stop, heading, at, present, option, label, is_right, *votes in _rows(results):
        answer = {True: "yes", False: "no"}.get(is_right, "")
        writer.writerow((stop, heading, at.isoformat(timespec="seconds"), present, option, label, answer, *votes))
    return text.getvalue()


def as_spreadsheet(results: Iterable[ClassResult]) -> str:
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
    for _stop, heading, at, present, _option, label, is_right, *votes in _rows(results):
        rows.append((heading, f"{at:%Y-%m-%d %H:%M:%S}", present, label, is_right, *votes))
    return spreadsheet(rows)


def _rows(results: Iterable[ClassResult]) -> Iterator[tuple]:
    """Yield stop, heading, time, students present, option, label, whether it is right, and the votes.

    The class may have begun in another version of the app, with other stops. For an unknown stop the ids replace
    heading and labels, and the field of the right answer is empty.
    """
    for result in results:
        at = datetime.fromtimestamp(result.at, UTC)
        stop = lesson.stop(result.stop) if lesson.has_stop(result.stop) else None
        for option, first in result.first.items():
            second = "" if result.second is None else result.second[option]
            heading, label, is_right = result.stop, option, ""
            if stop:
                heading, label, is_right = stop.heading, stop.options[option], option == stop.right
            yield result.stop, heading, at, result.present, option, label, is_right, first, second
