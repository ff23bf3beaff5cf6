"""Response times of the first page, compared with a bare page that has three sliders.

    python -m tests.benchmarks.app [--changes 30]

Both pages are measured in the same way in one run, so that their ratios are meaningful on a busy machine. A change is
one key press on a slider. The browser's time stamps of websocket frames measure the server. A script in the page
measures the time until the picture changes.
"""

import argparse
import math
import os
import statistics
import tempfile
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

from playwright.sync_api import Browser, Page, sync_playwright

from tests.checks.browser import CHROMIUM, FLAGS, ROOT, STAGE, running, settle, thumb, traffic

BARE = """
import streamlit as st
values = [st.slider(name, 0.5, 5.0, 1.0, 0.01, key=name) for name in ("m", "m_prime", "k")]
st.text(f"picture {values}")
"""
VISITS = 7
"""Number of visits. The report shows the medians of their times."""
FIRST_PICTURE = """
const look = () => {
  if (%s) window.firstPicture = performance.now() / 1000;
  else requestAnimationFrame(look);
};
requestAnimationFrame(look);
"""
"""Script that stores the time of the first frame with a picture. Playwright itself waits until the page is idle."""


@dataclass(frozen=True)
class Subject:
    """A measured page.

    Parameters
    ----------
    name : name in the report
    script : the Streamlit script
    first : JavaScript expression that is true once the page has its first picture
    complete : selector of an element that exists once the page is complete
    picture : JavaScript expression that changes with a slider; in the app it changes before the server answers
    words : JavaScript expression that changes after the server has answered
    """

    name: str
    script: Path
    first: str
    complete: str
    picture: str
    words: str


@dataclass(frozen=True)
class Costs:
    """Durations [s] and frame rates [1/s] of one page. test_browser_controls counts bytes and delayed frames."""

    first_picture: float
    complete_page: float
    server: list[float]
    release_to_picture: list[float]
    release_to_words: list[float]
    frames_per_second: float | None = None
    frames_slowed_down: float | None = None
    frames_in_silent_drag: float | None = None
    frames_in_drag_with_sound: float | None = None


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--changes", type=int, default=30, help="slider changes to measure (default: 30)")
    changes = parser.parse_args().changes
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        bare_script = Path(folder) / "bare.py"
        bare_script.write_text(BARE)
        text = "[data-testid=stText]"
        answer = f"document.querySelector('{text}').textContent"
        bare = Subject("bare page", bare_script, f"document.querySelector('{text}')", text, answer, answer)
        app = Subject(
            "first page",
            ROOT / "app.py",
            f"{STAGE.replace('.shadowRoot', '?.shadowRoot')}?.querySelector('.body.slab')",
            ".st-key-curve .scatterlayer",
            "document.querySelector('.present-machine')?.style.left",
            "[...document.querySelectorAll('annotation')].map((formula) => formula.textContent).join()",
        )
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}, Chromium {browser.version}, {changes} changes\n")
        costs = {subject.name: measure(browser, subject, changes) for subject in (bare, app)}
        browser.close()
    report(costs["bare page"], costs["first page"])


def measure(browser: Browser, subject: Subject, changes: int) -> Costs:
    """Measure the response times and the frame rates of a page."""
    with running(subject.script) as address:
        page, *_ = visit(browser, address, subject)  # warm up the server
        first_pictures, complete_pages = [], []
        for _ in range(VISITS):
            page.context.close()
            page, first_picture, complete_page = visit(browser, address, subject)
            first_pictures.append(first_picture)
            complete_pages.append(complete_page)
        times = [change(page, subject, "ArrowRight" if i % 2 else "ArrowLeft") for i in range(changes)]
        server, picture, words = zip(*times, strict=True)
        stage = page.locator(".st-key-stage").count() > 0
        extra = (frames_per_second(page), slowed_down(page), *without_and_with_sound(page)) if stage else ()
        page.context.close()
    medians = statistics.median(first_pictures), statistics.median(complete_pages)
    return Costs(*medians, server, picture, words, *extra)


def visit(browser: Browser, address: str, subject: Subject) -> tuple[Page, float, float]:
    """Return a new visitor's page, and the seconds to its first picture and to the complete page."""
    page = browser.new_context(viewport={"width": 1280, "height": 1400}, bypass_csp=True).new_page()
    traffic(page)  # counts from here on
    page.add_init_script(FIRST_PICTURE % subject.first)
    start = perf_counter()
    page.goto(address)
    page.wait_for_selector(subject.complete)
    complete_page = perf_counter() - start
    # Open the last step, if the page has steps. The words that `change` observes are in it.
    for step in page.locator(".st-key-six_steps summary").all()[-1:]:
        step.click()
    settle(page)
    return page, page.evaluate("window.firstPicture"), complete_page


def change(page: Page, subject: Subject, key: str) -> tuple[float, float, float]:
    """Press a key on a slider; return the seconds until the server's answer, the new picture and the new words."""
    stamps: dict[str, float] = {}
    client = page.context.new_cdp_session(page)
    client.send("Network.enable")
    client.on("Network.webSocketFrameSent", lambda event: stamps.setdefault("sent", event["timestamp"]))
    client.on("Network.webSocketFrameReceived", lambda event: stamps.update(received=event["timestamp"]))
    page.locator(".st-key-m_prime input[type=range]").focus()
    page.evaluate(
        f"""() => {{
          const looks = [() => {subject.picture}, () => {subject.words}];
          const before = looks.map((look) => look());
          let start;
          window.waited = [null, null];
          const watch = () => {{
            looks.forEach((look, i) => {{
              if (window.waited[i] === null && look() !== before[i]) window.waited[i] = performance.now() - start;
            }});
            if (window.waited.includes(null)) requestAnimationFrame(watch);
          }};
          const begin = () => {{
            start = performance.now();
            requestAnimationFrame(watch);
          }};
          addEventListener("keyup", begin, {{ once: true }});
        }}"""
    )
    page.keyboard.press(key)
    page.wait_for_function("!window.waited.includes(null)")
    settle(page)
    client.detach()
    picture, words = page.evaluate("window.waited")
    return stamps["received"] - stamps["sent"], picture / 1000, words / 1000


def frames_per_second(page: Page, seconds: float = 4) -> float:
    """Return the number of frames per second in which the slab has moved."""
    return page.evaluate(
        f"""() => new Promise((done) => {{
          const slab = {STAGE}.querySelector(".body.slab");
          const start = performance.now();
          let place = null, moved = 0;
          const watch = (now) => {{
            const at = slab.getAttribute("transform");
            if (at !== place) moved += 1;
            place = at;
            if (now - start < {seconds * 1000}) requestAnimationFrame(watch);
            else done(moved / ((now - start) / 1000));
          }};
          requestAnimationFrame(watch);
        }})"""
    )


def slowed_down(page: Page, times: int = 4) -> float:
    """Return the frames per second with a processor that is slower by a factor."""
    client = page.context.new_cdp_session(page)
    client.send("Emulation.setCPUThrottlingRate", {"rate": times})
    frames = frames_per_second(page)
    client.send("Emulation.setCPUThrottlingRate", {"rate": 1})
    client.detach()
    return frames


def without_and_with_sound(page: Page) -> tuple[float, float]:
    """Return the frames per second during a drag before and after a press on Listen."""
    silent = frames_in_drag(page)
    page.locator(".st-key-stage .listen").click()
    page.wait_for_function(f"{STAGE}.querySelector('.heard').textContent")
    return silent, frames_in_drag(page)


def frames_in_drag(page: Page, moves: int = 200) -> float:
    """Return the number of frames per second while a mouse drags the slider of m′ to and fro."""
    x, y = thumb(page, "m_prime")
    page.mouse.move(x, y)
    page.mouse.down()
    page.evaluate(
        """() => {
          const drag = (window.drag = { start: performance.now(), frames: 0 });
          const count = () => {
            if (window.drag !== drag) return;
            drag.frames += 1;
            requestAnimationFrame(count);
          };
          requestAnimationFrame(count);
        }"""
    )
    for move in range(moves):
        page.mouse.move(x + 60 * math.sin(move / 20), y)
    frames = page.evaluate("1000 * drag.frames / (performance.now() - drag.start)")
    page.mouse.up()
    settle(page)
    return float(frames)


def report(bare: Costs, app: Costs) -> None:
    """Print a table of both pages and the goals."""

    def row(what: str, left: Any, right: Any, goal: str = "") -> None:
        print(f"{what:<34}{left:>14}{right:>14}   {goal}")

    def ms(seconds: float) -> str:
        return f"{1000 * seconds:.1f} ms"

    def p95(times: list[float]) -> float:
        return statistics.quantiles(times, n=20)[-1]

    row("", "bare page", "first page", "goal")
    ratio = app.first_picture / bare.first_picture
    row("first picture", ms(bare.first_picture), ms(app.first_picture), f"≤ 1.3 × bare (here {ratio:.2f})")
    row("complete page", ms(bare.complete_page), ms(app.complete_page))
    row("server and network, p50", ms(statistics.median(bare.server)), ms(statistics.median(app.server)), "≤ 15 ms")
    row("server and network, p95", ms(p95(bare.server)), ms(p95(app.server)))
    bare_p50, app_p50 = (statistics.median(costs.release_to_picture) for costs in (bare, app))
    row("release → picture, p50", ms(bare_p50), ms(app_p50), f"≤ 1.5 × bare (here {app_p50 / bare_p50:.2f})")
    row("release → picture, p95", ms(p95(bare.release_to_picture)), ms(p95(app.release_to_picture)))
    bare_p50, app_p50 = (statistics.median(costs.release_to_words) for costs in (bare, app))
    row("release → numbers in words, p50", ms(bare_p50), ms(app_p50), f"(here {app_p50 / bare_p50:.2f} × bare)")
    row("stage, frames a second", "", f"{app.frames_per_second:.1f}", "60")
    row("… at a quarter of the speed", "", f"{app.frames_slowed_down:.1f}", "≥ 55")
    row("… during a drag", "", f"{app.frames_in_silent_drag:.1f}", "60")
    row("… during a drag with sound", "", f"{app.frames_in_drag_with_sound:.1f}", "60")


if __name__ == "__main__":
    main()
