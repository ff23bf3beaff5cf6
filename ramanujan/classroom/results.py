"""The votes of a class as a file for its lecturer, which contains numbers of votes and no names.

NumPy reads the file of an English server by

    numpy.loadtxt(file, delimiter=",", quotechar='"', dtype=str, encoding="utf-8-sig")
"""

from collections.abc import Iterable
from datetime import UTC, datetime

from ramanujan import lesson
from ramanujan.classroom.states import ClassResult
from ramanujan.classroom.store import ClassError
from ramanujan.lesson.stop import Stop
from ramanujan.text.spreadsheet import Cell, spreadsheet
from ramanujan.text.translation import _, pgettext


def find_stop(name: str) -> Stop:
    """Return the stop of a class. Raise `ClassError` for a stop that only another version of the app has."""
    if name not in {stop.id for stop in lesson.STOPS}:
        raise ClassError(_("The class is at a question that this version of the app does not have."))
    return lesson.find_stop(name)


def write_csv(results: Iterable[ClassResult]) -> str:
    """Return the results of a class as a CSV file for spreadsheets, with one row for each option.

    Times are UTC. The last column is empty if the class voted once. An option that only another version of the app has
    appears with its id.
    """
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
    for result in results:
        stop = find_stop(result.stop)
        asked_at = f"{datetime.fromtimestamp(result.at, UTC):%Y-%m-%d %H:%M:%S}"
        for option, first in result.first.items():
            second = "" if result.second is None else result.second[option]
            label, is_right = stop.options.get(option, option), option == stop.right
            rows.append((stop.heading, asked_at, result.present, label, is_right, first, second))
    return spreadsheet(rows)
