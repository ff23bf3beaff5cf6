// Writes the view of the stages on one clock into the address: layers, speed, reference frame, and the phases of a pause. A link
// then shows the same picture. shell/stages.py defines the names and values.

import { atRest } from "../components/lasting.js";
import { dom } from "../components/streamlit_dom.js";
import { finder } from "./parts.js";
import { TURN } from "./motion.js";

const PAUSE = 150; // ms from the last change until the address is written, because browsers limit the rate
const SPEEDS = [1, 0.5, 0.1];
const owners = new Map(); // page and prefix → the clock to which the address belongs

/** Make the keeper of one stage. `address_prefix` begins its names in the address; `send` is called with the view. */
export function makeKeeper(stage, { clock: name, address_prefix: prefix, layers: defaultLayers, compact }, send, signal) {
  const place = `${location.pathname} ${prefix}`, isOwner = (owners.get(place) ?? name) === name;
  const settings = isOwner ? dom.settings() : new URLSearchParams();
  const stages = () => [...stage.clock.stages];
  const setting = (key) => settings.get(prefix + key);
  let active = false;
  owners.set(place, name); // the next stop of the lesson has a new clock

  function write() {
    const { clock, layers } = stage, joined = (names) => [...names].sort().join() || "none", shown = joined(layers);
    const angles = stages().flatMap(({ playback: { phase, plainPhase } }) => [phase, plainPhase]);
    const turns = angles.map((angle) => Number((angle / TURN).toFixed(6)));
    const { seenFrom: from, speed, playing } = clock, pace = playing ? stage.pace() : 0;
    send({ layers: shown, from, speed, pace, turns: turns.join() });
    const view = [["speed", speed, 1], ["from", from, "ground"], ["paused", playing ? "" : turns.join(), ""]];
    if (!compact) view.push(["layers", shown, joined(defaultLayers)]);
    if (active) dom.keep(view.map(([key, ...values]) => [prefix + key, ...values]));
  }

  const soon = atRest(PAUSE, write, signal);
  return {
    /** The address's settings of the clock. */
    clock: () => ({
      speed: SPEEDS.find((speed) => String(speed) === setting("speed")) ?? 1,
      seenFrom: setting("from") === "block" ? "block" : "ground",
    }),
    /** The address's layers, or undefined. */
    layers() {
      const isLayer = (name) => /^\w+$/.test(name) && finder(stage.root)(`[data-layer=${name}]`);
      return setting("layers")?.split(",").filter(isLayer);
    },
    /** Both phases of this stage if the address pauses it, or null. */
    paused() {
      const at = 2 * stages().indexOf(stage), turns = setting("paused")?.split(",").slice(at, at + 2).map(Number) ?? [];
      active = turns.length === 2 && turns.every((turn) => Math.abs(turn) < 1e6);
      return active ? turns.map((turn) => turn * TURN) : null;
    },
    /** Send the view after a pause, without writing a new address. */
    send: soon,
    /** Write a change by a person into the address after a pause. */
    set() {
      active = true;
      soon();
    },
    /** Update the address, if this keeper has written it before. */
    update: () => active && stage.keeper.set(),
  };
}
