"""A page that stays open for a lesson: neither its memory nor its listeners grow.

RAMANUJAN_MINUTES sets how long the stage runs (60 for a thorough run), RAMANUJAN_PAGES how many page changes there are
(60 for a thorough run).
"""

from __future__ import annotations

import os

from tests.browser import listen, settle

MINUTES = float(os.environ.get("RAMANUJAN_MINUTES", "0.3"))
CHANGES = int(os.environ.get("RAMANUJAN_PAGES", "5"))
LINKS = "document.querySelectorAll('[data-testid=stTopNavLink]')"
HASTE = """
const now = performance.now.bind(performance), then = now();
performance.now = () => then + 60 * (now() - then);
const request = requestAnimationFrame.bind(window);
window.requestAnimationFrame = (draw) => request(() => draw(performance.now()));
"""
"""A clock that runs sixty times as fast: the stage runs an hour in a minute."""


def counts(tab: object, client: object) -> dict[str, float]:
    """Return what the page holds after its garbage has been collected."""
    for _ in range(2):
        client.send("HeapProfiler.collectGarbage")
        tab.wait_for_timeout(300)
    metrics = {metric["name"]: metric["value"] for metric in client.send("Performance.getMetrics")["metrics"]}
    return {name: metrics[name] for name in ("JSHeapUsedSize", "JSEventListeners", "Nodes")}


def open_tab(profile: object, address: str, motion: str, hasty: bool = False) -> tuple[object, object]:
    tab = profile.new_page()
    tab.set_viewport_size({"width": 1280, "height": 720})
    tab.emulate_media(reduced_motion=motion)
    listen(tab)
    if hasty:
        tab.add_init_script(HASTE)
    tab.goto(address)
    tab.wait_for_selector("[data-testid=stMainBlockContainer] h1")
    settle(tab)
    client = tab.context.new_cdp_session(tab)
    client.send("Performance.enable")
    return tab, client


def test_page_changes_leave_nothing_behind(server: str, profile: object) -> None:
    tab, client = open_tab(profile, f"{server}/speed?periods=1", "reduce")

    def go_round() -> None:
        for place in range(5):
            tab.evaluate(f"{LINKS}[{place}].click()")
            tab.wait_for_timeout(200)
            settle(tab)

    # The first round loads what each page needs.
    go_round()
    before = counts(tab, client)
    for _ in range(max(CHANGES // 5, 1)):
        go_round()
    after = counts(tab, client)
    tab.close()
    assert after["JSEventListeners"] <= 1.1 * before["JSEventListeners"] + 50, (before, after)
    assert after["Nodes"] <= 1.2 * before["Nodes"] + 500, (before, after)
    assert after["JSHeapUsedSize"] <= before["JSHeapUsedSize"] + 2**20 * (5 + CHANGES / 10), (before, after)


def test_a_running_stage_holds_no_more_after_a_while(server: str, profile: object) -> None:
    tab, client = open_tab(profile, server, "no-preference", hasty=True)
    tab.wait_for_timeout(3000)
    before = counts(tab, client)
    tab.wait_for_timeout(1000 * max(MINUTES, 0.2))
    after = counts(tab, client)
    tab.close()
    assert after["JSEventListeners"] <= before["JSEventListeners"], (before, after)
    assert after["Nodes"] <= before["Nodes"] + 50, (before, after)
    assert after["JSHeapUsedSize"] <= before["JSHeapUsedSize"] + 2**20, (before, after)
