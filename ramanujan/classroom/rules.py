"""Voting in class: students answer the lecturer's question, and see the distribution when the lecturer shows it.

    classes = shared()
    opened = classes.open_class()                   # a public code, and a secret key for the lecturer
    seat = classes.join(opened.code)                # a student, with a random name
    classes.ask(opened.key, "faster", ["machine", "plain"])
    classes.vote(seat, "faster", "plain")
    classes.show(opened.key, Phase.REVEALED)
    classes.read_distribution(opened.code, "faster")     # {"machine": 0, "plain": 1}
    classes.begin_second_vote(opened.key)           # after the discussion

A refused action raises `ClassError` with one sentence. Several processes share one database (`store`). An expired
class is deleted with all its votes. The method is from E. Mazur, *Peer Instruction* (1997).
"""

import re
import secrets
import time
from collections import Counter
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from ramanujan.classroom import codes
from ramanujan.classroom.states import END, Class, ClassQuestion, ClassResult, ClassView, Phase, Seat, Vote
from ramanujan.classroom.store import ClassError, SeatError, database_address, store_at
from ramanujan.text.translation import _

STUDENTS = 500
"""The largest number of students in one class."""
CLASSES = 200
"""The largest number of classes at one time."""
ABSENCE = 600.0
"""A new class may replace one in which nobody has been present for this long [s]."""
LIFETIME = 7 * 24 * 3600.0
"""The time until a class is deleted, unless its lecturer ends it before [s]."""
PRESENCE_DURATION = 20.0
"""A student counts as present for this long after a request [s]."""
NEW_SEAT = 60.0
"""A seat is new for this long [s]."""
PRESENCE_INTERVAL = 5.0
"""The shortest interval between two updates of the last request of a student or of a class [s].

Screens send more requests. A class without a request after its first seconds counts as left at once.
"""

_ID = re.compile(r"[a-z0-9_-]{1,40}", re.ASCII)
_Execute = Callable[..., Any]


class _Row(NamedTuple):
    """A row of the query `_CLASS`."""

    code: str
    key_hash: str
    opened: float
    visited: float
    expires: float
    is_open: int
    machine: str | None
    seen: str | None
    seen_at: float | None
    current_stop: str | None
    current_asking: int
    current_number: int
    taken: int
    present: int
    answered: int
    heard: float | None
    stop: str | None
    asking: int
    number: int
    phase: int
    reached: int
    option: str | None


_CLASS = """
WITH this AS MATERIALIZED (
    SELECT code, key_hash, opened, visited, expires, is_open, machine, seen, seen_at, stop, asking, number,
           (SELECT COUNT(*) FROM voter WHERE voter.code = class.code),
           (SELECT COUNT(*) FROM voter WHERE voter.code = class.code AND heard > ?),
           (SELECT COUNT(*) FROM vote JOIN voter ON voter.code = vote.code AND voter.voter = vote.voter
            WHERE vote.code = class.code AND vote.stop = class.stop AND vote.asking = class.asking
            AND vote.number = class.number AND heard > ?),
           (SELECT heard FROM voter WHERE voter.code = class.code AND voter.voter = ?)
    FROM class WHERE code = ? AND expires > ?)
SELECT this.*, question.stop, question.asking, question.number, phase, reached, option
FROM this LEFT JOIN question ON question.code = this.code
LEFT JOIN vote ON vote.code = question.code AND vote.stop = question.stop AND vote.asking = question.asking
AND vote.number = question.number AND vote.voter = ?
ORDER BY asked, question.asking, question.number
"""
"""The row of a class, once for each vote on each of its questions, with the answers of one student."""
_CHANGES = """
SELECT before.option = ?, after.option = ?, COUNT(*)
FROM vote AS before JOIN vote AS after USING (code, stop, asking, voter)
WHERE code = ? AND stop = ? AND asking = ? AND before.number = 1 AND after.number = 2
GROUP BY 1, 2
"""
_REMOVE_LEFT = """
DELETE FROM class WHERE code = (SELECT code FROM class WHERE visited <= ? ORDER BY visited, opened LIMIT 1)
"""
_RESULTS = """
SELECT stop, asking, number, options, asked, present, option, COUNT(option)
FROM question LEFT JOIN vote USING (code, stop, asking, number) WHERE code = ? AND reached > 0
GROUP BY stop, asking, number, options, asked, present, option ORDER BY asked, asking, number
"""
_SEATS = """
SELECT COUNT(CASE WHEN voter NOT IN (SELECT voter FROM vote WHERE code = ?) THEN 1 END),
       COUNT(CASE WHEN joined > ? THEN 1 END)
FROM voter WHERE code = ?
"""
"""The numbers of seats without any vote, and of new seats."""
_THIS_VOTE = "code = ? AND stop = ? AND asking = ? AND number = ?"


class Classes:
    """All classes of one database.

    address : the path of a file, or the address of a PostgreSQL server
    clock : function that returns the seconds since 1970, the same for all processes
    """

    def __init__(self, address: str | Path, clock: Callable[[], float] = time.time) -> None:
        self._store = store_at(address)
        self._clock = clock

    # ---- the lecturer

    def open_class(self) -> Class:
        """Open a class with a new code and a new key.

        If `CLASSES` classes exist, the one that has been longest without a desk, a wall or a phone is deleted.

        Raises
        ------
        ClassError : somebody has been present in every class lately.
        """
        secret = secrets.token_urlsafe(codes.SECRET_BYTES)
        now = self._clock()
        with self._store.writing() as execute:
            self._delete_old(execute)
            if _count_rows(execute, "class") >= CLASSES:
                removed = execute(_REMOVE_LEFT, (now - ABSENCE,)).rowcount
                if not removed:
                    raise ClassError(_("This server has no room for another class at the moment. Try again later."))
            code = codes.generate_code()
            while _count_rows(execute, "class WHERE code = ?", code):
                code = codes.generate_code()
            values = (code, codes.hash_secret(secret), now, now + LIFETIME)
            execute("INSERT INTO class (code, key_hash, opened, expires) VALUES (?, ?, ?, ?)", values)
        return Class(code, codes.join_key(code, secret))

    def close(self, key: str) -> None:
        """Delete a class and all its rows."""
        code = self.find_code(key)
        with self._store.writing() as execute:
            execute("DELETE FROM class WHERE code = ?", (code,))

    def find_code(self, key: str) -> str:
        """Return the code of the class that belongs to a lecturer's key."""
        code, secret = codes.split_key(key)
        rows = self._store.read("SELECT key_hash FROM class WHERE code = ? AND expires > ?", (code, self._clock()))
        _check_secret(secret, rows[0][0] if rows else "")
        return code

    def read_for_lecturer(self, key: str) -> ClassView:
        """Return the class that belongs to a lecturer's key, for a desk that is present."""
        code, secret = codes.split_key(key)
        rows = self._read_rows(code)
        _check_secret(secret, rows[0].key_hash if rows else "")
        return self._view(rows)

    def ask(self, key: str, stop: str, options: Sequence[str], anew: bool = False) -> None:
        """Take the class to a question.

        An earlier question is resumed with its votes, or opened again without votes if `anew`. The database keeps the
        earlier votes.
        """
        code = self.find_code(key)
        if not all(_ID.fullmatch(id) for id in (stop, *options)):
            raise ValueError(_("The ids of {stop} must have small letters, digits, - and _ only.").format(stop=stop))
        with self._store.writing() as execute:
            query = "SELECT asking, number FROM question WHERE code = ? AND stop = ? ORDER BY asking DESC, number DESC"
            row = execute(query, (code, stop)).fetchone()
            if row is None:
                vote = Vote()
            elif anew:
                times_asked, _number = row
                vote = Vote(times_asked + 1)
            else:
                vote = Vote(*row)
            self._begin_vote(execute, code, stop, vote, " ".join(options))

    def show(self, key: str, phase: Phase) -> None:
        """Show the current question in a phase, which may be earlier; after REVEALED it takes no more answers."""
        code = self.find_code(key)
        with self._store.writing() as execute:
            stop, vote, _options, _reached = _read_current(execute, code)
            present = _count_rows(execute, "voter WHERE code = ? AND heard > ?", code, self._earliest_presence)
            # Without a condition on `number`, a second vote is shown together with the first.
            execute(
                "UPDATE question SET present = CASE WHEN reached = 0 THEN ? ELSE present END, phase = ?, "
                "reached = CASE WHEN reached > ? THEN reached ELSE ? END WHERE code = ? AND stop = ? AND asking = ?",
                (present, *[int(phase)] * 3, code, stop, vote.times_asked),
            )

    def finish(self, key: str) -> None:
        """Take the class to the end of the lesson, `END`."""
        self._update_class(key, stop=END)

    def begin_second_vote(self, key: str) -> None:
        """Begin the second vote on the current question and close the first."""
        code = self.find_code(key)
        with self._store.writing() as execute:
            stop, vote, options, reached = _read_current(execute, code)
            if reached == Phase.SOLVED:
                raise ClassError(_("The class has already seen the right answer to this question."))
            if vote.is_second:
                raise ClassError(_("The class has already voted twice on this question."))
            self._begin_vote(execute, code, stop, vote._replace(number=2), options)

    def set_machine(self, key: str, machine: str) -> None:
        """Store the values of the lecturer's sliders, as a URL query, for the wall."""
        self._update_class(key, machine=machine)

    def set_view(self, key: str, view: str) -> None:
        """Store the desk's view of the machine and the current time, for all screens."""
        self._update_class(key, seen=view, seen_at=self._clock())

    def read_results_for_lecturer(self, key: str) -> list[ClassResult]:
        """Return the results of all questions whose votes were shown, the earliest question first."""
        votes: dict[tuple[str, Vote], dict[str, int]] = {}
        shown: dict[tuple[str, Vote], tuple[float, int]] = {}
        rows = self._store.read(_RESULTS, (self.find_code(key),))
        for stop, times_asked, number, options, at, present, option, count in rows:
            question = stop, Vote(times_asked, number)
            shown[question] = at, present
            votes.setdefault(question, dict.fromkeys(options.split(), 0))
            if option:
                votes[question][option] = count
        results = []
        for (stop, vote), first in votes.items():
            if vote.is_second:
                continue
            second_question = stop, vote._replace(number=2)
            at, present = shown[stop, vote]
            # After a second vote, count the students who saw its result.
            _at, present = shown.get(second_question, (at, present))
            results.append(ClassResult(stop, at, present, first, votes.get(second_question)))
        return results

    def let_join(self, key: str, is_open: bool) -> None:
        """Open or close the class to new students; a student with a seat stays."""
        self._update_class(key, is_open=int(is_open))

    def count_unusual_seats(self, key: str) -> tuple[int, int]:
        """Return the number of seats that never voted, and of seats taken within `NEW_SEAT`.

        A lecturer compares them with the students in the room, because a student with two browsers has two seats.
        """
        code = self.find_code(key)
        [(silent, new)] = self._store.read(_SEATS, (code, self._clock() - NEW_SEAT, code))
        return silent, new

    def remove_absent(self, key: str) -> None:
        """Remove all absent students, and their answers to the current question while its result is hidden."""
        code = self.find_code(key)
        absent = "voter IN (SELECT voter FROM voter WHERE code = ? AND heard <= ?)"
        with self._store.writing() as execute:
            if _count_rows(execute, "class JOIN question USING (code, stop, asking, number) WHERE code = ?", code):
                stop, vote, _options, reached = _read_current(execute, code)
                if reached == Phase.ASKED:
                    values = (code, stop, *vote, code, self._earliest_presence)
                    execute(f"DELETE FROM vote WHERE {_THIS_VOTE} AND {absent}", values)
            execute("DELETE FROM voter WHERE code = ? AND heard <= ?", (code, self._earliest_presence))

    # ---- a student

    def join(self, code: str, voter: str = "") -> Seat:
        """Return a seat in a class, the old one if the voter has one.

        Wrong codes are not counted, so they lock nobody out. A wrong code writes nothing to the database.

        Parameters
        ----------
        code : as typed, or from a link
        voter : random name of the browser in this class; empty for a new one

        Raises
        ------
        ClassError : the code is wrong, or the class is closed or full.
        """
        class_code = codes.read_code(code)
        if class_code is None:
            raise ClassError(_explain_wrong_code(code))
        seat = None
        if self._store.read("SELECT 1 FROM class WHERE code = ?", (class_code,)):
            with self._store.writing() as execute:
                self._delete_old(execute)
                seat = self._take_seat(execute, class_code, voter)
        if seat is None:
            raise ClassError(_no_such_class())
        return seat

    def vote(self, seat: Seat, stop: str, option: str, vote: Vote | None = None) -> None:
        """Store a student's answer to the current question; it replaces an earlier answer.

        Parameters
        ----------
        seat : of the student
        stop, option : ids
        vote : the vote on the student's screen; by default the current one

        Raises
        ------
        ClassError : the answer is too late or unknown, or the class has ended.
        SeatError : the student has lost the seat.
        """
        code, voter = seat.code, seat.voter
        with self._store.writing() as execute:
            if not _count_rows(execute, "class WHERE code = ? AND expires > ?", code, self._clock()):
                raise ClassError(_no_such_class())
            if not _count_rows(execute, "voter WHERE code = ? AND voter = ?", code, voter):
                raise SeatError(_no_seat())
            # After a lost connection a browser repeats an answer that counts already.
            same_answer = f"vote WHERE {_THIS_VOTE} AND voter = ? AND option = ?"
            if vote and _count_rows(execute, same_answer, code, stop, *vote, voter, option):
                return
            current_stop, current_vote, options, reached = _read_current(execute, code)
            if current_stop != stop:
                raise ClassError(_("Your answer came too late: the class has gone on to another question."))
            if reached > Phase.ASKED:
                raise ClassError(_("Your answer came too late: the result has already been shown."))
            if vote and vote != current_vote:
                raise ClassError(_("Your answer came too late: another vote has begun. Please answer again."))
            if option not in options.split():
                raise ClassError(_("This question has no such answer."))
            execute(
                "INSERT INTO vote VALUES (?, ?, ?, ?, ?, ?) "
                "ON CONFLICT (code, stop, asking, number, voter) DO UPDATE SET option = excluded.option",
                (code, stop, *current_vote, voter, option),
            )
            execute("UPDATE voter SET heard = ? WHERE code = ? AND voter = ?", (self._clock(), code, voter))

    # ---- everybody

    def read(self, code: str, voter: str = "") -> ClassView:
        """Return a class by a single query, for a screen that is present.

        Every screen calls this every few seconds.

        Parameters
        ----------
        code : code of the class
        voter : the student who reads it, if any

        Raises
        ------
        ClassError : the class has ended.
        SeatError : the student has lost the seat.
        """
        rows = self._read_rows(code, voter)
        if not rows:
            raise ClassError(_("The class has ended."))
        if voter and rows[0].heard is None:
            raise SeatError(_no_seat())
        return self._view(rows, voter)

    def read_distribution(self, code: str, stop: str, vote: Vote | None = None) -> dict[str, int]:
        """Return option → number of votes, by default of the last vote whose result has been shown."""
        query = (
            "SELECT options, asking, number FROM question WHERE code = ? AND stop = ? AND reached > 0 "
            "ORDER BY asking DESC, number DESC"
        )
        for options, times_asked, number in self._store.read(query, (code, stop)):
            shown_vote = Vote(times_asked, number)
            if vote in (None, shown_vote):
                counts = f"SELECT option, COUNT(*) FROM vote WHERE {_THIS_VOTE} GROUP BY option"
                votes = dict(self._store.read(counts, (code, stop, *shown_vote)))
                return {option: votes.get(option, 0) for option in options.split()}
        raise ClassError(_("The result of this question has not been shown yet."))

    def count_changes(self, code: str, stop: str, right: str, times_asked: int = 1) -> Counter[tuple[bool, bool]]:
        """Count the students who voted twice by whether each of their votes was right.

        Parameters
        ----------
        code, stop : the class and the question
        right : id of the right option
        times_asked : the field of both votes

        Returns
        -------
        (right in the first vote, right in the second vote) → number of students
        """
        # This call raises an error if the result has not been shown.
        self.read_distribution(code, stop, Vote(times_asked, 2))
        rows = self._store.read(_CHANGES, (right, right, code, stop, times_asked))
        return Counter({(bool(before), bool(after)): number for before, after, number in rows})

    def delete_expired(self) -> None:
        """Delete the expired classes; without a database, do nothing."""
        if self._store.exists():
            with self._store.writing() as execute:
                self._delete_old(execute)

    # ---- inside

    @property
    def _earliest_presence(self) -> float:
        """A student whose last request is later counts as present [s since 1970]."""
        return self._clock() - PRESENCE_DURATION

    def _read_rows(self, code: str, voter: str = "") -> list[_Row]:
        """Return the rows of a class for one of its students; no rows if the class has ended."""
        values = (self._earliest_presence, self._earliest_presence, voter, code, self._clock(), voter)
        return [_Row(*row) for row in self._store.read(_CLASS, values)]

    def _view(self, rows: Sequence[_Row], voter: str = "") -> ClassView:
        """Return the class in these rows, and mark its class and the student who reads it as present."""
        row = rows[0]
        self._mark_present(row, voter)
        asked = tuple(_read_question(each) for each in rows if each.stop)
        current = ClassQuestion(row.current_stop, Vote(row.current_asking, row.current_number))
        for question in asked:
            if (question.stop, question.vote) == (current.stop, current.vote):
                current = question
        return ClassView(
            current=current,
            asked=asked,
            answered=row.answered,
            present=row.present,
            taken=row.taken,
            is_open=bool(row.is_open),
            expires=row.expires,
            machine=row.machine,
            desk_view=row.seen,
            desk_view_age=self._clock() - (row.seen_at or 0.0),
        )

    def _mark_present(self, row: _Row, voter: str) -> None:
        """Store the time of a request of a screen, unless the class and the student have sent another one lately."""
        now = self._clock()
        is_class_due = now - max(row.opened, row.visited) > PRESENCE_INTERVAL
        is_student_due = row.heard is not None and now - row.heard > PRESENCE_INTERVAL
        if not (is_class_due or is_student_due):
            return
        with self._store.writing() as execute:
            if is_class_due:
                execute("UPDATE class SET visited = ? WHERE code = ?", (now, row.code))
            if is_student_due:
                execute("UPDATE voter SET heard = ? WHERE code = ? AND voter = ?", (now, row.code, voter))

    def _update_class(self, key: str, **columns: object) -> None:
        """Set columns of the lecturer's class."""
        code = self.find_code(key)
        assignments = ", ".join(f"{name} = ?" for name in columns)
        with self._store.writing() as execute:
            execute(f"UPDATE class SET {assignments} WHERE code = ?", (*columns.values(), code))

    def _delete_old(self, execute: _Execute) -> None:
        """Delete the expired classes."""
        execute("DELETE FROM class WHERE expires <= ?", (self._clock(),))

    def _begin_vote(self, execute: _Execute, code: str, stop: str, vote: Vote, options: str) -> None:
        """Make a vote the current one of a class, and create it if it is new."""
        # A vote fills the columns `asking` and `number`.
        execute(
            "INSERT INTO question (code, stop, asking, number, options, asked) VALUES (?, ?, ?, ?, ?, ?) "
            "ON CONFLICT DO NOTHING",
            (code, stop, *vote, options, self._clock()),
        )
        execute("UPDATE class SET stop = ?, asking = ?, number = ? WHERE code = ?", (stop, *vote, code))

    def _take_seat(self, execute: _Execute, code: str, voter: str) -> Seat | None:
        """Return the old or a new seat of a visitor, None if the class has just ended."""
        mark_present = "UPDATE voter SET heard = ? WHERE code = ? AND voter = ?"
        if execute(mark_present, (self._clock(), code, voter)).rowcount:
            return Seat(code, voter)
        row = execute("SELECT is_open FROM class WHERE code = ?", (code,)).fetchone()
        if not row:
            return None
        (is_open,) = row
        if not is_open:
            raise ClassError(_("The lecturer has closed this class to newcomers. Ask for it to be opened."))
        if _count_rows(execute, "voter WHERE code = ?", code) >= STUDENTS:
            raise ClassError(_("This class is full: it has {most} students.").format(most=STUDENTS))
        seat = Seat(code, voter or secrets.token_urlsafe(codes.VOTER_BYTES))
        now = self._clock()
        execute("INSERT INTO voter VALUES (?, ?, ?, ?)", (code, seat.voter, now, now))
        return seat


@cache
def _open_classes(address: str) -> Classes:
    return Classes(address)


def shared() -> Classes:
    """Return the classes of this server."""
    return _open_classes(database_address())


def _read_question(row: _Row) -> ClassQuestion:
    """Return the question in a row."""
    return ClassQuestion(row.stop, Vote(row.asking, row.number), Phase(row.phase), Phase(row.reached), row.option)


def _check_secret(secret: str, key_hash: str) -> None:
    """Raise `ClassError` if a lecturer's secret does not have this hash. The hash of a missing class is empty."""
    # A comparison in constant time reveals nothing about the hash.
    if not secrets.compare_digest(key_hash, codes.hash_secret(secret)):
        raise ClassError(_("This lecturer’s address belongs to no class. The class may have ended."))


def _count_rows(execute: _Execute, condition: str, *values: object) -> int:
    """Return the number of rows. The condition is the rest of the statement, "table WHERE …"."""
    return execute(f"SELECT COUNT(*) FROM {condition}", values).fetchone()[0]


def _read_current(execute: _Execute, code: str) -> tuple[str, Vote, str, Phase]:
    """Return the current stop, its vote, its options, and the phase it has reached."""
    query = (
        "SELECT stop, asking, number, options, reached FROM class JOIN question USING (code, stop, asking, number) "
        "WHERE code = ?"
    )
    row = execute(query, (code,)).fetchone()
    if row is None:
        raise ClassError(_("The class is asked no question at the moment."))
    stop, times_asked, number, options, reached = row
    return stop, Vote(times_asked, number), options, Phase(reached)


def _explain_wrong_code(text: str) -> str:
    """Return a sentence about the error in a text that is not a code."""
    letter = codes.find_foreign_letter(text)
    if letter:
        sentence = _("No class code contains {letter}. Look at the projector and type the code again.")
        return sentence.format(letter=letter)
    return _("A class code has six letters. Look at the projector and type them again.")


def _no_seat() -> str:
    return _("Your answer did not count. Join the class again with its code.")


def _no_such_class() -> str:
    return _("There is no class with this code. It may have ended; look at the projector and type the code again.")
