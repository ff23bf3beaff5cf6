"""What the tests share: the app under AppTest, a running server, a Chromium.

Browser tests need a Chromium or Chrome on the system; without one they are skipped, unless RAMANUJAN_REQUIRE_BROWSER
is set, as it is in CI. Each worker starts one browser, and each test opens contexts of its own in it: no test sees a
tab, a cookie or a stored value of another one. All workers of a run share one server, and what it has worked out.
"""

import os
import re
from collections.abc import Callable, Iterator
from functools import cache
from tempfile import TemporaryDirectory

import pytest
from hypothesis import settings
from streamlit.components.v2 import manifest_scanner
from streamlit.testing.v1 import AppTest

from tests.browser import CHROMIUM, FLAGS, ROOT, leave_out_figures, open_address, running, started
from tests.engines import bare, bare_address, browsers, engine, missing, playwright, some, window  # noqa: F401

IN_A_BROWSER = ("test_browser", "test_deployment")
SHARED = re.compile(r"firefox|webkit|notebook_|test_(accuracy|browser_files|class_postgres|deployment|rooms)\.py")
"""In the names of tests, what those have in common that share a browser, a kernel or a server."""

# The classes that tests open are not among those of this machine's own app, which keeps 200 at most.
_CLASSES = TemporaryDirectory()
os.environ.setdefault("RAMANUJAN_CLASSES", f"{_CLASSES.name}/classes.sqlite")

# In CI the same cases each time: a case that nobody has met yet is looked for on the machines of developers.
settings.register_profile("ci", derandomize=True)
if os.environ.get("RAMANUJAN_REQUIRE_BROWSER"):
    settings.load_profile("ci")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put first what takes longest: what needs a browser, and the larger files."""
    items.sort(key=lambda item: (not item.path.stem.startswith(IN_A_BROWSER), -item.path.stat().st_size, item.path))


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: object) -> object:
    """Give any worker any test, but those that start the same processes to one: pytest-xdist 3.8 loses its own groups.

    It writes them into the names of tests, where pytest does not look for them from 9.2 on.
    """
    from xdist.scheduler import LoadGroupScheduling

    class Scheduling(LoadGroupScheduling):
        def _split_scope(self, nodeid: str) -> str:
            shared = SHARED.search(nodeid)
            return shared[0] if shared else super()._split_scope(nodeid)

    return Scheduling(config, log)


@pytest.fixture
def app() -> AppTest:
    """The app before its first run."""
    return AppTest.from_file(str(ROOT / "app.py"), default_timeout=60)


_APP = pytest.StashKey[running]()


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: object) -> None:
    """Tell a worker the address of the app that all of them share."""
    if CHROMIUM:
        stash = node.config.stash
        stash[_APP] = stash.get(_APP, None) or running(ROOT / "app.py")
        node.workerinput["server"] = stash[_APP].address


def pytest_unconfigure(config: pytest.Config) -> None:
    """End the app that the workers have shared."""
    if app := config.stash.get(_APP, None):
        app.__exit__()


@pytest.fixture(scope="session")
def server(pytestconfig: pytest.Config) -> Iterator[str]:
    """The address of the running app."""
    if shared := getattr(pytestconfig, "workerinput", {}).get("server"):
        yield started(shared)
        return
    with running(ROOT / "app.py") as address:
        yield address


@pytest.fixture(scope="session")
def chromium(playwright: object) -> Iterator[object]:  # noqa: F811
    """One headless browser for all tests of a worker."""
    if CHROMIUM is None:
        missing("chromium")
    browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
    yield browser
    browser.close()


@pytest.fixture
def visit(chromium: object, server: str) -> Iterator[Callable]:
    """Open a page of the app as a new visitor: visit("?m=2", width=390, height=844, theme="dark").

    Each call has a browser context of its own, with further options as Playwright names them; `tab=page` opens the
    address in a visitor's tab instead, and `beside=page` in another tab of that visitor. Scripts run before those of
    the page. `network` is the address of another way to the server; `note` takes the address of each request. No page
    may end with an error. The stage stands still unless motion="no-preference" is asked for: to draw sixty frames a
    second without a graphics card takes a processor of its own. With figures=False there is nothing where they are.
    """
    contexts, errors = [], []

    def open_page(
        address: str = "",
        *scripts: str,
        width: int = 1280,
        height: int = 720,
        theme: str = "light",
        motion: str = "reduce",
        tab: object = None,
        beside: object = None,
        figures: bool = True,
        network: str | None = None,
        note: Callable[[str], object] | None = None,
        **options: object,
    ) -> object:
        size = {"width": width, "height": height}
        if not (tab or beside):
            contexts.append(chromium.new_context(viewport=size, **({"bypass_csp": True} | options)))
            contexts[-1].set_default_timeout(60_000)
            contexts[-1].on("weberror", lambda error: errors.append(str(error.error)))
        page = tab or (beside.context if beside else contexts[-1]).new_page()
        page.set_viewport_size(size)
        page.emulate_media(color_scheme=theme, reduced_motion=motion)
        if not figures:
            leave_out_figures(page)
        if note:
            page.on("request", lambda request: note(request.url))
        open_address(page, f"{network or server}/{address}", *scripts)
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert errors == []


# Each app test reads the descriptions of all packages, a tenth of a second; while tests run these stay as they are.
manifest_scanner.scan_component_manifests = cache(manifest_scanner.scan_component_manifests)
