"""A class whose votes are in PostgreSQL, so that several machines share it: a real server, killed and restarted.

The tests start Debian's server (`apt-get install postgresql`) on a free port. Without it they are skipped, unless
RAMANUJAN_REQUIRE_POSTGRES is set.
"""

import inspect
import os
import shutil
import socket
import subprocess
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from ramanujan.lesson import classes
from ramanujan.lesson.classes import ClassError, Phase
from tests import test_classes as in_a_file
from tests.test_classes import NEW_PROCESS, OPTIONS, Clock

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
        subprocess.run(command, check=True, capture_output=True, cwd="/", **USER)

    def start(self) -> None:
        options = f"-p {self.port} -h 127.0.0.1 -k {self.folder}"
        self.run("pg_ctl", "--wait", "--silent", "--log", str(self.folder / "log"), "--options", options, "start")

    def kill(self) -> None:
        """Kill the server, so that its clients lose their connections."""
        self.run("pg_ctl", "--mode", "immediate", "stop")


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    if PROGRAMS is None:
        if os.environ.get("RAMANUJAN_REQUIRE_POSTGRES"):
            pytest.fail("no PostgreSQL on this system, and RAMANUJAN_REQUIRE_POSTGRES is set")
        pytest.skip("no PostgreSQL on this system (on Debian: apt-get install postgresql)")
    # The server's user needs access to the folder.
    folder = Path(f"/tmp/ramanujan-postgres-{os.getpid()}")
    folder.mkdir()
    running = Server(folder)
    yield running
    running.kill()
    shutil.rmtree(folder)


def test_two_processes_share_a_class_and_a_killed_server_loses_no_vote(server: Server) -> None:
    school = classes.Classes(server.address, Clock())
    opened = school.open_class()
    school.ask(opened.key, "faster", OPTIONS)
    votes = NEW_PROCESS.Queue()
    others = [
        NEW_PROCESS.Process(
            target=in_a_file.answer_as, args=(server.address, opened.code, range(start, start + 30), votes, True)
        )
        for start in (0, 30)
    ]
    for process in others:
        process.start()
    acknowledged = dict([votes.get()])
    server.kill()
    server.start()
    acknowledged |= in_a_file.collect_confirmed(others, votes)
    assert len(acknowledged) == 60
    school.show(opened.key, Phase.REVEALED)
    assert school.read_distribution(opened.code, "faster") == {o: Counter(acknowledged.values())[o] for o in OPTIONS}


@pytest.mark.parametrize(
    "test",
    [
        in_a_file.test_the_distribution_is_hidden_until_it_is_revealed,
        in_a_file.test_first_and_second_vote_are_compared_student_by_student,
        in_a_file.test_an_answer_is_changed_until_the_reveal_and_a_late_one_is_refused_with_its_reason,
        in_a_file.test_a_browser_is_a_different_voter_in_each_class,
        in_a_file.test_students_with_a_recent_request_count_as_present,
        in_a_file.test_a_stop_that_is_asked_again_later_begins_a_new_vote_and_keeps_the_old_ones,
        in_a_file.test_only_the_key_opens_the_lecturers_desk,
    ],
    ids=lambda test: test.__name__,
)
def test_a_database_server_behaves_like_a_file(test, server: Server) -> None:
    clock = Clock()
    school = classes.Classes(server.address, clock)
    opened = school.open_class()
    school.ask(opened.key, "faster", OPTIONS)
    fixtures = {"school": school, "opened": opened, "clock": clock}
    test(**{name: fixtures[name] for name in inspect.signature(test).parameters})


def test_a_missing_server_raises_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ramanujan.lesson.class_store.PATIENCE", 0.0)
    with pytest.raises(ClassError, match="too much to do"):
        classes.Classes("postgresql://ramanujan@127.0.0.1:1/postgres").open_class()
