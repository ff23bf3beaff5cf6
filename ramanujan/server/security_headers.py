"""The headers that restrict a browser's use of a response."""

from typing import Any

from starlette.datastructures import MutableHeaders

from ramanujan.server import start_page


class SecurityHeaders:
    """Middleware that adds the same headers to every page, also to one that Streamlit sends for an unknown address.

    The standalone file has its own content security policy. Each response has the header X-Content-Type-Options.
    """

    def __init__(self, app: Any) -> None:
        self.app = app
        self.of_pages = {
            "content-security-policy": start_page.content_security_policy(),
            "referrer-policy": "no-referrer",
        }

    async def __call__(self, scope: dict[str, Any], receive: Any, send: Any) -> None:
        async def send_with_headers(message: dict[str, Any]) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                headers["x-content-type-options"] = "nosniff"
                if headers.get("content-type", "").startswith("text/html"):
                    for name, value in self.of_pages.items():
                        headers.setdefault(name, value)
            await send(message)

        await self.app(scope, receive, send_with_headers if scope["type"] == "http" else send)
