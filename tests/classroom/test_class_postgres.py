"""A class whose votes are in PostgreSQL, so that several machines share it: a real server, killed and restarted.

The tests start Debian's server (`apt-get install postgresql`) on a free port. Without it they are skipped, unless
RAMANUJAN_REQUIRE is set.
"""

import os
import shutil
import signal
import socket
import subprocess
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from ramanujan.classroom import rules, store
from ramanujan.classroom.rules import ClassError, Phase
from tests.checks.classes import (  # noqa: F401 (these tests also use a file)
    NEW_PROCESS,
    OPTIONS,
    Clock,
    answer_as,
    collect_confirmed,
    test_a_browser_is_a_different_voter_in_each_class,
    test_a_stop_that_is_asked_again_later_begins_a_new_vote_and_keeps_the_old_ones,
    test_an_answer_is_changed_until_the_reveal_and_a_late_one_is_refused_with_its_reason,
    test_first_and_second_vote_are_compared_student_by_student,
    test_only_the_key_opens_the_lecturers_desk,
    test_seats_that_never_voted_and_new_seats_are_counted,
    test_students_with_a_recent_request_count_as_present,
    test_the_distribution_is_hidden_until_it_is_revealed,
)
from tests.settings import PATIENCE, skip_missing

pytestmark = pytest.mark.xdist_group("postgres")

PROGRAMS = next(iter(sorted(Path("/usr/lib/postgresql").glob("*/bin"), reverse=True)), None)
USER = {"user": "postgres"} if hasattr(os, "geteuid") and os.geteuid() == 0 else {}
"""The server does not run as root."""


class Server:
    """A PostgreSQL server with a new, empty database."""

    def __init__(self, folder: Path) -> None:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]
        self.folder = folder / "data"
        if USER:
            shutil.chown(folder, USER["user"])
        self.run("initdb", "--auth", "trust", "--username", "ramanujan", "--no-sync")
        self.address = f"postgresql://ramanujan@127.0.0.1:{self.port}/postgres"
        self.start()

    def run(self, program: str, *more: str) -> None:
        command = [PROGRAMS / program, "--pgdata", self.folder, *more]
        subprocess.run(command, check=True, capture_output=True, cwd="/", timeout=PATIENCE, **USER)

    def start(self) -> None:
        options = f"-p {self.port} -h 127.0.0.1 -k {self.folder}"
        self.run("pg_ctl", "--wait", "--silent", "--log", str(self.folder / "log"), "--options", options, "start")

    def kill(self) -> None:
        """Kill the server, so that its clients lose their connections."""
        self.run("pg_ctl", "--mode", "immediate", "stop")


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    if PROGRAMS is None:
        skip_missing("PostgreSQL", "postgresql")
    # The server's user needs access to the folder.
    folder = Path(f"/tmp/ramanujan-postgres-{os.getpid()}")
    folder.mkdir()
    running = Server(folder)
    yield running
    running.kill()
    shutil.rmtree(folder)


@pytest.fixture
def school(server: Server, clock: Clock) -> rules.Classes:
    return rules.Classes(server.address, clock)


def test_two_processes_share_a_class_and_a_killed_server_loses_no_vote(server: Server) -> None:
    school = rules.Classes(server.address, Clock())
    opened = school.open_class()
    school.ask(opened.key, "faster", OPTIONS)
    votes = NEW_PROCESS.Queue()
    others = [
        NEW_PROCESS.Process(
            target=answer_as, args=(server.address, opened.code, range(start, start + 30), votes, True), daemon=True
        )
        for start in (0, 30)
    ]
    for process in others:
        process.start()
    acknowledged = dict([votes.get(timeout=PATIENCE)])
    server.kill()
    server.start()
    acknowledged |= collect_confirmed(others, votes)
    assert len(acknowledged) == 60
    school.show(opened.key, Phase.REVEALED)
    assert school.read_distribution(opened.code, "faster") == {o: Counter(acknowledged.values())[o] for o in OPTIONS}


def test_classes_of_another_version_stay_in_their_namespace(server: Server, caplog: pytest.LogCaptureFixture) -> None:
    import psycopg

    with psycopg.connect(server.address, autocommit=True) as connection:
        connection.execute("CREATE DATABASE earlier")
    address = server.address.replace("/postgres", "/earlier")
    with psycopg.connect(address, autocommit=True) as connection:
        connection.execute("CREATE TABLE schema_number (number INTEGER NOT NULL)")
        connection.execute("CREATE TABLE class (code TEXT)")
    school = rules.Classes(address)
    assert school.find_code(school.open_class().key)
    [sentence] = [record.message for record in caplog.records]
    assert "from another version of the app and stay there. New ones are in the schema ramanujan_4." in sentence
    with psycopg.connect(address) as connection:
        assert connection.execute("SELECT COUNT(*) FROM public.class").fetchone() == (0,)


def test_a_missing_database_is_named(server: Server) -> None:
    with pytest.raises(ClassError, match="The database “physics” for the classes does not exist"):
        rules.Classes(server.address.replace("/postgres", "/physics")).open_class()


def test_a_missing_server_raises_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(store, "ANSWER", 0.0)
    with pytest.raises(ClassError, match="too much to do"):
        rules.Classes("postgresql://ramanujan@127.0.0.1:1/postgres").open_class()


def test_after_a_failure_the_next_calls_fail_without_waiting_for_the_server(monkeypatch: pytest.MonkeyPatch) -> None:
    """The server accepts connections and never answers."""
    monkeypatch.setattr(store, "ANSWER", 0.0)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        silent.setblocking(False)
        school = rules.Classes(f"postgresql://ramanujan@127.0.0.1:{silent.getsockname()[1]}/postgres")
        with pytest.raises(ClassError, match="too much to do"):
            school.open_class()
        silent.accept()
        with pytest.raises(ClassError, match="too much to do"):
            school.open_class()
        with pytest.raises(BlockingIOError):
            silent.accept()
        # Later the app tries again.
        monkeypatch.setattr(school._store, "_outage_ends", 0.0)
        with pytest.raises(ClassError, match="too much to do"):
            school.open_class()
        silent.accept()


def test_every_call_to_a_frozen_server_fails_and_no_vote_is_lost(
    server: Server, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(store, "ANSWER", 2.0)
    monkeypatch.setattr(store, "OUTAGE", 0.0)
    school = rules.Classes(server.address, Clock())
    opened = school.open_class()
    school.ask(opened.key, "faster", OPTIONS)
    seats = [school.join(opened.code) for _ in range(4)]
    school.vote(seats[0], "faster", "plain")
    [(backend,)] = school._store.read("SELECT pg_backend_pid()")
    processes = (int((server.folder / "postmaster.pid").read_text().split()[0]), backend)

    def signal_all(number: int) -> None:
        for process in processes:
            os.kill(process, number)

    with ThreadPoolExecutor(len(seats)) as screens:
        signal_all(signal.SIGSTOP)
        try:
            calls = [screens.submit(school.vote, seat, "faster", "machine") for seat in seats]
            for call in calls:
                with pytest.raises(ClassError, match="too much to do"):
                    call.result(PATIENCE)
        finally:
            signal_all(signal.SIGCONT)
    assert school.read(opened.code, seats[0].voter).current.answer == "plain"
    school.vote(seats[1], "faster", "neither")
    assert school.read(opened.code).answered == 2
