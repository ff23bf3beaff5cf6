"""Fixtures that all tests share: the app under AppTest, a running server, a Chromium.

A test that uses a browser has the mark `browser`; `pytest -m "not browser"` leaves these tests out. Without its
browser such a test is skipped, unless RAMANUJAN_REQUIRE_BROWSER is set, as it is in CI. Each worker starts one
browser, and each test opens contexts of its own in it: no test sees a tab, a cookie or a stored value of another one.
All workers of a run share one server and its caches.
"""

import contextlib
import os
from collections import Counter
from collections.abc import Callable, Iterator
from functools import cache
from tempfile import TemporaryDirectory

import pytest
from hypothesis import settings
from streamlit.components.v2 import manifest_scanner
from streamlit.testing.v1 import AppTest

from tests.browser import (
    CHROMIUM,
    FLAGS,
    PAGES,
    ROOT,
    evidence,
    leave_out_figures,
    open_address,
    running,
    wait_for_start,
)
from tests.engines import bare, bare_address, browsers, engine, playwright, skip_missing, some, window  # noqa: F401

# The classes that tests open are not among those of this machine's own app, which keeps 200 at most.
_CLASSES = TemporaryDirectory()
os.environ.setdefault("RAMANUJAN_CLASSES", f"{_CLASSES.name}/classes.sqlite")

# In CI the same cases each time: a case that nobody has met yet is looked for on the machines of developers.
settings.register_profile("ci", derandomize=True)
if os.environ.get("RAMANUJAN_REQUIRE_BROWSER"):
    settings.load_profile("ci")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "browser: the test uses a browser (added by its fixtures)")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the tests that use a browser, group those that share one, and run the longest files first."""
    for item in items:
        if "playwright" not in item.fixturenames:
            continue
        item.add_marker("browser")
        parameters = item.callspec.params if hasattr(item, "callspec") else {}
        if parameters.get("engine") in ("firefox", "webkit"):
            # One worker starts this browser for all tests.
            item.add_marker(pytest.mark.xdist_group(parameters["engine"]))
    items.sort(key=lambda item: (item.get_closest_marker("browser") is None, -item.path.stat().st_size, item.path))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print each reason for skipped tests once, with the number of tests."""
    reasons = Counter(report.longrepr[2] for report in terminalreporter.stats.get("skipped", []))
    for reason, count in reasons.items():
        terminalreporter.write_line(f"{count} skipped: {reason.removeprefix('Skipped: ')}")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Iterator[None]:
    """Save what a failing browser test saw, and name it in the report: screenshot, address, console."""
    report = yield
    if report.when == "call" and report.failed:
        for number, page in enumerate(item.stash.get(PAGES, [])):
            with contextlib.suppress(Exception):
                report.sections.append((f"page {number}", evidence(page, f"{item.name}-{number}")))
    return report


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
        yield wait_for_start(shared)
        return
    with running(ROOT / "app.py") as address:
        yield address


@pytest.fixture(scope="session")
def chromium(playwright: object) -> Iterator[object]:  # noqa: F811
    """One headless browser for all tests of a worker."""
    if CHROMIUM is None:
        skip_missing("chromium")
    browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
    yield browser
    browser.close()


@pytest.fixture
def visit(request: pytest.FixtureRequest, chromium: object, server: str) -> Iterator[Callable]:
    """Open a page of the app as a new visitor: visit("?m=2", width=390, height=844, theme="dark").

    Each call has a browser context of its own, with further options as Playwright names them; `tab=page` opens the
    address in a visitor's tab instead, and `beside=page` in another tab of that visitor. Scripts run before those of
    the page. `network` is the address of another way to the server; `note` takes the address of each request. No page
    may end with an error. The stage stands still unless motion="no-preference" is asked for: to draw sixty frames a
    second without a graphics card takes a processor of its own. With figures=False there is nothing where they are.
    """
    contexts, errors = [], []
    pages = request.node.stash.setdefault(PAGES, [])

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
        if page not in pages:
            pages.append(page)
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
