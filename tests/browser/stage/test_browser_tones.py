"""Listen: the two tones of a stage, computed by the browser without playing them; and its button."""

import base64
import math

import numpy as np
import pytest

from ramanujan import UNIT_MASS_RATIO, Oscillator
from ramanujan.browser import stage
from ramanujan.browser.stage.words import SENTENCES
from tests.checks.browser import STAGE, module
from tests.checks.picture import Picture

CHANGED_WHILE_RENDERED = pytest.mark.parametrize("engine", ["chromium"])
"""Firefox cannot suspend an OfflineAudioContext for a change of the tones."""

RATE = 44_100
"""Samples per second."""
PLAIN_TONE = 330.0
"""The frequency of the plain mass [Hz]."""
RATIOS = (0.01, 0.05, 0.1, 0.5, 0.9, 1.0, 1.2, 2.0, 5.0, 20.0)
"""Mass ratios m′/m."""

RENDER = """
async ([plain, seconds, rate, first, changes, end]) => {
  const { makeTones } = await MODULE, context = new OfflineAudioContext(1, seconds * rate, rate);
  const play = makeTones(plain, context);
  play(first, true);
  const playAt = async (time, ratio, isOn) => {
    await context.suspend(time);
    play(ratio, isOn);
    context.resume();
  };
  for (const [time, ratio] of changes) playAt(time, ratio, true);
  if (end) playAt(end, changes.at(-1)?.[1] ?? first, false);
  const sound = await context.startRendering();
  const bytes = new Uint8Array(sound.getChannelData(0).buffer);
  let text = "";
  for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
  return btoa(text);
}
""".replace("MODULE", module("stage/tones"))


def frequency_ratio(epsilon: float) -> float:
    """Return Ω/√(k/m) of the core."""
    return math.sqrt(Oscillator(1.0, epsilon, 1.0).normalized_frequency_squared)


@pytest.fixture
def play(bare):
    """Return a function that renders the tones as an array of samples."""
    page = bare().page

    def render(seconds: float, first: float, changes=(), end: float | None = None) -> np.ndarray:
        text = page.evaluate(RENDER, [PLAIN_TONE, seconds, RATE, first, list(changes), end])
        return np.frombuffer(base64.b64decode(text), dtype=np.float32).astype(float)

    return render


def peaks(sound: np.ndarray, count: int) -> list[float]:
    """Return the frequencies of the largest peaks of the spectrum below 500 Hz [Hz], in ascending order."""
    padded = 16 * len(sound)
    spectrum = np.abs(np.fft.rfft(sound * np.blackman(len(sound)), padded))
    spectrum = spectrum[: int(500 * padded / RATE)]
    inner = spectrum[1:-1]
    places = 1 + np.flatnonzero((inner > spectrum[:-2]) & (inner > spectrum[2:]))
    largest = sorted(places, key=spectrum.__getitem__)[-count:]
    return sorted(place * RATE / padded for place in largest)


def envelope(sound: np.ndarray) -> np.ndarray:
    """Return the root mean square over each period of the plain mass's tone."""
    window = round(RATE / PLAIN_TONE)
    power = np.convolve(sound**2, np.ones(window) / window, "valid")
    return np.sqrt(power)


@CHANGED_WHILE_RENDERED
def test_the_tones_have_the_frequencies_of_machine_and_plain_mass(play):
    for epsilon in RATIOS:
        expected = sorted([PLAIN_TONE, PLAIN_TONE * frequency_ratio(epsilon)])
        # The window of Blackman separates two frequencies if they are more than 6/seconds apart.
        heard = peaks(play(4.0, frequency_ratio(epsilon))[RATE // 2 :], 2)
        assert heard == pytest.approx(expected, abs=0.1)


@CHANGED_WHILE_RENDERED
def test_the_beats_are_the_turns_between_the_hands(play):
    for epsilon in (1.0, 1.05, 1.3):
        ratio = frequency_ratio(epsilon)
        loudness = envelope(play(10.5, ratio)[RATE // 2 :])[:: RATE // 1000]
        above = loudness > loudness.mean()
        beats = np.count_nonzero(above[1:] & ~above[:-1])
        turns = 10 * PLAIN_TONE * abs(ratio - 1)
        assert beats == pytest.approx(turns, abs=1)


@CHANGED_WHILE_RENDERED
def test_in_step_there_is_one_steady_tone_however_the_ratio_was_found(play):
    in_step = frequency_ratio(UNIT_MASS_RATIO)
    assert in_step == 1.0
    moved = [(0.5 + i / 60, frequency_ratio(1.0 + 0.12 * i / 60)) for i in range(60)]
    for first, changes in ((in_step, []), (frequency_ratio(1.0), [*moved, (1.55, in_step)])):
        steady = envelope(play(4.0, first, changes)[2 * RATE :])
        assert np.ptp(steady) < 0.01 * steady.mean()
        assert steady.mean() > 0.05


@CHANGED_WHILE_RENDERED
def test_nothing_clicks_and_both_tones_together_stay_below_minus_twelve_decibels(play):
    sweep = [(0.3 + i / 60, 1.3 - 0.6 * i / 60) for i in range(60)]
    sound = play(2.0, 1.3, [*sweep, (1.4, 1.0), (1.5, 0.9)], end=1.7)
    assert np.max(np.abs(sound)) < 10 ** (-12 / 20)
    assert np.max(np.abs(np.diff(sound, prepend=0.0))) < 0.05
    assert np.max(np.abs(sound[: RATE // 1000])) < 0.02
    assert np.max(np.abs(sound[int(1.95 * RATE) :])) < 1e-3


RECORD_CONTEXTS = """() => {
  const Standard = AudioContext;
  globalThis.contexts = [];
  globalThis.AudioContext = class extends Standard {
    constructor() {
      super();
      contexts.push(this);
    }
  };
}"""
RECORD_ANNOUNCEMENTS = """() => {
  globalThis.announced = [];
  ramanujan.subscribe("announce", ({ sentence }) => announced.push(sentence));
}"""
ANSWERED = f"""(refusal) => {STAGE}.querySelector(".heard").textContent
  || {STAGE}.querySelector(".note").textContent === refusal"""
PLAY = "root.querySelector('[data-do=play]').click()"
PAUSE_OF_DESK = '{ layers: "energy", from: "ground", speed: 1, ago: 0, rates: "0,0", turns: "0.2,0.2" }'
MIDDLE_OF_LISTEN = """(() => {
  const { x, y, width, height } = root.querySelector("[data-do=listen]").getBoundingClientRect();
  return [x + width / 2, y + height / 2];
})()"""


def test_listen_starts_and_stops_the_tones(bare):
    picture = Picture(bare())
    picture.show(Oscillator(1.0, 1.0, 10.0), 0.08)
    page = picture.page
    page.evaluate(RECORD_CONTEXTS)
    page.evaluate(RECORD_ANNOUNCEMENTS)
    hidden = stage.payload(picture.machine, picture.compression)
    stops = {
        "button": lambda: page.mouse.click(*picture.find(MIDDLE_OF_LISTEN)),
        "escape": lambda: page.keyboard.press("Escape"),
        "pause": lambda: picture.find(PLAY),
        "scrub": lambda: picture.find("root.querySelector('.scrub input').dispatchEvent(new Event('input'))"),
        "pause at the desk": lambda: page.evaluate(f"ramanujan.publish('view/oscillator', {PAUSE_OF_DESK})"),
        "end of a stop": lambda: picture.bare.put(lambda: stage.publish(hidden, name="oscillator", hide=("motion",))),
    }
    for stop in stops.values():
        picture.find(f"root.querySelector('.stage.playing') || {PLAY}")
        page.mouse.click(*picture.find(MIDDLE_OF_LISTEN))
        page.wait_for_function(ANSWERED, arg=SENTENCES["no_sound"])
        if picture.find("root.querySelector('.note').textContent") == SENTENCES["no_sound"]:
            # A machine without a loudspeaker, in Firefox.
            assert page.evaluate("contexts.every(({ state }) => state !== 'running')")
            assert picture.find("root.querySelector('[data-do=listen]').ariaPressed") == "false"
            return
        assert page.evaluate("contexts[0].state") == "running"
        sentence = picture.find("root.querySelector('.heard').textContent")
        assert sentence.startswith("8.2 beats a second")
        assert picture.find("root.querySelector('[data-do=listen]').ariaPressed") == "true"
        page.wait_for_function("(sentence) => announced.includes(sentence)", arg=sentence)
        page.evaluate("announced.length = 0")
        stop()
        page.wait_for_function("contexts[0].state === 'suspended'")
        if picture.find("Boolean(root.querySelector('.hands'))"):
            assert picture.find("root.querySelector('.heard').textContent") == ""
            assert picture.find("root.querySelector('[data-do=listen]').ariaPressed") == "false"
    # Without motion there is nothing to hear, and the beats would reveal the answer to a stop of the lesson.
    assert not picture.find("root.querySelector('.hands, .heard')")
    assert page.evaluate("contexts.length") == 1
