"""Fixtures that all tests share: the app under AppTest, a running server, a Chromium.

A test that uses a browser has the mark `browser`; `pytest -m "not browser"` leaves these tests out. Without its
browser such a test is skipped, unless RAMANUJAN_REQUIRE is set, as it is in CI. Each worker starts one
browser, and each test opens new contexts in it. Tests share no tabs, cookies or stored values. All workers
of a run share one server and its caches.
"""

import contextlib
import faulthandler
import os
from collections import Counter
from collections.abc import Callable, Iterator
from functools import cache
from tempfile import TemporaryDirectory

import pytest
from hypothesis import settings
from streamlit.components.v2 import manifest_scanner
from streamlit.testing.v1 import AppTest

from tests.checks.browser import (
    CHROMIUM,
    FLAGS,
    PAGES,
    ROOT,
    evidence,
    go,
    leave_out_figures,
    open_address,
    running,
    wait_for_start,
)
from tests.checks.engines import bare, bare_address, browsers, engine, new_context, playwright, sample, window  # noqa: F401
from tests.settings import DEEP, PATIENCE, REQUIRED, skip_missing

# Store the tests' classes separately: the app on this computer stores at most 200.
_CLASSES = TemporaryDirectory()
os.environ.setdefault("RAMANUJAN_CLASSES", f"{_CLASSES.name}/classes.sqlite")

# CI uses the same cases in each run. Developers' runs search for new cases.
settings.register_profile("ci", derandomize=True)
if REQUIRED:
    settings.load_profile("ci")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "browser: the test uses a browser (added by its fixtures)")


def pytest_runtest_setup() -> None:
    """Remove the limit of a test (faulthandler_timeout in .pytest.ini) from a thorough run, whose tests take longer."""
    if DEEP:
        faulthandler.cancel_dump_traceback_later()


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
    """Save a screenshot of a failing browser test, and add its address and console to the report."""
    report = yield
    if report.when == "call" and report.failed:
        for number, page in enumerate(item.stash.get(PAGES, [])):
            with contextlib.suppress(Exception):
                report.sections.append((f"page {number}", evidence(page, f"{item.name}-{number}")))
    return report


@pytest.fixture
def app() -> AppTest:
    """The app before its first run."""
    return AppTest.from_file(str(ROOT / "app.py"), default_timeout=PATIENCE)


_APP = pytest.StashKey[running]()


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: object) -> None:
    """Pass the address of the shared app to a worker."""
    if CHROMIUM:
        stash = node.config.stash
        stash[_APP] = stash.get(_APP, None) or running(ROOT / "app.py")
        node.workerinput["server"] = stash[_APP].address


def pytest_unconfigure(config: pytest.Config) -> None:
    """Stop the shared app."""
    app = config.stash.get(_APP, None)
    if app:
        app.__exit__()


@pytest.fixture(scope="session")
def server(pytestconfig: pytest.Config) -> Iterator[str]:
    """The address of the running app."""
    shared = getattr(pytestconfig, "workerinput", {}).get("server")
    if shared:
        yield wait_for_start(shared)
        return
    with running(ROOT / "app.py") as address:
        yield address


@pytest.fixture(scope="session")
def german() -> Iterator[str]:
    """The address of an app in German. Its tests have the mark xdist_group("german"), so that one worker starts it."""
    variables = {"RAMANUJAN_LANGUAGE": "de", "RAMANUJAN_LANGUAGES": "en:/,hu:/hu/,de:/de/"}
    with running(ROOT / "app.py", **variables) as address:
        yield address


@pytest.fixture(scope="session")
def chromium(playwright: object) -> Iterator[object]:  # noqa: F811
    """One headless browser for all tests of a worker."""
    if CHROMIUM is None:
        skip_missing("Chromium", "chromium")
    browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
    yield browser
    browser.close()


@pytest.fixture
def visit(request: pytest.FixtureRequest, chromium: object, server: str) -> Iterator[Callable]:
    """Open a page of the app as a new visitor: visit("?m=2", width=390, height=844, theme="dark").

    Each call creates a browser context, with further options under Playwright's names. `tab=page` opens the address in
    an existing tab instead, `within=page` in such a tab without loading the app again, and `beside=page` in another tab
    of the same visitor. Scripts run before those of the page.
    `network` is the address of a proxy for the server. `note` is called with the address of each request. A page with
    an error fails the test. The stage moves only with motion="no-preference", because sixty frames a second without a
    graphics card need a whole processor. With figures=False, the page has no figures.
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
        within: object = None,
        beside: object = None,
        figures: bool = True,
        network: str | None = None,
        note: Callable[[str], object] | None = None,
        **options: object,
    ) -> object:
        size = {"width": width, "height": height}
        if not (tab or within or beside):
            contexts.append(new_context(chromium, viewport=size, **({"bypass_csp": True} | options)))
            contexts[-1].on("weberror", lambda error: errors.append(str(error.error)))
        page = tab or within or (beside.context if beside else contexts[-1]).new_page()
        if page not in pages:
            pages.append(page)
        page.set_viewport_size(size)
        page.emulate_media(color_scheme=theme, reduced_motion=motion)
        if within:
            go(page, address)
            return page
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


# Cache the descriptions of all packages: each app test would need a tenth of a second for them.
manifest_scanner.scan_component_manifests = cache(manifest_scanner.scan_component_manifests)
