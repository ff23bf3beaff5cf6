"""No setting is lost over slow and broken networks, or while the server is away.

With RAMANUJAN_DEEP, each page sees 500 quick changes.
"""

import random
from collections.abc import Callable, Iterator
from itertools import pairwise
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import expect

from ramanujan import Oscillator, lesson
from ramanujan.classroom.rules import shared
from ramanujan.shell import menu
from tests.checks.browser import inside, next_frame, press_preset, settle, thumb, traffic
from tests.checks.class_pages import RERUN_ON_DEMAND
from tests.checks.controls import hold, normalized
from tests.checks.slow_network import Network
from tests.settings import DEEP

CHANGES = 500 if DEEP else 1
COMPRESSION = ".st-key-compression input[type=range]"
BOX = ".st-key-m_prime_exact input"
M_PRIME = ".st-key-m_prime input[type=range]"
LINKS = "document.querySelectorAll('[data-testid=stTopNavLink]')"
HEADING = ".st-key-lecture h2:visible"

PUBLISHED = "globalThis.ramanujan.last('machine/oscillator').parameters"
PRESENT = "globalThis.ramanujan.last('drawn/oscillator').parameters"


def take_slab(page, centimetres: float) -> None:
    """Press on the slab and drag it."""
    box = page.locator(".st-key-stage .moving .body.slab rect:not(.grip)").first.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + centimetres * inside(page, "root.querySelector('.machine').getScreenCTM().a"), y, steps=5)
    next_frame(page)


@pytest.fixture
def late(visit, server) -> Iterator[Callable]:
    """Open a page over a network. `late.by(seconds)` sets its delay in each direction and restores the machine."""
    with Network(server) as way:
        pages = []

        def open_page(link: str = "?hide=curve,steps", *scripts: str, **options: object):
            pages.append(visit(link, *scripts, network=way.address, **options))
            return pages[-1]

        def by(seconds: float) -> None:
            page, way.seconds, traffic(pages[-1]).late = pages[-1], 0.0, 0.0
            press_preset(page, "Reset")
            page.evaluate("document.activeElement.blur()")
            settle(page)
            way.seconds = traffic(page).late = seconds

        open_page.by, open_page.way = by, way
        yield open_page


def address(page) -> dict[str, list[str]]:
    return parse_qs(urlsplit(page.url).query)


def drag(page, key: str, by: int, steps: int = 4) -> None:
    """Drag the thumb of a slider by `by` pixels."""
    hold(page, key, by, steps)
    page.mouse.up()


def record(page, name: str, topic: str, item: str) -> None:
    """Record an item of all later messages with a topic in window[name]."""
    page.evaluate(
        f"window.{name} = []; ramanujan.subscribe('{topic}', (message) => window.{name}.push(message.{item}))",
    )


# ---- the sliders


def test_over_a_slow_or_broken_network_every_slider_preset_typed_value_and_drag_of_the_slab_is_kept(late):
    page = late()
    check_slow_answer(page, late.by)
    check_many_drags(page, late.by)
    check_keys(page, late.by)
    check_preset_and_typed_value(page, late.by)
    check_keys_after_entry(page, late.by)
    for seconds in (0.0, 0.4):
        check_preset_after_typing(page, late.by, seconds)
    check_held_slab(page, late.by)
    check_keys_behind_the_slab(page, late.by)
    check_broken_network(page, late)


def check_slow_answer(page, late_by) -> None:
    """Check that a slow answer to one slider does not reset another one."""
    late_by(0.3)
    before = normalized(page)
    drag(page, "m_prime", 40)
    record(page, "ratios", "drawn/oscillator", "normalized")
    # While the answer is on its way, another slider moves. The stage must not show the old m′ again.
    drag(page, "m", 72, steps=24)
    settle(page)
    seen, machine = page.evaluate("window.ratios"), page.evaluate(PUBLISHED)
    final = Oscillator(machine["m"], machine["m_prime"], machine["k"], machine["radius"])
    assert machine["m"] > 1.5
    assert machine["m_prime"] > 1.1
    assert normalized(page) == pytest.approx(final.normalized_frequency_squared, rel=1e-6)
    # m′ grew, then m: Ω²m/k fell and then rose step by step. An outdated message would make it fall again.
    assert seen[0] < before
    assert len(seen) > 10
    assert all(a <= b + 1e-9 for a, b in pairwise(seen))


def check_many_drags(page, late_by) -> None:
    """Check that after many drags page and server agree."""
    late_by(0.2)
    for key, by in (("m", 30), ("k", 50), ("m_prime", -10), ("k", -30), ("m", 12)):
        drag(page, key, by, steps=3)
    # The wheel over a slider scrolls the page and does not change the slider.
    page.mouse.move(*thumb(page, "k"))
    before = page.locator(".st-key-k input[type=range]").input_value()
    page.mouse.wheel(0, 240)
    page.mouse.wheel(0, -240)
    press_preset(page, "Light rollers")
    settle(page)
    published = page.evaluate(PUBLISHED)
    assert published["k"] == float(before)
    assert page.evaluate(PRESENT) == published
    assert published["m_prime"] == pytest.approx(0.1 * published["m"])


def check_keys(page, late_by) -> None:
    """Check that every key press counts."""
    late_by(0.6)
    slider, box = (page.locator(place) for place in (".st-key-k input[type=range]", ".st-key-k_exact input"))
    for presses, pause, expected in ((8, 250, 14.0), (20, 30, 24.0)):
        slider.focus()
        for _ in range(presses):
            page.keyboard.press("ArrowRight")
            page.wait_for_timeout(pause)
        assert float(box.input_value()) == expected
        page.wait_for_url(f"**k={expected:g}**")
        settle(page)
        assert float(slider.input_value()) == float(box.input_value()) == expected


def check_preset_and_typed_value(page, late_by) -> None:
    """Check that earlier messages do not reset a preset and a typed value."""
    late_by(0.4)
    slider = page.locator(".st-key-k input[type=range]")

    def boxes(*keys: str) -> list[float]:
        return [float(page.locator(f".st-key-{key}_exact input").input_value()) for key in keys]

    # The message about k is sent before the page receives the preset, and contains the old m′.
    press_preset(page, "Light rollers")
    slider.focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_timeout(400)
    page.keyboard.press("ArrowRight")
    page.wait_for_url("**m_prime=0.1**")
    settle(page)
    assert boxes("m_prime", "k") == [0.1, 11.0]
    page.locator(".st-key-m_exact input").fill("9/8")
    page.locator(".st-key-m_exact input").press("Enter")
    slider.focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_url("**m=1.125**")
    settle(page)
    assert boxes("m", "k") == [1.125, 11.5]


def check_keys_after_entry(page, late_by) -> None:
    """Check that keys go on from a typed value and from a preset, before the server has answered."""
    late_by(0.3)
    box, slider = page.locator(BOX), page.locator(M_PRIME)
    box.fill("9/8")
    box.press("Enter")
    # With Shift, the keys move by a tenth of a step, to values that the slider cannot send.
    for begin, key, count, expected in (("1.13", "Shift+ArrowRight", 3, "1.128"), ("0.1", "ArrowRight", 5, "0.15")):
        if begin == "0.1":
            press_preset(page, "Light rollers")
        assert slider.input_value() == begin
        slider.focus()
        for _ in range(count):
            page.keyboard.press(key)
        page.wait_for_url(f"**m_prime={expected}**")
        settle(page)
        assert box.input_value() == expected
        assert page.evaluate(PUBLISHED)["m_prime"] == float(expected)


def check_preset_after_typing(page, late_by, seconds: float, stage: str = "oscillator") -> None:
    """Check that a preset replaces a value typed before it."""
    late_by(seconds)
    for preset in ("Equal masses", "Reset"):
        page.locator(BOX).fill("4.44")
        button = page.get_by_text(preset, exact=True)
        if not button.is_visible():
            page.locator(".st-key-more_controls summary").first.click()
        button.dblclick()  # the second press must not revert the first one
        settle(page)
        expect(page.locator(BOX)).to_have_value("1.0")
        assert page.locator(M_PRIME).input_value() == "1"
        assert "m_prime" not in address(page)
        assert page.evaluate(PUBLISHED.replace("oscillator", stage))["m_prime"] == 1.0


def test_over_a_slow_network_a_lecture_keeps_its_preset_and_every_key_press(late):
    page = late("derivation?step=2&values=numbers")
    check_preset_after_typing(page, late.by, 0.1, stage="beside")
    late.by(0.6)
    for _ in range(4):
        page.keyboard.press("ArrowRight")
        page.wait_for_timeout(150)
    assert page.locator(HEADING).inner_text().startswith("6.")
    page.wait_for_url("**step=6**")
    settle(page)
    assert page.locator(HEADING).inner_text().startswith("6.")


# ---- the slab


def check_held_slab(page, late_by) -> None:
    """Check that no message moves the slab during a drag."""
    late_by(0.3)
    drag(page, "m_prime", 40)
    take_slab(page, -3)
    page.wait_for_timeout(200)  # until the last jump has faded
    places = page.evaluate(
        """async () => {
          const places = [], end = performance.now() + 1800;
          while (performance.now() < end) {
            await new Promise(requestAnimationFrame);
            places.push(document.querySelector(".st-key-stage [data-testid=stBidiComponentIsolated]").shadowRoot
              .querySelector(".moving .slab").transform.baseVal[0].matrix.e);
          }
          return places;
        }"""
    )
    assert max(places) - min(places) < 0.05
    page.mouse.up()
    record(page, "bent", "drawn/oscillator", "parameters.compression")
    settle(page)
    assert set(page.evaluate("window.bent")) == {0.05}
    assert page.evaluate(PUBLISHED)["compression"] == pytest.approx(0.05)


def check_keys_behind_the_slab(page, late_by) -> None:
    """Check that no key press after a drag of the slab is lost."""
    late_by(0.1)
    for presses, pause in ((5, 150), (10, 0)):
        take_slab(page, -1 if presses == 5 else 1)
        page.mouse.up()
        page.wait_for_timeout(pause)
        page.locator(M_PRIME).focus()
        for _ in range(5):
            page.keyboard.press("ArrowRight")
            page.wait_for_timeout(100)
        settle(page)
        expected = 1 + presses / 100
        assert page.locator(M_PRIME).input_value() == f"{expected:.2f}".rstrip("0")
        assert float(address(page)["m_prime"][0]) == expected
        published = page.evaluate(PUBLISHED)
        assert published["m_prime"] == expected
        compression = float(page.locator(COMPRESSION).input_value())
        assert published["compression"] == pytest.approx(compression / 100)
        assert float(address(page).get("compression", ["8"])[0]) == pytest.approx(compression)


NOTICE_AT_ONCE = """() => {
  const app = document.querySelector("[data-testid=stApp]");
  const services = document.querySelector(".st-key-unseen-services [data-testid=stBidiComponentIsolated]").shadowRoot;
  const notice = services.querySelector("p:not([role])");
  new MutationObserver(() => requestAnimationFrame(() => (window.noticeAtOnce ??= !notice.hidden)))
    .observe(app, { attributeFilter: ["data-test-connection-state"] });
}"""
"""Records whether the notice appears in the same frame in which Streamlit disables the sliders."""


def check_broken_network(page, late) -> None:
    """Check that no setting and no drag is lost when the network breaks, also if the server forgets the session.

    A killed server forgets its sessions, too; test_deployment kills a real one.
    """
    check_broken_drag_of_slab(page, late)
    check_broken_drag_of_thumb(page, late)


def check_broken_drag_of_slab(page, late) -> None:
    """Check that x₀ is sent, whether the slab is released before or after the reconnect."""
    late.by(0.1)  # so that the value of the slab is sent before the answer of a new session arrives
    page.evaluate(NOTICE_AT_ONCE)
    for by, left, forget_session in ((-3, 5, True), (-2, 3, True), (1, 4, False)):
        take_slab(page, by)
        late.way.down()
        # The page shows a notice, and continues to work.
        notice = page.locator(".st-key-unseen-services p:not([role])")
        expect(notice).to_have_text("Reconnecting to the server. The page keeps everything that you set.")
        expect(notice).to_be_visible()
        assert page.evaluate("window.noticeAtOnce")
        if left == 3:  # the slab is released while there is no connection
            page.mouse.up()
            next_frame(page)
        late.way.up(forget_session)
        page.wait_for_selector(f"{COMPRESSION}:enabled", state="attached")
        expect(notice).to_be_hidden()
        settle(page)
        page.mouse.up()
        page.wait_for_url(f"**compression={left}**")
        settle(page)
        assert page.evaluate(PUBLISHED)["compression"] == pytest.approx(left / 100)
        assert page.locator(COMPRESSION).input_value() == str(left)
        # The settings are preserved and can be changed.
        page.locator(".st-key-m input[type=range]").press("ArrowRight")
        page.wait_for_url(f"**m=1.0{(5, 3, 4).index(left) + 1}**")
        settle(page)
        assert page.get_by_role("dialog").count() == 0


def check_broken_drag_of_thumb(page, late) -> None:
    """Check that a slider sends its value if its thumb is released while there is no connection."""
    hold(page, "m_prime", 40, 4)
    shown = page.locator(M_PRIME).input_value()
    late.way.down()
    page.wait_for_selector(f"{M_PRIME}:disabled", state="attached")
    page.mouse.up()
    next_frame(page)
    late.way.up(forget_session=True)
    page.wait_for_url(f"**m_prime={shown}**")
    settle(page)
    assert float(shown) > 1.1
    assert page.locator(BOX).input_value() == page.locator(M_PRIME).input_value() == shown
    assert page.evaluate(PUBLISHED)["m_prime"] == float(shown)


# ---- the whole page


def test_quick_changes_over_a_slow_network_never_end_the_app(late):
    page, chance = late(figures=False), random.Random(1729)
    late.by(0.1)
    places = range(len(menu.PAGES))
    for _ in range(CHANGES):
        for place in chance.sample(places, len(places)):
            page.evaluate(f"{LINKS}[{place}].click()")
            page.wait_for_timeout(100)
    page.evaluate(f"{LINKS}[0].click()")
    page.wait_for_selector("[data-testid=stMainBlockContainer] h1")
    settle(page)
    assert page.get_by_role("dialog").count() == 0, page.get_by_role("dialog").first.inner_text()
    page.locator(M_PRIME).press("ArrowRight")
    page.wait_for_url("**m_prime=1.01**")


def test_one_visit_is_one_entry_of_the_history_and_back_and_forward_go_through_them(visit):
    page = visit("?m_prime=2.03&hide=curve,steps")
    before = page.evaluate("history.length")
    page.get_by_role("link", name="Lesson", exact=True).first.click()
    page.get_by_role("heading", name="1.").wait_for()
    settle(page)
    assert page.evaluate("history.length") == before + 1

    def wait_for_page(title: str) -> None:
        expect(page.locator("h1").first).to_have_text(title)
        settle(page)
        assert address(page)["m_prime"] == ["2.03"]
        expect(page.locator(BOX)).to_have_value("2.03")

    page.go_back()
    wait_for_page("Ramanujan’s oscillator")
    page.evaluate(f"{LINKS}[1].click()")
    wait_for_page("Many ways to one frequency")
    page.go_back()
    wait_for_page("Ramanujan’s oscillator")
    page.go_forward()
    wait_for_page("Many ways to one frequency")


WITHOUT_UPDATES = """if (!sessionStorage.wasDeaf) {
  sessionStorage.wasDeaf = true;
  globalThis.setInterval = () => 0;
  const later = setTimeout;
  globalThis.setTimeout = (act, pause, ...more) => later(act, pause === 20_000 ? 3_000 : pause, ...more);
}"""
"""Stops a page's reruns until a reload, as after a lost message, and shortens the wait for it."""


def test_a_wall_whose_reruns_have_stopped_reloads_itself(visit):
    opened, stop = shared().open_class(), lesson.STOPS[0]
    wall = visit(f"lesson?class={opened.code}&wall=on&view=projector", WITHOUT_UPDATES)
    shared().ask(opened.key, stop.id, list(stop.options))
    expect(wall.locator("h1")).to_have_text([stop.heading])


def test_a_wall_shows_its_question_and_a_small_notice_while_the_server_is_away(late, visit):
    desk = visit("lesson", RERUN_ON_DEMAND)
    desk.locator(".st-key-class_door button").first.click()
    desk.locator(".st-key-class_open button").click()
    link = desk.get_by_role("link", name="Open the wall").get_attribute("href")
    desk.locator(".st-key-class_ask button").click()
    settle(desk)
    wall = late(f"lesson?{link.partition('?')[2]}", RERUN_ON_DEMAND)
    question, notice = wall.locator(".st-key-wall_asked h1"), wall.locator(".away")
    question.wait_for()
    assert not notice.is_visible()
    late.way.down()
    # Streamlit opens its box after some attempts; streamlit.css hides it.
    wall.locator(".stDialog").wait_for(state="attached")
    expect(notice).to_be_visible()
    expect(wall.locator(".stDialog")).to_be_hidden()
    box = notice.bounding_box()
    assert box["width"] * box["height"] < 0.05 * 1280 * 720
    late.way.up()
    expect(notice).to_be_hidden()
    assert question.is_visible()
