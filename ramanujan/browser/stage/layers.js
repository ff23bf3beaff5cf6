// The layers that can be chosen: energy bars by body, velocity arrows, contact forces, traces of the rims, coordinates.

import { fill, fixed, number, withUnit } from "../page/sentences.js";
import { makeCoordinates } from "./coordinates.js";
import {
  BODIES, CM, CONTACTS, ROLLERS, anchors, bodyNames, forceArrow, headOf, rimTrace, roundBelow, velocityArrow,
} from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { mapValues, onePeriod } from "./motion.js";
import { finder } from "./parts.js";
import { element, set } from "./svg.js";
import { WORDS } from "./texts.js";

const TRACE_POINTS = 90;
const PERIOD_POINTS = 24; // in which the greatest speed and force of a period are looked for

export function makeLayers(root) {
  const find = finder(root);
  let shown = new Set(), place = null, peak = { speed: 0, force: 0 }, data = {};

  const bars = [], shares = [], names = [];
  for (const name of [...BODIES, "spring"]) {
    const bar = document.createElement("i"), entry = document.createElement("li");
    entry.append(document.createElement("span"), " ", document.createElement("b"));
    bar.dataset.body = name;
    for (const node of [bar, entry]) node.style.setProperty("--fill", `var(--${name})`);
    find(".bar").append(bar);
    find(".legend").append(entry);
    bars.push(bar);
    shares.push(entry.lastChild);
    names.push(entry.firstChild);
  }
  const line = (layer, name, data) => makeLine(name, data, find(`.${layer}`));
  const arrows = Object.fromEntries(BODIES.map((name) => [name, line("arrows", name, { body: name })]));
  const forces = mapValues(CONTACTS, ([roller], contact) => line("forces", roller, { contact }));
  const traces = Object.fromEntries(ROLLERS.map((name) => [name, line("traces", name, { body: name })]));
  const coordinates = makeCoordinates(find(".coordinates"));

  function geometry(newPlace, parameters) {
    place = newPlace;
    const words = { ...bodyNames(parameters), spring: WORDS.bodies.spring };
    [...BODIES, "spring"].forEach((name, i) => (names[i].textContent = words[name]));
    find(".shared").textContent = fill(WORDS.shared, words);
  }

  function machine(parameters, solution, newData) {
    data = newData;
    findPeaks(onePeriod(parameters, solution, PERIOD_POINTS));
    drawScales();
    const states = onePeriod(parameters, solution, TRACE_POINTS);
    for (const name of ROLLERS) traces[name](rimTrace(name, states, place));
  }

  /** The greatest speed and the greatest contact force of a period: they set the scale of the arrows. */
  function findPeaks(states) {
    const largest = (formulas, known) => Math.max(...Object.values(formulas).map((formula) => Math.abs(formula(known))));
    peak = {
      speed: Math.max(...states.map((known) => largest(FORMULAS.velocity, known))),
      force: Math.max(...states.map((known) => largest(FORMULAS.contact_force, known))),
    };
  }

  /** How long an arrow is [cm] for a metre per second, and for a newton. */
  const lengthOf = () => ({
    speed: (1.5 * Math.max(place.R, 8)) / (peak.speed || 1),
    force: (1.1 * Math.max(place.R, 8)) / (peak.force || 1),
  });

  /** An arrow of each kind of a round size, with its value: without it lengths would mean nothing. */
  function drawScales() {
    const x = place.view.left + 2, above = place.slab.bottom + place.thick, per = lengthOf();
    const rows = { speed: [above + 16, velocityArrow, "m/s"], force: [above + 10, forceArrow, "N"] };
    for (const [name, [y, draw, unit]] of Object.entries(rows)) {
      const value = roundBelow(peak[name] || 1), length = value * per[name];
      set(find(`.${name} path`), { d: draw(x, y, length, headOf(place.R)) });
      const label = find(`.${name} text`);
      set(label, { x: x + length + 1.5, y: -y });
      label.textContent = withUnit(number(value, 1), unit);
    }
  }

  function frame(known, shift, write) {
    if (shown.has("traces")) set(find(".traces"), { transform: `translate(${-shift * CM})` });
    if (shown.has("arrows")) drawArrows(known, shift);
    if (shown.has("forces")) drawForces(known, shift);
    if (shown.has("coordinates")) coordinates.frame(known, place, shift);
    if (shown.has("energy")) drawEnergy(known, write);
  }

  function drawArrows(known, shift) {
    const from = anchors(place), { speed } = lengthOf();
    for (const name of BODIES) {
      const start = from[name][0] + (FORMULAS.displacement[name](known) - shift) * CM;
      arrows[name](velocityArrow(start, from[name][1], FORMULAS.velocity[name](known) * speed, headOf(place.R)));
    }
  }

  function drawForces(known, shift) {
    const { centre, R } = place, { force } = lengthOf();
    for (const [contact, [roller, side]] of Object.entries(CONTACTS)) {
      const [x, y] = centre[roller];
      const start = x + (FORMULAS.displacement[roller](known) - shift) * CM;
      // On the roller's own side of the contact.
      forces[contact](forceArrow(start, y + side * R * 0.9, FORMULAS.contact_force[contact](known) * force, headOf(R)));
      if (contact === data.slipping) set(find(".slipping"), { transform: `translate(${start} ${-(y + side * R)})` });
    }
    find(".slipping").style.display = data.slipping ? "" : "none";
  }

  function drawEnergy(known, write) {
    const energies = [...BODIES.map((name) => FORMULAS.kinetic_energy[name](known)), FORMULAS.potential_energy(known)];
    const total = energies.reduce((sum, energy) => sum + energy, 0) || 1;
    energies.forEach((energy, i) => {
      bars[i].style.width = `${(100 * energy) / total}%`;
      if (write) shares[i].textContent = withUnit(fixed(Math.round((100 * energy) / total), 0), "%");
    });
  }

  function show(layers) {
    shown = layers;
    find(".energy").hidden = !shown.has("energy");
    find(".shared").hidden = !shown.has("coordinates");
    for (const name of ["arrows", "traces", "forces", "coordinates"]) see(`.${name}`, shown.has(name));
    see(".speed", shown.has("arrows"));
    see(".force", shown.has("forces"));
  }
  const see = (selector, seen) => (find(selector).style.display = seen ? "" : "none");

  return { geometry, machine, frame, show };
}

/** A line in a body's ink on a rim of paper, so that it can be seen upon that body; what comes back draws it. */
function makeLine(name, data, parent) {
  const group = element("g", {}, parent);
  Object.assign(group.dataset, data);
  group.style.setProperty("--arrow", `var(--${name}-ink)`);
  const paths = ["rim", "line"].map((kind) => element("path", { class: kind }, group));
  return (d) => paths.forEach((path) => set(path, { d }));
}
