"""The database of the classes, which several processes of the app read and write at the same time.

    SqliteStore     a file, shared by the processes of one machine; needs no installation
    PostgresStore   a PostgreSQL server, shared by the processes of several machines (`pip install psycopg`)

`classes` defines the rules of a class; this module only runs statements. A transaction is atomic, even if its process
is killed. The database contains no personal names.
"""

import logging
import os
import sqlite3
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, ClassVar

from ramanujan.translation import _

_LOG = logging.getLogger(__name__)

PATIENCE = 10.0
"""The timeout of a call to a busy or restarting database [s]."""
POSTGRES = ("postgresql://", "postgres://")
"""The beginnings of the address of a PostgreSQL server."""

# Both databases accept these statements. The columns `asking` and `number` contain the fields of a `class_states.Vote`,
# `times_asked` and `number`. `heard` is the time of a student's last request, `seen` the desk's view of the machine.
_FIRST_SCHEMA = """
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
_OPENING = """
ALTER TABLE class ADD COLUMN opened DOUBLE PRECISION NOT NULL DEFAULT 0;
ALTER TABLE class ADD COLUMN network TEXT;
ALTER TABLE class ADD COLUMN was_joined INTEGER NOT NULL DEFAULT 1;
"""
_UPGRADES = (_FIRST_SCHEMA, _OPENING)
"""The statements of each schema upgrade. A database stores the number of its schema."""


class ClassError(Exception):
    """A refused action; the message is one sentence for the user."""


class CrowdError(ClassError):
    """An action that is refused because of too many requests, and may succeed in a moment."""


class SeatError(ClassError):
    """An action that needs a seat in the class."""


def database_address() -> str:
    """Return the file or address of the database: RAMANUJAN_CLASSES, or a file in the user's data folder."""
    default = _data_folder() / "ramanujan" / "classes.sqlite"
    return os.environ.get("RAMANUJAN_CLASSES") or str(default)


def _data_folder() -> Path:
    """Return the operating system's folder for the data of a user's programs."""
    if sys.platform == "win32":
        variable, folder = "LOCALAPPDATA", "~/AppData/Local"
    elif sys.platform == "darwin":
        variable, folder = "", "~/Library/Application Support"
    else:
        variable, folder = "XDG_DATA_HOME", "~/.local/share"
    configured = os.environ.get(variable, "")
    return Path(configured if os.path.isabs(configured) else os.path.expanduser(folder))


def store_at(address: str | Path) -> "Store":
    """Return the store for a file path or the address of a PostgreSQL server."""
    is_postgres = str(address).startswith(POSTGRES)
    return PostgresStore(str(address)) if is_postgres else SqliteStore(Path(address))


class Store:
    """A database. A database error raises a `ClassError` with one sentence and writes its reason to the log."""

    begin: ClassVar[tuple[str, ...]]
    """Statements that begin a transaction and exclude other writers."""
    errors: tuple[type[Exception], ...]

    def read(self, query: str, values: Sequence[Any] = ()) -> list[tuple[Any, ...]]:
        """Return all rows of a query."""
        with self._raise_class_errors(), self.connection() as connection:
            return self.execute(connection, query, values).fetchall()

    @contextmanager
    def writing(self) -> Iterator[Callable[..., Any]]:
        """Run a transaction; yield `execute`.

        No other process writes during the transaction, so a row stays up to date between a read and a write.
        """
        with self._raise_class_errors(), self.connection() as connection, self._transaction(connection):
            yield lambda query, values=(): self.execute(connection, query, values)

    def exists(self) -> bool:
        """Return whether the database may contain data, without creating it."""
        return True

    def connection(self) -> Any:
        """Return a context manager that yields a connection to the database, upgraded to the newest schema."""
        raise NotImplementedError

    def is_busy(self, error: Exception) -> bool:
        """Return whether a call failed only because the database is busy, and may succeed in a moment."""
        raise NotImplementedError

    def execute(self, connection: Any, query: str, values: Sequence[Any]) -> Any:
        """Execute a statement whose values are marked by `?`."""
        return connection.execute(query, values)

    @contextmanager
    def _transaction(self, connection: Any) -> Iterator[None]:
        """Begin a transaction; commit it at the end, or roll it back after an error."""
        try:
            for statement in self.begin:
                connection.execute(statement)
            yield
            connection.execute("COMMIT")
        except BaseException:
            with suppress(*self.errors):
                connection.execute("ROLLBACK")
            raise

    @contextmanager
    def _raise_class_errors(self) -> Iterator[None]:
        """Raise `ClassError` for an error of the database or of its file."""
        failures: tuple[type[Exception], ...] = (*self.errors, OSError)
        try:
            yield
        except failures as error:
            _LOG.warning("The database of the classes: %s", error)
            if isinstance(error, OSError):
                sentence = _(
                    "The server has no folder in which it can keep the answers of a class. "
                    "Whoever runs it can name a file in RAMANUJAN_CLASSES."
                )
            elif self.is_busy(error):
                sentence = _("The server has too much to do at the moment. Try again in a few seconds.")
            else:
                sentence = _(
                    "The server cannot keep answers at the moment. Whoever runs it finds the reason in its log."
                )
            raise ClassError(sentence) from error


def _upgrade(connection: Any, schema: int) -> None:
    """Upgrade a database from an earlier schema to the newest one, within a transaction."""
    for statements in _UPGRADES[schema:]:
        for statement in statements.split(";")[:-1]:
            connection.execute(statement)


class SqliteStore(Store):
    """An SQLite file. Each call opens a new connection, so a deleted or damaged file raises an error at once."""

    begin = ("BEGIN IMMEDIATE",)
    errors = (sqlite3.Error,)

    def __init__(self, path: Path) -> None:
        self.path = path

    @contextmanager
    def connection(self) -> Iterator[sqlite3.Connection]:
        """Open the file for one call; create it with permissions for its owner only."""
        if not self.path.exists():
            self.path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
            self.path.touch(mode=0o600)
        connection = sqlite3.connect(self.path, timeout=PATIENCE, isolation_level=None)
        try:
            # The mode is optional. Setting it may fail if another process creates the file at the same time.
            with suppress(sqlite3.OperationalError):
                connection.execute("PRAGMA journal_mode = WAL")
            # With this setting a vote survives a killed process, but a power failure may lose the last votes.
            connection.execute("PRAGMA synchronous = NORMAL")
            connection.execute("PRAGMA foreign_keys = ON")
            connection.execute("PRAGMA secure_delete = ON")
            if self._schema(connection) < len(_UPGRADES):
                with self._transaction(connection):
                    _upgrade(connection, self._schema(connection))
                    connection.execute(f"PRAGMA user_version = {len(_UPGRADES)}")
            yield connection
        finally:
            connection.close()

    def exists(self) -> bool:
        """Return whether the file exists."""
        return self.path.exists()

    def is_busy(self, error: Exception) -> bool:
        """Return whether the error states that another process has locked the file."""
        return getattr(error, "sqlite_errorcode", 0) & 0xFF in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED)

    def _schema(self, connection: sqlite3.Connection) -> int:
        return connection.execute("PRAGMA user_version").fetchone()[0]


class PostgresStore(Store):
    """A database on a PostgreSQL server. The threads of a process share one connection under a lock."""

    # The lock excludes all other processes until the transaction ends.
    begin = ("BEGIN", "SELECT pg_advisory_xact_lock(1729)")

    def __init__(self, address: str) -> None:
        try:
            import psycopg
        except ImportError as error:
            raise ClassError(_("To keep the classes in PostgreSQL, install the package psycopg.")) from error
        self._psycopg, self._address = psycopg, address
        self.errors = (psycopg.Error,)
        self._lock = threading.Lock()
        self._connection: Any = None

    @contextmanager
    def connection(self) -> Iterator[Any]:
        """Yield the connection; during a restart of the server, retry until the timeout."""
        end = time.monotonic() + PATIENCE
        with self._lock:
            while True:
                try:
                    if self._connection is None or self._connection.closed:
                        self._connection = self._connect()
                    self._connection.execute("SELECT 1")
                    break
                except self._psycopg.OperationalError:
                    if time.monotonic() > end:
                        raise
                    time.sleep(0.1)
            yield self._connection

    def is_busy(self, error: Exception) -> bool:
        """Return whether the server is unreachable, or another transaction has locked a row."""
        return isinstance(error, self._psycopg.OperationalError)

    def execute(self, connection: Any, query: str, values: Sequence[Any]) -> Any:
        """Execute a statement whose values are marked by `?`."""
        return connection.execute(query.replace("?", "%s"), values)

    def _connect(self) -> Any:
        """Return a new connection, after an upgrade of the database to the newest schema."""
        connection = self._psycopg.connect(self._address, autocommit=True, connect_timeout=3)
        with self._transaction(connection):
            connection.execute("CREATE TABLE IF NOT EXISTS schema_number (number INTEGER NOT NULL)")
            [(schema,)] = connection.execute("SELECT COALESCE(MAX(number), 0) FROM schema_number").fetchall()
            if schema < len(_UPGRADES):
                _upgrade(connection, schema)
                connection.execute("INSERT INTO schema_number VALUES (%s)", (len(_UPGRADES),))
        return connection
