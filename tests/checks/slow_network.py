"""A slow or broken network between the browser and the app: a small proxy on the loopback address.

    with Network(server) as network:
        network.seconds = 0.1
        page.goto(network.address)

Only websockets are delayed. With a delay of all requests, a page would take a minute to load.
"""

import asyncio
import contextlib
import re
import threading
from typing import Self
from urllib.parse import urlsplit

from tests.settings import PATIENCE

_HEAD = 65536
"""Largest size of a request's header [bytes]."""
_SESSION = re.compile(rb"(?i)(sec-websocket-protocol:[^,\r]*,[^,\r]*),[^\r]*")
"""The header of a reconnecting page; it ends with the id of the session to resume."""


class Network:
    """A network before one server, which listens at `address`, on a free port, during the block.

    `seconds` is the delay in each direction. `down()` breaks the network, and `up()` restores it.
    """

    seconds = 0.0

    def __init__(self, server: str) -> None:
        parts = urlsplit(server)
        self.target = (parts.hostname, parts.port)
        self._up, self._forgets_session = True, False
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
        self._thread.join(PATIENCE)
        self._loop.close()

    def down(self) -> None:
        """Break all connections, and accept none until `up`."""
        self._call(self._break())

    def up(self, forget_session: bool = False) -> None:
        """Accept connections again.

        With `forget_session`, remove the id of the session from requests. The server then begins a new session, as
        after a restart.
        """
        self._up, self._forgets_session = True, forget_session

    async def _listen(self) -> asyncio.Server:
        return await asyncio.start_server(self._serve, "127.0.0.1", 0, limit=_HEAD)

    def _call(self, coroutine):
        return asyncio.run_coroutine_threadsafe(coroutine, self._loop).result(timeout=PATIENCE)

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
        server_writer = None
        # Either side may close a connection at any time.
        with contextlib.suppress(OSError, asyncio.IncompleteReadError, asyncio.CancelledError):
            if self._up:
                head = await reader.readuntil(b"\r\n\r\n")
                delay = b"\r\nupgrade: websocket" in head.lower()
                if self._forgets_session:
                    head = _SESSION.sub(rb"\1", head)
                server_reader, server_writer = await asyncio.open_connection(*self.target)
                server_writer.write(head)
                await self._relay_both((reader, server_writer), (server_reader, writer), delay=delay)
        for each in filter(None, (writer, server_writer)):
            each.close()

    async def _relay_both(self, *directions: tuple[asyncio.StreamReader, asyncio.StreamWriter], delay: bool) -> None:
        """Relay both directions until one of them ends."""
        tasks = [asyncio.create_task(self._relay(*direction, delay)) for direction in directions]
        try:
            await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)

    async def _relay(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, delay: bool) -> None:
        """Relay data in order, with the network's delay."""
        pieces: asyncio.Queue[tuple[float, bytes]] = asyncio.Queue()

        async def send() -> None:
            while True:
                due, data = await pieces.get()
                await asyncio.sleep(max(0.0, due - self._loop.time()))
                if not data:
                    return
                writer.write(data)
                await writer.drain()

        sender = asyncio.create_task(send())
        try:
            data = b" "
            while data:
                data = await reader.read(65536)
                pieces.put_nowait((self._loop.time() + (self.seconds if delay else 0.0), data))
            await sender
        finally:
            sender.cancel()
