"""WebKit, the engine of Safari, in its GTK port: a page with the methods of Playwright that the tests use.

Playwright's WebKit needs another download. Debian's WebKit has a WebDriver (webkit2gtk-driver) for Selenium. It runs on
a virtual screen (Xvfb).
"""

import json
import os
import re
import shutil
import subprocess
import time
from glob import glob
from pathlib import Path

from selenium import webdriver
from selenium.webdriver import ActionChains, Keys
from selenium.webdriver.common.actions.action_builder import ActionBuilder
from selenium.webdriver.common.actions.mouse_button import MouseButton
from selenium.webdriver.common.actions.pointer_input import PointerInput

from tests.checks.browser import stop
from tests.settings import PATIENCE

BROWSER = next(iter(glob("/usr/lib/*/webkit2gtk-4.*/MiniBrowser")), None)
DRIVER = shutil.which("WebKitWebDriver")
SCREEN = shutil.which("Xvfb")

_EVALUATE = """
const [given, done] = arguments;
(async () => {
  const value = (TEXT);
  return typeof value === "function" ? value(given) : value;
})().then((value) => ({ value: value ?? null }), (error) => ({ error: `${error}\\n${error?.stack}` }))
  .then((answer) => done(JSON.stringify(answer)));
"""
"""Evaluates an expression without `eval`, which a page's policy forbids. JSON preserves the order of keys."""


_BUTTONS = {"left": MouseButton.LEFT, "middle": MouseButton.MIDDLE, "right": MouseButton.RIGHT}


class Page:
    """A window of WebKit; `close` stops the browser."""

    def __init__(self, folder: Path) -> None:
        """Start the browser with reduced motion; `folder` contains its settings."""
        settings = folder / "gtk-3.0"
        settings.mkdir()
        (settings / "settings.ini").write_text("[Settings]\ngtk-enable-animations=0\n")
        screen = [SCREEN, "-displayfd", "1", "-screen", "0", "2200x1400x24"]
        self.screen = subprocess.Popen(screen, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        environment = {"DISPLAY": f":{self.screen.stdout.readline().strip()}", "XDG_CONFIG_HOME": str(folder)}
        options = webdriver.WebKitGTKOptions()
        options.binary_location = BROWSER
        options.add_argument("--automation")
        service = webdriver.WebKitGTKService(DRIVER, env=os.environ | environment)
        self.driver = webdriver.WebKitGTK(options, service)
        # Selenium waits for an answer without a limit.
        self.driver.command_executor.client_config.timeout = PATIENCE
        self.mouse, self.keyboard = Mouse(self.driver), Keyboard(self.driver)

    def close(self) -> None:
        self.driver.quit()
        stop(self.screen)

    def forget(self) -> None:
        """Delete cookies and storage before the next test."""
        self.driver.switch_to.default_content()
        self.evaluate("location.protocol.startsWith('http') && (localStorage.clear(), sessionStorage.clear())")
        self.driver.delete_all_cookies()
        self.goto("about:blank")

    def goto(self, address: str) -> None:
        self.driver.get(address)

    def enter_frame(self) -> None:
        """Evaluate later expressions in the first frame of this page."""
        self.driver.switch_to.frame(0)

    @property
    def url(self) -> str:
        return self.driver.current_url

    def evaluate(self, text: str, given: object = None) -> object:
        answer = json.loads(self.driver.execute_async_script(_EVALUATE.replace("TEXT", text), given))
        if "error" in answer:
            raise AssertionError(answer["error"])
        return answer["value"]

    def wait_for_function(self, text: str, *, arg: object = None, timeout: float = 1000 * PATIENCE) -> None:
        end = time.monotonic() + timeout / 1000
        while not self.evaluate(text, arg):
            assert time.monotonic() < end, f"never true: {text}"
            self.wait_for_timeout(50)

    def wait_for_timeout(self, ms: float) -> None:
        time.sleep(ms / 1000)

    def set_viewport_size(self, size: dict[str, int]) -> None:
        """Resize the window until its page has this size. A window has a minimum width."""
        for _ in range(40):
            rect, inner = self.driver.get_window_rect(), self.evaluate("[innerWidth, innerHeight]")
            if inner == [size["width"], size["height"]]:
                break
            width, height = (size[name] + rect[name] - part for name, part in zip(size, inner, strict=True))
            self.driver.set_window_rect(0, 0, width, height)
            self.wait_for_timeout(50)

    def screenshot(self) -> bytes:
        return self.driver.get_screenshot_as_png()


class Mouse:
    """The mouse, with Playwright's interface."""

    def __init__(self, driver: webdriver.WebKitGTK) -> None:
        self.at, self.builder = (0, 0), ActionBuilder(driver, mouse=PointerInput("mouse", "mouse"), duration=0)

    def move(self, x: float, y: float, *, steps: int = 1) -> None:
        x0, y0 = self.at
        for i in range(1, steps + 1):
            share = i / steps
            self.builder.pointer_action.move_to_location(round(x0 + share * (x - x0)), round(y0 + share * (y - y0)))
        self.builder.perform()
        self.at = (x, y)

    def down(self, *, button: str = "left") -> None:
        self.builder.pointer_action.pointer_down(_BUTTONS[button])
        self.builder.perform()

    def up(self, *, button: str = "left") -> None:
        self.builder.pointer_action.pointer_up(_BUTTONS[button])
        self.builder.perform()

    def click(self, x: float, y: float) -> None:
        self.move(x, y)
        self.down()
        self.up()


class Keyboard:
    """The keyboard, with Playwright's interface."""

    def __init__(self, driver: webdriver.WebKitGTK) -> None:
        self.driver = driver

    def press(self, keys: str) -> None:
        """Press a key, such as ArrowLeft, a or Control+z."""
        # A plus at the end is itself the key.
        *modifiers, key = map(_character, re.split(r"\+(?=.)", keys))
        chain = ActionChains(self.driver, duration=0)
        for modifier in modifiers:
            chain.key_down(modifier)
        chain.send_keys(key)
        for modifier in modifiers:
            chain.key_up(modifier)
        chain.perform()

    def type(self, text: str) -> None:
        ActionChains(self.driver, duration=0).send_keys(text).perform()


def _character(key: str) -> str:
    """Return WebDriver's character for a key's name."""
    return getattr(Keys, re.sub(r"(?<=[a-z])(?=[A-Z])", "_", key).upper(), key) if len(key) > 1 else key
