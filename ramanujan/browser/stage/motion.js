// The motion of a machine: pure functions that evaluate FORMULAS, printed by SymPy. SI units; no page, no clock.

import { FORMULAS } from "./formulas.js";

export const TURN = 2 * Math.PI;

export const mapValues = (object, change) =>
  Object.fromEntries(Object.entries(object).map(([key, value]) => [key, change(value, key)]));
export const clamp = (value, least, most) => Math.min(most, Math.max(least, value));

/**
 * Return the solution: Ω, √(k/m) and Ω²m/k; { a, b, c, d } of a + b·t + c·cos Ωt + d·sin Ωt for each coordinate; and
 * the velocity of the centre of mass.
 */
export function solve(parameters, initial) {
  const Omega = FORMULAS.natural_frequency(parameters);
  const start = initial ?? { X: 0, phi: FORMULAS.released_angle(parameters), Phi: 0, X_dot: 0, phi_dot: 0, Phi_dot: 0 };
  const known = { ...parameters, ...start, Omega };
  const motion = mapValues(FORMULAS.motion, (parts) => mapValues(parts, (part) => part(known)));
  // No external force acts on the centre of mass, so its velocity depends only on the drifts b.
  const rates = Object.keys(motion).map((name) => [`${name}_dot`, motion[name].b]);
  const drifts = { ...parameters, ...Object.fromEntries(rates) };
  return {
    Omega,
    plain: FORMULAS.plain_frequency(parameters),
    normalized: FORMULAS.normalized_frequency_squared(parameters),
    motion,
    drift: FORMULAS.centre({ ...parameters, ...mapValues(FORMULAS.velocity, (velocity) => velocity(drifts)) }),
  };
}

/**
 * Coordinates and rates at a phase Ωt of the oscillation and a time t of the drift. A computed motion has its own
 * cosine and sine.
 */
export function stateAt({ Omega, motion }, phase, time, [cosine, sine] = [Math.cos(phase), Math.sin(phase)]) {
  const state = {};
  for (const [name, { a, b, c, d }] of Object.entries(motion)) {
    state[name] = a + b * time + c * cosine + d * sine;
    state[`${name}_dot`] = b + Omega * (d * cosine - c * sine);
  }
  return state;
}

/** Interpolate linearly between samples at equal steps; `share` is 0 at the first sample and 1 at the last. */
export function between(values, share) {
  const position = share * (values.length - 1), i = Math.min(Math.floor(position), values.length - 2);
  return values[i] + (position - i) * (values[i + 1] - values[i]);
}

/** The replacements of cos Ωt and sin Ωt for a computed motion: q, interpolated linearly, and −dq/d(Ωt). */
export function sampleAt({ q, per_period }, phase) {
  const position = clamp((phase / TURN) * per_period, 0, q.length - 1); // in samples
  const i = Math.min(Math.floor(position), q.length - 2);
  const slope = q[i + 1] - q[i]; // per sample
  return [q[i] + (position - i) * slope, (-slope * per_period) / TURN];
}

/** Five states in half a period, for the still picture of a reader who prefers reduced motion. */
export const exposures = (parameters, solution) =>
  [0, 1, 2, 3, 4].map((i) => ({ ...parameters, ...stateAt(solution, (Math.PI * i) / 4, 0) }));

/** The states of the first period, with the parameters that the formulas need. */
export function onePeriod(parameters, solution, points) {
  return Array.from({ length: points + 1 }, (_, i) => {
    const phase = (TURN * i) / points;
    return { ...parameters, ...stateAt(solution, phase, phase / solution.Omega), Omega: solution.Omega };
  });
}
