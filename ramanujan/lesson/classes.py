"""The class predicts: a lecturer asks, students answer, and nobody sees how the class voted before it is revealed.

    classes = shared()
    opened = classes.open_class()                   # a code for everybody, a key for the lecturer alone
    seat = classes.join(opened.code)                # a student: no name, a random voter
    classes.present(opened.key, "faster", ["machine", "plain"])
    classes.vote(opened.code, seat.voter, "faster", "plain")
    classes.reveal(opened.key)
    classes.distribution(opened.code, "faster")     # {"machine": 0, "plain": 1}
    classes.ask_again(opened.key)                   # the second vote, after talking to a neighbour

What a class cannot do raises `ClassError` with one sentence. All of it is in one file (`class_file`) that several
processes share, and is gone a day after the class was opened. Peer instruction: E. Mazur, *Peer Instruction* (1997).
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from sqlite3 import Connection

from ramanujan.lesson.class_codes import (
    foreign_to_codes,
    key_of,
    lock_for,
    new_code,
    new_secret,
    new_voter,
    opens,
    parts_of,
    read_code,
)
from ramanujan.lesson.class_file import CHANGES, DESK, QUESTION, ClassError, ClassFile, place
from ramanujan.lesson.class_states import Class, Comparison, Desk, Question, Seat
from ramanujan.translation import _

__all__ = ["Class", "ClassError", "Classes", "Comparison", "Desk", "Question", "Seat", "shared"]

STUDENTS = 500
"""Most students in one class."""
CLASSES = 200
"""Most classes at one time."""
LIFETIME = 24 * 3600.0
"""Seconds after which a class is gone."""
WRONG_CODES, WRONG_CODES_OF_ALL = 6, 120
"""Wrong codes that one session, and all sessions together, may try in a `MINUTE`."""
MINUTE = 60.0

_ID = re.compile(r"[a-z0-9_-]{1,40}", re.ASCII)


class Classes:
    """All classes of one file.

    path : of the file
    clock : seconds since some fixed moment, the same for all processes
    """

    def __init__(self, path: Path, clock: Callable[[], float] = time.time) -> None:
        self._file, self._clock = ClassFile(path), clock

    # ---- the lecturer

    def open_class(self) -> Class:
        """Open a class under a new code and return it with its key."""
        secret = new_secret()
        with self._file.writing() as file:
            self._forget(file)
            if _count(file, "class") >= CLASSES:
                raise ClassError(_("This server has no room for another class at the moment. Try again later."))
            while file.execute("SELECT 1 FROM class WHERE code = ?", (code := new_code(),)).fetchone():
                pass
            values = (code, lock_for(secret), self._clock())
            file.execute("INSERT INTO class (code, lock, opened, round) VALUES (?, ?, ?, 1)", values)
        return Class(code, key_of(code, secret))

    def close(self, key: str) -> None:
        """End a class; nothing of it remains."""
        code = self.code_of(key)
        with self._file.writing() as file:
            file.execute("DELETE FROM class WHERE code = ?", (code,))

    def code_of(self, key: str) -> str:
        """Return the code of the class that a lecturer's key belongs to."""
        code, secret = parts_of(key)
        rows = self._file.read("SELECT lock FROM class WHERE code = ? AND opened > ?", (code, self._oldest))
        if not rows or not opens(rows[0][0], secret):
            raise ClassError(_("This lecturer’s address belongs to no class. The class may have ended."))
        return code

    def present(self, key: str, stop: str, options: Sequence[str]) -> None:
        """Ask the class a question; a stop that was presented before is as it was left."""
        code = self.code_of(key)
        if not all(_ID.fullmatch(each) for each in (stop, *options)):
            raise ValueError(_("The ids of {stop} must have small letters, digits, - and _ only.").format(stop=stop))
        with self._file.writing() as file:
            query = "SELECT MAX(round) FROM question WHERE code = ? AND stop = ?"
            [(last,)] = file.execute(query, (code, stop))
            _ask(file, code, stop, last or 1, " ".join(options))

    def desk(self, key: str) -> Desk:
        """Return what the lecturer may see before the question is revealed."""
        rows = self._file.read(DESK, (self.code_of(key),))
        if not rows:
            raise ClassError(_no_such_class())
        stop, round_, revealed, solved, answered, joined = rows[0]
        return Desk(stop, round_, bool(revealed), bool(solved), answered, joined)

    def count(self, key: str) -> int:
        """Return how many have answered the present question in this round."""
        return self.desk(key).answered

    def reveal(self, key: str) -> None:
        """Show everybody how the class has voted on the present question; from now on it takes no answers."""
        self._uncover(key, "revealed = 1")

    def solve(self, key: str) -> None:
        """Show everybody the right answer to the present question as well; it is not asked again."""
        self._uncover(key, "revealed = 1, solved = 1")

    def ask_again(self, key: str) -> None:
        """Begin the second vote on the present question; the first takes no answers any more."""
        code = self.code_of(key)
        with self._file.writing() as file:
            stop, round_, options, _revealed, solved = _present(file, code)
            if solved:
                raise ClassError(_("The class has already seen the right answer to this question."))
            if round_ > 1:
                raise ClassError(_("The class has already voted twice on this question."))
            _ask(file, code, stop, round_ + 1, options)

    # ---- a student

    def join(self, code: str, session: str = "", voter: str = "") -> Seat:
        """Return a seat in a class, the old one if this voter has been there before.

        Parameters
        ----------
        code : as it was typed, or stands in a link
        session : whose wrong codes are counted together
        voter : of an earlier seat
        """
        with self._file.writing() as file:
            self._forget(file)
            seat = self._seat(file, code, session, voter)
        # Raised after the transaction, which keeps count of the wrong codes.
        if isinstance(seat, str):
            raise ClassError(seat)
        return seat

    def move(self, seat: Seat) -> Seat:
        """Return a new seat for a student whose seat was taken over, with all that this student has answered.

        Whoever opens the address of a neighbour sits down in the neighbour’s seat. The neighbour, who is still there,
        moves on with the votes, and the newcomer begins with none.
        """
        with self._file.writing() as file:
            self._must_be_open(file, seat.code)
            moved = _new_seat(file, seat.code, seat.session)
            file.execute("UPDATE vote SET voter = ? WHERE code = ? AND voter = ?", (moved.voter, seat.code, seat.voter))
        return moved

    def question(self, seat: Seat) -> Question:
        """Return what a student is asked now: one read by keys, since every phone asks every few seconds."""
        rows = self._file.read(QUESTION, (seat.voter, seat.voter, seat.code, self._oldest))
        if not rows:
            raise ClassError(_("The class has ended."))
        stop, round_, revealed, solved, chosen, session = rows[0]
        return Question(stop, round_, bool(revealed), bool(solved), chosen, session == seat.session)

    def vote(self, code: str, voter: str, stop: str, option: str, round_: int | None = None) -> None:
        """Take a student's answer to the present question, in place of an earlier one.

        Parameters
        ----------
        code, voter : of the student's seat
        stop, option : ids
        round_ : the one in which the student was asked, where an answer may come late
        """
        with self._file.writing() as file:
            self._must_be_open(file, code)
            if not file.execute("SELECT 1 FROM voter WHERE code = ? AND voter = ?", (code, voter)).fetchone():
                raise ClassError(_("Your answer did not count. Join the class again with its code."))
            # After a lost connection a browser says once more what counts already.
            said = "SELECT 1 FROM vote WHERE code = ? AND stop = ? AND round = ? AND voter = ? AND option = ?"
            if file.execute(said, (code, stop, round_, voter, option)).fetchone():
                return
            present, now, options, revealed, _solved = _present(file, code)
            if present != stop:
                raise ClassError(_("Your answer came too late: the class has gone on to another question."))
            if revealed:
                raise ClassError(_("Your answer came too late: the result has already been shown."))
            if now != (round_ or now):
                raise ClassError(_("Your answer came too late: the second vote has begun. Please answer again."))
            if option not in options.split():
                raise ClassError(_("This question has no such answer."))
            file.execute("INSERT OR REPLACE INTO vote VALUES (?, ?, ?, ?, ?)", (code, stop, now, voter, option))

    # ---- everybody, once it is revealed

    def distribution(self, code_or_key: str, stop: str, round_: int | None = None) -> dict[str, int]:
        """Return option → number of votes, in the order of the options; by default of the last round revealed."""
        code = self._either(code_or_key)
        query = "SELECT options, round FROM question WHERE code = ? AND stop = ? AND revealed ORDER BY round DESC"
        shown = [row for row in self._file.read(query, (code, stop)) if round_ in (None, row[1])]
        if not shown:
            raise ClassError(_("The result of this question has not been shown yet."))
        options, number = shown[0]
        query = "SELECT option, COUNT(*) FROM vote WHERE code = ? AND stop = ? AND round = ? GROUP BY option"
        votes = dict(self._file.read(query, (code, stop, number)))
        return {option: votes.get(option, 0) for option in options.split()}

    def comparison(self, code_or_key: str, stop: str, right: str) -> Comparison:
        """Return both votes on a stop, and how many have changed; `right` is the id of the right option."""
        first, second = (self.distribution(code_or_key, stop, number) for number in (1, 2))
        rows = self._file.read(CHANGES, (right, right, self._either(code_or_key), stop))
        people = {(bool(before), bool(after)): number for before, after, number in rows}
        return Comparison(
            first,
            second,
            to_right=people.get((False, True), 0),
            to_wrong=people.get((True, False), 0),
            stayed_right=people.get((True, True), 0),
            stayed_wrong=people.get((False, False), 0),
        )

    # ---- inside a transaction

    @property
    def _oldest(self) -> float:
        return self._clock() - LIFETIME

    def _forget(self, file: Connection) -> None:
        """Remove what has expired, with all that belongs to it."""
        file.execute("DELETE FROM class WHERE opened <= ?", (self._oldest,))
        file.execute("DELETE FROM wrong_code WHERE at <= ?", (self._clock() - MINUTE,))

    def _must_be_open(self, file: Connection, code: str) -> None:
        if not file.execute("SELECT 1 FROM class WHERE code = ? AND opened > ?", (code, self._oldest)).fetchone():
            raise ClassError(_no_such_class())

    def _either(self, code_or_key: str) -> str:
        code, secret = parts_of(code_or_key)
        return self.code_of(code_or_key) if secret else code

    def _uncover(self, key: str, what: str) -> None:
        code = self.code_of(key)
        with self._file.writing() as file:
            stop, round_, *_rest = _present(file, code)
            query = f"UPDATE question SET {what} WHERE code = ? AND stop = ? AND round <= ?"
            file.execute(query, (code, stop, round_))

    def _seat(self, file: Connection, text: str, session: str, voter: str) -> Seat | str:
        """Return the seat of whoever comes with this code, or why there is none."""
        code = read_code(text)
        if code is None:
            if wrong := foreign_to_codes(text):
                sentence = _("No class code contains {letter}. Look at the projector and type the code again.")
                return sentence.format(letter=wrong)
            return _("A class code has six letters. Look at the projector and type them again.")
        again = "UPDATE voter SET session = ? WHERE code = ? AND voter = ?"
        if file.execute(again, (session, code, voter)).rowcount:
            return Seat(code, voter, session)
        if (
            _count(file, "wrong_code WHERE session = ?", session) >= WRONG_CODES
            or _count(file, "wrong_code") >= WRONG_CODES_OF_ALL
        ):
            return _("Too many wrong codes have been typed. Wait a minute, then try again.")
        if not _count(file, "class WHERE code = ?", code):
            file.execute("INSERT INTO wrong_code VALUES (?, ?)", (self._clock(), session))
            return _no_such_class()
        if _count(file, "voter WHERE code = ?", code) >= STUDENTS:
            return _("This class is full: it has {most} students.").format(most=STUDENTS)
        return _new_seat(file, code, session)


@cache
def _of(path: Path) -> Classes:
    return Classes(path)


def shared() -> Classes:
    """Return the classes of this server."""
    return _of(place())


def _count(file: Connection, what: str, *values: str) -> int:
    return file.execute(f"SELECT COUNT(*) FROM {what}", values).fetchone()[0]


def _ask(file: Connection, code: str, stop: str, round_: int, options: str) -> None:
    query = "INSERT OR IGNORE INTO question (code, stop, round, options) VALUES (?, ?, ?, ?)"
    file.execute(query, (code, stop, round_, options))
    file.execute("UPDATE class SET stop = ?, round = ? WHERE code = ?", (stop, round_, code))


def _present(file: Connection, code: str) -> tuple[str, int, str, bool, bool]:
    """Return the present stop, its round, its options, and whether its result and its right answer are shown."""
    columns = "stop, round, options, revealed, solved"
    query = f"SELECT {columns} FROM class JOIN question USING (code, stop, round) WHERE code = ?"
    if row := file.execute(query, (code,)).fetchone():
        return row
    raise ClassError(_("The class has not been asked a question yet."))


def _new_seat(file: Connection, code: str, session: str) -> Seat:
    seat = Seat(code, new_voter(), session)
    file.execute("INSERT INTO voter VALUES (?, ?, ?)", (code, seat.voter, session))
    return seat


def _no_such_class() -> str:
    return _("There is no class with this code. It may have ended; look at the projector and type the code again.")
