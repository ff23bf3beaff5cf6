// Time: one animation loop for all stages on the page, and the clocks. Stages on the same clock run and pause together.
// The loop stops while nothing moves: sixty frames a second of an unchanged page used a quarter of a processor.

import { clamp } from "./motion.js";

export const VISIBLE_PERIOD = 0.7; // s, the shortest period that an eye can follow; faster motion is slowed to it

const clocks = new Map(); // name → { playing, speed, slowing, seenFrom, stages }
let frame = 0;
let lastTick = 0;
let needsFrame = false;

/** Add a stage to the clock with this name until the signal aborts. Return the clock. */
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

/** Restart the loop, because something may have moved. */
export function wake() {
  needsFrame = true;
  if (frame) return;
  lastTick = performance.now();
  frame = requestAnimationFrame(tick);
}

function tick(now) {
  frame = requestAnimationFrame(tick); // requested first, so that the loop survives an exception
  const elapsed = clamp((now - lastTick) / 1000, 0, 0.1); // a hidden tab does not catch up
  lastTick = now;
  needsFrame = false;
  for (const clock of clocks.values()) {
    // The fastest machine determines the speed of all stages on its clock.
    const factors = [...clock.stages].map((stage) => stage.period() / VISIBLE_PERIOD);
    clock.slowing = Math.min(1, ...factors);
    for (const stage of clock.stages) {
      const stageNeedsFrame = stage.advance(elapsed);
      needsFrame ||= stageNeedsFrame;
    }
  }
  if (needsFrame) return;
  cancelAnimationFrame(frame);
  frame = 0;
}
