// What compares the machine with the plain mass: two clock hands, the sentences below them, the gauge, the readouts. When the
// two are in step, all of these light up together.

import { fill, fixed, number, withUnit } from "../components/sentences.js";
import { FORMULAS } from "./formulas.js";
import { TURN } from "./motion.js";
import { finder } from "./parts.js";
import { element, put, set } from "./svg.js";
import { WORDS } from "./texts.js";

const LEAST = 0.01; // of a turn: the smallest angle between the hands that an eye can tell
const IN_STEP = LEAST / 1e6; // turns in a period: not even a million periods would show a difference
const NEARLY = 1 / 500; // turns in a period: close enough that the next step of a slider would only lose it

/** How near the two frequencies are: "in step", "nearly" or "apart". */
function nearness({ Omega, plain }) {
  const parting = Math.abs(Omega / plain - 1);
  return parting < IN_STEP ? "in-step" : parting < NEARLY ? "nearly" : "apart";
}

/** What the hands show now, in a sentence. Before the release they part, too, but nobody is ahead. */
function lead({ phase, plainPhase, periods }) {
  const turns = (phase - plainPhase) / TURN, apart = Math.abs(turns);
  const values = { turns: fixed(apart, 2), periods: fixed(Math.abs(periods), 1), least: fixed(LEAST, 2) };
  if (Math.abs(periods) < 0.05) return WORDS.start;
  if (apart < LEAST) return fill(periods < 0 ? WORDS.start : WORDS.close, values);
  if (periods < 0) return fill(WORDS.before, values);
  return fill(turns > 0 ? WORDS.ahead : WORDS.behind, values);
}

/** How soon the hands are one full turn apart. */
function parting({ Omega, plain }) {
  const periods = 1 / Math.abs(Omega / plain - 1);
  const turns = periods < 10 ? fixed(periods, 1) : fixed(Math.round(periods), 0);
  const words = { "in-step": WORDS.in_step, nearly: WORDS.nearly, apart: WORDS.parting };
  return fill(words[nearness({ Omega, plain })], { turns, least: fixed(LEAST, 2) });
}

export function makeDial(root) {
  const find = finder(root);
  const reads = Object.fromEntries(["normalized", "omega", "period"].map((name) => [name, find(`[data-read=${name}]`)]));
  const write = (node, text) => node.textContent === text || (node.textContent = text);
  const limit = FORMULAS.normalized_limit({}), at = (value) => 10 + (180 * value) / limit;
  set(find(".unity"), { x: at(1) });
  for (let value = 0; value <= limit; value += 0.5) {
    element("path", { d: `M${at(value)} ${value === 1 ? 18 : 30}V36` }, find(".gauge .ticks"));
    element("text", { x: at(value), y: 48 }, find(".gauge .ticks")).textContent = fixed(value, value % 1 && 1);
  }

  /** Without clocks, nothing on the page tells how near the two frequencies are. */
  function machine(solution, clocks) {
    reads.normalized.textContent = number(solution.normalized, 7);
    reads.omega.textContent = withUnit(number(solution.Omega, 5), "rad/s");
    reads.period.textContent = withUnit(number(TURN / solution.Omega, 4), "s");
    set(find(".step"), { "data-step": clocks ? nearness(solution) : "" });
    write(find(".parting"), parting(solution));
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
    if (running) write(find(".verdict"), lead(playback));
  }

  return { machine, frame };
}
