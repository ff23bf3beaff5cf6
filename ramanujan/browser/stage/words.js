// What a stage says: sentences from WORDS, the note over the picture, news for the page's live region.

import { bus } from "../components/bus.js";
import { atRest } from "../components/lasting.js";
import { fill, fixed, number, withUnit } from "../components/sentences.js";
import { TURN } from "./motion.js";
import { WORDS } from "./texts.js";

const NOTE_TIME = 3000; // ms that a note stays

/** A length to a tenth of a millimetre at most, without zeros at its end. */
export const centimetres = (metres) => withUnit(fixed(metres * 100, 2).replace(/[.,]?0+$/, ""), "cm");

/** The two periods, and how fast the clocks part. */
export function description({ Omega, plain }) {
  const apart = Math.abs(Omega / plain - 1);
  const period = withUnit(number(TURN / Omega, 3), "s");
  if (apart < 1e-12) return fill(WORDS.together, { period });
  return fill(Omega > plain ? WORDS.faster : WORDS.slower, { period, turns: number(1 / apart, 3) });
}

/** Where the machine is, for those who cannot see it. */
export const moment = (phase, time, { hides }) =>
  fill(hides("numbers") ? WORDS.turned : WORDS.moment, {
    turns: fixed(phase / TURN, 2),
    time: withUnit(fixed(time, 2), "s"),
  });

/**
 * The voice of one stage. `note` shows something for a few seconds, `paced` as long as it holds, `describe` and `tell`
 * are for the page's live region, which says a sentence once; what the machine does by itself comes before descriptions.
 */
export function makeVoice(root, { compact, parts, signal }) {
  const node = root.querySelector(".note");
  let message = null, pace = "", described = "", said = "";
  const show = (sentence) => (node.textContent = (message = sentence) ?? pace);
  const say = (sentence, urgent) => compact || bus.publish("say", { sentence, urgent });
  const fade = atRest(NOTE_TIME, () => show(null), signal);
  return {
    note(sentence) {
      show(sentence);
      fade();
    },
    /** The picture is shown at so many times its real speed; said where nobody has chosen that `speed`. */
    paced(factor, speed) {
      const slow = parts.hides("numbers") ? WORDS.in_slow_motion : WORDS.slowed;
      pace = factor === speed ? "" : fill(factor < speed ? slow : WORDS.lapsed, { factor: number(factor, 2) });
      show(message);
    },
    /** The description compares the machine with the plain mass, in numbers. */
    describe(sentence) {
      if (sentence === described || parts.hides("numbers") || parts.hides("clocks")) return;
      described = sentence;
      said = "";
      say(sentence, false);
    },
    /** Say what happened; what happens again and again, as at the edge of the block, is said once. */
    tell(sentence, once = false) {
      if (once && sentence === said) return;
      if (once) said = sentence;
      say(sentence, true);
    },
  };
}
