"""What a lecturer takes home of a class: every vote counted, nobody named."""

import csv
import io
from collections.abc import Iterable
from datetime import UTC, datetime

from ramanujan import lesson
from ramanujan.lesson.class_states import Asked

HEADER = ("stop", "question", "asked_at", "present", "option", "label", "right", "first_vote", "second_vote")


def as_csv(asked: Iterable[Asked]) -> str:
    """Return the questions that a class was asked as CSV: a row for each option.

    Times are UTC. `second_vote` is empty where there was none.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for each in asked:
        stop = lesson.stop(each.stop)
        right, at = stop.right, datetime.fromtimestamp(each.at, UTC).isoformat(timespec="seconds")
        for option, first in each.first.items():
            second = "" if each.second is None else each.second[option]
            label = stop.options[option]
            answer = "yes" if option == right else "no"
            writer.writerow((stop.id, stop.heading, at, each.present, option, label, answer, first, second))
    return text.getvalue()
