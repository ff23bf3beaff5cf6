// What a stage says: numbers as text, sentences from WORDS, the note over the picture, the live region.

const NOTE_TIME = 3000; // ms that a note stays
const SPEECH_PAUSE = 500; // ms without a change before the scene is described

const digits = (value, precision) => Number(value).toPrecision(precision);
const fill = (sentence, values) => sentence.replace(/\{(\w+)\}/g, (_, name) => values[name]);

/** The two periods, and how fast the clocks part. */
function description({ Omega, plain }, playing) {
  const apart = Math.abs(Omega / plain - 1);
  const sentence = fill(apart < 1e-12 ? WORDS.together : WORDS.apart, {
    period: digits(TURN / Omega, 3),
    side: Omega > plain ? "ahead" : "behind",
    turns: digits(1 / apart, 3),
  });
  return playing ? sentence : `${sentence} ${WORDS.paused}`;
}

/** The voice of one stage: `note` says something for a few seconds, `slowed` as long as it holds, `speak` describes. */
function makeVoice(root, signal) {
  const note = root.querySelector(".note"), region = root.querySelector(".live");
  let message = null, slowing = "", noting = 0, speaking = 0;
  const show = () => (note.textContent = message ?? slowing);
  signal.addEventListener("abort", () => [noting, speaking].forEach(clearTimeout));
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
      slowing = factor < 1 ? fill(WORDS.slowed, { factor: digits(factor * speed, 2) }) : "";
      show();
    },
    speak(sentence) {
      clearTimeout(speaking);
      speaking = setTimeout(() => (region.textContent = sentence()), SPEECH_PAUSE);
    },
  };
}
