// The playback of one machine: both phases, the fading offset of a jump, and the end of the motion. Pure; needs no
// page.

import { FORMULAS } from "./formulas.js";
import { TURN, between, clamp, mapValues, sampleAt, stateAt } from "./motion.js";

const SMOOTHING = 0.07; // s, the time in which a change of parameters fades into the picture
const SCAN = TURN / 240; // step of the phase when searching for the end of the motion
const NO_OFFSET = { X: 0, phi: 0, Phi: 0, plain: 0, shift: 0 };

export class Playback {
  phase = 0; // of the machine since the start; after a change of the machine, it goes on from this value
  plainPhase = 0; // of the plain mass, in the same way
  offset = NO_OFFSET;

  /**
   * Set { parameters, solution, samples, computed, collision, seenFrom }. `samples` replace the exact motion, and a
   * `computed` motion is compared with it. `collision` is a function of a state.
   */
  setMachine(machine) {
    Object.assign(this, machine);
  }

  /** Angles of both hands [rad], of the machine first. */
  get hands() {
    return [this.phase, this.plainPhase];
  }

  /** Angular frequencies of both hands [rad/s], 0 before the first machine. */
  get frequencies() {
    const { Omega = 0, plain = 0 } = this.solution ?? {};
    return [Omega, plain];
  }

  /** Periods of the plain mass since the start. */
  get periods() {
    return this.plainPhase / TURN;
  }

  /** The time [s] from the release of this machine to its present state. */
  get time() {
    return this.phase / this.solution.Omega;
  }

  /** Coordinates and rates at a phase, with the displacements of the plain mass and of the view [m]. */
  at(phase) {
    const time = phase / this.solution.Omega;
    const state = stateAt(this.solution, phase, time, this.samples && sampleAt(this.samples, phase));
    const plain = this.parameters.compression * Math.cos(this.plainPhase);
    const shift = this.seenFrom === "block" ? FORMULAS.displacement.block(state) : this.solution.drift * time;
    return { ...state, plain, shift };
  }

  /** The state of the computed machine, if there is one. */
  computedState() {
    return this.computed && stateAt(this.solution, this.phase, this.time, sampleAt(this.computed, this.phase));
  }

  /** The angle by which the computed machine is ahead at the ends of the periods, interpolated between them [rad]. */
  get computedLead() {
    return TURN * between(this.computed.turns, clamp(this.phase / this.end, 0, 1));
  }

  /** The number of full periods of the plain mass that have passed. */
  get fullPeriods() {
    return Math.floor(this.periods + 1e-9);
  }

  /** The energy at a phase, in multiples of that at release. */
  energyAt(phase) {
    return this.samples?.energies ? between(this.samples.energies, clamp(phase / this.end, 0, 1)) : 1;
  }

  /** The present state. */
  now() {
    return this.at(this.phase);
  }

  /** The state to draw: the present one with the fading offset. */
  drawn() {
    return mapValues(this.now(), (value, name) => value + (this.offset[name] ?? 0));
  }

  /** Fade from a drawn state to the present one. */
  flowFrom(before) {
    const now = this.now();
    this.offset = mapValues(NO_OFFSET, (_, name) => before[name] - now[name]);
  }

  /** Reduce the offset of the last jump. Return whether there was an offset. */
  fade(elapsed) {
    const isFading = Object.values(this.offset).some((rest) => Math.abs(rest) > 1e-6);
    this.offset = isFading ? mapValues(this.offset, (rest) => rest * Math.exp(-elapsed / SMOOTHING)) : NO_OFFSET;
    return isFading;
  }

  reset() {
    this.phase = this.plainPhase = 0;
  }

  /**
   * Advance the time. Return the reason for the end of the motion, or null. After `periods`, if given, a periodic
   * motion repeats, and any other motion ends for the reason "repeat".
   */
  advance(seconds, periods) {
    this.phase += this.solution.Omega * seconds;
    this.plainPhase += this.solution.plain * seconds;
    if (this.phase > this.end) return "ended";
    const collision = this.collision(this.now());
    if (collision || !periods || this.phase <= TURN * periods) return collision;
    if (!this.isPeriodic()) return "repeat";
    this.phase -= TURN * periods;
    return null;
  }

  /**
   * Move both clocks to the time of a phase. If the motion ends before it, stop there and return the reason, else null.
   */
  goTo(phase) {
    const { reached, reason } = this.findEnd(phase);
    this.plainPhase += ((reached - this.phase) * this.solution.plain) / this.solution.Omega;
    this.phase = reached;
    return reason;
  }

  /** The last phase up to this one before a collision, and the reason for the end of the motion, or null. */
  findEnd(phase) {
    if (this.isPeriodic()) return { reached: phase, reason: null };
    for (let reached = 0; reached < phase; reached += SCAN) {
      const reason = this.collision(this.at(Math.min(reached + SCAN, phase)));
      if (reason) return { reached, reason };
    }
    return { reached: phase, reason: null };
  }

  /** Move both clocks to a time since release, as in `goTo`. */
  goToTime(time) {
    this.plainPhase = this.solution.plain * time;
    this.phase = this.solution.Omega * time;
    return this.goTo(this.phase);
  }

  /** Whether all periods are equal. */
  isPeriodic() {
    const { X, Phi } = this.solution.motion;
    return !this.samples && Math.abs(X.b) < 1e-12 && Math.abs(Phi.b) < 1e-12;
  }

  /** The phase at the end of a computed motion. */
  get end() {
    const run = this.samples ?? this.computed;
    return run ? (TURN * (run.q.length - 1)) / run.per_period : Infinity;
  }
}
