// The playback of one machine: both phases, the fading offset of a jump, and the end of the motion. Pure; needs no page.

import { FORMULAS } from "./formulas.js";
import { TURN, mapValues, sampleAt, stateAt } from "./motion.js";

const SMOOTHING = 0.07; // s, the time in which a change of parameters fades into the picture
const SCAN = TURN / 48; // step of the phase when searching for the end of the motion
const NO_OFFSET = { X: 0, phi: 0, Phi: 0, plain: 0, shift: 0 };

export class Playback {
  phase = 0; // of the machine, Ωt; a change of parameters keeps it, so that the picture does not jump
  plainPhase = 0; // of the plain mass
  startPhase = 0; // the plain mass's phase when both hands started together
  keepsAngle = false; // whether a change of the machine keeps the angle between the hands
  offset = NO_OFFSET;
  collisionPhase = null; // of the first collision, if a person has moved the playback beyond it

  /**
   * Set the machine: its parameters, its solution and the reference frame. `samples` replace the exact motion, and a `computed`
   * motion is compared with it. `collision` is a function of a state.
   */
  setMachine({ parameters, solution, samples, computed, collision, seenFrom }) {
    const ratio = this.solution && this.solution.Omega / this.solution.plain;
    Object.assign(this, { parameters, solution, samples, computed, collision, seenFrom });
    this.collisionPhase = null;
    // The hands compare the two frequencies, so they start together again when the ratio of these changes.
    const hasNewRatio = ratio !== solution.Omega / solution.plain;
    if (!this.keepsAngle && hasNewRatio) this.plainPhase = this.startPhase = this.phase;
  }

  /** Periods of the plain mass since both hands started together. */
  get periods() {
    return (this.plainPhase - this.startPhase) / TURN;
  }

  /** The time [s] since release. */
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

  /** The present state: no later than the end of the motion. */
  now() {
    return this.at(this.collisionPhase === null ? this.phase : Math.min(this.phase, this.collisionPhase));
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
    this.phase = this.plainPhase = this.startPhase = 0;
    this.collisionPhase = null;
  }

  /**
   * Advance the time. Return the reason for the end of the motion, or null. After `periods`, if given, a periodic motion
   * repeats, and any other motion ends for the reason "repeat".
   */
  advance(seconds, periods) {
    this.phase += this.solution.Omega * seconds;
    this.plainPhase += this.solution.plain * seconds;
    if (this.collisionPhase !== null && this.phase > this.collisionPhase) return this.reasonAtCollision();
    if (this.phase > this.end) return "ended";
    const collision = this.collision(this.now());
    if (collision || !periods || this.phase <= TURN * periods) return collision;
    if (!this.isPeriodic()) return "repeat";
    this.phase -= TURN * periods;
    return null;
  }

  /** Move both clocks to the time of a phase. Return the reason if the motion ends before it, or null. */
  goTo(phase) {
    this.plainPhase += ((phase - this.phase) * this.solution.plain) / this.solution.Omega;
    this.phase = phase;
    this.collisionPhase = this.isPeriodic() ? null : this.findCollisionPhase(phase);
    return this.collisionPhase === null ? null : this.reasonAtCollision();
  }

  /** The reason for the end of the motion just beyond the phase `collisionPhase`. */
  reasonAtCollision() {
    return this.collision(this.at(this.collisionPhase + SCAN)) ?? "edge";
  }

  /** Move both clocks to a time since release. */
  goToTime(time) {
    this.plainPhase = this.solution.plain * time;
    this.startPhase = 0;
    this.phase = this.solution.Omega * time;
    return this.goTo(this.phase);
  }

  /** Set the plain mass's phase, and derive the phase at which both hands started together. */
  setPlainPhase(plainPhase) {
    const gained = this.solution.Omega / this.solution.plain - 1; // by the machine's hand, per radian of the plain mass's hand
    this.plainPhase = plainPhase;
    this.startPhase = Math.abs(gained) > 1e-9 ? plainPhase - (this.phase - plainPhase) / gained : 0;
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

  /** The phase of the first collision before this phase, or null. */
  findCollisionPhase(phase) {
    for (let end = SCAN; end < phase + SCAN; end += SCAN) {
      if (!this.collision(this.at(Math.min(end, phase)))) continue;
      let [inside, outside] = [end - SCAN, Math.min(end, phase)];
      for (let i = 0; i < 30; i++) {
        const middle = (inside + outside) / 2;
        if (this.collision(this.at(middle))) outside = middle;
        else inside = middle;
      }
      return inside;
    }
    return null;
  }
}
