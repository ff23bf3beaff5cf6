"""The file of the classes: one SQLite database in WAL mode that several processes of the app read and write at once.

What a class may do is said in `classes`; here a transaction is carried out or refused. A process that dies in the
middle of one leaves the file as it was before. Nothing in the file names a person.
"""

from __future__ import annotations

import logging
import os
import random
import sqlite3
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar

from ramanujan.translation import _

_LOG = logging.getLogger(__name__)
T = TypeVar("T")

BUSY_TIMEOUT = 0.25
"""Seconds that SQLite itself waits for another process; every thread of this process waits with it."""
PATIENCE = 10.0
"""Seconds after which a transaction is given up."""

_SCHEMA = """
CREATE TABLE IF NOT EXISTS class (
    code TEXT PRIMARY KEY, lock BLOB NOT NULL, opened REAL NOT NULL, stop TEXT, round INTEGER) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS question (
    code TEXT NOT NULL REFERENCES class ON DELETE CASCADE, stop TEXT NOT NULL, round INTEGER NOT NULL,
    options TEXT NOT NULL, revealed INTEGER NOT NULL DEFAULT 0, solved INTEGER NOT NULL DEFAULT 0,
    PRIMARY KEY (code, stop, round)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS voter (
    code TEXT NOT NULL REFERENCES class ON DELETE CASCADE, voter TEXT NOT NULL, session TEXT NOT NULL,
    PRIMARY KEY (code, voter)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS vote (
    code TEXT NOT NULL REFERENCES class ON DELETE CASCADE, stop TEXT NOT NULL, round INTEGER NOT NULL,
    voter TEXT NOT NULL, option TEXT NOT NULL, PRIMARY KEY (code, stop, round, voter)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS wrong_code (at REAL NOT NULL, session TEXT NOT NULL);
CREATE INDEX IF NOT EXISTS opened ON class (opened);
CREATE INDEX IF NOT EXISTS wrong_at ON wrong_code (at);
"""

DESK = """
SELECT stop, round, COALESCE(revealed, 0), COALESCE(solved, 0),
       (SELECT COUNT(*) FROM vote WHERE vote.code = class.code AND vote.stop = class.stop AND vote.round = class.round),
       (SELECT COUNT(*) FROM voter WHERE voter.code = class.code)
FROM class LEFT JOIN question USING (code, stop, round) WHERE code = ?
"""
"""Code → stop, round, revealed, solved, how many have answered, how many have joined."""
QUESTION = """
SELECT class.stop, class.round, COALESCE(revealed, 0), COALESCE(solved, 0), option, session
FROM class LEFT JOIN question USING (code, stop, round)
LEFT JOIN vote ON vote.code = class.code AND vote.stop = class.stop AND vote.round = class.round AND vote.voter = ?
JOIN voter ON voter.code = class.code AND voter.voter = ?
WHERE class.code = ? AND opened > ?
"""
"""Voter, voter, code, time → stop, round, revealed, solved, the voter's answer, the voter's session."""
CHANGES = """
SELECT before.option = ?, after.option = ?, COUNT(*)
FROM vote AS before JOIN vote AS after USING (code, stop, voter)
WHERE before.code = ? AND before.stop = ? AND before.round = 1 AND after.round = 2
GROUP BY 1, 2
"""
"""Right option, right option, code, stop → right at first, right at last, how many."""


class ClassError(Exception):
    """What a class cannot do, in one sentence for whoever asked."""


def place() -> Path:
    """Return where the classes are kept: where RAMANUJAN_CLASSES says, or in the system's temporary folder."""
    if named := os.environ.get("RAMANUJAN_CLASSES"):
        return Path(named)
    # A user's own name, so that two users of one computer do not meet in one file.
    user = getattr(os, "getuid", lambda: "")()
    return Path(tempfile.gettempdir()) / f"ramanujan-classes-{user}.sqlite"


class ClassFile:
    """The database, opened when it is first needed and again when its file has been taken away.

    All threads of a process share one connection and take turns: a poll is a few lookups by key, some microseconds.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._turn = threading.Lock()
        self._connection: sqlite3.Connection | None = None
        self._inode: tuple[int, int] | None = None
        self._lost: list[sqlite3.Connection] = []

    def read(self, query: str, values: Sequence[Any] = ()) -> list[tuple]:
        """Return all rows of a query."""

        def rows(connection: sqlite3.Connection) -> list[tuple]:
            return connection.execute(query, values).fetchall()

        with self._turn_at(rows) as found:
            return found

    @contextmanager
    def writing(self) -> Iterator[sqlite3.Connection]:
        """Hold the file for one transaction: all of it is written at the end of the block, or nothing.

        No other process writes meanwhile, so that what the block has read still holds when it writes.
        """

        def begin(connection: sqlite3.Connection) -> sqlite3.Connection:
            connection.execute("BEGIN IMMEDIATE")
            return connection

        with self._turn_at(begin) as connection:
            try:
                yield connection
                connection.execute("COMMIT")
            except BaseException:
                if connection.in_transaction:
                    connection.execute("ROLLBACK")
                raise

    @contextmanager
    def _turn_at(self, first: Callable[[sqlite3.Connection], T]) -> Iterator[T]:
        """Hold the connection from the first thing done with it, which is tried again while another process writes."""
        end = time.monotonic() + PATIENCE
        try:
            while True:
                with self._turn:
                    try:
                        done = first(self._open())
                    except sqlite3.OperationalError as error:
                        if not _is_busy(error) or time.monotonic() > end:
                            raise
                    else:
                        yield done
                        return
                # Outside the lock, and never in step with the others who wait.
                time.sleep(random.uniform(0.005, 0.05))
        except (sqlite3.Error, OSError) as error:
            _LOG.warning("The file of the classes, %s: %s", self.path, error)
            raise ClassError(_trouble(error)) from error

    def _open(self) -> sqlite3.Connection:
        """Return the connection to the file that is there now."""
        if self._connection is not None and self._inode == _inode(self.path):
            return self._connection
        if self._connection is not None:
            # Closed, it would take the journal of its successor along, which has the same name.
            self._lost.append(self._connection)
            self._connection = None
        self.path.touch(mode=0o600)
        connection = sqlite3.connect(self.path, BUSY_TIMEOUT, isolation_level=None, check_same_thread=False)
        try:
            connection.execute("PRAGMA journal_mode = WAL")
            # A vote outlives the death of a process; only a computer that loses its power may lose the last ones.
            connection.execute("PRAGMA synchronous = NORMAL")
            connection.execute("PRAGMA foreign_keys = ON")
            connection.executescript(_SCHEMA)
        except BaseException:
            connection.close()
            raise
        self._connection, self._inode = connection, _inode(self.path)
        return connection


def _inode(path: Path) -> tuple[int, int] | None:
    try:
        found = os.stat(path)
    except FileNotFoundError:
        return None
    return found.st_dev, found.st_ino


def _is_busy(error: sqlite3.OperationalError) -> bool:
    return getattr(error, "sqlite_errorcode", 0) & 0xFF in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED)


def _trouble(error: Exception) -> str:
    if isinstance(error, sqlite3.OperationalError) and _is_busy(error):
        return _("The server has too much to do at the moment. Try again in a few seconds.")
    return _("The server cannot keep answers at the moment. Whoever runs it finds the reason in its log.")
