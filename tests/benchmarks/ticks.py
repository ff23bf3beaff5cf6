"""The cost of a tick: a desk, a wall or a phone reads its class again and draws it.

    python -m tests.benchmarks.ticks [--questions 6] [--students 30] [--ticks 50]

For each screen the program prints the connections to the SQLite file, the queries and the milliseconds of a tick. The
class has seen the answers to all questions before the present one, and its popovers are closed.
"""

import argparse
import os
import sqlite3
import statistics
import tempfile
from collections import Counter
from functools import partial
from time import perf_counter
from typing import Any

from streamlit.testing.v1 import AppTest

from ramanujan.classroom.rules import Class, Phase, shared
from ramanujan.lesson import STOPS

_QUERIES = ("SELECT", "WITH", "INSERT", "UPDATE", "DELETE")
_connect = sqlite3.connect
_counts: Counter[str] = Counter()
_durations: list[float] = []


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--questions", type=int, default=6, help="questions shown so far (default: 6)")
    parser.add_argument("--students", type=int, default=30)
    parser.add_argument("--ticks", type=int, default=50)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        os.environ["RAMANUJAN_CLASSES"] = f"{folder}/classes.sqlite"
        opened, seat = play(arguments.questions, arguments.students)
        stop = STOPS[arguments.questions - 1]
        common = {"stop": stop.id, "class_seen": stop.id}
        screens = {
            "desk": (draw_desk, common | {"class_key": opened.key}),
            "wall": (draw_wall, common | {"class_wall": opened.code}),
            "phone": (draw_phone, common | {"class_seat": seat, "class_drawn": (stop.id, True), "class_is_open": True}),
        }
        print(f"{arguments.questions} questions, {arguments.students} students, median of {arguments.ticks} ticks")
        print(f"{'':<8}{'connections':>12}{'queries':>9}{'milliseconds':>14}")
        for name, (draw, state) in screens.items():
            print_costs(name, draw, state, arguments.ticks)


def play(questions: int, students: int) -> tuple[Class, Any]:
    """Play a class up to the answer of its last question. Return the class and the seat of a student."""
    school = shared()
    opened = school.open_class()
    seats = [school.join(opened.code) for _ in range(students)]
    for stop in STOPS[:questions]:
        options = list(stop.options)
        school.ask(opened.key, stop.id, options)
        for number, seat in enumerate(seats):
            school.vote(seat, stop.id, options[number % len(options)])
        for phase in (Phase.REVEALED, Phase.RUNNING, Phase.SOLVED):
            school.show(opened.key, phase)
    return opened, seats[0]


def print_costs(name: str, draw: Any, state: dict[str, Any], ticks: int) -> None:
    """Draw a screen many times, and print the costs of a tick."""
    app = AppTest.from_function(draw, default_timeout=60)
    for key, value in state.items():
        app.session_state[key] = value
    # The first tick fills the caches.
    app.run()
    _counts.clear()
    _durations.clear()
    sqlite3.connect = count_connection
    for _ in range(ticks):
        app.run()
    sqlite3.connect = _connect
    assert not app.exception, app.exception
    costs = (_counts["connections"] / ticks, _counts["queries"] / ticks, 1000 * statistics.median(_durations))
    print(f"{name:<8}{costs[0]:>12.1f}{costs[1]:>9.1f}{costs[2]:>14.1f}", flush=True)


def count_connection(*arguments: Any, **options: Any) -> sqlite3.Connection:
    """Open a connection whose queries are counted. PRAGMA, BEGIN and COMMIT do not count."""
    connection = _connect(*arguments, **options)
    _counts["connections"] += 1

    def count(statement: str) -> None:
        _counts["queries"] += statement.lstrip().startswith(_QUERIES)

    connection.set_trace_callback(count)
    return connection


def measure(draw: partial[None]) -> None:
    """Draw a screen, and store the duration."""
    start = perf_counter()
    draw()
    _durations.append(perf_counter() - start)


def draw_desk() -> None:
    """Draw the desk that the session state describes, as one script."""
    from functools import partial

    import streamlit as st

    from ramanujan import lesson
    from ramanujan.classroom.rules import Phase
    from ramanujan.pages.classroom import desk as screen
    from tests.benchmarks import ticks

    ticks.measure(partial(screen._draw_live_desk, lesson.find_stop(st.session_state["stop"]), Phase.SOLVED))


def draw_wall() -> None:
    """Draw the part of a wall that changes often, as one script."""
    from functools import partial

    import streamlit as st

    from ramanujan.pages.classroom import wall
    from tests.benchmarks import ticks

    ticks.measure(partial(wall._follow_class, st.session_state["class_wall"]))


def draw_phone() -> None:
    """Draw the question on a phone, as one script."""
    from functools import partial

    from ramanujan.pages.classroom import phone as screen
    from tests.benchmarks import ticks

    ticks.measure(partial(screen._draw_live_question))


if __name__ == "__main__":
    # Under its module name, so that the scripts of the screens share its counters.
    from tests.benchmarks import ticks

    ticks.main()
