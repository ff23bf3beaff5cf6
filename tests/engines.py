"""Three browsers for modules and journeys: Chromium and Firefox by Playwright, WebKit by Selenium (webkit.py).

Each is started when a test first needs it. Where one is missing its tests are skipped, unless RAMANUJAN_REQUIRE_BROWSER
is set. A test that not every browser can take part in names those that can:
`@pytest.mark.parametrize("engine", ["chromium"])`; one of what browsers have in common, arithmetic above all, has the
mark ANY_ENGINE.
"""

import os
import shutil
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack

import pytest

from tests import webkit
from tests.bare import Bare, serving
from tests.browser import PAGES

ENGINES = ("chromium", "firefox", "webkit")
ANY_ENGINE = pytest.mark.parametrize("engine", ENGINES if os.environ.get("RAMANUJAN_DEEP") else ENGINES[:1])
"""One browser stands for all, unless RAMANUJAN_DEEP is set."""
FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
CALM = {"ui.prefersReducedMotion": 1}
"""What makes Firefox wish for less motion, which Playwright cannot tell it."""

REFUSED = """window.refused = [];
addEventListener("securitypolicyviolation", (told) => refused.push(`${told.violatedDirective}: ${told.blockedURI}`))"""
"""Notes what the server's policy has kept a page from loading."""


def _check_refused(page: object) -> None:
    refused = {*page.evaluate("refused")} - {"script-src: eval"}  # Playwright tries it in Firefox
    assert not refused, refused


def missing(packages: str) -> None:
    """Skip a test whose browser is missing, or let it fail where all must be there."""
    end = pytest.fail if os.environ.get("RAMANUJAN_REQUIRE_BROWSER") else pytest.skip
    end(f"a browser is missing (on Debian: apt-get install {packages})")


@pytest.fixture(scope="session")
def playwright() -> Iterator[object]:
    """Playwright, which a process can start once."""
    from playwright.sync_api import expect, sync_playwright

    # On a machine that others share, a page of five figures takes more than 5 s.
    expect.set_options(timeout=20_000)
    with sync_playwright() as started:
        yield started


@pytest.fixture(scope="session")
def browsers(
    request: pytest.FixtureRequest, playwright: object, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Callable]:
    """Start a browser by its name, or return the one that was started before."""
    running = {}
    with ExitStack() as stack:

        def start(name: str) -> object:
            if name == "chromium":
                return request.getfixturevalue("chromium")
            if name == "firefox":
                if not FIREFOX:
                    missing("firefox-esr")
                options = {"executable_path": FIREFOX, "firefox_user_prefs": CALM}
                browser = playwright.firefox.launch(channel="moz-firefox", **options)
            else:
                if not (webkit.BROWSER and webkit.DRIVER and webkit.SCREEN):
                    missing("webkit2gtk-driver xvfb")
                browser = webkit.Page(tmp_path_factory.mktemp("webkit"))
            stack.callback(browser.close)
            return browser

        yield lambda name: running.get(name) or running.setdefault(name, start(name))


@pytest.fixture(params=ENGINES)
def engine(request: pytest.FixtureRequest) -> str:
    """The name of the browser in which a test runs: it runs in each of them."""
    return request.param


@pytest.fixture
def some(engine: str) -> Callable[[Iterable[object]], list[object]]:
    """Choose from cases: all of them in Chromium, or where RAMANUJAN_DEEP is set; of three one in other browsers."""
    step = 1 if engine == "chromium" or os.environ.get("RAMANUJAN_DEEP") else 3
    return lambda cases: list(cases)[::step]


@pytest.fixture
def window(request: pytest.FixtureRequest, engine: str, browsers: Callable) -> Iterator[Callable]:
    """Open a window that knows nothing of others, with less motion: window(width, height, engine)."""
    with ExitStack() as stack:

        def open_window(width: int = 1280, height: int = 720, name: str = engine) -> object:
            browser, size = browsers(name), {"width": width, "height": height}
            if name == "webkit":
                stack.callback(browser.forget)
                browser.set_viewport_size(size)
                return browser
            context = browser.new_context(viewport=size, reduced_motion="reduce", bypass_csp=True)
            stack.callback(context.close)
            context.add_init_script(REFUSED)
            page = context.new_page()
            request.node.stash.setdefault(PAGES, []).append(page)
            stack.callback(lambda: _check_refused(page))
            return page

        yield open_window


@pytest.fixture(scope="session")
def bare_address() -> Iterator[str]:
    """Where the bare page is offered."""
    with serving() as address:
        yield address


@pytest.fixture
def bare(window: Callable, bare_address: str) -> Iterator[Callable[..., Bare]]:
    """Open a bare page: bare("?layers=none", theme="dark", width=390); it must end without an error."""
    opened = []

    def open_bare(search: str = "", *, theme: str = "light", width: int = 1280, height: int = 720) -> Bare:
        opened.append(Bare(window(width, height), f"{bare_address}/{theme}{search}"))
        return opened[-1]

    yield open_bare
    errors = [error for each in opened for error in each.page.evaluate("errors")]
    assert errors == [], errors
