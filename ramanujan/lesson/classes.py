"""The class predicts: a lecturer asks, students answer, and nobody sees how the class voted before it is revealed.

    classes = shared()
    opened = classes.open_class()                   # a code for everybody, a key for the lecturer alone
    seat = classes.join(opened.code)                # a student: no name, a random voter
    classes.ask(opened.key, "faster", ["machine", "plain"])
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
from ramanujan.lesson.class_states import END, Asked, Class, Phase, Question, Seat, Seats, Vote
from ramanujan.lesson.class_store import ClassError, CrowdError, SeatError, place, store_at
from ramanujan.translation import _

STUDENTS = 500
"""Most students in one class."""
NETWORK_SEATS = 60
"""Most seats that one network gets in a class within a `MINUTE`, as many as a lecture hall behind one router needs.

It opens as many classes at most.
"""
CLASSES = 200
"""Most classes at one time."""
DAY = 24 * 3600.0
LIFETIMES = (DAY, 7 * DAY, 30 * DAY)
"""Seconds after which a class is gone, the usual first."""
PRESENT = 20.0
"""Seconds for which somebody who was heard of counts as present."""
HEARD_EVERY = 5.0
"""Seconds after which being heard of is written down again: a phone asks twice as often."""
MINUTE = 60.0

_ID = re.compile(r"[a-z0-9_-]{1,40}", re.ASCII)
_Execute = Callable[..., Any]

_PRESENTLY = "SELECT COUNT(*) FROM voter WHERE voter.code = class.code AND heard > ?"
_QUESTION = f"""
SELECT stop, asking, number, COALESCE(phase, 0), COALESCE(reached, 0),
       (SELECT COUNT(*) FROM vote JOIN voter ON voter.code = vote.code AND voter.voter = vote.voter
        WHERE vote.code = class.code AND vote.stop = class.stop AND vote.asking = class.asking
        AND vote.number = class.number AND heard > ?),
       ({_PRESENTLY})
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

    where : a file's path, or a PostgreSQL server's address
    clock : seconds since 1970, the same for all processes
    """

    def __init__(self, where: str | Path, clock: Callable[[], float] = time.time) -> None:
        self._store, self._clock = store_at(where), clock

    # ---- the lecturer

    def open_class(self, lifetime: float = DAY, address: str = "") -> Class:
        """Open a class under a new code and return it with its key.

        If all places are taken, the class that was opened first among those that nobody has ever joined makes way.

        Parameters
        ----------
        lifetime : seconds until the class is deleted
        address : IP address of the lecturer; one network opens only so many classes at a time
        """
        secret = secrets.token_urlsafe(class_codes.SECRET_BYTES)
        now, network = self._clock(), class_codes.network_of(address, "")
        with self._store.writing() as execute:
            self._forget(execute)
            # Earlier openings have been forgotten.
            if _count(execute, "class WHERE network = ?", network) >= NETWORK_SEATS:
                sentence = _("{most} classes were opened from your network within a minute. Try again in a minute.")
                raise CrowdError(sentence.format(most=NETWORK_SEATS))
            if _count(execute, "class") >= CLASSES and not execute(_REMOVE_UNUSED).rowcount:
                raise ClassError(_("This server has no room for another class at the moment. Try again later."))
            code = class_codes.new_code()
            while _count(execute, "class WHERE code = ?", code):
                code = class_codes.new_code()
            execute(
                "INSERT INTO class (code, key_hash, expires, opened, network, was_joined) VALUES (?, ?, ?, ?, ?, 0)",
                (code, class_codes.hash_of(secret), now + lifetime, now, network),
            )
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

    def ask(self, key: str, stop: str, options: Sequence[str], anew: bool = False) -> None:
        """Take the class to a question; one that was asked before is as it was left, or asked once more.

        The votes of an earlier asking are kept.
        """
        code = self.code_of(key)
        if not all(_ID.fullmatch(each) for each in (stop, *options)):
            raise ValueError(_("The ids of {stop} must have small letters, digits, - and _ only.").format(stop=stop))
        with self._store.writing() as execute:
            query = "SELECT asking, number FROM question WHERE code = ? AND stop = ? ORDER BY asking DESC, number DESC"
            last = Vote(*(execute(query, (code, stop)).fetchone() or Vote(0)))
            vote = last if last.asking and not anew else Vote(last.asking + 1)
            self._begin(execute, code, stop, vote, " ".join(options))

    def show(self, key: str, phase: Phase) -> None:
        """Show the present question in a phase, also in an earlier one; once REVEALED, it takes no more answers."""
        code = self.code_of(key)
        with self._store.writing() as execute:
            stop, vote, *_rest = _present(execute, code)
            present = execute(f"{_PRESENTLY.replace('class.code', '?')}", (code, self._lately)).fetchone()[0]
            # With a second vote, the first is shown too.
            execute(
                "UPDATE question SET present = CASE WHEN reached = 0 THEN ? ELSE present END, phase = ?, "
                "reached = CASE WHEN reached > ? THEN reached ELSE ? END WHERE code = ? AND stop = ? AND asking = ?",
                (present, *[int(phase)] * 3, code, stop, vote.asking),
            )

    def finish(self, key: str) -> None:
        """Take the class to the end, where it looks back at its votes."""
        self._set(key, stop=END)

    def ask_again(self, key: str) -> None:
        """Begin the second vote on the present question; the first takes no answers any more."""
        code = self.code_of(key)
        with self._store.writing() as execute:
            stop, vote, options, reached = _present(execute, code)
            if reached == Phase.SOLVED:
                raise ClassError(_("The class has already seen the right answer to this question."))
            if vote.is_second:
                raise ClassError(_("The class has already voted twice on this question."))
            self._begin(execute, code, stop, vote._replace(number=2), options)

    def set_machine(self, key: str, machine: str) -> None:
        """Let the wall show this machine: what the lecturer's sliders hold, as the query of an address."""
        self._set(key, machine=machine)

    def set_seen(self, key: str, seen: str) -> None:
        """Let every screen show what is seen of the machine at the lecturer's desk, and since when."""
        self._set(key, seen=seen, seen_at=self._clock())

    def asked(self, key: str) -> list[Asked]:
        """Return what the lecturer takes home of a class: `results`."""
        return self.results(self.code_of(key))

    def results(self, code: str, least: Phase = Phase.REVEALED) -> list[Asked]:
        """Return every question that the class was asked and that has come so far, in the order of asking."""
        rows = self._store.read(
            "SELECT stop, asking, number, options, asked, present FROM question WHERE code = ? AND reached >= ? "
            "ORDER BY asked, asking, number",
            (code, int(least)),
        )
        shown = {(stop, Vote(asking, number)): rest for stop, asking, number, *rest in rows}
        found = []
        for (stop, vote), (options, at, present) in shown.items():
            if vote.is_second:
                continue
            again = vote._replace(number=2)
            first, second = self._votes(code, stop, vote, options), None
            if (stop, again) in shown:
                second, present = self._votes(code, stop, again, options), shown[stop, again][-1]
            found.append(Asked(stop, at, present, first, second))
        return found

    def seats(self, key: str) -> Seats:
        """Return how many seats are taken, how many of them lately, and whether there are more."""
        code = self.code_of(key)
        query = (
            f"SELECT (SELECT COUNT(*) FROM voter WHERE voter.code = class.code), ({_PRESENTLY}), (SELECT COUNT(*) "
            "FROM voter WHERE voter.code = class.code AND joined > ?), is_open FROM class WHERE code = ?"
        )
        taken, present, lately, is_open = self._store.read(query, (self._lately, self._clock() - MINUTE, code))[0]
        return Seats(taken, present, lately, bool(is_open))

    def let_join(self, key: str, is_open: bool) -> None:
        """Open or close the door: whoever has a seat keeps it, and others get one only while it is open."""
        self._set(key, is_open=int(is_open))

    def remove_absent(self, key: str) -> None:
        """Remove everybody who was not heard of lately, and their answers to a question whose result is not shown."""
        code = self.code_of(key)
        absent = "voter IN (SELECT voter FROM voter WHERE code = ? AND heard <= ?)"
        with self._store.writing() as execute:
            if _count(execute, "class JOIN question USING (code, stop, asking, number) WHERE code = ?", code):
                stop, vote, _options, reached = _present(execute, code)
                if reached == Phase.ASKED:
                    values = (code, stop, *vote, code, self._lately)
                    execute(f"DELETE FROM vote WHERE {_THIS_VOTE} AND {absent}", values)
            execute("DELETE FROM voter WHERE code = ? AND heard <= ?", (code, self._lately))

    # ---- a student

    def join(self, code: str, voter: str = "", address: str = "") -> Seat:
        """Return a seat in a class, the old one if this voter has been there before.

        A code is looked up before anything else, by one read, and wrong ones leave nothing behind: however many
        anybody has typed, a right one gets in.

        Parameters
        ----------
        code : as it was typed, or stands in a link
        voter : random name of the browser in this class; a new one where there is none
        address : IP address of the visitor; those of one network get only so many seats at a time
        """
        if (read := class_codes.read_code(code)) is None:
            raise ClassError(_no_code(code))
        seat = None
        if self._store.read("SELECT 1 FROM class WHERE code = ?", (read,)):
            with self._store.writing() as execute:
                self._forget(execute)
                seat = self._seat(execute, read, voter, class_codes.network_of(address, read))
        if seat is None:
            raise ClassError(_no_such_class())
        return seat

    def chosen(self, seat: Seat, question: Question) -> str | None:
        """Return the student's own answer to a question, and know from now on that the student is present."""
        now = self._clock()
        rows = self._store.read(
            "SELECT option, heard FROM voter LEFT JOIN vote ON vote.code = voter.code AND vote.voter = voter.voter "
            "AND stop = ? AND asking = ? AND number = ? WHERE voter.code = ? AND voter.voter = ?",
            (question.stop, *question.vote, seat.code, seat.voter),
        )
        if not rows:
            raise SeatError(_no_seat())
        option, heard = rows[0]
        if now - heard > HEARD_EVERY:
            with self._store.writing() as execute:
                execute("UPDATE voter SET heard = ? WHERE code = ? AND voter = ?", (now, seat.code, seat.voter))
        return option

    def vote(self, seat: Seat, stop: str, option: str, vote: Vote | None = None) -> None:
        """Take a student's answer to the present question, in place of an earlier one.

        Parameters
        ----------
        seat : of the student
        stop, option : ids
        vote : the one in which the student was asked, where an answer may come late
        """
        code, voter = seat.code, seat.voter
        with self._store.writing() as execute:
            if not _count(execute, "class WHERE code = ? AND expires > ?", code, self._clock()):
                raise ClassError(_no_such_class())
            if not _count(execute, "voter WHERE code = ? AND voter = ?", code, voter):
                raise SeatError(_no_seat())
            # After a lost connection a browser says once more what counts already.
            said = f"vote WHERE {_THIS_VOTE} AND voter = ? AND option = ?"
            if vote and _count(execute, said, code, stop, *vote, voter, option):
                return
            present, now, options, reached = _present(execute, code)
            if present != stop:
                raise ClassError(_("Your answer came too late: the class has gone on to another question."))
            if reached > Phase.ASKED:
                raise ClassError(_("Your answer came too late: the result has already been shown."))
            if now != (vote or now):
                raise ClassError(_("Your answer came too late: another vote has begun. Please answer again."))
            if option not in options.split():
                raise ClassError(_("This question has no such answer."))
            execute(
                "INSERT INTO vote VALUES (?, ?, ?, ?, ?, ?) "
                "ON CONFLICT (code, stop, asking, number, voter) DO UPDATE SET option = excluded.option",
                (code, stop, *now, voter, option),
            )
            execute("UPDATE voter SET heard = ? WHERE code = ? AND voter = ?", (self._clock(), code, voter))

    # ---- everybody

    def question(self, code: str) -> Question:
        """Return what a class is asked now: one read by keys, since every phone asks every few seconds."""
        rows = self._store.read(_QUESTION, (self._lately, self._lately, code, self._clock()))
        if not rows:
            raise ClassError(_("The class has ended."))
        stop, asking, number, phase, reached, answered, present = rows[0]
        return Question(stop, Vote(asking, number), Phase(phase), Phase(reached), answered, present)

    def last(self, code: str, stop: str) -> Question | None:
        """Return how a stop was left that the class was asked before; numbers of people belong to the present one."""
        query = (
            "SELECT asking, number, phase, reached FROM question WHERE code = ? AND stop = ? "
            "ORDER BY asking DESC, number DESC"
        )
        for asking, number, phase, reached in self._store.read(query, (code, stop))[:1]:
            return Question(stop, Vote(asking, number), Phase(phase), Phase(reached), 0, 0)
        return None

    def expires(self, code: str) -> float:
        """Return the time at which the class and all its answers are deleted [s since 1970]."""
        rows = self._store.read("SELECT expires FROM class WHERE code = ? AND expires > ?", (code, self._clock()))
        if not rows:
            raise ClassError(_("The class has ended."))
        return rows[0][0]

    def machine(self, code: str) -> str | None:
        """Return what the wall shows of the lecturer's sliders."""
        rows = self._store.read("SELECT machine FROM class WHERE code = ?", (code,))
        return rows[0][0] if rows else None

    def seen(self, code: str) -> tuple[str | None, float]:
        """Return what the desk has told last of what is seen there, and how long ago [s]."""
        rows = self._store.read("SELECT seen, seen_at FROM class WHERE code = ?", (code,))
        seen, at = rows[0] if rows else (None, None)
        return seen, self._clock() - (at or 0.0)

    def distribution(self, code: str, stop: str, vote: Vote | None = None) -> dict[str, int]:
        """Return option → number of votes, in the order of the options; by default of the last vote that was shown."""
        query = (
            "SELECT options, asking, number FROM question WHERE code = ? AND stop = ? AND reached > 0 "
            "ORDER BY asking DESC, number DESC"
        )
        for options, *of in self._store.read(query, (code, stop)):
            if vote in (None, Vote(*of)):
                return self._votes(code, stop, Vote(*of), options)
        raise ClassError(_("The result of this question has not been shown yet."))

    def changes(self, code: str, stop: str, right: str, asking: int = 1) -> Counter[tuple[bool, bool]]:
        """Return how many of those who voted twice were right in the first vote and in the second.

        Parameters
        ----------
        code, stop : the class and the question
        right : id of the right option
        asking : of the two votes

        Returns
        -------
        whether they were right before, and after → their number
        """
        # Raises where the result has not been shown.
        self.distribution(code, stop, Vote(asking, 2))
        rows = self._store.read(_CHANGES, (right, right, code, stop, asking))
        return Counter({(bool(before), bool(after)): number for before, after, number in rows})

    def delete_expired(self) -> None:
        """Delete what has expired; do nothing if no class was ever opened."""
        if self._store.exists():
            with self._store.writing() as execute:
                self._forget(execute)

    # ---- inside

    @property
    def _lately(self) -> float:
        return self._clock() - PRESENT

    def _set(self, key: str, **columns: object) -> None:
        """Set columns of the lecturer's class."""
        code, names = self.code_of(key), ", ".join(f"{name} = ?" for name in columns)
        with self._store.writing() as execute:
            execute(f"UPDATE class SET {names} WHERE code = ?", (*columns.values(), code))

    def _votes(self, code: str, stop: str, vote: Vote, options: str) -> dict[str, int]:
        query = f"SELECT option, COUNT(*) FROM vote WHERE {_THIS_VOTE} GROUP BY option"
        votes = dict(self._store.read(query, (code, stop, *vote)))
        return {option: votes.get(option, 0) for option in options.split()}

    def _forget(self, execute: _Execute) -> None:
        """Delete the classes that have expired, with all their rows, and the networks of earlier visitors."""
        execute("DELETE FROM class WHERE expires <= ?", (self._clock(),))
        earlier = self._clock() - MINUTE
        execute("UPDATE class SET network = NULL WHERE network IS NOT NULL AND opened <= ?", (earlier,))
        execute("UPDATE voter SET network = NULL WHERE network IS NOT NULL AND joined <= ?", (earlier,))

    def _begin(self, execute: _Execute, code: str, stop: str, vote: Vote, options: str) -> None:
        execute(
            "INSERT INTO question (code, stop, asking, number, options, asked) VALUES (?, ?, ?, ?, ?, ?) "
            "ON CONFLICT DO NOTHING",
            (code, stop, *vote, options, self._clock()),
        )
        execute("UPDATE class SET stop = ?, asking = ?, number = ? WHERE code = ?", (stop, *vote, code))

    def _seat(self, execute: _Execute, code: str, voter: str, network: str) -> Seat | None:
        """Return the seat of whoever comes with this code; None where the class has just ended."""
        again = "UPDATE voter SET heard = ? WHERE code = ? AND voter = ?"
        if execute(again, (self._clock(), code, voter)).rowcount:
            return Seat(code, voter)
        found = execute("SELECT is_open FROM class WHERE code = ?", (code,)).fetchone()
        if not found:
            return None
        if not found[0]:
            raise ClassError(_("The lecturer has closed this class to newcomers. Ask for it to be opened."))
        if _count(execute, "voter WHERE code = ?", code) >= STUDENTS:
            raise ClassError(_("This class is full: it has {most} students.").format(most=STUDENTS))
        # Older ones have been forgotten.
        if _count(execute, "voter WHERE code = ? AND network = ?", code, network) >= NETWORK_SEATS:
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
def _of(where: str) -> Classes:
    return Classes(where)


def shared() -> Classes:
    """Return the classes of this server."""
    return _of(place())


def _count(execute: _Execute, what: str, *values: object) -> int:
    return execute(f"SELECT COUNT(*) FROM {what}", values).fetchone()[0]


def _present(execute: _Execute, code: str) -> tuple[str, Vote, str, Phase]:
    """Return the present stop, the vote on it, its options, and how far it has come."""
    query = (
        "SELECT stop, asking, number, options, reached FROM class JOIN question USING (code, stop, asking, number) "
        "WHERE code = ?"
    )
    for stop, asking, number, options, reached in execute(query, (code,)).fetchall():
        return stop, Vote(asking, number), options, Phase(reached)
    raise ClassError(_("The class is asked no question at the moment."))


def _no_code(text: str) -> str:
    """Return what is wrong with a text that is no code."""
    if wrong := class_codes.foreign_to_codes(text):
        sentence = _("No class code contains {letter}. Look at the projector and type the code again.")
        return sentence.format(letter=wrong)
    return _("A class code has six letters. Look at the projector and type them again.")


def _no_seat() -> str:
    return _("Your answer did not count. Join the class again with its code.")


def _no_such_class() -> str:
    return _("There is no class with this code. It may have ended; look at the projector and type the code again.")
