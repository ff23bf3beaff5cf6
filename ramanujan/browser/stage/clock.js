// Time: one animation loop for every stage on the page, and clocks, which stages share that run and pause together.

import { clamp } from "./motion.js";

export const EYE = 0.7; // s, the shortest period that an eye can follow; what is faster is slowed

const running = new Set(); // stages on the page
const clocks = new Map(); // name → { playing, speed, slowing, seenFrom, stages }
let frame = 0;
let lastTick = 0;

/** Put a stage on the clock of that name until the signal aborts, and return the clock. */
export function joinClock(name, stage, playing, signal) {
  if (!clocks.has(name)) clocks.set(name, { playing, speed: 1, slowing: 1, seenFrom: "ground", stages: new Set() });
  const clock = clocks.get(name);
  clock.stages.add(stage);
  running.add(stage);
  frame ||= requestAnimationFrame(tick);
  signal.addEventListener("abort", () => {
    running.delete(stage);
    clock.stages.delete(stage);
    if (!clock.stages.size) clocks.delete(name);
  });
  return clock;
}

function tick(now) {
  frame = running.size ? requestAnimationFrame(tick) : 0; // first of all: one bad frame must not be the last
  const elapsed = clamp((now - lastTick) / 1000, 0, 0.1); // a hidden tab does not catch up
  lastTick = now;
  for (const clock of clocks.values()) clock.slowing = Math.min(1, ...[...clock.stages].map((stage) => stage.period() / EYE));
  for (const stage of [...running]) stage.advance(elapsed);
}
