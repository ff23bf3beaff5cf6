// Listen: while its button is pressed, both oscillations sound (tones.js), and a sentence says what is heard. The tones
// are loaded at the first press.

import { bus } from "../bus.js";
import { debounce } from "../lasting.js";
import { fill, number } from "../sentences.js";
import { driftOf } from "./dial.js";
import { TURN } from "./motion.js";
import { finder } from "./parts.js";
import { WORDS } from "./texts.js";

const PLAIN_TONE = 330; // Hz, the tone of the plain mass
const COUNTABLE = 20; // beats per second; an ear hears faster beats as two tones
const REST = 700; // ms without a change before a screen reader says the sentence
const START = 3000; // ms; a browser that has not started the sound by then does not play it

/** A sentence about the tones at a drift. */
function heardSentence(drift) {
  const beats = PLAIN_TONE * Math.abs(drift);
  if (beats === 0) return WORDS.one_tone;
  if (beats > COUNTABLE) return fill(WORDS.two_tones, { ratio: number(1 + drift, 3) });
  return fill(WORDS.beats, { beats: number(beats, 2) });
}

/** Return `tune(solution)`, which follows the drawn machine; `toggle()`; and `silence()`. */
export function makeListener(root, { voice, parts }, signal) {
  const find = finder(root), button = find("[data-do=listen]"), heard = find(".heard");
  const announceHeard = debounce(REST, () => {
    const sentence = heard.textContent;
    if (sentence && !parts.hides("hands")) bus.publish("announce", { sentence, urgent: false });
  }, signal);
  let solution = null, isOn = false, isFirst = true, tones = null;

  function write(sentence) {
    if (heard.textContent === sentence) return;
    heard.textContent = sentence;
    announceHeard();
  }

  function say(sentence) {
    voice.note(sentence);
    voice.announce(sentence);
  }

  function tune(drawn = solution) {
    solution = drawn;
    if (!tones) return;
    const drift = driftOf(solution);
    tones.tune(1 + drift);
    write(heardSentence(drift));
  }

  function setOn(on) {
    isOn = on;
    button.ariaPressed = String(on);
  }

  async function listen() {
    setOn(true);
    let context;
    try {
      const { playTones } = await import("./tones.js");
      context = new AudioContext();
      await Promise.race([context.resume(), new Promise((_resolve, reject) => setTimeout(reject, START))]);
      // Meanwhile, the button may have been pressed again, once or twice.
      if (!isOn || tones) return context.close();
      tones = playTones(PLAIN_TONE, context);
      tune();
      if (isFirst) say(fill(WORDS.sped_up, { factor: number((PLAIN_TONE * TURN) / solution.plain, 2) }));
      isFirst = false;
    } catch {
      context?.close();
      setOn(false);
      say(WORDS.no_sound);
    }
  }

  function silence() {
    if (!isOn) return;
    setOn(false);
    write("");
    tones?.stop();
    tones = null;
  }

  document.addEventListener("visibilitychange", () => document.hidden && silence(), { signal });
  document.addEventListener("keydown", ({ key }) => key === "Escape" && silence(), { signal });
  addEventListener("pagehide", silence, { signal });
  signal.addEventListener("abort", silence);
  return { tune, silence, toggle: () => (isOn ? silence() : listen()) };
}
