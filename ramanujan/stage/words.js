// What a stage says: numbers as text, sentences from WORDS, the note over the picture, news for the page's live region.

const NOTE_TIME = 3000; // ms that a note stays

const digits = (value, precision) => Number(value).toPrecision(precision);
const fill = (sentence, values) => sentence.replace(/\{(\w+)\}/g, (_, name) => values[name]);
const centimetres = (metres) => Number((metres * 100).toFixed(2));

/** The picture in one sentence, with the bodies that are there. */
function pictured(parameters) {
  const [left, right, top] = ROLLERS.map((name) => shapeOf(parameters[`beta_${name}`]));
  return fill(WORDS.picture, { left, right, top });
}

/** The two periods, and how fast the clocks part. */
function description({ Omega, plain }) {
  const apart = Math.abs(Omega / plain - 1);
  const period = digits(TURN / Omega, 3);
  if (apart < 1e-12) return fill(WORDS.together, { period });
  return fill(Omega > plain ? WORDS.faster : WORDS.slower, { period, turns: digits(1 / apart, 3) });
}

/** Where the machine is, for those who cannot see it. */
const moment = (phase, time, { hides }) =>
  fill(hides("numbers") ? WORDS.turned : WORDS.moment, { turns: (phase / TURN).toFixed(2), time: time.toFixed(2) });

/**
 * The voice of one stage. `note` shows something for a few seconds, `slowed` as long as it holds, `describe` and `tell`
 * are for the page's live region, which says a sentence once; what the machine does by itself comes before descriptions.
 */
function makeVoice(root, { compact, parts, signal }) {
  const node = root.querySelector(".note");
  let message = null, slowing = "", noting = 0, described = "", told = "";
  const show = () => (node.textContent = message ?? slowing);
  const say = (sentence, urgent) => compact || bus.publish("say", { sentence, urgent });
  signal.addEventListener("abort", () => clearTimeout(noting));
  return {
    note(sentence) {
      message = sentence;
      clearTimeout(noting);
      noting = setTimeout(() => {
        message = null;
        show();
      }, NOTE_TIME);
      show();
    },
    slowed(factor, speed) {
      const sentence = parts.hides("numbers") ? WORDS.in_slow_motion : WORDS.slowed;
      slowing = factor < 1 ? fill(sentence, { factor: digits(factor * speed, 2) }) : "";
      show();
    },
    /** The description compares the machine with the plain mass, in numbers. */
    describe(sentence) {
      if (sentence === described || parts.hides("numbers") || parts.hides("clocks")) return;
      described = sentence;
      told = "";
      say(sentence, false);
    },
    /** Say what happened; what happens again and again, as at the edge of the block, is said once. */
    tell(sentence, once = false) {
      if (once && sentence === told) return;
      if (once) told = sentence;
      say(sentence, true);
    },
  };
}
