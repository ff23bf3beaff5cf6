"""How soon a page says that its server is away after a kill (goal: 1 s): `python -m tests.benchmarks.reconnecting`."""

import argparse
import time

from playwright.sync_api import sync_playwright

from ramanujan.shell.navigation import PAGES
from tests.browser import CHROMIUM, FLAGS, ROOT, listen, running, settle

SERVICES = "document.querySelector('.st-key-services [data-testid=stBidiComponentIsolated]').shadowRoot"
NOTICE = f"{SERVICES}.querySelector('p:not([role])')"
WATCH = f"""() => new MutationObserver(() => {{ if (!{NOTICE}.hidden) window.away ??= Date.now(); }})
  .observe({NOTICE}, {{ attributes: true }})"""


def main() -> int:
    """Measure, print, and return 0 if every page is in time."""
    argparse.ArgumentParser(description=__doc__).parse_args()
    slowest = 0.0
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        for page in PAGES.values():
            server = running(ROOT / "app.py")
            with server as address:
                tab = browser.new_page(bypass_csp=True)
                listen(tab)
                tab.goto(f"{address}/{page.address}")
                tab.wait_for_selector(".st-key-m_exact")
                settle(tab)
                tab.evaluate(WATCH)
                server.process.kill()
                killed = time.time()
                tab.wait_for_function("window.away", timeout=30_000)
                seconds = tab.evaluate("window.away") / 1000 - killed
                slowest = max(slowest, seconds)
                print(f"{page.name:12} {seconds:5.2f} s", flush=True)
                tab.close()
        browser.close()
    return int(slowest > 1)


if __name__ == "__main__":
    raise SystemExit(main())
