"""The app in a frame of another site, for example a course page. Browsers send no cookie of the app to such a frame."""

import pytest
from playwright.sync_api import expect

from ramanujan import lesson
from ramanujan.classroom.rules import shared
from tests.checks.engines import new_context
from tests.checks.two_sites import CoursePage

STOP = lesson.STOPS[0]
OPTION = ".st-key-class_phone [role=radiogroup] label"


@pytest.mark.parametrize(("engine", "secure"), [("chromium", False), ("firefox", True)])
def test_a_pupil_in_a_frame_gets_one_seat_in_a_tab(browsers, server, engine, secure):
    opened = shared().open_class()
    shared().ask(opened.key, STOP.id, list(STOP.options))
    context = new_context(browsers(engine), ignore_https_errors=True, reduced_motion="reduce")
    with CoursePage(server, f"lesson?class={opened.code}&embed=true", secure=secure) as course:
        tab = context.new_page()
        for _visit in range(2):
            tab.goto(course.address)
            frame = tab.frame_locator("iframe")
            link = frame.get_by_role("link", name="Open the class in a tab of its own")
            link.wait_for()
        # The lesson works in the frame, without the class.
        frame.get_by_text(STOP.question).wait_for()
        assert frame.locator(".st-key-class_door, .st-key-class_phone").count() == 0
        assert shared().read(opened.code).taken == 0
        assert link.get_attribute("target") == "_blank"
        own = context.new_page()
        own.goto(link.get_attribute("href"))
        own.locator(OPTION).nth(1).click()
        own.get_by_text("Your answer counts.").wait_for()
        own.reload()
        expect(own.locator(OPTION).nth(1).locator("input")).to_be_checked()
        assert "frame=" not in own.url
    assert shared().read(opened.code).taken == 1
    context.close()
