"""The pages of a class in a browser."""

from playwright.sync_api import Page

VOTES = ".st-key-class_phone [role=radiogroup] label"
RERUN_ON_DEMAND = """(() => {
  const acts = new Map(), begin = setInterval, end = clearInterval;
  globalThis.setInterval = (act, pause, ...more) => {
    const id = begin(pause > 400 ? () => undefined : act, pause, ...more);
    if (pause > 400) acts.set(id, act);
    return id;
  };
  globalThis.clearInterval = (id) => (acts.delete(id), end(id));
  globalThis.rerun = () => acts.forEach((act) => act());
  const later = setTimeout;
  globalThis.setTimeout = (act, pause, ...more) => (pause > 10_000 ? 0 : later(act, pause, ...more));
})()"""
"""Replaces the periodic reruns of a page by reruns on demand, because nine pages would rerun all the time.

It also omits timeouts of more than ten seconds, after which an idle wall would reload itself.
"""


def rerun(*pages: Page) -> None:
    """Rerun pages, so that they show the present state of the class."""
    for page in pages:
        page.evaluate("rerun()")
