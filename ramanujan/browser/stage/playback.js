// The playback of one machine: both phases, the rest of a jump that still fades, and where the motion ends. Pure; needs no page.

import { FORMULAS } from "./formulas.js";
import { TURN, mapValues, sampleAt, stateAt } from "./motion.js";

const SMOOTHING = 0.07; // s, the time in which a change of parameters fades into the picture
const SCAN = TURN / 48; // step of phase in which the end of the way is looked for
const NO_OFFSET = { X: 0, phi: 0, Phi: 0, plain: 0, shift: 0 };

export class Playback {
  phase = 0; // of the machine, Ωt: it stays when parameters change, so that the picture does not jump
  plainPhase = 0; // of the plain mass
  together = 0; // the plain mass's phase when both hands started together
  keeps = false; // whether the hands keep the angle between them while the machine changes
  offset = NO_OFFSET;
  exit = null; // the phase at which the machine has left its place, if somebody has gone beyond it

  /**
   * Take a machine: its parameters, its solution, samples in place of the exact motion or a computed one beside it, what tells
   * that it has left, and from where it is seen.
   */
  take({ parameters, solution, samples, computed, leaves, seenFrom }) {
    const ratio = this.solution && this.solution.Omega / this.solution.plain;
    Object.assign(this, { parameters, solution, samples, computed, leaves, seenFrom });
    this.exit = null;
    // The clocks compare frequencies: they start together whenever these change.
    if (!this.keeps && ratio !== solution.Omega / solution.plain) this.plainPhase = this.together = this.phase;
  }

  /** How many periods of the plain mass ago both hands started together. */
  get periods() {
    return (this.plainPhase - this.together) / TURN;
  }

  /** The time [s] since release. */
  get time() {
    return this.phase / this.solution.Omega;
  }

  /** Coordinates and rates at a phase, with the plain mass's displacement and the way of the view over the floor [m]. */
  at(phase) {
    const time = phase / this.solution.Omega;
    const state = stateAt(this.solution, phase, time, this.samples && sampleAt(this.samples, phase));
    const plain = this.parameters.compression * Math.cos(this.plainPhase);
    const shift = this.seenFrom === "block" ? FORMULAS.displacement.block(state) : this.solution.drift * time;
    return { ...state, plain, shift };
  }

  /** Where the computed machine is, if there is one beside the exact one. */
  rival() {
    return this.computed && stateAt(this.solution, this.phase, this.time, sampleAt(this.computed, this.phase));
  }

  now() {
    return this.at(this.exit === null ? this.phase : Math.min(this.phase, this.exit));
  }

  drawn() {
    return mapValues(this.now(), (value, name) => value + (this.offset[name] ?? 0));
  }

  /** Let the picture flow from a state that was drawn to the present one. */
  flowFrom(before) {
    const now = this.now();
    this.offset = mapValues(NO_OFFSET, (_, name) => before[name] - now[name]);
  }

  /** Let some of the last jump fade; return whether there was any. */
  fade(elapsed) {
    const fading = Object.values(this.offset).some((rest) => Math.abs(rest) > 1e-6);
    this.offset = fading ? mapValues(this.offset, (rest) => rest * Math.exp(-elapsed / SMOOTHING)) : NO_OFFSET;
    return fading;
  }

  reset() {
    this.phase = this.plainPhase = this.together = 0;
    this.exit = null;
  }

  /** Let time pass. Return why the way has ended, or null. `periods`: after so many the motion begins again. */
  advance(seconds, periods) {
    this.phase += this.solution.Omega * seconds;
    this.plainPhase += this.solution.plain * seconds;
    if (this.exit !== null && this.phase > this.exit) return this.leaves(this.at(this.exit + SCAN)) ?? "edge";
    if (this.phase > this.end) return "ended";
    const left = this.leaves(this.now());
    if (left || !periods || this.phase <= TURN * periods) return left;
    if (!this.periodic()) return "again";
    this.phase -= TURN * periods;
    return null;
  }

  /** Go to a phase and stay there; the plain mass goes by the same time. Return why the machine cannot follow, or null. */
  goTo(phase) {
    this.plainPhase += ((phase - this.phase) * this.solution.plain) / this.solution.Omega;
    this.phase = phase;
    this.exit = this.periodic() ? null : this.findExit(phase);
    return this.exit === null ? null : this.leaves(this.at(this.exit + SCAN)) ?? "edge";
  }

  /** Go to a time since release, for both clocks. */
  goToTime(time) {
    this.plainPhase = this.solution.plain * time;
    this.together = 0;
    this.phase = this.solution.Omega * time;
    return this.goTo(this.phase);
  }

  /** Give the plain mass this phase; from it follows when both hands started together. */
  meet(plainPhase) {
    const gained = this.solution.Omega / this.solution.plain - 1;
    this.plainPhase = plainPhase;
    this.together = Math.abs(gained) > 1e-9 ? plainPhase - (this.phase - plainPhase) / gained : 0;
  }

  /** Whether every period is like the first. */
  periodic() {
    const { X, Phi } = this.solution.motion;
    return !this.samples && Math.abs(X.b) < 1e-12 && Math.abs(Phi.b) < 1e-12;
  }

  /** The phase at which a computed motion ends. */
  get end() {
    const run = this.samples ?? this.computed;
    return run ? (TURN * (run.q.length - 1)) / run.per_period : Infinity;
  }

  /** The phase at which the machine first leaves its place on the way to this one, or null. */
  findExit(phase) {
    for (let end = SCAN; end < phase + SCAN; end += SCAN) {
      if (!this.leaves(this.at(Math.min(end, phase)))) continue;
      let [inside, outside] = [end - SCAN, Math.min(end, phase)];
      for (let i = 0; i < 30; i++) {
        const middle = (inside + outside) / 2;
        if (this.leaves(this.at(middle))) outside = middle;
        else inside = middle;
      }
      return inside;
    }
    return null;
  }
}
