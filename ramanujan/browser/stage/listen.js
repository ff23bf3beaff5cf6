// Listen: while its button is pressed, both oscillations sound (tones.js), and a sentence says what is heard. The tones
// are loaded at the first press.

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
const FADE = 300; // ms, after which the tones are inaudible

/** A sentence about the tones at a drift. */
function heardSentence(drift) {
  const beats = PLAIN_TONE * Math.abs(drift);
  if (beats === 0) return WORDS.one_tone;
  if (beats > COUNTABLE) return fill(WORDS.two_tones, { ratio: number(1 + drift, 3) });
  return fill(WORDS.beats, { beats: number(beats, 2) });
}

/** Return `tune(solution)`, which follows the drawn machine; `toggle()`; and `silence()`. */
export function makeListener(root, { voice }, signal) {
  const find = finder(root), button = find("[data-do=listen]"), heard = find(".heard");
  const announceHeard = debounce(REST, () => heard.checkVisibility() && voice.announce(heard.textContent), signal);
  let solution = null, isOn = false, context = null, playTones = null;

  function tune(drawn) {
    solution = drawn;
    if (isOn) update();
  }

  /** Let button, tones and sentence follow the machine and `isOn`. */
  function update() {
    const drift = driftOf(solution), sounds = isOn && context?.state === "running";
    const sentence = sounds ? heardSentence(drift) : "";
    button.ariaPressed = String(isOn);
    playTones?.(1 + drift, isOn);
    if (heard.textContent === sentence) return;
    heard.textContent = sentence;
    announceHeard();
  }

  async function listen() {
    isOn = true;
    update();
    try {
      context ??= new AudioContext();
      await Promise.race([context.resume(), new Promise((_resolve, reject) => setTimeout(reject, START))]);
      const { makeTones } = await import("./tones.js");
      if (!isOn) return; // pressed again meanwhile
      if (!playTones) voice.say(fill(WORDS.sped_up, { factor: number((PLAIN_TONE * TURN) / solution.plain, 2) }));
      playTones ??= makeTones(PLAIN_TONE, context);
      update();
    } catch {
      if (!isOn) return;
      silence();
      voice.say(WORDS.no_sound);
    }
  }

  function silence() {
    if (!isOn) return;
    isOn = false;
    update();
    setTimeout(() => isOn || context?.suspend(), FADE);
  }

  document.addEventListener("visibilitychange", () => document.hidden && silence(), { signal });
  document.addEventListener("keydown", ({ key }) => key === "Escape" && silence(), { signal });
  signal.addEventListener("abort", () => {
    silence();
    setTimeout(() => context?.close(), 2 * FADE);
  });
  return { tune, silence, toggle: () => (isOn ? silence() : listen()) };
}
