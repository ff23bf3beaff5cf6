// The comparison of the machine with the plain mass: two clock hands, the sentences below them, the gauge, and the readouts.
// All of these light up when the two are in step.

import { fill, fixed, number, withUnit } from "../components/sentences.js";
import { FORMULAS } from "./formulas.js";
import { TURN } from "./motion.js";
import { finder } from "./parts.js";
import { element, put, set } from "./svg.js";
import { WORDS } from "./texts.js";

const LEAST = 0.01; // turns, the smallest visible angle between the hands
const IN_STEP = LEAST / 1e6; // turns per period: no visible difference even after a million periods
const NEARLY = 1 / 500; // turns per period: the next step of a slider would be farther away

/** Classify the distance of the two frequencies: "in-step", "nearly" or "apart". */
function nearness({ Omega, plain }) {
  const turnsPerPeriod = Math.abs(Omega / plain - 1);
  return turnsPerPeriod < IN_STEP ? "in-step" : turnsPerPeriod < NEARLY ? "nearly" : "apart";
}

/** Return a sentence about the present angle between the hands. Before the release neither hand is ahead. */
function leadSentence({ phase, plainPhase, periods }) {
  const turns = (phase - plainPhase) / TURN, apart = Math.abs(turns);
  const values = { turns: fixed(apart, 2), periods: fixed(Math.abs(periods), 1), least: fixed(LEAST, 2) };
  if (Math.abs(periods) < 0.05) return WORDS.start;
  if (apart < LEAST) return fill(periods < 0 ? WORDS.start : WORDS.close, values);
  if (periods < 0) return fill(WORDS.before, values);
  return fill(turns > 0 ? WORDS.ahead : WORDS.behind, values);
}

/** Return a sentence: the time until the hands are one full turn apart. */
function partingSentence({ Omega, plain }) {
  const periods = 1 / Math.abs(Omega / plain - 1);
  const turns = periods < 10 ? fixed(periods, 1) : fixed(Math.round(periods), 0);
  const words = { "in-step": WORDS.in_step, nearly: WORDS.nearly, apart: WORDS.parting };
  return fill(words[nearness({ Omega, plain })], { turns, least: fixed(LEAST, 2) });
}

export function makeDial(root) {
  const find = finder(root);
  const readouts = Object.fromEntries(["normalized", "omega", "period"].map((name) => [name, find(`[data-read=${name}]`)]));
  const write = (node, text) => node.textContent === text || (node.textContent = text);
  const limit = FORMULAS.normalized_limit({}), at = (value) => 10 + (180 * value) / limit;
  set(find(".unity"), { x: at(1) });
  for (let value = 0; value <= limit; value += 0.5) {
    element("path", { d: `M${at(value)} ${value === 1 ? 18 : 30}V36` }, find(".gauge .ticks"));
    element("text", { x: at(value), y: 48 }, find(".gauge .ticks")).textContent = fixed(value, value % 1 && 1);
  }

  /** Show a machine's frequencies. `showsNearness` is false while the page must not reveal how near the two are. */
  function machine(solution, showsNearness) {
    readouts.normalized.textContent = number(solution.normalized, 7);
    readouts.omega.textContent = withUnit(number(solution.Omega, 5), "rad/s");
    readouts.period.textContent = withUnit(number(TURN / solution.Omega, 4), "s");
    set(find(".step"), { "data-step": showsNearness ? nearness(solution) : "" });
    write(find(".parting"), partingSentence(solution));
    set(find(".pointer"), { transform: `translate(${at(Math.min(solution.normalized, limit))} 30)` });
  }

  function frame(playback, running) {
    const { phase, plainPhase } = playback;
    const degrees = (angle) => ((angle % TURN) * 360) / TURN, between = ((phase - plainPhase) / TURN) % 1;
    put(find, {
      ".hand.machine": { transform: `rotate(${degrees(phase)})` },
      ".hand.plain": { transform: `rotate(${degrees(plainPhase)})` },
      ".lead": {
        transform: `rotate(${degrees(between > 0 ? plainPhase : phase) - 90})`,
        "stroke-dasharray": `${Math.abs(between)} 1`,
      },
    });
    if (running) write(find(".verdict"), leadSentence(playback));
  }

  return { machine, frame };
}
