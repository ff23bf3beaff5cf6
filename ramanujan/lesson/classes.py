"""The class predicts: a lecturer asks, students answer, and nobody sees how the class voted before it is revealed.

    classes = shared()
    opened = classes.open_class()                   # a code for everybody, a key for the lecturer alone
    seat = classes.join(opened.code)                # a student: no name, a random voter
    classes.present(opened.key, "faster", ["machine", "plain"])
    classes.vote(seat, "faster", "plain")
    classes.show(opened.key, Phase.REVEALED)
    classes.distribution(opened.code, "faster")     # {"machine": 0, "plain": 1}
    classes.ask_again(opened.key)                   # the second vote, after talking to a neighbour

What a class cannot do raises `ClassError` with one sentence. All of it is in one database (`class_store`) that several
processes share, and is gone when the class expires. Peer instruction: E. Mazur, *Peer Instruction* (1997).
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
from ramanujan.lesson.class_states import Asked, Class, Phase, Question, Seat
from ramanujan.lesson.class_store import ClassError, place, store_at
from ramanujan.translation import _

STUDENTS = 500
"""Most students in one class."""
CLASSES = 200
"""Most classes at one time."""
DAY = 24 * 3600.0
LIFETIMES = (DAY, 7 * DAY, 30 * DAY)
"""Seconds after which a class is gone, the usual first."""
PRESENT = 20.0
"""Seconds for which somebody who was heard of counts as present."""
HEARD_EVERY = 5.0
"""Seconds after which being heard of is written down again: a phone asks twice as often."""
WRONG_CODES, WRONG_CODES_OF_ALL = 6, 120
"""Wrong codes that one session, and all sessions together, may try in a `MINUTE`."""
MINUTE = 60.0

_ID = re.compile(r"[a-z0-9_-]{1,40}", re.ASCII)
_Execute = Callable[..., Any]

_PRESENTLY = "SELECT COUNT(*) FROM voter WHERE voter.code = class.code AND heard > ?"
_QUESTION = f"""
SELECT stop, round, COALESCE(phase, 0),
       (SELECT COUNT(*) FROM vote JOIN voter ON voter.code = vote.code AND voter.voter = vote.voter
        WHERE vote.code = class.code AND vote.stop = class.stop AND vote.round = class.round AND heard > ?),
       ({_PRESENTLY})
FROM class LEFT JOIN question USING (code, stop, round) WHERE code = ? AND expires > ?
"""
_CHANGES = """
SELECT before.option = ?, after.option = ?, COUNT(*)
FROM vote AS before JOIN vote AS after USING (code, stop, voter)
WHERE before.code = ? AND before.stop = ? AND before.round = ? AND after.round = ?
GROUP BY 1, 2
"""


class Classes:
    """All classes of one database.

    where : a file's path, or a PostgreSQL server's address
    clock : seconds since 1970, the same for all processes
    """

    def __init__(self, where: str | Path, clock: Callable[[], float] = time.time) -> None:
        self._store, self._clock = store_at(where), clock

    # ---- the lecturer

    def open_class(self, lifetime: float = DAY) -> Class:
        """Open a class under a new code, for so many seconds, and return it with its key."""
        secret = secrets.token_urlsafe(class_codes.SECRET_BYTES)
        with self._store.writing() as execute:
            self._forget(execute)
            if _count(execute, "class") >= CLASSES:
                raise ClassError(_("This server has no room for another class at the moment. Try again later."))
            while _count(execute, "class WHERE code = ?", code := class_codes.new_code()):
                pass
            values = (code, class_codes.hash_of(secret), self._clock() + lifetime)
            execute("INSERT INTO class (code, key_hash, expires, round) VALUES (?, ?, ?, 1)", values)
        return Class(code, class_codes.key_of(code, secret))

    def close(self, key: str) -> None:
        """End a class; nothing of it remains."""
        code = self.code_of(key)
        with self._store.writing() as execute:
            execute("DELETE FROM class WHERE code = ?", (code,))

    def code_of(self, key: str) -> str:
        """Return the code of the class that a lecturer's key belongs to."""
        code, secret = class_codes.parts_of(key)
        rows = self._store.read("SELECT key_hash FROM class WHERE code = ? AND expires > ?", (code, self._clock()))
        # The time that the comparison takes says nothing about either.
        if not rows or not secrets.compare_digest(rows[0][0], class_codes.hash_of(secret)):
            raise ClassError(_("This lecturer’s address belongs to no class. The class may have ended."))
        return code

    def expires(self, key: str) -> float:
        """Return when the class and all its answers are deleted [s since 1970]."""
        return self._store.read("SELECT expires FROM class WHERE code = ?", (self.code_of(key),))[0][0]

    def present(self, key: str, stop: str, options: Sequence[str], anew: bool = False) -> None:
        """Take the class to a question; one that was asked before is as it was left, or asked once more.

        The votes of an earlier asking are kept.
        """
        code = self.code_of(key)
        if not all(_ID.fullmatch(each) for each in (stop, *options)):
            raise ValueError(_("The ids of {stop} must have small letters, digits, - and _ only.").format(stop=stop))
        with self._store.writing() as execute:
            query = "SELECT MAX(round) FROM question WHERE code = ? AND stop = ?"
            last = execute(query, (code, stop)).fetchone()[0]
            # Each asking has an odd round for the first vote and an even one for the second.
            round_ = (last + 1) // 2 * 2 + 1 if last and anew else last or 1
            self._begin(execute, code, stop, round_, " ".join(options))

    def show(self, key: str, phase: Phase) -> None:
        """Take the present question to a phase; from REVEALED on it takes no answers."""
        code = self.code_of(key)
        with self._store.writing() as execute:
            stop, round_, *_rest = _present(execute, code)
            present = execute(f"{_PRESENTLY.replace('class.code', '?')}", (code, self._lately)).fetchone()[0]
            # With a second vote, the first is shown too.
            first = round_ - 1 if round_ % 2 == 0 else round_
            execute(
                "UPDATE question SET present = CASE WHEN phase = 0 THEN ? ELSE present END, "
                "phase = CASE WHEN phase > ? THEN phase ELSE ? END "
                "WHERE code = ? AND stop = ? AND round BETWEEN ? AND ?",
                (present, int(phase), int(phase), code, stop, first, round_),
            )

    def ask_again(self, key: str) -> None:
        """Begin the second vote on the present question; the first takes no answers any more."""
        code = self.code_of(key)
        with self._store.writing() as execute:
            stop, round_, options, phase = _present(execute, code)
            if phase == Phase.SOLVED:
                raise ClassError(_("The class has already seen the right answer to this question."))
            if round_ % 2 == 0:
                raise ClassError(_("The class has already voted twice on this question."))
            self._begin(execute, code, stop, round_ + 1, options)

    def set_machine(self, key: str, machine: str) -> None:
        """Let the wall show this machine: what the lecturer's sliders hold, as the query of an address."""
        code = self.code_of(key)
        with self._store.writing() as execute:
            execute("UPDATE class SET machine = ? WHERE code = ?", (machine, code))

    def asked(self, key: str) -> list[Asked]:
        """Return every question that the class was asked and whose result was shown, in the order of asking."""
        code = self.code_of(key)
        rows = self._store.read(
            "SELECT stop, round, options, asked, present FROM question WHERE code = ? AND phase > 0 "
            "ORDER BY asked, round",
            (code,),
        )
        shown = {(stop, round_): (options, at, present) for stop, round_, options, at, present in rows}
        found = []
        for (stop, round_), (options, at, present) in shown.items():
            if round_ % 2:
                second = shown.get((stop, round_ + 1))
                votes = [self._votes(code, stop, number, options) for number in (round_, round_ + 1)]
                found.append(Asked(stop, at, second[2] if second else present, votes[0], votes[1] if second else None))
        return found

    # ---- a student

    def join(self, code: str, session: str = "", voter: str = "") -> Seat:
        """Return a seat in a class, the old one if this voter has been there before.

        Parameters
        ----------
        code : as it was typed, or stands in a link
        session : whose wrong codes are counted together
        voter : random name of the browser in this class; a new one where there is none
        """
        with self._store.writing() as execute:
            self._forget(execute)
            seat = self._seat(execute, code, session, voter)
        # Raised after the transaction, which keeps count of the wrong codes.
        if isinstance(seat, str):
            raise ClassError(seat)
        return seat

    def chosen(self, seat: Seat, question: Question) -> str | None:
        """Return the student's own answer to a question, and know from now on that the student is present."""
        now = self._clock()
        rows = self._store.read(
            "SELECT option, heard FROM voter LEFT JOIN vote ON vote.code = voter.code AND vote.voter = voter.voter "
            "AND stop = ? AND round = ? WHERE voter.code = ? AND voter.voter = ?",
            (question.stop, question.round, seat.code, seat.voter),
        )
        if rows and now - rows[0][1] > HEARD_EVERY:
            with self._store.writing() as execute:
                execute("UPDATE voter SET heard = ? WHERE code = ? AND voter = ?", (now, seat.code, seat.voter))
        return rows[0][0] if rows else None

    def vote(self, seat: Seat, stop: str, option: str, round_: int | None = None) -> None:
        """Take a student's answer to the present question, in place of an earlier one.

        Parameters
        ----------
        seat : of the student
        stop, option : ids
        round_ : the one in which the student was asked, where an answer may come late
        """
        code, voter = seat.code, seat.voter
        with self._store.writing() as execute:
            if not _count(execute, "class WHERE code = ? AND expires > ?", code, self._clock()):
                raise ClassError(_no_such_class())
            if not _count(execute, "voter WHERE code = ? AND voter = ?", code, voter):
                raise ClassError(_("Your answer did not count. Join the class again with its code."))
            # After a lost connection a browser says once more what counts already.
            said = "vote WHERE code = ? AND stop = ? AND round = ? AND voter = ? AND option = ?"
            if _count(execute, said, code, stop, round_, voter, option):
                return
            present, now, options, phase = _present(execute, code)
            if present != stop:
                raise ClassError(_("Your answer came too late: the class has gone on to another question."))
            if phase > Phase.ASKED:
                raise ClassError(_("Your answer came too late: the result has already been shown."))
            if now != (round_ or now):
                raise ClassError(_("Your answer came too late: the second vote has begun. Please answer again."))
            if option not in options.split():
                raise ClassError(_("This question has no such answer."))
            execute(
                "INSERT INTO vote VALUES (?, ?, ?, ?, ?) "
                "ON CONFLICT (code, stop, round, voter) DO UPDATE SET option = excluded.option",
                (code, stop, now, voter, option),
            )
            execute("UPDATE voter SET heard = ? WHERE code = ? AND voter = ?", (self._clock(), code, voter))

    # ---- everybody

    def question(self, code: str) -> Question:
        """Return what a class is asked now: one read by keys, since every phone asks every few seconds."""
        rows = self._store.read(_QUESTION, (self._lately, self._lately, code, self._clock()))
        if not rows:
            raise ClassError(_("The class has ended."))
        stop, round_, phase, answered, present = rows[0]
        return Question(stop, round_, Phase(phase), answered, present)

    def last(self, code: str, stop: str) -> Question | None:
        """Return how a stop was left that the class was asked before; numbers of people belong to the present one."""
        query = "SELECT round, phase FROM question WHERE code = ? AND stop = ? ORDER BY round DESC"
        rows = self._store.read(query, (code, stop))
        return Question(stop, rows[0][0], Phase(rows[0][1]), 0, 0) if rows else None

    def machine(self, code: str) -> str | None:
        """Return what the wall shows of the lecturer's sliders."""
        rows = self._store.read("SELECT machine FROM class WHERE code = ?", (code,))
        return rows[0][0] if rows else None

    def distribution(self, code: str, stop: str, round_: int | None = None) -> dict[str, int]:
        """Return option → number of votes, in the order of the options; by default of the last vote that was shown."""
        query = "SELECT options, round FROM question WHERE code = ? AND stop = ? AND phase > 0 ORDER BY round DESC"
        shown = [row for row in self._store.read(query, (code, stop)) if round_ in (None, row[1])]
        if not shown:
            raise ClassError(_("The result of this question has not been shown yet."))
        options, number = shown[0]
        return self._votes(code, stop, number, options)

    def changes(self, code: str, stop: str, right: str, round_: int = 2) -> Counter[tuple[bool, bool]]:
        """Return how many of those who voted twice were right in the first vote and in the second.

        Parameters
        ----------
        code, stop : the class and the question
        right : id of the right option
        round_ : of the second vote

        Returns
        -------
        whether they were right before, and after → their number
        """
        # Raises where the result has not been shown.
        self.distribution(code, stop, round_)
        rows = self._store.read(_CHANGES, (right, right, code, stop, round_ - 1, round_))
        return Counter({(bool(before), bool(after)): number for before, after, number in rows})

    # ---- inside

    @property
    def _lately(self) -> float:
        return self._clock() - PRESENT

    def _votes(self, code: str, stop: str, round_: int, options: str) -> dict[str, int]:
        query = "SELECT option, COUNT(*) FROM vote WHERE code = ? AND stop = ? AND round = ? GROUP BY option"
        votes = dict(self._store.read(query, (code, stop, round_)))
        return {option: votes.get(option, 0) for option in options.split()}

    def _forget(self, execute: _Execute) -> None:
        """Remove what has expired, with all that belongs to it."""
        execute("DELETE FROM class WHERE expires <= ?", (self._clock(),))
        execute("DELETE FROM wrong_code WHERE at <= ?", (self._clock() - MINUTE,))

    def _begin(self, execute: _Execute, code: str, stop: str, round_: int, options: str) -> None:
        execute(
            "INSERT INTO question (code, stop, round, options, asked) VALUES (?, ?, ?, ?, ?) ON CONFLICT DO NOTHING",
            (code, stop, round_, options, self._clock()),
        )
        execute("UPDATE class SET stop = ?, round = ? WHERE code = ?", (stop, round_, code))

    def _seat(self, execute: _Execute, text: str, session: str, voter: str) -> Seat | str:
        """Return the seat of whoever comes with this code, or why there is none."""
        code = class_codes.read_code(text)
        if code is None:
            if wrong := class_codes.foreign_to_codes(text):
                sentence = _("No class code contains {letter}. Look at the projector and type the code again.")
                return sentence.format(letter=wrong)
            return _("A class code has six letters. Look at the projector and type them again.")
        again = "UPDATE voter SET heard = ? WHERE code = ? AND voter = ?"
        if execute(again, (self._clock(), code, voter)).rowcount:
            return Seat(code, voter)
        if (
            _count(execute, "wrong_code WHERE session = ?", session) >= WRONG_CODES
            or _count(execute, "wrong_code") >= WRONG_CODES_OF_ALL
        ):
            return _("Too many wrong codes have been typed. Wait a minute, then try again.")
        if not _count(execute, "class WHERE code = ?", code):
            execute("INSERT INTO wrong_code VALUES (?, ?)", (self._clock(), session))
            return _no_such_class()
        if _count(execute, "voter WHERE code = ?", code) >= STUDENTS:
            return _("This class is full: it has {most} students.").format(most=STUDENTS)
        seat = Seat(code, voter or secrets.token_urlsafe(class_codes.VOTER_BYTES))
        execute("INSERT INTO voter VALUES (?, ?, ?)", (code, seat.voter, self._clock()))
        return seat


@cache
def _of(where: str) -> Classes:
    return Classes(where)


def shared() -> Classes:
    """Return the classes of this server."""
    return _of(place())


def _count(execute: _Execute, what: str, *values: object) -> int:
    return execute(f"SELECT COUNT(*) FROM {what}", values).fetchone()[0]


def _present(execute: _Execute, code: str) -> tuple[str, int, str, Phase]:
    """Return the present stop, its round, its options, and how far it has come."""
    query = "SELECT stop, round, options, phase FROM class JOIN question USING (code, stop, round) WHERE code = ?"
    if row := execute(query, (code,)).fetchone():
        return row
    raise ClassError(_("The class has not been asked a question yet."))


def _no_such_class() -> str:
    return _("There is no class with this code. It may have ended; look at the projector and type the code again.")
