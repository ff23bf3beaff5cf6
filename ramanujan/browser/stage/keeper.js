// Writes the view of the stages on one clock into the address: layers, speed, reference frame, and the phases of a
// pause. A link then shows the same picture. shell/stages.py defines the names and values.

import { debounce } from "../lasting.js";
import { address } from "../page_address.js";
import { finder } from "./parts.js";
import { TURN } from "./motion.js";

const PAUSE = 150; // ms from the last change until the address is written, because browsers limit the rate
const SPEEDS = [1, 0.5, 0.1];
const FRAMES = ["ground", "block"];
const owners = new Map(); // page and prefix → the clock to which the address belongs

/** The names of layers, as in the address. */
export const listLayers = (names) => [...names].sort().join() || "none";

/**
 * Return the object that stores the view of one stage. `address_prefix` is the prefix of its names in the address.
 * After a change, `send` is called with the view, which `VIEW` in __init__.py describes.
 */
export function makeKeeper(stage, options, send, signal) {
  const { clock: name, address_prefix: prefix, compact } = options;
  // The address belongs to the newest clock with this prefix. At the next stop of a lesson, a new clock ignores the
  // settings that the clock before it has written.
  const place = `${location.pathname} ${prefix}`, isOwner = (owners.get(place) ?? name) === name;
  const settings = isOwner ? address.settings() : new URLSearchParams();
  const stages = () => [...stage.clock.stages];
  const setting = (key) => settings.get(prefix + key);
  let isWriting = false; // whether this stage writes the address
  owners.set(place, name);

  function write() {
    const { clock } = stage, layers = listLayers(stage.layers);
    const turns = stages().flatMap(({ playback }) => playback.hands).map((angle) => Number((angle / TURN).toFixed(6)));
    const { seenFrom: from, speed, playing } = clock, pace = playing ? stage.pace() : 0;
    const rates = stages().flatMap(({ playback }) => playback.frequencies).map((each) => (pace * each) / TURN);
    send({ layers, from, speed, rates: rates.join(), turns: turns.join() });
    // Name, value and default of each setting in the address.
    const paused = playing ? "" : turns.join();
    const view = [["speed", speed, 1], ["from", from, stage.defaultFrame()], ["paused", paused, ""]];
    if (!compact) view.push(["layers", layers, listLayers(stage.defaultLayers())]);
    if (isWriting) address.writeSettings(view.map(([key, ...values]) => [prefix + key, ...values]));
  }

  const writeLater = debounce(PAUSE, write, signal);
  return {
    /** The speed and the reference frame in the address, or their defaults. */
    clock: () => ({
      speed: SPEEDS.find((speed) => String(speed) === setting("speed")) ?? 1,
      seenFrom: FRAMES.find((frame) => frame === setting("from")) ?? stage.defaultFrame(),
    }),
    /** The address's layers, or undefined. */
    layers() {
      const isLayer = (name) => /^\w+$/.test(name) && finder(stage.root)(`[data-layer=${name}]`);
      return setting("layers")?.split(",").filter(isLayer);
    },
    /** Both phases of this stage if the address pauses it, or null. */
    paused() {
      const start = 2 * stages().indexOf(stage); // two numbers for each stage on the clock
      const turns = setting("paused")?.split(",").slice(start, start + 2).map(Number) ?? [];
      isWriting = turns.length === 2 && turns.every((turn) => Math.abs(turn) < 1e6);
      return isWriting ? turns.map((turn) => turn * TURN) : null;
    },
    /** Send the view after a pause, without writing a new address. */
    send: writeLater,
    /** Write the view into the address after a pause, because a person has changed it. */
    storeInAddress() {
      isWriting = true;
      writeLater();
    },
    /**
     * Update the address if it contains this stage's view, because a person has changed the view or the address paused
     * it.
     */
    update: () => isWriting && stage.keeper.storeInAddress(),
  };
}
