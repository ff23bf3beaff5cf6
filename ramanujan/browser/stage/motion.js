// The motion of a machine, evaluated: pure functions of FORMULAS, which SymPy prints. SI units; no page, no clock.

import { FORMULAS } from "./formulas.js";

export const TURN = 2 * Math.PI;

export const mapValues = (object, change) =>
  Object.fromEntries(Object.entries(object).map(([key, value]) => [key, change(value, key)]));
export const clamp = (value, least, most) => Math.min(most, Math.max(least, value));

/** Ω, √(k/m), Ω²m/k, a + b·t + c·cos Ωt + d·sin Ωt for each coordinate, and the velocity of the centre of mass. */
export function solve(parameters, initial) {
  const Omega = FORMULAS.natural_frequency(parameters);
  const start = initial ?? { X: 0, phi: FORMULAS.released_angle(parameters), Phi: 0, X_dot: 0, phi_dot: 0, Phi_dot: 0 };
  const known = { ...parameters, ...start, Omega };
  const motion = mapValues(FORMULAS.motion, (parts) => mapValues(parts, (part) => part(known)));
  // Nothing outside pushes the centre of mass, so only the drifts b count.
  const drifts = { ...parameters, ...Object.fromEntries(Object.keys(motion).map((name) => [`${name}_dot`, motion[name].b])) };
  return {
    Omega,
    plain: FORMULAS.plain_frequency(parameters),
    normalized: FORMULAS.normalized_frequency_squared(parameters),
    motion,
    drift: FORMULAS.centre({ ...parameters, ...mapValues(FORMULAS.velocity, (velocity) => velocity(drifts)) }),
  };
}

/** Coordinates and rates at a phase Ωt of the oscillation and a time t of the drift; `turned` replaces cos Ωt and sin Ωt. */
export function stateAt({ Omega, motion }, phase, time, turned = [Math.cos(phase), Math.sin(phase)]) {
  const [cosine, sine] = turned, state = {};
  for (const [name, { a, b, c, d }] of Object.entries(motion)) {
    state[name] = a + b * time + c * cosine + d * sine;
    state[`${name}_dot`] = b + Omega * (d * cosine - c * sine);
  }
  return state;
}

/** What an integrator has in place of cos Ωt and sin Ωt: q at equal steps, straight between two of them, and minus its slope. */
export function sampleAt({ q, per_period }, phase) {
  const at = clamp((phase / TURN) * per_period, 0, q.length - 1), i = Math.min(Math.floor(at), q.length - 2);
  return [q[i] + (at - i) * (q[i + 1] - q[i]), ((q[i] - q[i + 1]) * per_period) / TURN];
}

/** The still of someone who asked for less motion: half a period in five exposures. */
export const exposures = (parameters, solution) =>
  [0, 1, 2, 3, 4].map((i) => ({ ...parameters, ...stateAt(solution, (Math.PI * i) / 4, 0) }));

/** The states of one period, from release on, with what the formulas need besides. */
export function onePeriod(parameters, solution, points) {
  return Array.from({ length: points + 1 }, (_, i) => {
    const phase = (TURN * i) / points;
    return { ...parameters, ...stateAt(solution, phase, phase / solution.Omega), Omega: solution.Omega };
  });
}
