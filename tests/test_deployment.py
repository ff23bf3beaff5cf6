"""The recipe in .deploy on the loopback address: two processes behind HAProxy, with a browser."""

import asyncio
import os
import random
import sqlite3
import time
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor

import pytest
import websockets
from streamlit.proto.BackMsg_pb2 import BackMsg
from streamlit.proto.ForwardMsg_pb2 import ForwardMsg

from ramanujan.lesson import classes
from ramanujan.lesson.class_codes import hash_network
from ramanujan.shell.browser_cookie import NAME
from tests.browser import CHROMIUM, get, settle, wait_for_start
from tests.deployed import HAPROXY, deployed

pytestmark = pytest.mark.xdist_group("deployment")

STORE = "ramanujan"
"""The cookie that names a visitor's process."""


@pytest.fixture(scope="module")
def hall() -> Iterator[deployed]:
    for program, name, package in ((HAPROXY, "HAPROXY", "haproxy"), (CHROMIUM, "BROWSER", "chromium")):
        if program is None:
            if os.environ.get(f"RAMANUJAN_REQUIRE_{name}"):
                pytest.fail(f"no {package} on this system, and RAMANUJAN_REQUIRE_{name} is set")
            pytest.skip(f"no {package} on this system (on Debian: apt-get install {package})")
    running = deployed()
    # A class that expired long before the start.
    classes.Classes(f"{running.state.name}/classes.sqlite", lambda: 0.0).open_class()
    with running:
        yield running


def cookie_of(hall: deployed, **headers: str) -> str | None:
    """Return the cookie by which the proxy ties a visitor to a process, if it sets one."""
    cookies = get(hall.address, **headers)[0].get_all("Set-Cookie", [])
    return next((cookie.partition(";")[0] for cookie in cookies if cookie.startswith(f"{STORE}=")), None)


def process_of(tab: object) -> str:
    """Return the name of the process that serves a visitor."""
    [cookie] = [cookie["value"] for cookie in tab.context.cookies() if cookie["name"] == STORE]
    return cookie


def test_expired_answers_are_deleted_when_the_server_starts(hall: deployed) -> None:
    expired, end = None, time.monotonic() + 60
    while expired != (0,) and time.monotonic() < end:
        with sqlite3.connect(f"{hall.state.name}/classes.sqlite") as file:
            expired = file.execute("SELECT COUNT(*) FROM class WHERE expires < 1e6").fetchone()
    assert expired == (0,)


def test_visitors_are_distributed_and_each_stays_in_one_process(hall: deployed) -> None:
    # The proxy checks every second whether a process is up, and prefers the one with fewer open connections.
    cookies: set[str | None] = set()
    for _ in range(240):
        cookies.add(cookie_of(hall))
        time.sleep(0.25)
        if len(cookies) == 2:
            break
    assert cookies == {f"{STORE}=first", f"{STORE}=second"}
    for cookie in cookies:
        # A valid cookie is not set again.
        assert all(cookie_of(hall, Cookie=cookie) is None for _ in range(4))
    # Negative control: a cookie with an unknown process is replaced.
    assert cookie_of(hall, Cookie=f"{STORE}=third")


def test_a_visitor_is_identified_by_the_address_from_the_proxy(hall: deployed) -> None:
    """The app ignores the addresses in a visitor's own headers: visitors with one address count as one network."""
    school = classes.Classes(f"{hall.state.name}/classes.sqlite")
    opened = school.open_class()

    async def join(proxied: str, own: str) -> None:
        """Join from one loopback address, with another one in the header."""
        async with websockets.connect(
            f"ws{hall.address.removeprefix('http')}/_stcore/stream",
            local_addr=(proxied, 0),
            subprotocols=["streamlit"],
            additional_headers={"X-Forwarded-For": own, "X-Real-IP": own, "Forwarded": f"for={own}"},
        ) as socket:
            question = BackMsg()
            question.rerun_script.query_string = f"class={opened.code}"
            question.rerun_script.page_name = "lesson"
            await socket.send(question.SerializeToString())
            while ForwardMsg.FromString(await socket.recv()).WhichOneof("type") != "script_finished":
                pass

    def networks() -> Counter[str]:
        with sqlite3.connect(f"{hall.state.name}/classes.sqlite") as file:
            rows = file.execute("SELECT network FROM voter WHERE code = ?", (opened.code,))
            return Counter(network for (network,) in rows)

    # Use another thread, because Playwright may have left an event loop in this one.
    with ThreadPoolExecutor(1) as thread:
        for number in range(4):
            thread.submit(asyncio.run, join("127.0.0.2", f"10.0.0.{number}")).result()
        thread.submit(asyncio.run, join("127.0.0.3", "127.0.0.2")).result()
    assert networks() == {hash_network("127.0.0.2", opened.code): 4, hash_network("127.0.0.3", opened.code): 1}


def test_over_https_a_first_visit_is_small(hall: deployed, chromium: object) -> None:
    context = chromium.new_context(ignore_https_errors=True, reduced_motion="reduce", bypass_csp=True)
    tab = context.new_page()
    client = context.new_cdp_session(tab)
    client.send("Network.enable")
    answers, sizes = {}, {}

    def note(event: dict) -> None:
        answers[event["requestId"]] = event["response"]

    def measure(event: dict) -> None:
        sizes[event["requestId"]] = event["encodedDataLength"]

    client.on("Network.responseReceived", note)
    client.on("Network.loadingFinished", measure)
    tab.goto(hall.secure)
    tab.locator(".js-plotly-plot .scatterlayer path").first.wait_for(state="attached")
    tab.locator("svg.machine[viewBox]").wait_for(state="attached")
    # The browser sends the cookies of the app and of the proxy only over HTTPS.
    secure = {cookie["name"]: cookie["secure"] for cookie in context.cookies()}
    assert {NAME, STORE} <= {*secure}
    assert all(secure.values()), secure
    context.close()
    sent = {number: answer for number, answer in answers.items() if answer["url"].startswith("https")}
    scripts = [answer for answer in sent.values() if answer["url"].endswith(".js")]
    assert len(scripts) > 20
    assert {answer["headers"].get("content-encoding") for answer in scripts} == {"gzip"}
    # A class of thirty loads it over one Wi-Fi.
    assert sum(sizes.get(number, 0) for number in sent) < 2.6e6


def test_a_change_of_language_preserves_page_machine_and_options(hall: deployed, visit: Callable) -> None:
    hall.start("hungarian")
    wait_for_start(f"{hall.address}/hu")
    tab = visit("motion?m=2.5&mu=0.4", network=hall.address, figures=False)
    move(tab, 3)
    english = tab.url
    for lang, name, address in (("hu", "Magyar", english.replace("/motion", "/hu/motion")), ("en", "English", english)):
        tab.locator(".st-key-link select").select_option(name)
        tab.wait_for_url(address)
        tab.wait_for_selector(f"html[lang={lang}] [data-testid=stMainBlockContainer] h1")
        settle(tab)
        assert tab.url == address
        assert tab.locator(".st-key-m input[type=range]").first.input_value() == "2.5"


def test_a_killed_process_loses_no_vote_and_no_setting(hall: deployed, visit: Callable) -> None:
    visitors = [visit("lesson", network=hall.address, figures=False) for _ in range(2)]
    students = {process_of(tab): tab for tab in visitors}
    assert set(students) == {"first", "second"}
    check_votes(students["first"], students["second"])
    check_killed_process(hall, students["first"], students["second"])


def check_votes(desk: object, phone: object) -> None:
    """Check the vote of a student who reaches another process by the lecturer's link."""

    def press(name: str) -> None:
        desk.locator(f".st-key-class_{name} button").click()

    press("door")
    press("open")
    desk.wait_for_url("**lecturer=**")
    desk.evaluate("navigator.clipboard.writeText = async (text) => (window.copied = text)")
    desk.locator("[data-testid=stExpandSidebarButton]").click()
    desk.get_by_role("button", name="Share").click()
    desk.get_by_role("button", name="Copy link").click()
    desk.wait_for_function("window.copied")
    link = desk.evaluate("copied")
    assert "lecturer=" not in link
    phone.goto(link)
    phone.get_by_text("The first question will appear here").wait_for()
    press("ask")
    phone.locator(".st-key-class_phone [role=radiogroup] label").nth(1).click()
    phone.get_by_text("Your answer counts").wait_for()
    desk.get_by_text("Answers: 1 of 1").wait_for()
    press("reveal")
    desk.get_by_text("1 of 1, 100\u202f%").first.wait_for()
    phone.get_by_text("1 of 1, 100\u202f%").first.wait_for()


def check_killed_process(hall: deployed, tab: object, other: object) -> None:
    """Check that visitors keep all settings when their process is killed."""
    tab.goto(f"{hall.address}/motion?m=2.5&mu=0.4")
    tab.wait_for_selector("[data-testid=stMainBlockContainer] h1")
    settle(tab)
    # Only the visitor's process has the file. Several downloads show that every request reaches this process.
    for _ in range(3):
        with tab.expect_download() as download:
            tab.get_by_role("button", name="CSV").click()
        assert "2.5" in download.value.path().read_text()
    move(tab, random.Random(1729).randint(3, 9))
    address, value = tab.url, slider(tab).input_value()
    assert "m_prime=" in address
    other_address = other.url

    with tab.expect_websocket(timeout=60_000):
        hall.kill("first")
    # The page is unchanged, and the first change restores all settings in the new process.
    settle(tab)
    assert (tab.url, slider(tab).input_value()) == (address, value)
    move(tab, 1)
    assert process_of(tab) == "second"
    moved = f"{float(value) + 0.01:.2f}"
    assert slider(tab).input_value() == moved
    assert tab.url == address.replace(f"m_prime={value}", f"m_prime={moved}")
    assert tab.locator(".st-key-mu input[type=range]").input_value() == "0.4"
    tab.reload()
    tab.wait_for_selector("[data-testid=stMainBlockContainer] h1")
    settle(tab)
    assert process_of(tab) == "second"
    assert slider(tab).input_value() == moved
    assert other.url == other_address
    # The tests without a browser run later, with both processes.
    hall.start("first")
    hall.wait({"first"})


def slider(tab: object) -> object:
    return tab.locator(".st-key-m_prime input[type=range]").first


def move(tab: object, steps: int) -> None:
    """Move m′ by `steps` steps and wait for the answer."""
    slider(tab).focus()
    for _ in range(steps):
        tab.keyboard.press("ArrowRight")
    settle(tab)
