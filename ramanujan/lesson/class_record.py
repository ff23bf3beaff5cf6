"""The votes of a class as a file for its lecturer: every vote is counted, and nobody is named."""

import csv
import io
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime

from ramanujan import lesson
from ramanujan.lesson.class_states import Asked
from ramanujan.spreadsheet import Cell, spreadsheet
from ramanujan.translation import _, pgettext

HEADER = ("stop", "question", "asked_at", "present", "option", "label", "right", "first_vote", "second_vote")


def as_csv(asked: Iterable[Asked]) -> str:
    """Return the questions of a class as CSV for programs: a row for each option.

    Times are UTC. `second_vote` is empty if the class voted once.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for stop, heading, at, present, option, label, is_right, *votes in _rows(asked):
        answer = {True: "yes", False: "no"}.get(is_right, "")
        writer.writerow((stop, heading, at.isoformat(timespec="seconds"), present, option, label, answer, *votes))
    return text.getvalue()


def as_spreadsheet(asked: Iterable[Asked]) -> str:
    """Return the questions of a class as a file for a spreadsheet: a row for each option."""
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
    for _stop, heading, at, present, _option, label, is_right, *votes in _rows(asked):
        rows.append((heading, f"{at:%Y-%m-%d %H:%M:%S}", present, label, is_right, *votes))
    return spreadsheet(rows)


def _rows(asked: Iterable[Asked]) -> Iterator[tuple]:
    """Yield stop, heading, time, students present, option, label, whether it is right, and the votes.

    Of a stop that is unknown, the ids are its heading and labels, and no option is called right or wrong.
    """
    for each in asked:
        at = datetime.fromtimestamp(each.at, UTC)
        # Another version of the app, in which the class began, may have had other stops.
        stop = lesson.stop(each.stop) if lesson.has_stop(each.stop) else None
        for option, first in each.first.items():
            second = "" if each.second is None else each.second[option]
            heading, label, is_right = each.stop, option, ""
            if stop:
                heading, label, is_right = stop.heading, stop.options[option], option == stop.right
            yield each.stop, heading, at, each.present, option, label, is_right, first, second
