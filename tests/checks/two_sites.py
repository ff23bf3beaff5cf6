"""The app in a frame of another site: a course page at 127.0.0.1 that shows a page of localhost.

    with CoursePage(server, "lesson?class=BCDFHJ", secure=True) as course:
        page.goto(course.address)

A relay serves the app under that name. With `secure` both sites use HTTPS, with an untrusted certificate.
"""

import asyncio
import contextlib
import ssl
import threading
from typing import Self
from urllib.parse import urlsplit

import trustme

from tests.settings import PATIENCE

_PIECE = 65536
"""Largest number of bytes forwarded at once."""


class CoursePage:
    """A page of another site with the app in a frame. It listens on a free port during the block."""

    def __init__(self, server: str, link: str, *, secure: bool) -> None:
        self._server, self._link = urlsplit(server), link
        self._scheme = "https" if secure else "http"
        self._context = None
        if secure:
            self._context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            trustme.CA().issue_cert("127.0.0.1", "localhost").configure_cert(self._context)
        self._ready = threading.Event()
        self._thread = threading.Thread(target=lambda: asyncio.run(self._run()), daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        assert self._ready.wait(timeout=PATIENCE)
        return self

    def __exit__(self, *_: object) -> None:
        self._loop.call_soon_threadsafe(self._end.set)
        self._thread.join(PATIENCE)

    async def _run(self) -> None:
        """Listen until the end of the block. Then asyncio cancels the open connections."""
        self._loop, self._end = asyncio.get_running_loop(), asyncio.Event()
        course, app = [
            await asyncio.start_server(serve, "127.0.0.1", 0, ssl=self._context)
            for serve in (self._serve_course, self._serve_app)
        ]
        self.address = f"{self._scheme}://127.0.0.1:{course.sockets[0].getsockname()[1]}/"
        self.frame = f"{self._scheme}://localhost:{app.sockets[0].getsockname()[1]}/{self._link}"
        self._ready.set()
        await self._end.wait()
        course.close()
        app.close()

    async def _serve_course(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with contextlib.suppress(OSError), contextlib.closing(writer):
            await reader.read(_PIECE)
            text = f'<title>Course</title><iframe src="{self.frame}" width="390" height="844"></iframe>'
            writer.write(f"HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nConnection: close\r\n\r\n{text}".encode())
            await writer.drain()

    async def _serve_app(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with contextlib.suppress(OSError), contextlib.closing(writer):
            from_app, to_app = await asyncio.open_connection(self._server.hostname, self._server.port)
            # At the end of the block asyncio cancels this task.
            with contextlib.closing(to_app), contextlib.suppress(asyncio.CancelledError):
                await asyncio.gather(_relay(reader, to_app), _relay(from_app, writer))


async def _relay(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    """Forward data until the connection ends, then close the other one."""
    with contextlib.suppress(OSError):
        while piece := await reader.read(_PIECE):
            writer.write(piece)
            await writer.drain()
    writer.close()
