"""The database of the classes, which several processes of the app read and write at the same time.

    SqliteStore     a file, shared by the processes of one machine; needs no installation
    PostgresStore   a PostgreSQL server, shared by the processes of several machines (`pip install psycopg`)

`rules` defines the rules of a class; this module only runs statements. A transaction is atomic, even if its process is
killed. The database contains no personal names.
"""

import logging
import os
import socket
import sqlite3
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from typing import Any, ClassVar

from ramanujan.text.translation import _

_LOG = logging.getLogger(__name__)

PATIENCE = 10.0
"""The timeout of a call to a busy SQLite file [s]."""
ANSWER = 4.0
"""The timeout of a call to a PostgreSQL server, and of its wait for other calls [s]."""
CONNECT = 2
"""The timeout of an attempt to connect to a PostgreSQL server; libpq has no shorter one [s]."""
OUTAGE = 5.0
"""After a failure of the PostgreSQL server, calls fail at once for this long [s]."""
HOLD = 0.5
"""After a transaction, an SQLite file stays open for this long [s]."""
POSTGRES = ("postgresql://", "postgres://")
"""The beginnings of the address of a PostgreSQL server."""

# Both databases accept these statements. The columns `asking` and `number` contain the fields of a `states.Vote`,
# `times_asked` and `number`. `heard` is the time of a student's last request, `joined` of the first, `seen` the desk's
# view of the machine. `visited` is the time of the last request of a screen: a desk, a wall or a phone.
_TABLES = """
CREATE TABLE class (
    code TEXT PRIMARY KEY, key_hash TEXT NOT NULL, opened DOUBLE PRECISION NOT NULL, expires DOUBLE PRECISION NOT NULL,
    visited DOUBLE PRECISION NOT NULL DEFAULT 0, is_open INTEGER NOT NULL DEFAULT 1, stop TEXT,
    asking INTEGER NOT NULL DEFAULT 1, number INTEGER NOT NULL DEFAULT 1, machine TEXT, seen TEXT,
    seen_at DOUBLE PRECISION);
CREATE TABLE question (
    code TEXT NOT NULL REFERENCES class ON DELETE CASCADE, stop TEXT NOT NULL, asking INTEGER NOT NULL,
    number INTEGER NOT NULL, options TEXT NOT NULL, phase INTEGER NOT NULL DEFAULT 0,
    reached INTEGER NOT NULL DEFAULT 0, asked DOUBLE PRECISION NOT NULL, present INTEGER NOT NULL DEFAULT 0,
    PRIMARY KEY (code, stop, asking, number));
CREATE TABLE voter (
    code TEXT NOT NULL REFERENCES class ON DELETE CASCADE, voter TEXT NOT NULL, heard DOUBLE PRECISION NOT NULL,
    joined DOUBLE PRECISION NOT NULL, PRIMARY KEY (code, voter));
CREATE TABLE vote (
    code TEXT NOT NULL REFERENCES class ON DELETE CASCADE, stop TEXT NOT NULL, asking INTEGER NOT NULL,
    number INTEGER NOT NULL, voter TEXT NOT NULL, option TEXT NOT NULL,
    PRIMARY KEY (code, stop, asking, number, voter));
CREATE INDEX class_expires ON class (expires);
"""
SCHEMA = 4
"""The number of these tables. Change it with them: classes in tables of another number are left alone."""
_NAMESPACE = f"ramanujan_{SCHEMA}"
"""The namespace of the tables in a PostgreSQL database."""
_KEEPALIVE: dict[str, Any] = {
    "keepalives_idle": 5,
    "keepalives_interval": 2,
    "keepalives_count": 3,
    "tcp_user_timeout": 10_000,
}
"""Parameters by which an idle connection closes when the network has failed [s, the last one in ms]."""


class ClassError(Exception):
    """A refused action; the message is one sentence for the user."""


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
        deleted = 0

        def execute(query: str, values: Sequence[Any] = ()) -> Any:
            nonlocal deleted
            cursor = self.execute(connection, query, values)
            if query.lstrip().startswith("DELETE"):
                deleted += cursor.rowcount
            return cursor

        with self._raise_class_errors(), self.connection() as connection:
            with self._transaction(connection):
                yield execute
            if deleted:
                self.erase_deleted(connection)

    def exists(self) -> bool:
        """Return whether the database may contain data, without creating it."""
        return True

    def connection(self) -> Any:
        """Return a context manager that yields a connection to the database with its tables."""
        raise NotImplementedError

    def is_busy(self, error: Exception) -> bool:
        """Return whether a call failed only because the database is busy, and may succeed in a moment."""
        raise NotImplementedError

    def execute(self, connection: Any, query: str, values: Sequence[Any]) -> Any:
        """Execute a statement whose values are marked by `?`."""
        return connection.execute(query, values)

    def erase_deleted(self, connection: Any) -> None:
        """Erase deleted rows from the disk, after the transaction."""

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
                sentence = _too_much_to_do()
            else:
                sentence = _(
                    "The server cannot keep answers at the moment. Whoever runs it finds the reason in its log."
                )
            raise ClassError(sentence) from error


def _create_tables(connection: Any) -> None:
    """Create the tables, within a transaction."""
    for statement in _TABLES.split(";")[:-1]:
        connection.execute(statement)


def _log_other_version(old: str, new: str) -> None:
    """Log that the classes of another version of the app stay in one place, and that new ones are in another."""
    _LOG.warning("The classes in %s are from another version of the app and stay there. New ones are in %s.", old, new)


class SqliteStore(Store):
    """An SQLite file. Each call opens a new connection, so a deleted or damaged file raises an error at once.

    The last connection to close copies the log into the file, which takes longer than twenty votes. So a transaction
    leaves an idle connection, which closes after `HOLD` in another thread. After that all data is in the one file.

    If the file contains tables of another version of the app, the classes are in a new file beside it.
    """

    begin = ("BEGIN IMMEDIATE",)
    errors = (sqlite3.Error,)

    def __init__(self, path: Path) -> None:
        self.path = path
        self._lock = threading.Lock()
        self._idle: _IdleConnection | None = None

    @contextmanager
    def connection(self) -> Iterator[sqlite3.Connection]:
        """Open the file for one call; create it with permissions for its owner only."""
        with self._lock:
            if self._idle and self._idle.is_moved():
                self._idle.delete_log()
                self._close_idle()
        if not self.path.exists():
            self.path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
            self.path.touch(mode=0o600)
        with closing(sqlite3.connect(self.path, timeout=PATIENCE, isolation_level=None)) as connection:
            # The mode is optional. Setting it may fail if another process creates the file at the same time.
            with suppress(sqlite3.OperationalError):
                connection.execute("PRAGMA journal_mode = WAL")
            # With this setting a vote survives a killed process, but a power failure may lose the last votes.
            connection.execute("PRAGMA synchronous = NORMAL")
            connection.execute("PRAGMA foreign_keys = ON")
            connection.execute("PRAGMA secure_delete = ON")
            if self._has_tables(connection):
                yield connection
                return
        beside = self.path.with_stem(f"{self.path.stem}-{SCHEMA}")
        _log_other_version(str(self.path), str(beside))
        self.path = beside
        with self.connection() as connection:
            yield connection

    def exists(self) -> bool:
        """Return whether the file exists."""
        return self.path.exists()

    def is_busy(self, error: Exception) -> bool:
        """Return whether the error states that another process has locked the file."""
        return getattr(error, "sqlite_errorcode", 0) & 0xFF in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED)

    def erase_deleted(self, connection: sqlite3.Connection) -> None:
        """Empty the log. It contains earlier versions of the pages, also those that `secure_delete` overwrites."""
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")

    @contextmanager
    def _transaction(self, connection: sqlite3.Connection) -> Iterator[None]:
        """Run a transaction, and leave an idle connection."""
        with super()._transaction(connection):
            yield
        with self._lock, suppress(*self.errors, OSError):
            if self._idle is None:
                self._idle = _IdleConnection(self.path, self._rest)

    def _rest(self) -> None:
        """Close the idle connection."""
        with self._lock:
            self._close_idle()

    def _close_idle(self) -> None:
        """Close the idle connection, if there is one. The caller has acquired the lock."""
        if self._idle:
            self._idle.close()
            self._idle = None

    def _has_tables(self, connection: sqlite3.Connection) -> bool:
        """Return whether the file has the tables of this version; create them in an empty file."""
        if self._read_schema(connection) == SCHEMA:
            return True
        with self._transaction(connection):
            # Another process may have created the tables in the meantime.
            [(count,)] = connection.execute("SELECT COUNT(*) FROM sqlite_master")
            if count:
                return self._read_schema(connection) == SCHEMA
            _create_tables(connection)
            connection.execute(f"PRAGMA user_version = {SCHEMA}")
        return True

    def _read_schema(self, connection: sqlite3.Connection) -> int:
        return connection.execute("PRAGMA user_version").fetchone()[0]


class _IdleConnection:
    """A connection that keeps an SQLite file and its log open.

    path : the file
    rest : function that closes the connection, called after `HOLD`
    """

    def __init__(self, path: Path, rest: Callable[[], None]) -> None:
        self._connection = sqlite3.connect(path, check_same_thread=False)
        # A query opens the log.
        self._connection.execute("PRAGMA user_version").fetchall()
        self._path = path
        self._number = _file_number(path)
        log = [path.with_name(f"{path.name}-{suffix}") for suffix in ("wal", "shm")]
        self._log = {file: _file_number(file) for file in log}
        self._timer = threading.Timer(HOLD, rest)
        self._timer.start()

    def is_moved(self) -> bool:
        """Return whether the file was deleted or replaced."""
        return _file_number(self._path) != self._number

    def delete_log(self) -> None:
        """Delete the log of a file that was deleted or replaced, so that the new file does not get its rows."""
        for file, number in self._log.items():
            # Another process may have done this already. Then this log is that of the new file.
            if _file_number(file) == number:
                file.unlink(missing_ok=True)

    def close(self) -> None:
        """Close the connection."""
        self._timer.cancel()
        self._connection.close()


def _file_number(path: Path) -> tuple[int, int] | None:
    """Return the numbers by which the system identifies a file, None without a file."""
    try:
        status = path.stat()
    except FileNotFoundError:
        return None
    return status.st_dev, status.st_ino


class PostgresStore(Store):
    """A database on a PostgreSQL server. The threads of a process share one connection under a lock.

    The tables are in a namespace of their own, beside the tables of another version of the app.

    A call fails after `ANSWER`, also if the server accepts it and never answers. Other calls then fail at once for the
    duration `OUTAGE`, because a screen makes several calls.
    """

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
        self._outage_ends = 0.0

    @contextmanager
    def connection(self) -> Iterator[Any]:
        """Yield the connection; during a restart of the server, retry until the timeout."""
        if not self._lock.acquire(timeout=ANSWER):
            raise ClassError(_too_much_to_do())
        try:
            if time.monotonic() < self._outage_ends:
                raise ClassError(_too_much_to_do())
            end = time.monotonic() + ANSWER
            while not self._is_connected(end):
                time.sleep(0.1)
            with _disconnecting_at(end, self._connection):
                yield self._connection
        except self._psycopg.OperationalError:
            # The server answers if only a statement has failed.
            if self._connection is None or self._connection.closed:
                self._outage_ends = time.monotonic() + OUTAGE
            raise
        finally:
            self._lock.release()

    def is_busy(self, error: Exception) -> bool:
        """Return whether the server is unreachable, or another transaction has locked a row."""
        return isinstance(error, self._psycopg.OperationalError)

    def execute(self, connection: Any, query: str, values: Sequence[Any]) -> Any:
        """Execute a statement whose values are marked by `?`."""
        return connection.execute(query.replace("?", "%s"), values)

    def _is_connected(self, end: float) -> bool:
        """Connect if necessary, and return whether the server answers. After the end raise its error."""
        try:
            if self._connection is None or self._connection.closed:
                self._connection = self._connect(end)
            with _disconnecting_at(end, self._connection):
                self._connection.execute("SELECT 1")
        except self._psycopg.OperationalError as error:
            self._raise_missing_database(error)
            if time.monotonic() > end:
                raise
            return False
        return True

    def _connect(self, end: float) -> Any:
        """Return a new connection to the tables of this version; create them in a new database."""
        connection = self._psycopg.connect(self._address, autocommit=True, connect_timeout=CONNECT, **_KEEPALIVE)
        try:
            with _disconnecting_at(end, connection):
                self._prepare(connection)
        except BaseException:
            connection.close()
            raise
        return connection

    def _prepare(self, connection: Any) -> None:
        """Set the timeouts of a connection, and select the tables of this version or create them."""
        # In milliseconds. The server cancels a statement before the app disconnects, and ends the transaction of a
        # process that is frozen.
        connection.execute(f"SET statement_timeout = {750 * ANSWER:.0f}")
        connection.execute(f"SET idle_in_transaction_session_timeout = {1000 * ANSWER:.0f}")
        with self._transaction(connection):
            connection.execute(f"CREATE SCHEMA IF NOT EXISTS {_NAMESPACE}")
            connection.execute(f"SET search_path = {_NAMESPACE}")
            query = f"SELECT to_regclass('{_NAMESPACE}.class'), to_regclass('public.schema_number')"
            [(table, other_version)] = connection.execute(query).fetchall()
            if table is None:
                _create_tables(connection)
                if other_version:
                    _log_other_version("the schema public", f"the schema {_NAMESPACE}")

    def _raise_missing_database(self, error: Exception) -> None:
        """Raise `ClassError` if the server has no database with the name in the address."""
        name = self._psycopg.conninfo.conninfo_to_dict(self._address).get("dbname")
        # A failed connection has no error code.
        if f'database "{name}" does not exist' in str(error):
            _LOG.warning("The database of the classes: %s", error)
            sentence = _("The database “{name}” for the classes does not exist. Whoever runs the server can create it.")
            raise ClassError(sentence.format(name=name)) from error


@contextmanager
def _disconnecting_at(end: float, connection: Any) -> Iterator[None]:
    """Disconnect at the end, so that a call to a server that never answers fails.

    Parameters
    ----------
    end : value of `time.monotonic` [s]
    connection : the connection of the call
    """
    timer = threading.Timer(end - time.monotonic(), _disconnect, (connection,))
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def _disconnect(connection: Any) -> None:
    """Shut the socket of a connection to a PostgreSQL server, while another thread waits for an answer."""
    # The connection may have been closed in the meantime.
    with suppress(Exception):
        server = socket.socket(fileno=connection.fileno())
        try:
            server.shutdown(socket.SHUT_RDWR)
        finally:
            # The connection itself closes the socket.
            server.detach()


def _too_much_to_do() -> str:
    return _("The server has too much to do at the moment. Try again in a few seconds.")
