"""The recipe in .deploy on the loopback address: two processes behind HAProxy, with a browser."""

import random
import resource
import sqlite3
import time
from collections.abc import Callable, Iterator
from urllib.error import HTTPError

import pytest

from ramanujan.classroom import rules
from ramanujan.shell.class_keys import COOKIE
from tests.checks.browser import CHROMIUM, get, settle, wait_for_start
from tests.checks.deployed import HAPROXY, deployed
from tests.checks.engines import new_context
from tests.settings import skip_missing

pytestmark = pytest.mark.xdist_group("deployment")

STORE = "ramanujan"
"""The cookie that names a visitor's process."""


@pytest.fixture(scope="module")
def hall() -> Iterator[deployed]:
    for program, package in ((HAPROXY, "haproxy"), (CHROMIUM, "chromium")):
        if program is None:
            skip_missing(package, package)
    running = deployed()
    # A class that expired long before the start.
    rules.Classes(f"{running.state.name}/classes.sqlite", lambda: 0.0).open_class()
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


def test_a_process_raises_its_limit_of_open_files(hall: deployed) -> None:
    """With 256 files, 40 phones came in once, and 8 of them after two reloads."""
    for process in hall.processes.values():
        limit, most = resource.prlimit(process.pid, resource.RLIMIT_NOFILE)
        assert limit == most


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


def test_the_proxy_does_not_serve_the_metrics(hall: deployed) -> None:
    for path in ("_stcore/metrics", "%5Fstcore/metrics", "_stcore%2Fmetrics", "hu/_stcore/metrics"):
        with pytest.raises(HTTPError, match="404"):
            get(f"{hall.address}/{path}")
    assert get(f"http://127.0.0.1:{hall.ports['first']}/_stcore/metrics")
    assert get(f"{hall.address}/_stcore/health")


def test_over_https_a_first_visit_is_small(hall: deployed, chromium: object) -> None:
    context = new_context(chromium, ignore_https_errors=True, reduced_motion="reduce", bypass_csp=True)
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
    tab.locator(".st-key-stage svg.machine[viewBox]").wait_for(state="attached")
    # The browser sends the cookies of the app and of the proxy only over HTTPS.
    secure = {cookie["name"]: cookie["secure"] for cookie in context.cookies()}
    assert {COOKIE, STORE} <= {*secure}
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

    with tab.expect_websocket():
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
