"""The standalone file: its size, no requests, exact numbers, from disk and in a frame of another site."""

import gzip
import io
import random
import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy as sp
from PIL import Image
from playwright.sync_api import Frame, Page, expect

from ramanujan import UNIT_MASS_RATIO
from ramanujan.derivation.model import k, m, m_prime
from ramanujan.shell.parameters import PARAMETERS
from ramanujan.standalone import html
from tests.checks.bare import serving
from tests.checks.browser import next_frame
from tests.checks.engines import new_context
from tests.checks.reference import natural_frequency_squared

MACHINE_KEYS = ("k", "m", "m_prime")
"""The last one changes the drift."""
READY = "globalThis.ramanujan?.last('drawn/oscillator')"
STAGE = "document.querySelector('.st-key-stage > div').shadowRoot"
READ = f"""() => {{
  const root = {STAGE};
  const texts = [...root.querySelectorAll("[data-read]")].map((node) => [node.dataset.read, node.textContent]);
  const hands = ["machine", "plain"].map((name) => root.querySelector(`.hand.${{name}}`).getAttribute("transform"));
  const [lead, parting] = [".verdict", ".parting"].map((name) => root.querySelector(name).textContent);
  const note = document.querySelector(".note").textContent;
  return {{ drawn: {READY}, hands, lead, parting, note, ...Object.fromEntries(texts) }};
}}"""
"""The drawn machine, the readouts, the hands, the sentences about the hands, and the note below the sliders."""
TYPE = """([key, text]) => {
  const box = document.querySelector(`.st-key-${key}_exact > div`).shadowRoot.querySelector("input");
  box.value = text;
  box.dispatchEvent(new Event("change"));
  return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
}"""
"""Enter a text into a slider's box."""
SEEK = """(time) => {
  ramanujan.publish("seek/oscillator", { time });
  return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
}"""

MARK = "getComputedStyle(document.querySelector('.st-key-m_prime.slider'), '::after').content"
"""The label of the marked mass ratio at the slider of m′."""


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file on disk."""
    path = tmp_path_factory.mktemp("standalone") / "ramanujans-oscillator.html"
    path.write_text(html(), encoding="utf-8")
    return path


def opened(page: object, address: str) -> object:
    """Open the file at an address and wait for the machine."""
    page.goto(address)
    page.wait_for_function(READY)
    return page


def number(text: str) -> float:
    """Return the number at the beginning of a readout."""
    return float(re.match(r"[\d.\u202f]+", text)[0].replace("\u202f", ""))


def exact(values: dict[str, float]) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Return Ω² and k/m of a machine, from Kane's method, with 40 digits."""
    parameters = {symbol: sp.Rational(values[name]) for symbol, name in ((m, "m"), (m_prime, "m_prime"), (k, "k"))}
    with mpmath.workdps(40):
        return tuple(mpmath.mpf(each.subs(parameters).evalf(40)) for each in (natural_frequency_squared(), k / m))


def test_the_file_is_small(file):
    content = file.read_bytes()
    assert len(content) <= 350_000
    assert len(gzip.compress(content)) <= 120_000


def test_the_file_runs_from_disk(window, file, engine):
    """The address sets the machine; boxes accept fractions and commas. Invalid texts cause a message."""
    page = opened(window(), f"{file.as_uri()}#m_prime=9/8&k=20,5&m=9&compression=1,200&x=1&speed=7&from=block")
    state = page.evaluate(READ)
    assert state["drawn"]["ratio"] == 1.125
    assert state["drawn"]["parameters"]["k"] == 20.5
    for sentence in (
        "The value of m in the address",
        "The value of compression in the address was ignored: 1,200 can mean 1.200 or 1200.",
        "The value of speed in the address",
    ):
        assert sentence in state["note"]
    assert state["note"].count(" in the address") == 3
    page.wait_for_function("location.hash === '#m_prime=1.125&k=20.5&from=block'")
    page.evaluate(TYPE, ["m_prime", "5/6"])
    state = page.evaluate(READ)
    assert state["drawn"]["normalized"] == pytest.approx(9 / 8, rel=1e-15)
    assert state["note"] == ""
    messages = {
        "x": "Type m′ as a number such as 1.25 or as a fraction such as 9/8.",
        "1,200": "1,200 can mean 1.200 or 1200. Type one of these two for m′.",
        "99": "m′ must be between 0.05 and 10\u202fkg.",
    }
    for text, sentence in messages.items():
        page.evaluate(TYPE, ["m_prime", text])
        state = page.evaluate(READ)
        assert state["note"] == f"{sentence} The old value, 0.8333333\u202fkg, was kept."
        assert state["drawn"]["ratio"] == 5 / 6
    # With reduced motion the story ends at once.
    page.evaluate("document.querySelector('.st-key-story > div').shadowRoot.querySelector('button').click()")
    page.wait_for_function("Math.abs(ramanujan.last('drawn/oscillator').normalized - 1) < 1e-14")
    page.wait_for_function("location.hash.includes('m_prime=1.127')")
    # The label of the mark, from the style sheet.
    assert page.evaluate(MARK).startswith('"↑ ')
    if engine != "webkit":
        check_mouse(page)


def check_mouse(page) -> None:
    """Check that the mouse sets every mass near the two marks, and stops exactly at the ratio in step."""
    left, top, width = page.evaluate(
        "(({ x, y, width }) => [x, y, width])(document.querySelector('.st-key-m_prime').getBoundingClientRect())"
    )
    box = "document.querySelector('.st-key-m_prime_exact > div').shadowRoot.querySelector('input').value"
    kilogram = (width - 16) / 2.15
    page.mouse.move(left + 8 + 0.95 * kilogram, top + 14)
    page.mouse.down()
    for mass in [0.8 + 0.6 * i / 19 for i in range(20)]:
        # Firefox's thumb is wider than the one that the style sheet assumes.
        for off in (0, 2):
            page.mouse.move(round(left + 8 + (mass - 0.05) * kilogram) + off, top + 14)
            next_frame(page)
            if abs(float(page.evaluate(box)) - mass) <= 0.01:
                break
        else:
            pytest.fail(f"{mass} kg was not reached")
    page.mouse.move(left + 8 + (UNIT_MASS_RATIO - 0.05) * kilogram + 1, top + 14)
    page.wait_for_function(f"{READY}.ratio === {UNIT_MASS_RATIO!r}")
    page.mouse.up()
    page.wait_for_function(f"ramanujan.last('exact/m_prime').value === {UNIT_MASS_RATIO!r}")


def test_a_saved_file_begins_with_its_settings(window, file, tmp_path):
    """A link overrides the settings in the file, also if all values of the link are the defaults."""
    saved, page = tmp_path / "saved.html", window()

    def save(settings: str) -> str:
        text = file.read_text(encoding="utf-8").replace('data-standalone=""', f'data-standalone="{settings}"', 1)
        saved.write_text(text, encoding="utf-8")
        return saved.as_uri()

    opened(page, save("k=20.5&amp;layers=energy"))
    assert page.evaluate(READ)["drawn"]["parameters"]["k"] == 20.5
    assert page.evaluate(f"{STAGE}.querySelector('[data-layer=energy] input').checked")
    page.goto("about:blank")
    opened(page, save("k=20.5"))
    page.evaluate(TYPE, ["k", "10"])
    page.wait_for_function("location.hash === ''")
    link = page.evaluate("location.href")
    page.goto("about:blank")
    opened(page, link)
    assert page.evaluate(READ)["drawn"]["parameters"]["k"] == 10


def test_a_page_saved_by_the_browser_is_the_same_page(window, file, tmp_path):
    """A browser saves the elements of the page, with those that the script has added, and without shadow trees."""
    saved, page = tmp_path / "saved.html", opened(window(), f"{file.as_uri()}#k=20.5&layers=energy")
    page.evaluate(TYPE, ["m", "99"])
    before = page.evaluate(READ)
    assert before.pop("note")
    saved.write_text(f"<!doctype html>{page.evaluate('document.documentElement.outerHTML')}", encoding="utf-8")
    page.goto("about:blank")
    opened(page, saved.as_uri())
    assert page.evaluate(READ) == before | {"note": ""}
    assert page.evaluate("location.hash") == "#k=20.5&layers=energy"
    for key, value in {"m_prime": 3, "m": 1.5, "k": 9, "compression": 4}.items():
        page.evaluate(TYPE, [key, str(value)])
        values = f"[...document.querySelectorAll('.st-key-{key} input')].map((input) => input.value)"
        assert page.evaluate(values) == [str(value)]
    assert page.evaluate(READ)["drawn"]["ratio"] == 2
    page.wait_for_function("location.hash === '#k=9&layers=energy&m_prime=3&m=1.5&compression=4'")
    assert page.evaluate("`#${document.documentElement.dataset.standalone}` === location.hash")


@pytest.mark.parametrize("engine", ["chromium"])
def test_the_file_agrees_with_exact_frequencies(window, file, engine):
    """Check Ω²m/k, the readouts, both hands and the sentences about them after some periods, for 40 machines."""
    page, chance = opened(window(), file.as_uri()), random.Random(1729)
    for _ in range(40):
        values = {}
        for name in MACHINE_KEYS:
            parameter = PARAMETERS[name]
            values[name] = round(chance.uniform(parameter.least, parameter.most), 3)
            page.evaluate(TYPE, [name, str(values[name])])
        omega_squared, plain_squared = exact(values)
        time = float(chance.uniform(1, 70) / mpmath.sqrt(plain_squared))
        page.evaluate(SEEK, time)
        state = page.evaluate(READ)
        normalized = float(omega_squared / plain_squared)
        assert state["drawn"]["normalized"] == pytest.approx(normalized, rel=1e-14)
        assert number(state["normalized"]) == pytest.approx(normalized, abs=6e-7)
        assert number(state["omega"]) == pytest.approx(float(mpmath.sqrt(omega_squared)), rel=6e-5)
        for hand, squared in zip(state["hands"], (omega_squared, plain_squared), strict=True):
            degrees = float(re.search(r"\((-?[\d.e-]+)", hand)[1])
            turns = degrees / 360 - float(mpmath.sqrt(squared) * time / (2 * mpmath.pi))
            assert turns - round(turns) == pytest.approx(0, abs=1e-4)
        check_sentences(state, omega_squared, plain_squared, time)


def check_sentences(state: dict, omega_squared: mpmath.mpf, plain_squared: mpmath.mpf, time: float) -> None:
    """Check the sentences about the angle between the hands after a time [s], and about the drift."""
    plain = mpmath.sqrt(plain_squared)
    periods, gain = plain * time / (2 * mpmath.pi), mpmath.sqrt(omega_squared) / plain - 1
    ahead = float(gain * periods)
    if apart := re.search(r"is ([\d.]+) turns (\w+)", state["lead"]):
        assert float(apart[1]) == pytest.approx(abs(ahead), abs=0.0051)
        assert apart[2] == ("ahead" if gain > 0 else "behind")
    else:
        assert ahead == pytest.approx(round(ahead), abs=0.01), "the hands meet"
    verb, apart = re.search(r"machine (\w+) one full turn in ([\d.]+) periods", state["parting"]).groups()
    assert verb == ("gains" if gain > 0 else "loses")
    apart = float(apart)
    assert apart == pytest.approx(float(1 / abs(gain)), abs=0.51 if apart >= 10 else 0.051)


@pytest.mark.parametrize("engine", ["chromium"])
def test_the_ring_on_the_curve_is_at_the_machine(window, file, engine):
    page = opened(window(), file.as_uri())
    centre = "({ cx, cy }) => [cx, cy].map((coordinate) => coordinate.baseVal.value)"
    ring, star = page.locator(".curve .ring"), page.locator(".curve path.unit")
    assert ring.evaluate(centre) == pytest.approx(page.locator(".curve .equal").evaluate(centre), abs=0.01)
    expect(page.get_by_text("Hardy’s taxi")).to_be_hidden()
    # A click near the star selects the ratio in step, and a sentence says why it matters.
    star.click(force=True)
    expect(page.get_by_text("Hardy’s taxi")).to_be_visible()
    page.wait_for_function("Math.abs(ramanujan.last('drawn/oscillator').normalized - 1) < 1e-14")
    origin = star.evaluate("({ transform }) => (({ e, f }) => [e, f])(transform.baseVal[0].matrix)")
    assert ring.evaluate(centre) == pytest.approx(origin, abs=0.01)


def test_the_bar_of_a_root_is_above_its_digits(window, file, engine):
    page = opened(window(), file.as_uri())
    page.evaluate("document.querySelector('msqrt mn').scrollIntoView({ block: 'center' })")
    # Until a font is loaded, browsers draw the bar without the digits.
    page.wait_for_function("document.fonts.check('1em Formulas')")
    next_frame(page)
    x, y, width, height = page.evaluate(box_of("document.querySelector('msqrt mn')"))
    picture = Image.open(io.BytesIO(page.screenshot())).convert("L")
    darkness = 255 - np.asarray(picture.crop((x, y - 8, x + width, y + height)), dtype=float).mean(axis=1)
    bar = darkness.argmax()
    # Between bar and digits, a row of pixels is nearly blank.
    assert darkness[bar + 1 : bar + 4].min() < darkness[bar] / 8
    assert darkness[bar + 4 :].max() > darkness[bar] / 4


@pytest.mark.parametrize("engine", ["chromium", "firefox"])
def test_every_formula_fits_on_a_phone(window, file, engine):
    """A formula that is too wide breaks before a term."""
    page = opened(window(390, 844), file.as_uri())
    page.evaluate("document.querySelectorAll('details').forEach((details) => (details.open = true))")
    wide = "[...document.querySelectorAll('.six_steps div')].filter((box) => box.scrollWidth > box.clientWidth)"
    assert page.evaluate(f"{wide}.map((box) => box.textContent)") == []


@pytest.mark.parametrize("engine", ["chromium"])
def test_on_a_phone_the_reason_takes_the_place_of_the_question(window, file, engine):
    """Nothing moves then, and the title stays uncovered."""
    page = opened(window(390, 844), file.as_uri())
    rows = "[...document.querySelectorAll('h1, .head, .st-key-story, .st-key-m_prime, .st-key-stage')]"
    heights = f"{rows}.map((row) => row.getBoundingClientRect().top)"
    before, question = page.evaluate(heights), page.locator(".question")
    expect(question).to_be_visible()
    page.evaluate(TYPE, ["m_prime", repr(UNIT_MASS_RATIO)])
    expect(page.get_by_text("Hardy’s taxi")).to_be_visible()
    expect(question).to_be_hidden()
    assert page.evaluate(heights) == before
    page.locator("h1").click(trial=True)  # fails if something covers the title


@pytest.mark.parametrize("engine", ["chromium"])
def test_without_scripts_the_file_shows_still_pictures(browsers, file, engine):
    context = new_context(browsers(engine), java_script_enabled=False)
    page = context.new_page()
    page.goto(file.as_uri())
    for part in (".st-key-stage svg", ".st-key-stage p", ".curve .line"):
        expect(page.locator(part)).to_be_visible()
    expect(page.locator(".hint")).to_be_hidden()
    context.close()


@contextmanager
def framed_by_another_site(file: Path, folder: Path) -> Iterator[str]:
    """Serve the file, and on another site a page with the file in a sandboxed frame; yield the page's address."""
    handlers = [partial(SimpleHTTPRequestHandler, directory=path) for path in (file.parent, folder)]
    with serving(handlers[0]) as port, serving(handlers[1]) as other:
        source = f"http://localhost:{port}/{file.name}#k=20"
        frame = f'<iframe sandbox="allow-scripts" src="{source}" width="900" height="700"></iframe>'
        (folder / "course.html").write_text(f'<link rel="icon" href="data:,">{frame}')
        yield f"http://127.0.0.1:{other}/course.html"


@pytest.mark.parametrize("engine", ["chromium", "firefox"])
def test_the_file_in_a_frame_of_another_site_makes_no_request(browsers, file, engine, tmp_path):
    """The frame is sandboxed, with the content security policy in effect; keyboard and touch work in it."""
    context = new_context(browsers(engine), viewport={"width": 1000, "height": 760}, reduced_motion="reduce")
    page, requests, errors = context.new_page(), [], []
    page.on("request", lambda request: requests.append(request.url))
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    with framed_by_another_site(file, tmp_path) as address:
        page.goto(address)
        inside = page.frames[1]
        # The policy blocks Playwright's scripts, so the test uses only visible elements.
        normalized = inside.locator("[data-read=normalized]")
        expect(normalized).to_have_text("1.050505")
        expect(inside.locator(".st-key-k input[type=range]")).to_have_value("20")
        slider = inside.locator(".st-key-m_prime input[type=range]")
        if engine == "chromium":
            slider.click(position={"x": 100, "y": 10})
            page.keyboard.press("ArrowRight")
            drag_slab_by_touch(page, inside)
            expect(inside.locator(".st-key-compression input[type=range]")).not_to_have_value("8")
        else:  # Playwright's mouse and keys do not reach a frame in Firefox
            moved = "input.stepUp(); for (const type of ['input', 'change']) input.dispatchEvent(new Event(type))"
            slider.evaluate(f"(input) => {{ {moved} }}")
        expect(slider).not_to_have_value("1")
        expect(normalized).not_to_have_text("1.050505")
    sent = [url for url in requests if not url.startswith("data:") and not url.endswith("favicon.ico")]
    assert [url.rpartition("/")[2].partition("#")[0] for url in sent] == ["course.html", file.name]
    assert errors == []
    assert context.cookies() == []
    context.close()


def drag_slab_by_touch(page: Page, inside: Frame) -> None:
    """Drag the slab 60 px to the left with a finger."""
    client, box = page.context.new_cdp_session(page), inside.locator(".body.slab .grip").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    for kind, by in (("touchStart", 0), ("touchMove", -30), ("touchMove", -60), ("touchEnd", None)):
        points = [] if by is None else [{"x": x + by, "y": y}]
        client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})


def box_of(node: str) -> str:
    """Return the JavaScript expression for a node's position and size [px]."""
    return f"(({{ x, y, width, height }}) => [x, y, width, height])({node}.getBoundingClientRect())"


@pytest.mark.parametrize("engine", ["webkit"])
def test_the_file_answers_in_a_frame_of_another_site_in_webkit(window, file, engine, tmp_path):
    """The frame is sandboxed. The keyboard moves a slider, and the mouse drags the slab. The driver has no touch."""
    page = window(1000, 760)
    with framed_by_another_site(file, tmp_path) as address:
        page.goto(address)
        frame_x, frame_y, *_size = page.evaluate(box_of("document.querySelector('iframe')"))
        page.enter_frame()
        page.wait_for_function(READY)
        assert page.evaluate("self.origin") == "null"
        # Only keys move WebKit's focus into a frame: to the button, to the box of m′, and to its slider.
        for key in ("Tab", "Tab", "Tab", "ArrowRight"):
            page.keyboard.press(key)
        page.wait_for_function("location.hash === '#k=20&m_prime=1.01'")
        page.wait_for_function("ramanujan.last('drawn/oscillator').ratio === 1.01")
        x, y, width, height = page.evaluate(box_of(f"{STAGE}.querySelector('.grip')"))
        x, y = frame_x + x + width / 2, frame_y + y + height / 2
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x - 60, y, steps=3)
        page.mouse.up()
        page.wait_for_function("ramanujan.last('drawn/oscillator').parameters.compression < 0.05")
        page.wait_for_function("location.hash.includes('compression=')")
