"""The files of the page: complete after aborted requests, compressed, and cached by browsers."""

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
from urllib.request import Request, urlopen

import pytest
import streamlit
from playwright.sync_api import expect

from ramanujan.browser import modules
from ramanujan.browser.components.link import STANDALONE_FILE
from tests.checks.browser import get, running
from tests.checks.engines import new_context
from tests.settings import PATIENCE

pytestmark = pytest.mark.xdist_group("files")
FOLDER = Path(streamlit.__file__).parent / "static"
FILES = [f"/{path.relative_to(FOLDER).as_posix()}" for path in FOLDER.glob("static/**/*.[jc]s*")]
UNPACK = {"gzip": gzip.decompress, "identity": bytes}
SCRIPT = """
import streamlit as st

if __name__ != "__main__":
    from ramanujan.server import asgi as server
    app = st.App(__file__, middleware=server.MIDDLEWARE)
else:
    st.title("A page")
"""
"""An app that only serves the page's files."""


@pytest.fixture(scope="module")
def fresh(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a new server with the app under the path /up.to/there."""
    script = tmp_path_factory.mktemp("files") / "app.py"
    script.write_text(SCRIPT)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("STREAMLIT_SERVER_BASE_URL_PATH", "up.to/there")
        server = running(script)
    server.address += "/up.to/there"
    with server as address:
        yield address


def test_aborted_requests_do_not_damage_the_files_of_other_visitors(fresh, chromium):
    """Compare all answers with the files after 600 aborted connections and five closed pages.

    Once, an incomplete copy from an aborted response was cached for all visitors.
    """
    address = fresh
    parts, chance = urlsplit(address), random.Random(1729)
    requests = [(path, coding) for path in ("/", *FILES) for coding in UNPACK]

    def leave(path: str, coding: str, after: float) -> None:
        with socket.create_connection((parts.hostname, parts.port)) as client:
            # With this option the socket resets the connection when it is closed, as a closed tab does.
            client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            head = f"GET {parts.path}{path} HTTP/1.1\r\nHost: app\r\nAccept-Encoding: {coding}\r\n\r\n"
            client.sendall(head.encode())
            time.sleep(after)

    def compare(path: str, coding: str) -> str | None:
        """Return a fault, or None without one. There is no file of the page, so return its content instead."""
        headers, body = get(f"{address}{path}", Accept_Encoding=coding)
        assert headers.get("Content-Encoding", "identity") == coding, path
        assert ("immutable" in headers["Cache-Control"]) == (path != "/")
        content = UNPACK[coding](body)
        if path == "/":
            return content.decode()
        return None if content == (FOLDER / path[1:]).read_bytes() else f"{path} in {coding}"

    with ThreadPoolExecutor(30) as pool:
        chosen = [*chance.choices(requests, k=590), *([("/", "gzip")] * 10)]
        list(pool.map(lambda each: leave(*each, chance.uniform(0, 0.03)), chosen))
        for _ in range(5):
            page = new_context(chromium).new_page()
            page.goto(address, wait_until="commit")
            page.wait_for_timeout(chance.uniform(0, 300))
            page.context.close()
        answers = list(pool.map(lambda each: compare(*each), requests))
    assert answers[len(UNPACK) :] == [None] * (len(requests) - len(UNPACK))
    assert len({*answers[: len(UNPACK)]}) == 1
    assert f"{modules.folder_url()}/begin.js" in answers[0]


def test_browsers_cache_files_forever(fresh):
    module = f"/{modules.folder_url()}/begin.js"
    for path in (FILES[0], module):
        for accepted, coding in {"br, gzip": "gzip", "br": None, "gzip;q=0.5": "gzip", "br, gzip; q=0.0": None}.items():
            headers, _ = get(f"{fresh}{path}", Accept_Encoding=accepted)
            assert headers["Content-Encoding"] == coding, (accepted, path)
            assert headers["Vary"] == "accept-encoding"
            assert "immutable" in headers["Cache-Control"]
    # The rule holds for Streamlit's own answers, too.
    for accepted, coding in {"gzip": "gzip", "gzip;q=0": None}.items():
        assert get(f"{fresh}/manifest.json", Accept_Encoding=accepted)[0]["Content-Encoding"] == coding
    # A browser's cached copy of Streamlit's start page does not replace the app's.
    index = (FOLDER / "index.html").stat()
    assert get(fresh, If_Modified_Since=time.strftime("%a, %d %b %Y %H:%M:%S GMT", time.gmtime(index.st_mtime + 9)))
    # Modules of another version of the app are missing.
    place, version = modules.folder_url().split("/")
    for wrong in (f"{place}/0000", f"{place}/{version[1:]}", f"{place}/{version}x"):
        with pytest.raises(HTTPError, match="404"):
            get(f"{fresh}/{wrong}/begin.js")


def test_a_page_makes_no_foreign_request_and_sends_no_referrer(fresh):
    headers, page = get(f"{fresh}/")
    policy = dict(rule.split(" ", 1) for rule in headers["Content-Security-Policy"].split("; "))
    assert policy["default-src"] == "'self' blob: data:"
    assert not [source for sources in policy.values() for source in sources.split() if source[:1] not in "'bd"]
    assert {"'unsafe-inline'", "'unsafe-eval'", "data:"}.isdisjoint(policy["script-src"].split())
    assert page.count(b"<script>") == policy["script-src"].count("'sha256-") > 0
    for path in ("", "motion", "unknown", "index.html", "un.known", "_stcore/unknown", STANDALONE_FILE):
        of_page, _content = get(f"{fresh}/{path}")
        assert of_page["Content-Type"].startswith("text/html"), path
        assert of_page["Referrer-Policy"] == "no-referrer", path
        own_policy = path == STANDALONE_FILE
        assert (of_page["Content-Security-Policy"] == headers["Content-Security-Policy"]) != own_policy, path
    assert of_page["Content-Security-Policy"].startswith("default-src 'none'; script-src data: ")
    for path in ("", FILES[0], "/_stcore/health", f"/{modules.folder_url()}/begin.js"):
        assert get(f"{fresh}{path}")[0]["X-Content-Type-Options"] == "nosniff", path
    for requests, is_secure in {"http": False, "https": True, "https, http": True}.items():
        cookies = [get(f"{fresh}{path}", X_Forwarded_Proto=requests)[0]["Set-Cookie"] for path in ("/", "/motion")]
        assert [cookie.endswith("; Secure") for cookie in cookies] == [is_secure] * 2


def status(address: str, method: str = "GET", **headers: str) -> int:
    """Return the status of the response to a request."""
    try:
        with urlopen(Request(address, method=method, headers=headers), timeout=PATIENCE) as response:
            return response.status
    except HTTPError as error:
        return error.code


@pytest.mark.parametrize("method", ["POST", "DELETE"])
def test_a_file_cannot_be_changed(fresh, method):
    for path in ("", "motion", "index.html", STANDALONE_FILE, f"{modules.folder_url()}/begin.js", FILES[0].strip("/")):
        assert status(f"{fresh}/{path}", method) == 405, path


def test_the_standalone_file_is_sent_again_only_if_it_has_changed(fresh):
    address = f"{fresh}/{STANDALONE_FILE}"
    tag = get(address)[0]["ETag"]
    assert status(address, **{"If-None-Match": f'"other", {tag}'}) == 304
    assert status(address, **{"If-None-Match": '"other"'}) == 200


def test_an_address_outside_of_the_base_path_is_missing(fresh):
    origin = fresh.removesuffix("/up.to/there")
    for path in ("", "motion", "up", "up.to/therefore", STANDALONE_FILE, f"{modules.folder_url()}/begin.js"):
        assert status(f"{origin}/{path}") == 404, path
    assert status(f"{origin}/up.to/there") == 200


def test_a_frame_without_an_origin_shows_a_sentence(fresh, chromium):
    page = new_context(chromium).new_page()
    page.set_content(f'<iframe sandbox="allow-scripts" src="{fresh}/motion"></iframe>')
    expect(page.frame_locator("iframe").get_by_text("The app cannot run here")).to_be_visible()
    page.context.close()
