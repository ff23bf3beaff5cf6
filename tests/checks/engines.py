"""Three browsers: Chromium and Firefox by Playwright, WebKit by Selenium (webkit.py).

Each browser is started when a test first needs it. The tests of a missing browser are skipped, or fail if
RAMANUJAN_REQUIRE is set. A test for some browsers lists them, as in
`@pytest.mark.parametrize("engine", ["chromium"])`. A test that does not depend on the browser, such as one of
arithmetic, has the mark ANY_ENGINE.
"""

import shutil
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack

import pytest

from tests.checks import webkit
from tests.checks.bare import Bare, serving
from tests.checks.browser import PAGES
from tests.settings import DEEP, PATIENCE, skip_missing

ENGINES = ("chromium", "firefox", "webkit")
ANY_ENGINE = pytest.mark.parametrize("engine", ENGINES if DEEP else ENGINES[:1])
"""One browser represents all, unless RAMANUJAN_DEEP is set."""
FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
CALM = {"ui.prefersReducedMotion": 1}
"""Firefox's setting for reduced motion, which Playwright cannot change."""

REFUSED = """window.refused = [];
addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) =>
  refused.push(`${violatedDirective}: ${blockedURI}`))"""
"""Record the requests that the server's content security policy has blocked."""


def _check_refused(page: object) -> None:
    refused = {*page.evaluate("refused")} - {"script-src: eval"}  # Playwright tries it in Firefox
    assert not refused, refused


@pytest.fixture(scope="session")
def playwright() -> Iterator[object]:
    """Playwright, which a process can start only once."""
    from playwright.sync_api import expect, sync_playwright

    expect.set_options(timeout=1000 * PATIENCE)
    with sync_playwright() as started:
        yield started


@pytest.fixture(scope="session")
def browsers(
    request: pytest.FixtureRequest, playwright: object, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Callable]:
    """Return a running browser by its name; start it if necessary."""
    running = {}
    with ExitStack() as stack:

        def start(name: str) -> object:
            if name == "chromium":
                return request.getfixturevalue("chromium")
            if name == "firefox":
                if not FIREFOX:
                    skip_missing("Firefox", "firefox-esr")
                options = {"executable_path": FIREFOX, "firefox_user_prefs": CALM}
                browser = playwright.firefox.launch(channel="moz-firefox", **options)
            else:
                if not (webkit.BROWSER and webkit.DRIVER and webkit.SCREEN):
                    skip_missing("WebKit", "webkit2gtk-driver xvfb")
                browser = webkit.Page(tmp_path_factory.mktemp("webkit"))
            stack.callback(browser.close)
            return browser

        yield lambda name: running.get(name) or running.setdefault(name, start(name))


@pytest.fixture(params=ENGINES)
def engine(request: pytest.FixtureRequest) -> str:
    """The name of the browser; a test runs once in each browser."""
    return request.param


@pytest.fixture
def sample(engine: str) -> Callable[[Iterable[object]], list[object]]:
    """Choose cases: all in Chromium or if RAMANUJAN_DEEP is set, every third in other browsers."""
    step = 1 if engine == "chromium" or DEEP else 3
    return lambda cases: list(cases)[::step]


def new_context(browser: object, **options: object) -> object:
    """Open an isolated context, with Playwright's options, whose waits have the limit of all tests."""
    context = browser.new_context(**options)
    context.set_default_timeout(1000 * PATIENCE)
    return context


@pytest.fixture
def window(request: pytest.FixtureRequest, engine: str, browsers: Callable) -> Iterator[Callable]:
    """Open an isolated window with reduced motion: window(width, height, engine)."""
    with ExitStack() as stack:

        def open_window(width: int = 1280, height: int = 720, name: str = engine) -> object:
            browser, size = browsers(name), {"width": width, "height": height}
            if name == "webkit":
                stack.callback(browser.forget)
                browser.set_viewport_size(size)
                return browser
            context = new_context(browser, viewport=size, reduced_motion="reduce", bypass_csp=True)
            stack.callback(context.close)
            context.add_init_script(REFUSED)
            page = context.new_page()
            request.node.stash.setdefault(PAGES, []).append(page)
            stack.callback(lambda: _check_refused(page))
            return page

        yield open_window


@pytest.fixture(scope="session")
def bare_address() -> Iterator[str]:
    """The address of the bare page."""
    with serving() as port:
        yield f"http://127.0.0.1:{port}"


@pytest.fixture
def bare(window: Callable, bare_address: str) -> Iterator[Callable[..., Bare]]:
    """Open a bare page, as in bare("?layers=none", theme="dark", width=390). A JavaScript error fails the test."""
    opened = []

    def open_bare(search: str = "", *, theme: str = "light", width: int = 1280, height: int = 720) -> Bare:
        opened.append(Bare(window(width, height), f"{bare_address}/{theme}{search}"))
        return opened[-1]

    yield open_bare
    errors = [error for each in opened for error in each.page.evaluate("errors")]
    assert errors == [], errors
