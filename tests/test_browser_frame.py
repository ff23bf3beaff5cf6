"""A class in a frame of another site, for example a course page: one seat per pupil, and stored answers.

Browsers send no cookie of the app to such a frame. The tests also start browsers that deny storage to other sites:
Firefox with a preference, and Debian's Chromium.
"""

import shutil
from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import BrowserContext, Locator, Page, expect

from ramanujan import lesson
from ramanujan.lesson.classes import Class, shared
from tests.browser import FLAGS
from tests.engines import CALM, FIREFOX, skip_missing
from tests.two_sites import CoursePage

STOP = lesson.STOPS[0]
CHROMIUM_WITH_WINDOWS = shutil.which("chromium")
"""Debian's Chromium denies storage to frames of other sites; chromium-headless-shell does not."""
OPTION = ".st-key-class_phone [role=radiogroup] label"


@pytest.fixture
def opened() -> Class:
    """A class with the first question open."""
    opened = shared().open_class()
    shared().ask(opened.key, STOP.id, list(STOP.options))
    return opened


@pytest.fixture
def visitor() -> Iterator[Callable[[object], BrowserContext]]:
    """A function that opens a visitor's context in a browser."""
    contexts = []

    def begin(browser: object) -> BrowserContext:
        contexts.append(browser.new_context(ignore_https_errors=True, reduced_motion="reduce"))
        contexts[-1].set_default_timeout(20_000)
        return contexts[-1]

    yield begin
    for context in contexts:
        context.close()


@pytest.fixture
def strict(playwright: object, engine: str) -> Iterator[object]:
    """A browser that denies storage to frames of other sites."""
    if engine == "firefox":
        if not FIREFOX:
            skip_missing("Firefox", "firefox-esr")
        prefs = CALM | {"network.cookie.cookieBehavior": 1}
        browser = playwright.firefox.launch(channel="moz-firefox", executable_path=FIREFOX, firefox_user_prefs=prefs)
    else:
        if not CHROMIUM_WITH_WINDOWS:
            skip_missing("Chromium", "chromium")
        arguments = [*FLAGS, "--headless=new"]
        browser = playwright.chromium.launch(executable_path=CHROMIUM_WITH_WINDOWS, args=arguments)
    yield browser
    browser.close()


def choose(option: Locator) -> None:
    """Choose an answer and wait until it counts. In Firefox, Playwright's clicks miss elements in a frame."""
    option.locator("input").dispatch_event("click")
    counts = option.locator("xpath=ancestor::*[contains(@class, 'st-key-class_phone')]")
    expect(counts.get_by_text("Your answer counts.")).to_be_visible(timeout=20_000)


def check_lasting_seat(tab: Page, course: CoursePage, opened: Class) -> None:
    """Check that an answer in the frame counts once, also after reloads, and remains chosen."""
    for visit in range(3):
        tab.goto(course.address)
        option = tab.frame_locator("iframe").locator(OPTION).nth(1)
        if visit == 0:
            choose(option)
        expect(option.locator("input")).to_be_checked(timeout=20_000)
    assert tab.frame_locator("iframe").get_by_text("in a tab of its own").count() == 0
    assert shared().count_seats(opened.key).taken == 1
    assert shared().read_question(opened.code).answered == 1


@pytest.mark.parametrize(("engine", "secure"), [("chromium", False), ("firefox", True)])
def test_a_pupil_in_a_frame_has_one_seat(browsers, visitor, server, opened, engine, secure):
    with CoursePage(server, f"lesson?class={opened.code}&embed=true", secure=secure) as course:
        check_lasting_seat(visitor(browsers(engine)).new_page(), course, opened)


@pytest.mark.parametrize("engine", ["chromium"])
def test_without_storage_a_partitioned_cookie_preserves_the_seat(strict, visitor, server, opened):
    with CoursePage(server, f"lesson?class={opened.code}", secure=True) as course:
        check_lasting_seat(visitor(strict).new_page(), course, opened)


@pytest.mark.parametrize(("engine", "secure"), [("chromium", False), ("firefox", True)])
def test_without_any_storage_the_page_offers_a_new_tab(strict, visitor, server, opened, secure):
    with CoursePage(server, f"lesson?class={opened.code}&embed=true", secure=secure) as course:
        context = visitor(strict)
        tab = context.new_page()
        tab.goto(course.address)
        frame = tab.frame_locator("iframe")
        frame.get_by_text("Your answer counts once").wait_for()
        frame.get_by_text("This browser stores nothing").wait_for()
        assert frame.get_by_text("30 days").count() == 0
        link = frame.get_by_role("link", name="Open the class in a tab of its own")
        assert link.get_attribute("target") == "_blank"
        own = context.new_page()
        own.goto(link.get_attribute("href"))
        choose(own.locator(OPTION).nth(1))
        own.reload()
        expect(own.locator(OPTION).nth(1).locator("input")).to_be_checked(timeout=20_000)
        assert own.get_by_text("Your answer counts once").count() == 0
        assert "frame=" not in own.url
