"""The app as deployed by `.deploy/`, on the loopback address: the unit's processes behind HAProxy and HTTPS."""

from __future__ import annotations

import contextlib
import os
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from configparser import ConfigParser

import trustme

from tests.checks.browser import ROOT, stop

RECIPE = ROOT / ".deploy"
HAPROXY = shutil.which("haproxy") or shutil.which("haproxy", path="/usr/sbin:/usr/local/sbin")

OTHERS = {"hungarian": 8503, "german": 8504}
"""The processes of other languages → their ports in the recipe."""

COOKIE = "ramanujan="
"""Prefix of the cookie in which the proxy stores a visitor's process."""
_PLACE = "/opt/ramanujan"
"""The app's folder in the unit. The tests replace it by this folder and this Python."""
_STATE = "/var/lib/ramanujan"
"""The unit's StateDirectory. The tests replace it by a temporary one."""


class deployed:  # noqa: N801 (reads as a sentence: with deployed(2) as hall)
    """Run the recipe's processes and its proxy during the block.

    The proxy has two addresses: `address`, and `secure` for HTTPS, with an untrusted certificate. A process of another
    language is started by its name.
    """

    def __init__(self, processes: int = 2) -> None:
        names = ("first", "second")[:processes]
        self.ports = dict(zip((*names, *OTHERS), _free_ports(processes + len(OTHERS)), strict=True))
        self.processes: dict[str, subprocess.Popen] = {}
        self.state = tempfile.TemporaryDirectory()

    def __enter__(self) -> deployed:
        open_port, secure_port = _free_ports(2)
        self.address, self.secure = f"http://127.0.0.1:{open_port}", f"https://127.0.0.1:{secure_port}"
        addresses = {f"RAMANUJAN_{name.upper()}": f"127.0.0.1:{port}" for name, port in self.ports.items()}
        certificate = os.path.join(self.state.name, "ramanujan.pem")
        trustme.CA().issue_cert("127.0.0.1").private_key_and_cert_chain_pem.write_to_path(certificate)
        addresses |= {
            "RAMANUJAN_ADDRESS": f"127.0.0.1:{open_port}",
            "RAMANUJAN_SECURE_ADDRESS": f"127.0.0.1:{secure_port}",
            "RAMANUJAN_CERTIFICATE": certificate,
        }
        try:
            # The proxy starts before the processes, and adds each of them when it is up.
            self.proxy = subprocess.Popen(
                [HAPROXY, "-db", "-f", str(RECIPE / "ramanujan.cfg"), "-f", str(RECIPE / "https.cfg")],
                env=os.environ | addresses,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            names = self.ports.keys() - OTHERS.keys()
            for name in names:
                self.start(name)
            self.wait(names)
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        # The proxy first, because it holds connections to the others.
        for process in [*([self.proxy] if hasattr(self, "proxy") else []), *self.processes.values()]:
            stop(process)
        self.state.cleanup()

    def wait(self, names: set[str], seconds: float = 90) -> None:
        """Wait until the proxy's cookies show that visitors reach each of these processes."""
        seen, end = set(), time.monotonic() + seconds
        while not names <= seen:
            if time.monotonic() > end:
                raise RuntimeError(f"the proxy sends nobody to {', '.join(names - seen)}")
            with contextlib.suppress(OSError), urllib.request.urlopen(self.address, timeout=5) as answer:
                cookies = [cookie.partition(";")[0] for cookie in answer.headers.get_all("Set-Cookie", [])]
                seen.update(cookie.removeprefix(COOKIE) for cookie in cookies if cookie.startswith(COOKIE))
            time.sleep(0.1)

    def start(self, name: str) -> None:
        """Start a process with the command of its unit."""
        unit = ConfigParser(interpolation=None, strict=False)
        unit.optionxform = str
        unit.read(RECIPE / "ramanujan@.service")
        service = unit["Service"]
        environment = service["Environment"].split()
        if name in OTHERS:
            unit.read(RECIPE / f"ramanujan@{OTHERS[name]}.service.d/language.conf")
            environment += service["Environment"].split()
        command = [
            part.replace("%i", str(self.ports[name])).replace(f"{_PLACE}/.venv/bin/python", sys.executable)
            for part in shlex.split(service["ExecStart"])
        ]
        # The usual limit of open files on some laptops.
        command = ["sh", "-c", 'ulimit -S -n 256 && exec "$@"', "sh", *command]
        self.processes[name] = subprocess.Popen(
            command,
            cwd=service["WorkingDirectory"].replace(_PLACE, str(ROOT)),
            env=os.environ | dict(value.replace(_STATE, self.state.name).split("=") for value in environment),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )

    def kill(self, name: str) -> None:
        """Kill a process."""
        self.processes[name].send_signal(signal.SIGKILL)
        self.processes[name].wait()


def _free_ports(count: int) -> list[int]:
    probes = [socket.socket() for _ in range(count)]
    for probe in probes:
        probe.bind(("127.0.0.1", 0))
    ports = [probe.getsockname()[1] for probe in probes]
    for probe in probes:
        probe.close()
    return ports
