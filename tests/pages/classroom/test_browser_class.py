"""A class in browsers: a desk on a phone, two walls, a voter, the short lesson, and the votes' file.

Other students vote without a browser; test_scene_classroom checks their phones. The longest stops are checked on the
wall at all sizes, or all stops if RAMANUJAN_DEEP is set.
"""

import csv
import io
import random
import time
from collections import Counter
from collections.abc import Callable

import pytest
import zxingcpp
from PIL import Image
from playwright.sync_api import Locator, Page, expect

from ramanujan import lesson
from ramanujan.classroom.rules import Phase, Seat, shared
from tests.checks.browser import next_frame, script, settle, traffic
from tests.checks.class_pages import RERUN_ON_DEMAND, VOTES, rerun
from tests.settings import DEEP, PATIENCE

WALL_FAULTS = script("wall")
SIZES = ((1024, 768), (1920, 1080), (1280, 768), (3840, 2160))
"""Sizes of walls."""
SHORT_LESSON = [stop for stop in lesson.STOPS if stop.is_in_short_lesson]
BETWEEN = range(2, 6)
"""Numbers of the stops that the class plays without its screens."""
OPTIONS = "[class*=st-key-wall_options] li"
AT = "ramanujan.last('time/stage_two-clocks_0')"

WIDEST_CODE = """(node) => {
  const place = node.parentElement.closest(".st-key-class_letters"), text = node.firstElementChild ?? node;
  const before = text.textContent;
  text.textContent = "MWM WMW";
  const range = document.createRange();
  range.selectNodeContents(text);
  const lines = new Set([...range.getClientRects()].map((box) => box.top)).size;
  const fits = lines === 1 && range.getBoundingClientRect().right <= place.getBoundingClientRect().right;
  text.textContent = before;
  return fits ? parseFloat(getComputedStyle(node).fontSize) : 0;
}"""
"""The size of a code's letters on the wall [px], or 0 if the widest code needs two lines."""
SPACED = """* { line-height: 1.5 !important; letter-spacing: .12em !important; word-spacing: .16em !important }
p { margin-bottom: 2em !important }"""
"""The text spacing of WCAG 1.4.12."""
READABLE = """() => {
  const wall = document.querySelector(".st-key-class_wall");
  const reach = wall.scrollHeight - wall.scrollTop, right = wall.clientWidth + 1;
  const words = [...wall.querySelectorAll("p, li, h1")].flatMap((node) => {
    const range = document.createRange();
    range.selectNodeContents(node);
    return [...range.getClientRects()];
  });
  const place = wall.querySelector(".st-key-wall-still, .st-key-wall-running").getBoundingClientRect();
  return words.length > 5 && words.every((box) => box.bottom <= Math.min(reach, place.top + 1) && box.right <= right);
}"""
"""Whether all words are above the machine, in the scrollable area, and not cut at the right edge."""


def vote(phone: Page, number: int) -> None:
    phone.bring_to_front()  # a tab in the background draws once a second
    sent = len(traffic(phone).sent)
    places = [option.bounding_box() for option in phone.locator(VOTES).all()]
    phone.locator(VOTES).nth(number).click()
    end = time.monotonic() + PATIENCE
    while len(traffic(phone).sent) == sent or traffic(phone).is_unanswered:
        assert time.monotonic() < end, "the phone sends no vote, or gets no answer"
        phone.wait_for_timeout(10)
    expect(phone.locator(VOTES).nth(number).locator("input")).to_be_checked()
    confirmation = phone.get_by_text("Your answer counts")
    confirmation.wait_for()
    # The vote moves no option. All have the same width, and the confirmation is above them.
    for option, place in zip(phone.locator(VOTES).all(), places, strict=True):
        assert option.bounding_box()["y"] == pytest.approx(place["y"], abs=2)
        assert option.bounding_box()["width"] == pytest.approx(places[0]["width"], abs=1)
    assert 0 <= confirmation.bounding_box()["y"] <= places[0]["y"]


def check_open_question_in_view(phone: Page) -> None:
    """Check that question and options are in view on a small phone in both orientations."""
    before = phone.viewport_size
    for width, height in ((390, 664), (844, 390)):
        phone.set_viewport_size({"width": width, "height": height})
        next_frame(phone)
        assert phone.get_by_role("navigation").count() == 0
        last = phone.locator(VOTES).last.bounding_box()
        assert last["y"] + last["height"] <= height
    phone.set_viewport_size(before)


@pytest.fixture
def screen(visit):
    """Open the lesson's page in a new browser context, or in another tab of an existing one."""

    def show(query: str, width: int = 390, height: int = 844, beside: Page | None = None) -> Page:
        return visit(f"lesson?{query}", RERUN_ON_DEMAND, width=width, height=height, beside=beside)

    return show


def play_without_screens(key: str, stop: lesson.Stop, seats: list[Seat]) -> Counter:
    """Play a stop on the server alone. Return the votes."""
    option = stop.answer()
    shared().ask(key, stop.id, list(stop.options))
    for seat in seats:
        shared().vote(seat, stop.id, option)
    for phase in (Phase.REVEALED, Phase.RUNNING, Phase.SOLVED):
        shared().show(key, phase)
    return Counter({option: len(seats)})


class Screens:
    """A desk on a phone, walls, and a student's phone of one class. Two other students vote without a browser."""

    def __init__(self, screen: Callable[..., Page]) -> None:
        self.screen, self.random = screen, random.Random(1729)
        self.desk = screen("")
        self.desk.locator(".st-key-class_door button").first.click()
        self.desk.locator(".st-key-class_open button").click()
        wall_link = self.desk.get_by_role("link", name="Open the wall").get_attribute("href")
        self.query = wall_link.partition("?")[2]
        self.wall = screen(self.query, *SIZES[0])
        self.walls = [self.wall]
        self.code = self.query.partition("class=")[2][:6]
        self.phone = screen(f"class={self.code}")
        self.tab = screen(f"class={self.code}", beside=self.phone)
        for page in (self.phone, self.tab):
            page.get_by_text("The first question will appear here").wait_for()
        self.seats = [shared().join(self.code, f"student {number}") for number in range(2)]
        self.students = 1 + len(self.seats)
        self.key = self.desk.url.partition("lecturer=")[2].partition("&")[0]

    def press(self, following: str) -> None:
        """Press the button of the next move, and wait until the desk shows the element `following`."""
        self.desk.bring_to_front()
        box = self.desk.locator(".st-key-class_moves [data-testid=stBaseButton-primary]").bounding_box()
        assert box["y"] + box["height"] <= 844
        self.desk.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        self.desk.locator(following).wait_for()
        settle(self.desk)
        rerun(*self.walls)

    def wait_for_moment(self, leader: Page) -> None:
        """Wait until all walls and desks show the same moment as the leading desk."""
        moment = leader.evaluate(AT)
        assert not moment["playing"]
        expected = [pytest.approx(moment[name], abs=1e-4) for name in ("time", "periods")]
        end = time.monotonic() + PATIENCE
        for page in (self.desk, *self.walls):
            while [page.evaluate(AT)[name] for name in ("time", "periods")] != expected:
                assert time.monotonic() < end, "a wall or desk shows another moment"
                rerun(page)
                page.wait_for_timeout(100)


def check_code(screens: Screens) -> None:
    """Check that the wall shows the number of students, large letters, and a QR code of the class."""
    wall = screens.wall
    rerun(*screens.walls)
    wall.get_by_text("3 students have joined").wait_for()
    letters = wall.locator(".st-key-class_letters [data-testid=stText]")
    assert letters.text_content().replace(" ", "") == screens.code
    for width, height in SIZES[:2]:
        wall.set_viewport_size({"width": width, "height": height})
        assert letters.evaluate(WIDEST_CODE) > 0.09 * height
    sizes = [
        wall.locator(words).evaluate("(node) => parseFloat(getComputedStyle(node).fontSize)")
        for words in ("h1", ".st-key-class_invitation p >> nth=0", ".st-key-class_wall_foot p")
    ]
    assert sizes[0] > sizes[1] > sizes[2] > 0.034 * height
    for width, height in reversed(SIZES[:2]):
        wall.set_viewport_size({"width": width, "height": height})
        [barcode] = zxingcpp.read_barcodes(Image.open(io.BytesIO(wall.screenshot())))
        assert barcode.text.endswith(f"/lesson?class={screens.code}")


def check_question(screens: Screens, stop: lesson.Stop) -> None:
    """Open the question of a stop, and check that wall and phone show it."""
    screens.press(".st-key-class_reveal")
    wall, phone = screens.wall, screens.phone
    rerun(phone)
    expect(wall.locator("h1")).to_have_text([stop.heading])
    expect(wall.locator(".face")).to_be_visible(visible=stop.shows_dials)
    expect(phone.locator("h1")).to_have_text([stop.heading])
    expect(phone.locator("svg.machine")).to_be_visible()
    settle(phone)
    check_open_question_in_view(phone)


def change_vote_in_tab(screens: Screens, number: int) -> int:
    """Change the student's vote in another tab, which shows it. Return the number of the new option."""
    phone, tab = screens.phone, screens.tab
    rerun(tab)
    expect(tab.locator(VOTES).nth(number).locator("input")).to_be_checked()
    new_number = (number - 1) % tab.locator(VOTES).count()
    vote(tab, new_number)
    tab.close()
    # A reload preserves the last vote.
    phone.reload()
    expect(phone.locator(VOTES).nth(new_number).locator("input")).to_be_checked()
    return new_number


def check_votes(screens: Screens, stop: lesson.Stop, has_tab: bool) -> tuple[str, Counter]:
    """Vote at random as all students. Return the vote of the student with the phone, and all votes."""
    options = list(stop.options)
    own, *others = (screens.random.choice(options) for _ in range(screens.students))
    vote(screens.phone, options.index(own))
    if has_tab:
        own = options[change_vote_in_tab(screens, options.index(own))]
    for seat, option in zip(screens.seats, others, strict=True):
        shared().vote(seat, stop.id, option)
    rerun(screens.phone, screens.desk, screens.wall)
    expect(screens.desk.locator(".st-key-class_desk")).to_contain_text("Answers: 3 of 3")
    assert screens.wall.locator(f"{OPTIONS} strong").count() == 0
    return own, Counter([own, *others])


def check_result(screens: Screens, stop: lesson.Stop, votes: Counter) -> None:
    """Show the result and the running machine, and check that the wall does not show the right answer."""
    screens.press(".st-key-class_run")
    total = screens.students
    shares = [f"{round(100 * votes[option] / total)}\u202f%" for option in stop.options]
    expect(screens.wall.locator(f"{OPTIONS} strong")).to_have_text(shares)
    expect(screens.wall.locator(".st-key-class_wall_foot")).to_contain_text(f"{total} votes")
    screens.press(".st-key-class_solve")
    screens.wall.locator("svg.machine .body.slab").first.wait_for()
    expect(screens.wall.locator(".listen:visible")).to_have_count(int(stop.shows_dials))
    assert screens.wall.locator(".st-key-wall_reason").count() == 0


def check_common_view(screens: Screens) -> None:
    """Check that a second desk and a later wall begin at the moment of the others, and that each desk follows."""
    desk = screens.desk
    for _ in range(2):
        desk.locator(".st-key-stage_two-clocks_0 [data-do=play]").click()
        desk.wait_for_timeout(400)
    screens.wait_for_moment(desk)
    second_desk = screens.screen(desk.url.partition("?")[2])
    later_wall = screens.screen(screens.query, *SIZES[2])
    screens.walls += [second_desk, later_wall]
    for leader, place in ((desk, "0.7"), (second_desk, "0.2")):
        leader.locator(".st-key-stage_two-clocks_0 .scrub input").fill(place)
        settle(leader)
        screens.wait_for_moment(leader)
    for page in (screens.walls.pop(), screens.walls.pop()):
        page.close()


def check_answer(screens: Screens, stop: lesson.Stop) -> None:
    """Show the right answer, and check that the machine stays on the wall."""
    screens.press(".st-key-class_next, .st-key-class_finish")
    screens.wall.locator(".st-key-wall_reason").wait_for()
    assert screens.wall.locator("svg.machine .body.slab").first.is_visible()


def check_reply(screens: Screens, stop: lesson.Stop, own: str) -> None:
    """Check that the phone also shows the machine and the reply to the student's answer."""
    phone, desk, wall = screens.phone, screens.desk, screens.wall
    rerun(phone)
    sentence = "This was your answer" if own == stop.answer() else stop.reply(own).replace("*", "")[:30]
    phone.get_by_text(sentence).first.wait_for()
    phone.locator("pre, .katex" if stop.exhibit else "svg.machine").first.wait_for()
    widths = [page.evaluate("document.querySelector('[data-testid=stMain]').scrollWidth") for page in (phone, desk)]
    assert max(widths) <= 390
    secret = screens.key.partition("-")[2]
    assert len(secret) > 20
    assert secret not in wall.content() + wall.url + phone.content() + phone.url


def check_download(desk: Page, votes_of_stops: list[Counter]) -> None:
    """Check the downloaded votes of all stops."""
    desk.get_by_role("button", name="Download the results").click()
    with desk.expect_download() as download:
        desk.get_by_role("button", name="Download as CSV").click()
    rows = list(csv.DictReader(download.value.path().read_text(encoding="utf-8-sig").splitlines()))
    columns = ("Stop", "Option", "Right answer", "Votes", "Votes after the discussion")
    downloaded = [tuple(map(row.get, columns)) for row in rows]
    assert downloaded == [
        (stop.heading, label, "yes" if option == stop.answer() else "no", str(votes[option]), "")
        for stop, votes in zip(SHORT_LESSON, votes_of_stops, strict=True)
        for option, label in stop.options.items()
    ]
    times = [row["Asked at (UTC)"] for row in rows]
    assert times == sorted(times)


def test_a_class_plays_the_short_lesson_from_a_phone_and_downloads_its_votes(screen):
    screens = Screens(screen)
    desk, wall = screens.desk, screens.wall
    check_code(screens)
    votes_of_stops = []
    for number, stop in enumerate(SHORT_LESSON, start=1):
        if number in BETWEEN:
            votes_of_stops.append(play_without_screens(screens.key, stop, screens.seats))
            continue
        if number - 1 in BETWEEN:
            rerun(desk)
            expect(desk.locator("h1")).to_contain_text(SHORT_LESSON[number - 2].heading)
            settle(desk)
        check_question(screens, stop)
        own, votes = check_votes(screens, stop, has_tab=number == 1)
        votes_of_stops.append(votes)
        check_result(screens, stop, votes)
        if number == 1:
            check_common_view(screens)
        check_answer(screens, stop)
        if number == 1:
            desk.locator(".st-key-moment button").click()
            settle(desk)
            screens.wait_for_moment(desk)
            assert wall.evaluate(AT)["periods"] == pytest.approx(stop.periods)
        if number > 1:
            check_reply(screens, stop, own)
    assert not wall.locator("header a, .st-key-pager button").first.is_visible()
    screens.press(".st-key-table-learned")
    expect(wall.locator("h1")).to_have_text(["What the class has learned"])
    check_download(desk, votes_of_stops)


def test_no_view_of_a_wall_is_cut_at_any_size(screen):
    """Check the state with the most content, after a second vote."""
    opened, wrong, places = shared().open_class(), [], {}
    wall = screen(f"class={opened.code}&wall=on&view=projector")

    def look(state: str, heading: str) -> None:
        rerun(wall)
        expect(wall.locator("h1")).to_have_text([heading])
        settle(wall)
        for width, height in SIZES:
            wall.set_viewport_size({"width": width, "height": height})
            next_frame(wall)
            wrong.extend((heading, state, width, fault) for fault in wall.evaluate(WALL_FAULTS))
            for nodes in ("h1, .face", OPTIONS):
                heights = [round(box["y"]) for box in map(Locator.bounding_box, wall.locator(nodes).all()) if box]
                if heights:
                    places.setdefault((heading, width, nodes), set()).add(tuple(heights))

    by_length = sorted(SHORT_LESSON, key=lambda stop: len(stop.question + "".join(stop.options.values())))
    for stop in lesson.STOPS if DEEP else by_length[-3:]:
        shared().ask(opened.key, stop.id, list(stop.options))
        for number, option in enumerate(stop.options):
            shared().vote(shared().join(opened.code, f"voter-{number}"), stop.id, option)
        shared().begin_second_vote(opened.key)
        look("asked again", stop.heading)
        for phase in (Phase.REVEALED, Phase.SOLVED):
            shared().show(opened.key, phase)
            look(phase.name, stop.heading)
    shared().finish(opened.key)
    look("end", "What the class has learned")
    assert wrong == []
    # In all states of a stop, the heading has one place, and so have the clock and each option.
    assert {place: heights for place, heights in places.items() if len(heights) > 1} == {}


def test_a_wall_fits_with_a_readers_text_spacing_and_the_end_of_a_class_is_one_sentence(screen):
    opened, stop = shared().open_class(), lesson.STOPS[0]
    wall = screen(f"class={opened.code}&wall=on&view=projector", 1280, 768)
    shared().ask(opened.key, stop.id, list(stop.options))
    shared().vote(shared().join(opened.code), stop.id, next(o for o in stop.options if o != stop.right))
    for phase in Phase:
        if phase != Phase.ASKED:
            shared().show(opened.key, phase)
        rerun(wall)
        shown = {Phase.ASKED: stop.question, Phase.SOLVED: stop.explanation()}
        wall.get_by_text(shown.get(phase, "Where is the machine’s hand")[:60]).first.wait_for()
        settle(wall)
        wall.add_style_tag(content=SPACED)
        next_frame(wall)
        assert wall.evaluate(READABLE), phase.name
    phone = screen(f"class={opened.code}")
    phone.get_by_text("What is stored about you").wait_for()
    shared().close(opened.key)
    rerun(wall, phone)
    for page in (wall, phone):
        page.locator("h1").wait_for(state="detached")
        settle(page)
    expect(phone.locator(".st-key-class_phone")).to_have_text("The class has ended.Leave the class")
    assert phone.locator("svg.machine").count() == phone.get_by_text("What is stored about you").count() == 0
    box = wall.locator("[data-testid=stAlert]")
    # The controls of the page are fixed at the top right. They must not cover the sentence.
    x, y, width, _height = box.bounding_box().values()
    corner = [x + width - 60, y + 12]
    assert box.evaluate("(node, corner) => node.contains(document.elementFromPoint(...corner))", corner)
    expect(box).to_have_text("The class has ended.")
