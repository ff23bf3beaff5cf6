"""Voting in class: students answer the lecturer's question, and see the distribution when the lecturer shows it.

    classes = shared()
    opened = classes.open_class()                   # a public code, and a secret key for the lecturer
    seat = classes.join(opened.code)                # a student, with a random name
    classes.ask(opened.key, "faster", ["machine", "plain"])
    classes.vote(seat, "faster", "plain")
    classes.show(opened.key, Phase.REVEALED)
    classes.read_distribution(opened.code, "faster")     # {"machine": 0, "plain": 1}
    classes.begin_second_vote(opened.key)           # after the discussion

A refused action raises `ClassError` with one sentence. Several processes share one database (`class_store`). An expired
class is deleted with all its votes. The method is from E. Mazur, *Peer Instruction* (1997).
"""

import re
import secrets
import time
from collections import Counter
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from ramanujan.lesson import class_codes
from ramanujan.lesson.class_states import END, Class, ClassQuestion, ClassResult, Phase, Seat, Seats, Vote
from ramanujan.lesson.class_store import ClassError, CrowdError, SeatError, database_address, store_at
from ramanujan.translation import _

STUDENTS = 500
"""The largest number of students in one class."""
NETWORK_SEATS = 60
"""The largest number of new seats for one network in a class within a `MINUTE`: a lecture hall behind one router.

The number of classes that one network opens within a `MINUTE` has the same limit.
"""
CLASSES = 200
"""The largest number of classes at one time."""
DAY = 24 * 3600.0
LIFETIMES = (DAY, 7 * DAY, 30 * DAY)
"""The lifetimes of a class, the default first [s]."""
PRESENCE_DURATION = 20.0
"""A student counts as present for this long after a request [s]."""
PRESENCE_INTERVAL = 5.0
"""The shortest interval between two updates of a student's last request [s]; phones send twice as many requests."""
MINUTE = 60.0

_ID = re.compile(r"[a-z0-9_-]{1,40}", re.ASCII)
_Execute = Callable[..., Any]

_COUNT_PRESENT = "SELECT COUNT(*) FROM voter WHERE voter.code = class.code AND heard > ?"
_QUESTION = f"""
SELECT stop, asking, number, COALESCE(phase, 0), COALESCE(reached, 0),
       (SELECT COUNT(*) FROM vote JOIN voter ON voter.code = vote.code AND voter.voter = vote.voter
        WHERE vote.code = class.code AND vote.stop = class.stop AND vote.asking = class.asking
        AND vote.number = class.number AND heard > ?),
       ({_COUNT_PRESENT})
FROM class LEFT JOIN question USING (code, stop, asking, number) WHERE code = ? AND expires > ?
"""
_CHANGES = """
SELECT before.option = ?, after.option = ?, COUNT(*)
FROM vote AS before JOIN vote AS after USING (code, stop, asking, voter)
WHERE code = ? AND stop = ? AND asking = ? AND before.number = 1 AND after.number = 2
GROUP BY 1, 2
"""
_REMOVE_UNUSED = """
DELETE FROM class WHERE code = (SELECT code FROM class WHERE was_joined = 0 ORDER BY opened LIMIT 1)
"""
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

    def open_class(self, lifetime: float = DAY, address: str = "") -> Class:
        """Open a class with a new code and a new key.

        If `CLASSES` classes exist, the oldest class without students is deleted.

        Parameters
        ----------
        lifetime : time until the class is deleted [s]
        address : IP address of the lecturer, for the limit of classes per network

        Raises
        ------
        ClassError : a limit is reached.
        """
        secret = secrets.token_urlsafe(class_codes.SECRET_BYTES)
        now, network = self._clock(), class_codes.hash_network(address)
        with self._store.writing() as execute:
            self._delete_old(execute)
            # `_delete_old` has removed the networks of classes opened more than a minute ago.
            if _count_rows(execute, "class WHERE network = ?", network) >= NETWORK_SEATS:
                sentence = _("{most} classes were opened from your network within a minute. Try again in a minute.")
                raise CrowdError(sentence.format(most=NETWORK_SEATS))
            if _count_rows(execute, "class") >= CLASSES:
                removed = execute(_REMOVE_UNUSED).rowcount
                if not removed:
                    raise ClassError(_("This server has no room for another class at the moment. Try again later."))
            code = class_codes.generate_code()
            while _count_rows(execute, "class WHERE code = ?", code):
                code = class_codes.generate_code()
            execute(
                "INSERT INTO class (code, key_hash, expires, opened, network, was_joined) VALUES (?, ?, ?, ?, ?, 0)",
                (code, class_codes.hash_secret(secret), now + lifetime, now, network),
            )
        return Class(code, class_codes.join_key(code, secret))

    def close(self, key: str) -> None:
        """Delete a class and all its rows."""
        code = self.find_code(key)
        with self._store.writing() as execute:
            execute("DELETE FROM class WHERE code = ?", (code,))

    def find_code(self, key: str) -> str:
        """Return the code of the class that belongs to a lecturer's key."""
        code, secret = class_codes.split_key(key)
        rows = self._store.read("SELECT key_hash FROM class WHERE code = ? AND expires > ?", (code, self._clock()))
        # A comparison in constant time reveals nothing about the hash.
        if not rows or not secrets.compare_digest(rows[0][0], class_codes.hash_secret(secret)):
            raise ClassError(_("This lecturer’s address belongs to no class. The class may have ended."))
        return code

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
        """Return the results of the class that belongs to a key."""
        return self.read_results(self.find_code(key))

    def read_results(self, code: str, reached: Phase = Phase.REVEALED) -> list[ClassResult]:
        """Return the results of all questions that have reached at least this phase, the earliest question first."""
        rows = self._store.read(
            "SELECT stop, asking, number, options, asked, present FROM question WHERE code = ? AND reached >= ? "
            "ORDER BY asked, asking, number",
            (code, int(reached)),
        )
        students_present = {}
        for stop, times_asked, number, _options, _at, present in rows:
            students_present[stop, Vote(times_asked, number)] = present
        results = []
        for stop, times_asked, number, options, at, present in rows:
            vote = Vote(times_asked, number)
            if vote.is_second:
                continue
            first = self._count_votes(code, stop, vote, options)
            second = None
            second_vote = vote._replace(number=2)
            if (stop, second_vote) in students_present:
                second = self._count_votes(code, stop, second_vote, options)
                # Count the students who saw the result, after the second vote.
                present = students_present[stop, second_vote]
            results.append(ClassResult(stop=stop, at=at, present=present, first=first, second=second))
        return results

    def count_seats(self, key: str) -> Seats:
        """Return the numbers of seats, and whether more students may join."""
        code = self.find_code(key)
        query = (
            f"SELECT (SELECT COUNT(*) FROM voter WHERE voter.code = class.code), ({_COUNT_PRESENT}), (SELECT COUNT(*) "
            "FROM voter WHERE voter.code = class.code AND joined > ?), is_open FROM class WHERE code = ?"
        )
        # The first ? of the query is in _COUNT_PRESENT.
        values = (self._earliest_presence, self._clock() - MINUTE, code)
        [(taken, present, newcomers, is_open)] = self._store.read(query, values)
        return Seats(taken, present, newcomers, bool(is_open))

    def let_join(self, key: str, is_open: bool) -> None:
        """Open or close the class to new students; a student with a seat stays."""
        self._update_class(key, is_open=int(is_open))

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

    def join(self, code: str, voter: str = "", address: str = "") -> Seat:
        """Return a seat in a class, the old one if the voter has one.

        Wrong codes are not counted, so they lock nobody out. A wrong code writes nothing to the database.

        Parameters
        ----------
        code : as typed, or from a link
        voter : random name of the browser in this class; empty for a new one
        address : IP address of the visitor, for the limit of seats per network

        Raises
        ------
        ClassError : the code is wrong, or the class is closed or full.
        """
        class_code = class_codes.read_code(code)
        if class_code is None:
            raise ClassError(_explain_wrong_code(code))
        seat = None
        if self._store.read("SELECT 1 FROM class WHERE code = ?", (class_code,)):
            with self._store.writing() as execute:
                self._delete_old(execute)
                seat = self._take_seat(execute, class_code, voter, class_codes.hash_network(address, class_code))
        if seat is None:
            raise ClassError(_no_such_class())
        return seat

    def read_answer(self, seat: Seat, question: ClassQuestion) -> str | None:
        """Return the student's answer to a question, and mark the student as present."""
        now = self._clock()
        rows = self._store.read(
            "SELECT option, heard FROM voter LEFT JOIN vote ON vote.code = voter.code AND vote.voter = voter.voter "
            "AND stop = ? AND asking = ? AND number = ? WHERE voter.code = ? AND voter.voter = ?",
            (question.stop, *question.vote, seat.code, seat.voter),
        )
        if not rows:
            raise SeatError(_no_seat())
        option, heard = rows[0]
        if now - heard > PRESENCE_INTERVAL:
            with self._store.writing() as execute:
                execute("UPDATE voter SET heard = ? WHERE code = ? AND voter = ?", (now, seat.code, seat.voter))
        return option

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

    def read_question(self, code: str) -> ClassQuestion:
        """Return the current question of a class.

        Every phone calls this every few seconds, so it is one read by keys.
        """
        rows = self._store.read(_QUESTION, (self._earliest_presence, self._earliest_presence, code, self._clock()))
        if not rows:
            raise ClassError(_("The class has ended."))
        stop, times_asked, number, phase, reached, answered, present = rows[0]
        return ClassQuestion(
            stop=stop,
            vote=Vote(times_asked, number),
            phase=Phase(phase),
            reached=Phase(reached),
            answered=answered,
            present=present,
        )

    def read_last_state(self, code: str, stop: str) -> ClassQuestion | None:
        """Return the last state of an earlier question, without its numbers of students; None if it was never asked."""
        query = (
            "SELECT asking, number, phase, reached FROM question WHERE code = ? AND stop = ? "
            "ORDER BY asking DESC, number DESC"
        )
        rows = self._store.read(query, (code, stop))
        if not rows:
            return None
        times_asked, number, phase, reached = rows[0]
        return ClassQuestion(stop, Vote(times_asked, number), Phase(phase), Phase(reached), answered=0, present=0)

    def read_expiry(self, code: str) -> float:
        """Return the time at which the class and all its answers are deleted [s since 1970]."""
        rows = self._store.read("SELECT expires FROM class WHERE code = ? AND expires > ?", (code, self._clock()))
        if not rows:
            raise ClassError(_("The class has ended."))
        return rows[0][0]

    def read_machine(self, code: str) -> str | None:
        """Return the values of the lecturer's sliders, as a URL query."""
        rows = self._store.read("SELECT machine FROM class WHERE code = ?", (code,))
        return rows[0][0] if rows else None

    def read_view(self, code: str) -> tuple[str | None, float]:
        """Return the desk's view of the machine as `set_view` stored it, and its age [s]."""
        rows = self._store.read("SELECT seen, seen_at FROM class WHERE code = ?", (code,))
        view, stored_at = rows[0] if rows else (None, None)
        return view, self._clock() - (stored_at or 0.0)

    def read_distribution(self, code: str, stop: str, vote: Vote | None = None) -> dict[str, int]:
        """Return option → number of votes, by default of the last vote whose result has been shown."""
        query = (
            "SELECT options, asking, number FROM question WHERE code = ? AND stop = ? AND reached > 0 "
            "ORDER BY asking DESC, number DESC"
        )
        for options, times_asked, number in self._store.read(query, (code, stop)):
            shown_vote = Vote(times_asked, number)
            if vote in (None, shown_vote):
                return self._count_votes(code, stop, shown_vote, options)
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

    def _update_class(self, key: str, **columns: object) -> None:
        """Set columns of the lecturer's class."""
        code = self.find_code(key)
        assignments = ", ".join(f"{name} = ?" for name in columns)
        with self._store.writing() as execute:
            execute(f"UPDATE class SET {assignments} WHERE code = ?", (*columns.values(), code))

    def _count_votes(self, code: str, stop: str, vote: Vote, options: str) -> dict[str, int]:
        """Return option → number of votes; `options` are separated by spaces."""
        query = f"SELECT option, COUNT(*) FROM vote WHERE {_THIS_VOTE} GROUP BY option"
        votes = dict(self._store.read(query, (code, stop, *vote)))
        return {option: votes.get(option, 0) for option in options.split()}

    def _delete_old(self, execute: _Execute) -> None:
        """Delete the expired classes, and the networks of visitors who joined more than a minute ago."""
        execute("DELETE FROM class WHERE expires <= ?", (self._clock(),))
        earlier = self._clock() - MINUTE
        execute("UPDATE class SET network = NULL WHERE network IS NOT NULL AND opened <= ?", (earlier,))
        execute("UPDATE voter SET network = NULL WHERE network IS NOT NULL AND joined <= ?", (earlier,))

    def _begin_vote(self, execute: _Execute, code: str, stop: str, vote: Vote, options: str) -> None:
        """Make a vote the current one of a class, and create it if it is new."""
        # A vote fills the columns `asking` and `number`.
        execute(
            "INSERT INTO question (code, stop, asking, number, options, asked) VALUES (?, ?, ?, ?, ?, ?) "
            "ON CONFLICT DO NOTHING",
            (code, stop, *vote, options, self._clock()),
        )
        execute("UPDATE class SET stop = ?, asking = ?, number = ? WHERE code = ?", (stop, *vote, code))

    def _take_seat(self, execute: _Execute, code: str, voter: str, network: str) -> Seat | None:
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
        # `_delete_old` has removed the networks of students who joined more than a minute ago.
        if _count_rows(execute, "voter WHERE code = ? AND network = ?", code, network) >= NETWORK_SEATS:
            sentence = _(
                "{most} students of your network have joined within a minute. This page joins by itself in a moment."
            )
            raise CrowdError(sentence.format(most=NETWORK_SEATS))
        seat = Seat(code, voter or secrets.token_urlsafe(class_codes.VOTER_BYTES))
        values = (code, seat.voter, self._clock(), self._clock(), network)
        execute("INSERT INTO voter (code, voter, heard, joined, network) VALUES (?, ?, ?, ?, ?)", values)
        execute("UPDATE class SET was_joined = 1 WHERE code = ?", (code,))
        return seat


@cache
def _open_classes(address: str) -> Classes:
    return Classes(address)


def shared() -> Classes:
    """Return the classes of this server."""
    return _open_classes(database_address())


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
    letter = class_codes.find_foreign_letter(text)
    if letter:
        sentence = _("No class code contains {letter}. Look at the projector and type the code again.")
        return sentence.format(letter=letter)
    return _("A class code has six letters. Look at the projector and type them again.")


def _no_seat() -> str:
    return _("Your answer did not count. Join the class again with its code.")


def _no_such_class() -> str:
    return _("There is no class with this code. It may have ended; look at the projector and type the code again.")
