"""Where the classes are kept: one database that several processes of the app read and write at once.

    SqliteStore     a file that the processes of one machine share; nothing has to be installed
    PostgresStore   a PostgreSQL server that the processes of several machines share (`pip install psycopg`)

What a class may do is said in `classes`; here a transaction is carried out or refused. A process that dies in the
middle of one leaves the database as it was before. Nothing in it names a person.
"""

import logging
import os
import random
import sqlite3
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, ClassVar, TypeVar

from ramanujan.translation import _

_LOG = logging.getLogger(__name__)
T = TypeVar("T")

BUSY_TIMEOUT = 0.25
"""Seconds that SQLite itself waits for another process; every thread of this process waits with it."""
PATIENCE = 10.0
"""Seconds after which a transaction is given up."""
POSTGRES = ("postgresql://", "postgres://")

# Both databases understand it. `asking` and `number` are the fields of a `class_states.Vote`.
_SCHEMA = """
CREATE TABLE IF NOT EXISTS class (
    code TEXT PRIMARY KEY, key_hash TEXT NOT NULL, expires DOUBLE PRECISION NOT NULL,
    is_open INTEGER NOT NULL DEFAULT 1, stop TEXT, asking INTEGER NOT NULL DEFAULT 1,
    number INTEGER NOT NULL DEFAULT 1, machine TEXT, seen TEXT, seen_at DOUBLE PRECISION);
CREATE TABLE IF NOT EXISTS question (
    code TEXT NOT NULL REFERENCES class ON DELETE CASCADE, stop TEXT NOT NULL, asking INTEGER NOT NULL,
    number INTEGER NOT NULL, options TEXT NOT NULL, phase INTEGER NOT NULL DEFAULT 0,
    reached INTEGER NOT NULL DEFAULT 0, asked DOUBLE PRECISION NOT NULL, present INTEGER NOT NULL DEFAULT 0,
    PRIMARY KEY (code, stop, asking, number));
CREATE TABLE IF NOT EXISTS voter (
    code TEXT NOT NULL REFERENCES class ON DELETE CASCADE, voter TEXT NOT NULL, heard DOUBLE PRECISION NOT NULL,
    joined DOUBLE PRECISION NOT NULL, network TEXT, PRIMARY KEY (code, voter));
CREATE TABLE IF NOT EXISTS vote (
    code TEXT NOT NULL REFERENCES class ON DELETE CASCADE, stop TEXT NOT NULL, asking INTEGER NOT NULL,
    number INTEGER NOT NULL, voter TEXT NOT NULL, option TEXT NOT NULL,
    PRIMARY KEY (code, stop, asking, number, voter));
CREATE INDEX IF NOT EXISTS class_expires ON class (expires);
"""
_OLD = ("wrong_code", "vote", "voter", "question", "class")
"""Tables of an earlier version of the app, which a computer may still have; they hold other columns."""


class ClassError(Exception):
    """What a class cannot do, in one sentence for whoever asked."""


class CrowdError(ClassError):
    """What a class cannot do yet, but can do in a moment."""


class SeatError(ClassError):
    """What a class does only for whoever has a seat in it."""


def place() -> str:
    """Return where the classes are kept: where RAMANUJAN_CLASSES says, or in the system's temporary folder."""
    if named := os.environ.get("RAMANUJAN_CLASSES"):
        return named
    # A user's own name, so that two users of one computer do not meet in one file.
    user = getattr(os, "getuid", lambda: "")()
    return str(Path(tempfile.gettempdir()) / f"ramanujan-classes-{user}.sqlite")


def store_at(where: str | Path) -> "Store":
    """Return the store at a file's path or a PostgreSQL server's address."""
    return PostgresStore(str(where)) if str(where).startswith(POSTGRES) else SqliteStore(Path(where))


class Store:
    """A database, opened when it is first needed and again when it was lost.

    All threads of a process share one connection and take turns: a poll is a few lookups by key, some microseconds.
    """

    begin: ClassVar[tuple[str, ...]]
    """Statements that begin a transaction in which no other process writes."""
    errors: tuple[type[Exception], ...]

    def __init__(self) -> None:
        self._turn = threading.Lock()

    def read(self, query: str, values: Sequence[Any] = ()) -> list[tuple]:
        """Return all rows of a query."""
        with self._turn_at(lambda connection: self.execute(connection, query, values).fetchall()) as found:
            return found

    @contextmanager
    def writing(self) -> Iterator[Callable[..., Any]]:
        """Hold the database for one transaction and give what executes statements in it; all is written, or nothing.

        No other process writes meanwhile, so that what the block has read still holds when it writes.
        """

        def begin(connection: Any) -> Any:
            for statement in self.begin:
                connection.execute(statement)
            return connection

        with self._turn_at(begin) as connection:
            try:
                yield lambda query, values=(): self.execute(connection, query, values)
                connection.execute("COMMIT")
            except BaseException:
                with suppress(*self.errors):
                    connection.execute("ROLLBACK")
                raise

    @contextmanager
    def _turn_at(self, first: Callable[[Any], T]) -> Iterator[T]:
        """Hold the connection from the first thing done with it, which is tried again while the database is busy."""
        end = time.monotonic() + PATIENCE
        try:
            while True:
                with self._turn:
                    try:
                        done = first(self.connect())
                    except self.errors as error:
                        if not self.may_pass(error) or time.monotonic() > end:
                            raise
                    else:
                        yield done
                        return
                # Outside the lock, and never in step with the others who wait.
                time.sleep(random.uniform(0.005, 0.05))
        except (*self.errors, OSError) as error:
            _LOG.warning("The database of the classes: %s", error)
            if self.may_pass(error):
                raise ClassError(
                    _("The server has too much to do at the moment. Try again in a few seconds.")
                ) from error
            raise ClassError(
                _("The server cannot keep answers at the moment. Whoever runs it finds the reason in its log.")
            ) from error

    def connect(self) -> Any:
        """Return the open connection, or a new one."""
        raise NotImplementedError

    def may_pass(self, error: Exception) -> bool:
        """Tell whether an error may be gone in a moment."""
        raise NotImplementedError

    def execute(self, connection: Any, query: str, values: Sequence[Any]) -> Any:
        """Execute a statement whose values are marked by `?`."""
        return connection.execute(query, values)

    def _make_tables(self, connection: Any) -> None:
        """Make the tables that are missing, in a transaction; those of an earlier version are removed first."""
        for statement in _SCHEMA.split(";")[:-1]:
            connection.execute(statement)
        if "seen_at" in (column[0] for column in connection.execute("SELECT * FROM class WHERE 1 = 0").description):
            return
        _LOG.warning("The database of the classes was made by an earlier version. Its classes are removed.")
        for table in _OLD:
            connection.execute(f"DROP TABLE IF EXISTS {table}")
        self._make_tables(connection)


class SqliteStore(Store):
    """One SQLite database in WAL mode."""

    begin = ("BEGIN IMMEDIATE",)
    errors = (sqlite3.Error,)

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.path = path
        self._connection: sqlite3.Connection | None = None
        self._files: dict[str, tuple[int, int]] = {}
        self._lost: list[sqlite3.Connection] = []

    def connect(self) -> sqlite3.Connection:
        """Return the connection to the files that are there now; where one was taken away, open them anew."""
        files = self._inodes()
        if self._connection is None or self._files != files:
            self._give_up(files)
            self._connection, self._files = self._open(), self._inodes()
        return self._connection

    def _give_up(self, files: dict[str, tuple[int, int]]) -> None:
        """Let go of a connection, if there is one, without harm to the files that are there now."""
        connection, self._connection = self._connection, None
        if connection is None:
            return
        if self._files.get("") == files.get(""):
            # Only the journal is gone. This connection still has it open, and writes it into the database.
            connection.execute("PRAGMA wal_checkpoint")
            connection.close()
        else:
            # SQLite would delete the new database’s journal with this connection, by its name. So it stays open.
            self._lost.append(connection)

    def _open(self) -> sqlite3.Connection:
        """Open the file, which only its owner may read, and make the tables that are missing."""
        self.path.touch(mode=0o600)
        connection = sqlite3.connect(self.path, timeout=BUSY_TIMEOUT, isolation_level=None, check_same_thread=False)
        try:
            connection.execute("PRAGMA journal_mode = WAL")
            # A vote outlives the death of a process; only a computer that loses its power may lose the last ones.
            connection.execute("PRAGMA synchronous = NORMAL")
            connection.execute("PRAGMA foreign_keys = ON")
            connection.execute(*self.begin)
            self._make_tables(connection)
            connection.execute("COMMIT")
        except BaseException:
            connection.close()
            raise
        return connection

    def may_pass(self, error: Exception) -> bool:
        """Tell whether another process holds the file."""
        return getattr(error, "sqlite_errorcode", 0) & 0xFF in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED)

    def _inodes(self) -> dict[str, tuple[int, int]]:
        """Return which files the database and its journal are, as far as they are there."""
        found = {}
        for suffix in ("", "-wal"):
            with suppress(FileNotFoundError):
                at = os.stat(f"{self.path}{suffix}")
                found[suffix] = at.st_dev, at.st_ino
        return found


class PostgresStore(Store):
    """A database on a PostgreSQL server."""

    # The lock is the server's for all processes, until the transaction ends.
    begin = ("BEGIN", "SELECT pg_advisory_xact_lock(1729)")

    def __init__(self, address: str) -> None:
        super().__init__()
        try:
            import psycopg
        except ImportError as error:
            raise ClassError(_("To keep the classes in PostgreSQL, install the package psycopg.")) from error
        self._psycopg, self._address = psycopg, address
        self.errors = (psycopg.Error,)
        self._connection: Any = None

    def connect(self) -> Any:
        """Return the open connection, or a new one where the server was restarted."""
        if self._connection is None or self._connection.closed:
            connection = self._psycopg.connect(self._address, autocommit=True, connect_timeout=3)
            # Two processes that create a table at once would meet in the catalogue.
            with connection.transaction():
                connection.execute(self.begin[1])
                self._make_tables(connection)
            self._connection = connection
        return self._connection

    def may_pass(self, error: Exception) -> bool:
        """Tell whether the server is away or another transaction holds what this one needs."""
        return isinstance(error, self._psycopg.OperationalError)

    def execute(self, connection: Any, query: str, values: Sequence[Any]) -> Any:
        """Execute a statement whose values are marked by `?`."""
        return connection.execute(query.replace("?", "%s"), values)
