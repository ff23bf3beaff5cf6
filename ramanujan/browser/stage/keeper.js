// Keeps in the address what is seen of the stages on one clock, so that a link shows the same picture: layers, speed, the view
// from ground or block, and the moment of a pause. shell/stages.py has the names and their values.

import { atRest } from "../components/lasting.js";
import { dom } from "../components/streamlit_dom.js";
import { finder } from "./parts.js";
import { TURN } from "./motion.js";

const PAUSE = 150; // ms from the last change to the address: a browser refuses to write it many times a second
const SPEEDS = [1, 0.5, 0.1];
const owners = new Map(); // page and prefix → the clock of whose stages the address speaks

/** The keeper of one stage; `kept` is the prefix of its names in the address, `send` takes what is seen. */
export function makeKeeper(stage, { clock: name, kept: prefix, layers: shownAtFirst, compact }, send, signal) {
  const place = `${location.pathname} ${prefix}`, mine = (owners.get(place) ?? name) === name;
  const known = mine ? dom.settings() : new URLSearchParams();
  const stages = () => [...stage.clock.stages];
  const said = (key) => known.get(prefix + key);
  let active = false;
  owners.set(place, name); // another stop of the lesson begins anew

  function write() {
    const { clock, layers } = stage, named = (names) => [...names].sort().join() || "none", shown = named(layers);
    const angles = stages().flatMap(({ playback: { phase, plainPhase } }) => [phase, plainPhase]);
    const turns = angles.map((angle) => Number((angle / TURN).toFixed(6)));
    const { seenFrom: from, speed, playing } = clock, pace = playing ? stage.pace() : 0;
    send({ layers: shown, from, speed, pace, turns: turns.join() });
    const view = [["speed", speed, 1], ["from", from, "ground"], ["paused", playing ? "" : turns.join(), ""]];
    if (!compact) view.push(["layers", shown, named(shownAtFirst)]);
    if (active) dom.keep(view.map(([key, ...values]) => [prefix + key, ...values]));
  }

  const soon = atRest(PAUSE, write, signal);
  return {
    /** What the address says of the clock. */
    clock: () => ({
      speed: SPEEDS.find((speed) => String(speed) === said("speed")) ?? 1,
      seenFrom: said("from") === "block" ? "block" : "ground",
    }),
    /** The layers that it names, or none. */
    layers: () => said("layers")?.split(",").filter((name) => /^\w+$/.test(name) && finder(stage.root)(`[data-layer=${name}]`)),
    /** Both phases of this stage where it is paused, or none. */
    paused() {
      const at = 2 * stages().indexOf(stage), turns = said("paused")?.split(",").slice(at, at + 2).map(Number) ?? [];
      active = turns.length === 2 && turns.every((turn) => Math.abs(turn) < 1e6);
      return active ? turns.map((turn) => turn * TURN) : null;
    },
    /** Send what is seen, once it rests: the machine has begun anew. */
    tell: soon,
    /** Write what a person has set, once it rests. */
    set() {
      active = true;
      soon();
    },
    /** Write again what has been written once. */
    update: () => active && stage.keeper.set(),
  };
}
