"""The files of the page, for everybody alike: whole, packed once, and kept by browsers, whoever came before."""

import gzip
import random
import socket
import struct
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from urllib.error import HTTPError
from urllib.parse import urlsplit

import brotli
import pytest
import streamlit

from ramanujan.browser import modules
from tests.browser import get, running

FOLDER = Path(streamlit.__file__).parent / "static"
FILES = [f"/{path.relative_to(FOLDER).as_posix()}" for path in FOLDER.glob("static/**/*.[jc]s*")]
UNPACK = {"gzip": gzip.decompress, "br": brotli.decompress, "identity": bytes}
SCRIPT = """
import gzip, hashlib, pathlib, brotli, streamlit as st

def counted(pack, **quick):
    def count(content, *_, **slow):
        with pathlib.Path(__file__).with_name("packed").open("a") as log:
            log.write(f"{quick} {hashlib.md5(content).hexdigest()}\\n")
        return pack(content, **quick)
    return count

if __name__ != "__main__":
    gzip.compress, brotli.compress = counted(gzip.compress, compresslevel=1), counted(brotli.compress, quality=1)
    from ramanujan.shell import server
    app = st.App(__file__, middleware=server.MIDDLEWARE)
else:
    st.title("A page")
"""
"""An app with nothing but the page's files; it packs them quickly, and notes what it packs."""


@pytest.fixture(scope="module")
def fresh(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[str, Path]]:
    """The address of a server that nobody has asked for anything yet, below a path, and its notes."""
    script = tmp_path_factory.mktemp("files") / "app.py"
    script.write_text(SCRIPT)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("STREAMLIT_SERVER_BASE_URL_PATH", "up/there")
        server = running(script)
    server.address += "/up/there"
    with server as address:
        yield address, script.with_name("packed")


def test_who_leaves_early_takes_nothing_away_from_the_others(fresh, chromium):
    """600 connections are closed from sockets, some more from a browser; then all answers are compared with the files.

    The cause: what had been sent to somebody who had left was kept for all, empty or cut.
    """
    address, notes = fresh
    parts, chance = urlsplit(address), random.Random(1729)
    asked = [(path, coding) for path in ("/", *FILES) for coding in UNPACK]

    def leave(path: str, coding: str, after: float) -> None:
        with socket.create_connection((parts.hostname, parts.port)) as client:
            # It resets the connection, as a tab does.
            client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            head = f"GET {parts.path}{path} HTTP/1.1\r\nHost: app\r\nAccept-Encoding: {coding}\r\n\r\n"
            client.sendall(head.encode())
            time.sleep(after)

    def compare(path: str, coding: str) -> str | None:
        headers, body = get(f"{address}{path}", Accept_Encoding=coding)
        assert headers.get("Content-Encoding", "identity") == coding, path
        assert ("immutable" in headers["Cache-Control"]) == (path != "/")
        assert headers["Vary"] == "accept-encoding"
        content = UNPACK[coding](body)
        if path == "/":
            return content.decode()
        return None if content == (FOLDER / path[1:]).read_bytes() else f"{path} in {coding}"

    with ThreadPoolExecutor(30) as pool:
        chosen = [*chance.choices(asked, k=590), *([("/", "gzip")] * 10)]
        list(pool.map(lambda each: leave(*each, chance.uniform(0, 0.03)), chosen))
        for _ in range(5):
            page = chromium.new_page()
            page.goto(address, wait_until="commit", timeout=60_000)
            page.wait_for_timeout(chance.uniform(0, 300))
            page.close()
        answers = list(pool.map(lambda each: compare(*each), asked))
    assert answers[len(UNPACK) :] == [None] * (len(asked) - len(UNPACK))
    assert len({*answers[: len(UNPACK)]}) == 1
    assert f"{modules.place()}/begin.js" in answers[0]
    packed = notes.read_text().splitlines()
    assert len(packed) == len({*packed}) > len(FILES)


def test_a_browser_keeps_files_for_good_and_is_told_what_it_gets(fresh):
    address, _ = fresh
    script = max(FILES, key=lambda path: (FOLDER / path[1:]).stat().st_size)
    content = (FOLDER / script[1:]).read_bytes()
    module = f"/{modules.place()}/begin.js"
    for accepted, coding in {"br;q=0, gzip": "gzip", "gzip;q=0.5, *;q=0": "gzip", "*": "br", "br;q=0": None}.items():
        for path in (script, module, "/motion"):
            headers, _ = get(f"{address}{path}", Accept_Encoding=accepted)
            assert headers["Content-Encoding"] == coding, (accepted, path)
    tags = [get(f"{address}{script}", Accept_Encoding=coding)[0]["ETag"] for coding in ("gzip", "identity")]
    for tag in tags:
        with pytest.raises(HTTPError, match="304"):
            get(f"{address}{script}", Accept_Encoding="gzip", If_None_Match=tag)
    headers, part = get(f"{address}{script}", Accept_Encoding="gzip", Range="bytes=7-99")
    assert (part, headers["Content-Encoding"]) == (content[7:100], None)
    # What a browser has kept of Streamlit's own start page does not stand for the app's.
    index = (FOLDER / "index.html").stat()
    assert get(address, If_Modified_Since=time.strftime("%a, %d %b %Y %H:%M:%S GMT", time.gmtime(index.st_mtime + 9)))
    # A module of another version of the app is not there, nor one whose version is only like it.
    place, version = modules.place().split("/")
    for wrong in (f"{place}/0000", f"{place}/{version[1:]}", f"{place}/{version}x", "static/js"):
        with pytest.raises(HTTPError, match="404"):
            get(f"{address}/{wrong}/begin.js")


def test_a_page_loads_nothing_from_elsewhere_and_tells_nobody_its_address(fresh):
    address, _ = fresh
    headers, page = get(f"{address}/")
    assert headers["Referrer-Policy"] == "no-referrer"
    policy = dict(rule.split(" ", 1) for rule in headers["Content-Security-Policy"].split("; "))
    assert policy["default-src"] == "'self' blob: data:"
    assert not [source for sources in policy.values() for source in sources.split() if source[:1] not in "'bd"]
    assert {"'unsafe-inline'", "'unsafe-eval'", "data:"}.isdisjoint(policy["script-src"].split())
    assert page.count(b"<script>") == policy["script-src"].count("'sha256-") > 0
    for path in ("", FILES[0], "/_stcore/health", f"/{modules.place()}/begin.js"):
        assert get(f"{address}{path}")[0]["X-Content-Type-Options"] == "nosniff", path
    for asked, is_secure in {"http": False, "https": True}.items():
        cookies = [get(f"{address}{path}", X_Forwarded_Proto=asked)[0]["Set-Cookie"] for path in ("/", "/motion")]
        assert [cookie.endswith("; Secure") for cookie in cookies] == [is_secure] * 2
