// Time: one animation loop for every stage on the page, and clocks, which stages share that run and pause together. The loop
// rests while nothing moves: on a page that stands still, sixty frames a second took a quarter of a processor.

import { clamp } from "./motion.js";

export const EYE = 0.7; // s, the shortest period that an eye can follow; what is faster is slowed

const clocks = new Map(); // name → { playing, speed, slowing, seenFrom, stages }
let frame = 0;
let lastTick = 0;
let asked = false; // whether another frame is wanted

/** Put a stage on the clock of that name until the signal aborts, and return the clock. */
export function joinClock(name, stage, playing, signal) {
  if (!clocks.has(name)) clocks.set(name, { playing, speed: 1, slowing: 1, seenFrom: "ground", stages: new Set() });
  const clock = clocks.get(name);
  clock.stages.add(stage);
  wake();
  signal.addEventListener("abort", () => {
    clock.stages.delete(stage);
    if (!clock.stages.size) clocks.delete(name);
  });
  return clock;
}

/** Let the loop run again: something may have moved. */
export function wake() {
  asked = true;
  if (frame) return;
  lastTick = performance.now();
  frame = requestAnimationFrame(tick);
}

function tick(now) {
  frame = requestAnimationFrame(tick); // first of all: one bad frame must not be the last
  const elapsed = clamp((now - lastTick) / 1000, 0, 0.1); // a hidden tab does not catch up
  lastTick = now;
  asked = false;
  for (const clock of clocks.values()) {
    clock.slowing = Math.min(1, ...[...clock.stages].map((stage) => stage.period() / EYE));
    for (const stage of clock.stages) asked = stage.advance(elapsed) || asked;
  }
  if (asked) return;
  cancelAnimationFrame(frame);
  frame = 0;
}
