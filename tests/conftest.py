"""What the tests share: the app under AppTest, a running server, a Chromium.

Browser tests need a Chromium or Chrome on the system; without one they are skipped, unless RAMANUJAN_REQUIRE_BROWSER
is set, as it is in CI. Those of one file stay together in one worker, which starts their browser once; all workers of
a run share one server, and what it has worked out.
In CI, whose machine others share, a browser test that fails gets a second try, which the report counts as a rerun; on
your own machine it gets none, so that a race is seen.
"""

import os
from collections.abc import Callable, Iterator
from functools import cache

import pytest
from hypothesis import settings
from streamlit.components.v2 import manifest_scanner
from streamlit.testing.v1 import AppTest

from tests.browser import (
    CHROMIUM,
    FLAGS,
    MOUNTED,
    ROOT,
    arrived,
    count_anew,
    is_back,
    listen,
    rest,
    running,
    settle,
    started,
)
from tests.engines import bare, bare_address, browsers, engine, missing, playwright, window  # noqa: F401

IN_A_BROWSER = ("test_browser", "test_deployment")
UNOPTIMIZED = "--js-flags=--no-opt --no-maglev"
TABS = 3
"""How many tabs a worker keeps."""


# In CI the same cases each time: a case that nobody has met yet is looked for on the machines of developers.
settings.register_profile("ci", derandomize=True)
if os.environ.get("RAMANUJAN_REQUIRE_BROWSER"):
    settings.load_profile("ci")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the files that take longest first: those in a browser, and the larger ones."""
    items.sort(key=lambda item: (not item.path.stem.startswith(IN_A_BROWSER), -item.path.stat().st_size, item.path))
    if os.environ.get("RAMANUJAN_REQUIRE_BROWSER"):
        for item in items:
            if item.path.stem.startswith(IN_A_BROWSER):
                item.add_marker(pytest.mark.flaky(reruns=1))


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
def profile(playwright: object, tmp_path_factory: pytest.TempPathFactory) -> Iterator[object]:  # noqa: F811
    """One headless browser for all tests of a worker, with one profile on the disk.

    There it keeps compiled scripts, as a visitor's browser does. It does not optimize them, which for a test of a
    second or two never pays. Both together halve a visit: the first page takes 0.9 s of the processor instead of 1.7.
    """
    if CHROMIUM is None:
        missing("chromium")
    place = tmp_path_factory.mktemp("profile")
    context = playwright.chromium.launch_persistent_context(
        place, executable_path=CHROMIUM, args=[*FLAGS, UNOPTIMIZED], downloads_path=place
    )
    yield context
    context.close()


@pytest.fixture(scope="session")
def chromium(profile: object) -> object:
    """The browser itself, for visitors who know nothing of each other."""
    return profile.browser


@pytest.fixture(scope="session")
def tabs() -> list[object]:
    """The browser's tabs, the one used last at the end: to open a page takes more than a second of a processor."""
    return []


@pytest.fixture
def visit(request: pytest.FixtureRequest, profile: object, tabs: list[object], server: str) -> Iterator[Callable]:
    """Open a page of the app: visit("?m=2", width=390, height=844, theme="dark"); it must end without an error.

    A tab that has this address already, and that Reset and the stage's own controls bring back to how it was, is taken
    again, unless anew=True, or network= gives the address of another way to the server. The stage stands still unless
    motion="no-preference" is asked for: to draw sixty frames a second without a graphics card takes a processor of its
    own.
    """
    opened, errors = [], []

    def note(error: object) -> None:
        errors.append(str(error))

    def tab_for(address: str) -> object:
        free = [tab for tab in tabs if tab not in opened]
        same = next((tab for tab in free if tab.home and tab.home[0] == address), None)
        if same or len(tabs) >= TABS:
            tab = same or free[0]
            tabs.remove(tab)
        else:
            tab = profile.new_page()
            tab.home = None
            listen(tab)
        tabs.append(tab)
        return tab

    def open_page(
        address: str = "",
        *,
        width: int = 1280,
        height: int = 720,
        theme: str = "light",
        motion: str = "reduce",
        anew: bool = False,
        network: str | None = None,
    ) -> object:
        anew = anew or getattr(request.node, "execution_count", 1) > 1  # a second try trusts no tab of the first
        page = tab_for(address)
        opened.append(page)
        page.bring_to_front()  # a tab behind another draws once a second
        page.on("pageerror", note)
        back = not (anew or network) and theme == "light" and is_back(page, address)  # a tab is left in the light theme
        page.set_viewport_size({"width": width, "height": height})
        page.emulate_media(color_scheme=theme, reduced_motion=motion)
        page.mouse.move(0, 0)
        if not back:
            count_anew(page)
            page.goto(f"{network or server}/{address}")
            page.wait_for_selector("[data-testid=stMainBlockContainer]")
            settle(page)
            page.wait_for_function(MOUNTED)
            settle(page)  # the first page has asked for what follows its machine
            arrived(page, address)
            if network:
                page.home = None  # its way to the server ends with the test
        return page

    yield open_page
    for page in opened:
        page.remove_listener("pageerror", note)
        rest(page)
    assert errors == []


# Each app test reads the descriptions of all packages, a tenth of a second; while tests run these stay as they are.
manifest_scanner.scan_component_manifests = cache(manifest_scanner.scan_component_manifests)
