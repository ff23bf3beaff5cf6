"""Nothing that somebody has set is lost when two things happen at once, or when the server is away."""

from __future__ import annotations

import contextlib
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import expect

from tests.browser import ROOT, listen, next_frame, running, settle
from tests.slow_network import delayed, network
from tests.test_browser_hand import TOLD, take_slab

COMPRESSION = ".st-key-compression input[type=range]"
BOX = ".st-key-m_prime_exact input"


@contextlib.contextmanager
def opened(profile, server: str, delay: float, link: str = ""):
    """Open a page over a network that is late by so much."""
    with delayed(server, delay) if delay else contextlib.nullcontext(server) as address:
        page = profile.new_page()
        listen(page)
        page.set_viewport_size({"width": 1280, "height": 720})
        page.emulate_media(reduced_motion="reduce")
        page.goto(f"{address}/{link}")
        page.wait_for_selector(BOX, timeout=60_000)
        settle(page)
        yield page
        page.close()


def address(page) -> dict[str, list[str]]:
    return parse_qs(urlsplit(page.url).query)


def calm(page, delay: float) -> None:
    settle(page)
    page.wait_for_timeout(200 + 2500 * delay)
    settle(page)


@pytest.mark.parametrize(("delay", "link"), [(0.0, ""), (0.4, ""), (0.1, "derivation")])
def test_a_preset_wins_over_what_was_typed_before_it(profile, server, delay, link):
    with opened(profile, server, delay, link) as page:
        for preset in ("Equal masses", "Reset"):
            page.locator(BOX).fill("4.44")
            page.get_by_text(preset, exact=True).click()
            calm(page, delay)
            expect(page.locator(BOX)).to_have_value("1.0")
            assert page.locator(".st-key-m_prime input[type=range]").input_value() == "1"
            assert "m_prime" not in address(page)
            assert page.evaluate(TOLD.replace("oscillator", "beside" if link else "oscillator"))["m_prime"] == 1.0


@pytest.mark.parametrize("pause", [0, 150])
def test_no_key_press_is_lost_behind_a_released_slab(profile, server, pause):
    with opened(profile, server, 0.1) as page:
        page.wait_for_selector(".st-key-stage .readouts dd:not(:empty)", state="attached")
        for presses in (5, 10):
            take_slab(page, -1 if presses == 5 else 1)
            page.mouse.up()
            page.wait_for_timeout(pause)
            page.locator(".st-key-m_prime input[type=range]").focus()
            for _ in range(5):
                page.keyboard.press("ArrowRight")
                page.wait_for_timeout(100)
            calm(page, 0.1)
            expected = 1 + presses / 100
            assert page.locator(".st-key-m_prime input[type=range]").input_value() == f"{expected:.2f}".rstrip("0")
            assert float(address(page)["m_prime"][0]) == expected
            told = page.evaluate(TOLD)
            assert told["m_prime"] == expected
            held = float(page.locator(COMPRESSION).input_value())
            assert told["compression"] == pytest.approx(held / 100)
            assert float(address(page).get("compression", ["8"])[0]) == pytest.approx(held)


TOLD_AT_ONCE = """() => {
  const app = document.querySelector("[data-testid=stApp]");
  const library = document.querySelector(".st-key-library [data-testid=stBidiComponentIsolated]").shadowRoot;
  const notice = library.querySelector("p:not([role])");
  new MutationObserver(() => requestAnimationFrame(() => (window.toldAtOnce ??= !notice.hidden)))
    .observe(app, { attributeFilter: ["data-test-connection-state"] });
}"""
"""Whether the notice is there in the frame in which Streamlit reports the loss, which disables the sliders."""


@pytest.mark.parametrize("let_go", ["while the server is away", "after its return"])
def test_a_killed_server_takes_no_slab_out_of_the_hand(profile, let_go):
    first = running(ROOT / "app.py")
    with first as server, network(server) as way, opened(profile, way.address, 0) as page:
        page.wait_for_selector(".st-key-stage .readouts dd:not(:empty)", state="attached")
        take_slab(page, -3)
        page.evaluate(TOLD_AT_ONCE)
        first.process.kill()
        first.process.wait()
        way.down()
        # The page says what has happened, and goes on by itself.
        notice = page.locator(".st-key-library p:not([role])")
        expect(notice).to_have_text("Reconnecting to the server. The page keeps everything that you set.")
        expect(notice).to_be_visible()
        assert page.evaluate("window.toldAtOnce")
        if let_go == "while the server is away":
            page.mouse.up()
            next_frame(page)
        with running(ROOT / "app.py") as server:
            way.lead_to(server)
            way.up()
            page.wait_for_selector(f"{COMPRESSION}:enabled", timeout=60_000)
            expect(notice).to_be_hidden()
            settle(page)
            if let_go == "after its return":
                page.mouse.up()
            page.wait_for_url("**compression=5**", timeout=5000)
            settle(page)
            assert page.evaluate(TOLD)["compression"] == pytest.approx(0.05)
            assert page.locator(COMPRESSION).input_value() == "5"


def test_one_visit_is_one_entry_of_the_history(profile, server):
    with opened(profile, server, 0, "?m_prime=2.03") as page:
        before = page.evaluate("history.length")
        page.get_by_role("link", name="Lesson", exact=True).first.click()
        page.get_by_role("heading", name="1.").wait_for()
        calm(page, 0)
        assert page.evaluate("history.length") == before + 1
        page.go_back()
        expect(page.locator("h1")).to_have_text("Ramanujan’s oscillator")
        calm(page, 0)
        assert address(page) == {"m_prime": ["2.03"]}
        expect(page.locator(BOX)).to_have_value("2.03")
