// The comparison of the machine with the plain mass: two clock hands, the arrow of the drift, the sentences below them,
// and the readouts. Dial and sentences are highlighted when the two are in step. A computed machine is compared with
// the exact one instead. It is seen once a period, so the exact hand is always at the start.

import { fill, fixed, number, withUnit } from "../sentences.js";
import { TURN } from "./motion.js";
import { finder } from "./parts.js";
import { put, set } from "./svg.js";
import { WORDS } from "./texts.js";

const VISIBLE = 0.01; // turns, the smallest visible angle between the hands
const IN_STEP = VISIBLE / 1e6; // turns per period: no visible difference even after a million periods
const ROUNDING = 1e-14; // the greatest rounding error of Ω²m/k
const NEARLY = 1 / 400; // turns per period: about a step of the slider of m′ to each side
const DRIFT_PERIODS = 3; // the arrow spans the angle that the machine's hand gains in this number of periods
const LEAST_TURNS = 0.001; // the least angle of a computed machine that is a number in its sentence
const LONGEST = 0.96, HEAD = 0.045; // turns: the longest arrow, and the head of any but the shortest

/** The drift [turns per period of the plain mass]: what the machine's hand gains on the other, exactly 0 in step. */
export function driftOf({ Omega, plain }) {
  const drift = Omega / plain - 1;
  return Math.abs(drift) < IN_STEP ? 0 : drift;
}

/** Return whether the machine is in step exactly, not only for a million periods. */
function isExact({ normalized }) {
  return Math.abs(normalized - 1) < ROUNDING;
}

/** Classify a drift: "in-step", "nearly" or "apart". */
function nearness(drift) {
  if (drift === 0) return "in-step";
  return Math.abs(drift) < NEARLY ? "nearly" : "apart";
}

/** Return a sentence about the present angle between the hands. */
function leadSentence({ phase, plainPhase, periods, solution }) {
  const turns = (phase - plainPhase) / TURN, distance = Math.abs(turns);
  if (distance < VISIBLE) {
    const words = Math.abs(periods) < 0.05 ? WORDS.start : WORDS.close;
    return fill(words, { least: fixed(VISIBLE, 2) });
  }
  const side = turns > 0 ? "ahead" : "behind", whole = Math.round(distance);
  if (Math.abs(distance - whole) < VISIBLE) return fill(WORDS[`meets_${side}`], { turns: fixed(whole, 0) });
  const isInStep = nearness(driftOf(solution)) === "in-step";
  return fill(WORDS[isInStep ? `stays_${side}` : side], { turns: fixed(distance, 2) });
}

/** Return a sentence about the angle by which the computed machine is ahead, in turns like the error allowed. */
function computedSentence(lead) {
  const turns = Math.abs(lead) / TURN;
  if (turns < LEAST_TURNS) return fill(WORDS.computed_agrees, { least: fixed(LEAST_TURNS, 3) });
  return fill(WORDS[`computed_${lead > 0 ? "ahead" : "behind"}`], { turns: fixed(turns, turns < 0.1 ? 3 : 2) });
}

/** Return the number of periods in which the machine gains or loses one full turn, as text. */
export function periodsPerTurn(drift) {
  const periods = 1 / Math.abs(drift);
  return fixed(periods, periods < 10 ? 1 : 0);
}

/** Return a sentence about the drift: whether there is none, or the time in which it becomes one full turn. */
function driftSentence(solution) {
  const drift = driftOf(solution);
  if (isExact(solution)) return WORDS.never_parts;
  if (nearness(drift) === "in-step") return fill(WORDS.in_step, { least: fixed(VISIBLE, 2) });
  return fill(drift > 0 ? WORDS.gains : WORDS.loses, { periods: periodsPerTurn(drift) });
}

/** Make the dial. `asked`: the number of periods in the question of this stage, which the sentence counts, or null. */
export function makeDial(root, asked) {
  const find = finder(root);
  const names = ["normalized", "omega", "period"];
  const readouts = Object.fromEntries(names.map((name) => [name, find(`[data-read=${name}]`)]));
  let describedRatio; // Ω²m/k with nine digits, or "exact", of the machine in the sentence about the drift
  find(".key .drift").textContent = fill(WORDS.drift, { periods: DRIFT_PERIODS });

  /** Set the text of a node, if it has changed. */
  function write(node, text) {
    if (node.textContent !== text) node.textContent = text;
  }

  /**
   * Show a machine's frequencies. `showsNearness` is false while the page must not reveal how close both frequencies
   * are.
   */
  function machine(solution, showsNearness) {
    readouts.normalized.textContent = number(solution.normalized, 7);
    readouts.omega.textContent = withUnit(number(solution.Omega, 5), "rad/s");
    readouts.period.textContent = withUnit(number(TURN / solution.Omega, 4), "s");
    const drift = driftOf(solution);
    set(find(".step"), { "data-step": showsNearness ? nearness(drift) : "" });
    drawDrift(showsNearness ? DRIFT_PERIODS * drift : 0);
    const ratio = isExact(solution) ? "exact" : solution.normalized.toPrecision(9);
    if (ratio !== describedRatio) write(find(".parting"), driftSentence(solution));
    describedRatio = ratio;
  }

  /** Write the sentence about the present angle, and up to the moment of a question the periods that have passed. */
  function writeVerdict(playback) {
    if (playback.computed) return write(find(".verdict"), computedSentence(playback.computedLead));
    const sentence = leadSentence(playback), done = playback.fullPeriods;
    const isCounting = asked && done >= 0 && done <= asked;
    write(find(".verdict"), isCounting ? fill(WORDS.counting, { done, periods: asked, sentence }) : sentence);
    // The sentence about the drift would answer the question before its moment.
    find(".step").toggleAttribute("data-counting", isCounting && done < asked);
  }

  /** Compare a computed machine with the exact one. A mark shows the allowed error, `within` turns to each side. */
  function compare({ within }) {
    find(".key .machine").textContent = WORDS.computed_hand;
    find(".key .plain").textContent = WORDS.exact_hand;
    set(find(".dial"), { "aria-label": WORDS.computed_dial });
    set(find(".allowed"), { "stroke-dasharray": `${2 * within} 1`, transform: `rotate(${-90 - 360 * within})` });
    explain(WORDS.once_a_period);
  }

  /** Replace the sentence about the drift until the drift changes. */
  function explain(sentence) {
    write(find(".parting"), sentence);
  }

  /** Draw an arrow from the machine's hand over an angle in turns, clockwise if it is positive. It vanishes at 0. */
  function drawDrift(turns) {
    const length = Math.min(Math.abs(turns), LONGEST), size = Math.min(1, length / HEAD), shaft = length - size * HEAD;
    put(find, {
      ".dial .drift > g": { transform: `scale(${turns < 0 ? -1 : 1} 1)` },
      ".dial .drift circle": { "stroke-dasharray": `${shaft} 1` },
      ".dial .drift path": { transform: `rotate(${180 * (shaft + length)}) translate(0 -43) scale(${size})` },
    });
  }

  /** Draw the hands at a moment. `writesText`: whether the sentence below them is updated, too. */
  function frame(playback, writesText) {
    const { computed } = playback, [own, other] = computed ? [playback.computedLead, 0] : playback.hands;
    const degrees = (angle) => ((angle % TURN) * 360) / TURN;
    const turns = (own - other) / TURN, isWhole = !computed && Math.abs(turns - Math.round(turns)) < VISIBLE;
    // Turns by which the machine's hand is ahead. A whole number, slightly missed, would be drawn as a full circle.
    const lead = isWhole ? 0 : turns % 1;
    put(find, {
      ".hand.machine": { transform: `rotate(${degrees(own)})` },
      ".dial .drift": { transform: `rotate(${degrees(own)})` },
      ".hand.plain": { transform: `rotate(${degrees(other)})` },
      ".lead": {
        transform: `rotate(${degrees(lead > 0 ? other : own) - 90})`,
        "stroke-dasharray": `${Math.abs(lead)} 1`,
      },
    });
    if (writesText) writeVerdict(playback);
  }

  return { machine, compare, explain, frame };
}
