// The comparison of the machine with the plain mass: two clock hands, the sentences below them, the gauge, and the readouts.
// All of these are highlighted when the two are in step.

import { fill, fixed, number, withUnit } from "../components/sentences.js";
import { FORMULAS } from "./formulas.js";
import { TURN } from "./motion.js";
import { finder } from "./parts.js";
import { element, put, set } from "./svg.js";
import { WORDS } from "./texts.js";

const VISIBLE = 0.01; // turns, the smallest visible angle between the hands
const IN_STEP = VISIBLE / 1e6; // turns per period: no visible difference even after a million periods
const NEARLY = 1 / 500; // turns per period: the next step of a slider would be farther away

/** Classify the distance of the two frequencies: "in-step", "nearly" or "apart". */
function nearness({ Omega, plain }) {
  const turnsPerPeriod = Math.abs(Omega / plain - 1);
  if (turnsPerPeriod < IN_STEP) return "in-step";
  return turnsPerPeriod < NEARLY ? "nearly" : "apart";
}

/** Return a sentence about the present angle between the hands. It names the hand that is ahead only after the start. */
function leadSentence({ phase, plainPhase, periods }) {
  const turns = (phase - plainPhase) / TURN, distance = Math.abs(turns);
  const values = { turns: fixed(distance, 2), periods: fixed(Math.abs(periods), 1), least: fixed(VISIBLE, 2) };
  if (Math.abs(periods) < 0.05) return WORDS.start;
  if (distance < VISIBLE) return fill(periods < 0 ? WORDS.start : WORDS.close, values);
  if (periods < 0) return fill(WORDS.before, values);
  return fill(turns > 0 ? WORDS.ahead : WORDS.behind, values);
}

/** Return a sentence: the time until the hands are one full turn apart. */
function partingSentence({ Omega, plain }) {
  const periods = 1 / Math.abs(Omega / plain - 1);
  const rounded = periods < 10 ? fixed(periods, 1) : fixed(Math.round(periods), 0);
  const words = { "in-step": WORDS.in_step, nearly: WORDS.nearly, apart: WORDS.parting };
  return fill(words[nearness({ Omega, plain })], { periods: rounded, least: fixed(VISIBLE, 2) });
}

export function makeDial(root) {
  const find = finder(root);
  const readouts = Object.fromEntries(["normalized", "omega", "period"].map((name) => [name, find(`[data-read=${name}]`)]));
  const limit = FORMULAS.normalized_limit({});
  // The gauge of stage.html is 200 units wide, with a margin of 10 units.
  const gaugeX = (value) => 10 + (180 * value) / limit;
  set(find(".unity"), { x: gaugeX(1) });
  for (let value = 0; value <= limit; value += 0.5) {
    element("path", { d: `M${gaugeX(value)} ${value === 1 ? 18 : 30}V36` }, find(".gauge .ticks"));
    element("text", { x: gaugeX(value), y: 48 }, find(".gauge .ticks")).textContent = fixed(value, Number.isInteger(value) ? 0 : 1);
  }

  /** Set the text of a node, if it has changed. */
  function write(node, text) {
    if (node.textContent !== text) node.textContent = text;
  }

  /** Show a machine's frequencies. `showsNearness` is false while the page must not reveal how close both frequencies are. */
  function machine(solution, showsNearness) {
    readouts.normalized.textContent = number(solution.normalized, 7);
    readouts.omega.textContent = withUnit(number(solution.Omega, 5), "rad/s");
    readouts.period.textContent = withUnit(number(TURN / solution.Omega, 4), "s");
    set(find(".step"), { "data-step": showsNearness ? nearness(solution) : "" });
    write(find(".parting"), partingSentence(solution));
    set(find(".pointer"), { transform: `translate(${gaugeX(Math.min(solution.normalized, limit))} 30)` });
  }

  /** Draw the hands at a moment. `writesText`: whether the sentence below them is updated, too. */
  function frame(playback, writesText) {
    const { phase, plainPhase } = playback;
    const degrees = (angle) => ((angle % TURN) * 360) / TURN;
    const lead = ((phase - plainPhase) / TURN) % 1; // turns by which the machine's hand is ahead
    put(find, {
      ".hand.machine": { transform: `rotate(${degrees(phase)})` },
      ".hand.plain": { transform: `rotate(${degrees(plainPhase)})` },
      ".lead": {
        transform: `rotate(${degrees(lead > 0 ? plainPhase : phase) - 90})`,
        "stroke-dasharray": `${Math.abs(lead)} 1`,
      },
    });
    if (writesText) write(find(".verdict"), leadSentence(playback));
  }

  return { machine, frame };
}
