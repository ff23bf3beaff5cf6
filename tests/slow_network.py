"""A slow or broken network between the browser and the app: a small proxy on the loopback address.

    with Network(server) as way:
        way.seconds = 0.1
        page.goto(way.address)

Only websockets are delayed: a page's scripts would otherwise take a minute to load, and they decide nothing.
"""

import asyncio
import contextlib
import re
import threading
from typing import Self
from urllib.parse import urlsplit

_HEAD = 65536
"""Bytes that the head of a request may take."""
_SESSION = re.compile(rb"(?i)(sec-websocket-protocol:[^,\r]*,[^,\r]*),[^\r]*")
"""What a page that comes back says in the head: at its end the session that it wants to go on with."""


class Network:
    """The way to one server, which can be slow and can break: `seconds` of delay each way, `down()` and `up()`.

    It listens on a free port, at `address`, for as long as the block lasts.
    """

    seconds = 0.0

    def __init__(self, server: str) -> None:
        parts = urlsplit(server)
        self.target = (parts.hostname, parts.port)
        self._up, self._killed = True, False
        self._connections: set[asyncio.Task] = set()
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        self._listener = self._call(self._listen())
        host, port = self._listener.sockets[0].getsockname()
        self.address = f"http://{host}:{port}"
        return self

    def __exit__(self, *_: object) -> None:
        self._call(self._close())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    def down(self) -> None:
        """Break every connection, and accept none until `up`."""
        self._call(self._break())

    def up(self, killed: bool = False) -> None:
        """Accept connections again; to the page of one that was killed the server is one that has never seen it."""
        self._up, self._killed = True, killed

    async def _listen(self) -> asyncio.Server:
        return await asyncio.start_server(self._serve, "127.0.0.1", 0, limit=_HEAD)

    def _call(self, coroutine):
        return asyncio.run_coroutine_threadsafe(coroutine, self._loop).result(timeout=30)

    async def _break(self) -> None:
        self._up = False
        for task in self._connections:
            task.cancel()
        await asyncio.gather(*self._connections, return_exceptions=True)

    async def _close(self) -> None:
        self._listener.close()
        await self._break()

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        task = asyncio.current_task()
        self._connections.add(task)
        task.add_done_callback(self._connections.discard)
        there = None
        # A connection may end at any moment, from either side: that is no error here.
        with contextlib.suppress(OSError, asyncio.IncompleteReadError, asyncio.CancelledError):
            if self._up:
                head = await reader.readuntil(b"\r\n\r\n")
                delay = b"\r\nupgrade: websocket" in head.lower()
                if self._killed:
                    head = _SESSION.sub(rb"\1", head)
                back, there = await asyncio.open_connection(*self.target)
                there.write(head)
                await self._relay_both((reader, there), (back, writer), delay=delay)
        for end in filter(None, (writer, there)):
            end.close()

    async def _relay_both(self, *ways: tuple[asyncio.StreamReader, asyncio.StreamWriter], delay: bool) -> None:
        """Relay both ways until one of them ends."""
        tasks = [asyncio.create_task(self._relay(*way, delay)) for way in ways]
        try:
            await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)

    async def _relay(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, delay: bool) -> None:
        """Hand on what comes, in order, each piece as late as the network is slow."""
        pieces: asyncio.Queue[tuple[float, bytes]] = asyncio.Queue()

        async def hand_on() -> None:
            while True:
                due, data = await pieces.get()
                await asyncio.sleep(max(0.0, due - self._loop.time()))
                if not data:
                    return
                writer.write(data)
                await writer.drain()

        sender = asyncio.create_task(hand_on())
        try:
            data = b" "
            while data:
                data = await reader.read(65536)
                pieces.put_nowait((self._loop.time() + (self.seconds if delay else 0.0), data))
            await sender
        finally:
            sender.cancel()
