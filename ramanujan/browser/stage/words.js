// The sentences of a stage: the note over the picture, and announcements for the page's live region.

import { bus } from "../bus.js";
import { debounce } from "../lasting.js";
import { fill, fixed, number, withUnit } from "../sentences.js";
import { driftOf, periodsPerTurn } from "./dial.js";
import { TURN } from "./motion.js";
import { WORDS } from "./texts.js";

const NOTE_TIME = 3000; // ms for which a note is shown

/** A length, rounded to a tenth of a millimetre, without trailing zeros. */
export const centimetres = (metres) => withUnit(fixed(metres * 100, 2).replace(/[.,]?0+$/, ""), "cm");

/** A sentence about the period, and about the rate at which the hands separate. */
export function description(solution) {
  const drift = driftOf(solution);
  const period = withUnit(number(TURN / solution.Omega, 3), "s");
  if (drift === 0) return fill(WORDS.together, { period });
  return fill(drift > 0 ? WORDS.faster : WORDS.slower, { period, turns: periodsPerTurn(drift) });
}

/**
 * A sentence about two machines with the same drift: how a change of k alone, or of the masses alone, affects both
 * frequencies. Null for any other change.
 */
export function sameDriftSentence(before, { m, k }) {
  if ((before.m === m) === (before.k === k)) return null;
  const factor = number(Math.sqrt(k / m / (before.k / before.m)), 3);
  return fill(before.m === m ? WORDS.same_drift_k : WORDS.same_drift_m, { factor });
}

/** A sentence about the present time, for screen readers. */
export const moment = (phase, time, { hides }) =>
  fill(hides("numbers") ? WORDS.turned : WORDS.moment, {
    periods: fixed(phase / TURN, 2),
    time: withUnit(fixed(time, 2), "s"),
  });

/**
 * The voice of one stage. `note` shows a sentence for a few seconds, `showPace` until the pace changes. `describe` and
 * `announce` publish sentences for the page's live region; an announcement takes precedence over a description.
 */
export function makeVoice(root, { compact, parts, signal }) {
  const node = root.querySelector(".note");
  let message = null, paceSentence = "", described = "", announced = "";
  const show = (sentence) => {
    message = sentence;
    node.textContent = message ?? paceSentence;
  };
  const publish = (sentence, { urgent }) => compact || bus.publish("announce", { sentence, urgent });
  const fade = debounce(NOTE_TIME, () => show(null), signal);
  return {
    note(sentence) {
      show(sentence);
      fade();
    },
    /** Show and announce a sentence. */
    say(sentence, options) {
      this.note(sentence);
      this.announce(sentence, options);
    },
    /**
     * Show how many times as fast as in reality the machine moves, unless the reader has chosen this factor as `speed`.
     */
    showPace(factor, speed) {
      const slow = parts.hides("numbers") ? WORDS.in_slow_motion : WORDS.slowed;
      paceSentence = factor === speed ? "" : fill(factor < speed ? slow : WORDS.lapsed, { factor: number(factor, 2) });
      show(message);
    },
    /** Publish a description, unless the numbers or the clocks are hidden; a description reveals both. */
    describe(sentence) {
      if (sentence === described || parts.hides("numbers") || parts.hides("clocks")) return;
      described = sentence;
      announced = "";
      publish(sentence, { urgent: false });
    },
    /**
     * Announce an event. With `once`, a repeated event, such as a collision, is announced once after each description.
     */
    announce(sentence, { once = false } = {}) {
      if (once && sentence === announced) return;
      if (once) announced = sentence;
      publish(sentence, { urgent: true });
    },
  };
}
