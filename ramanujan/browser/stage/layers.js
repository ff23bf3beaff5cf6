// The layers with a tick box: energy bars by body, velocity arrows, horizontal forces, weights and normal forces, traces of the
// rims, coordinates. Lengths are centimetres of the picture.

import { fill, fixed, number, withUnit } from "../components/sentences.js";
import { drawCoordinates } from "./coordinates.js";
import {
  BODIES, CM, CONTACTS, ROLLERS, anchors, bodyNames, displacements, forceArrow, frameValue, headOf, horizontalForces, rimTrace,
  roundBelow, velocityArrow, verticalForces,
} from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { mapValues, onePeriod } from "./motion.js";
import { finder, layerNames } from "./parts.js";
import { element, set } from "./svg.js";
import { WORDS } from "./texts.js";

const TRACE_POINTS = 90;
const PERIOD_POINTS = 24; // states of a period at which the largest speed and force are sampled
const LONGEST = { speed: 1.5, force: 1.8 }; // length of the longest arrow, in radii of a roller
const SMALLEST_RADIUS = 8; // cm, the least unit of these lengths, so that the arrows of small rollers are visible
const LONGEST_FORCE_HEAD = 1.8; // cm
const GAP = 1.2; // cm between an arrow and its label
const LABEL_WIDTH = 15; // cm, at least the width of the longest label of `drawRolling`

export function makeLayers(root) {
  const find = finder(root), layers = layerNames(root);
  // `place` is the geometry from `layout`. `maxima` has the largest value of each kind of arrow, and `unitLengths` the length of
  // an arrow of one unit [cm]. `measure` determines maxima and unit lengths when a layer first needs them.
  let shown = new Set(), place = null, maxima, unitLengths, data = {}, seenFrom = "ground", measure = null, isLayered = false;

  const [bars, names, shares] = [".bar i", ".legend span", ".legend b"].map((each) => [...root.querySelectorAll(each)]);
  const lines = {}; // layer and name → the function that sets the line's path
  /** Draw a line of a layer in a body's colour. Its elements are created once and reused. */
  function draw(layer, name, body, d) {
    const key = `${layer} ${name}`;
    lines[key] ??= makeLine(name, body, find(`.${layer}`));
    const setPath = lines[key];
    setPath(d);
  }
  const points = mapValues(WORDS.rolling, (text) => Object.assign(element("text", {}, find(".rolling")), { textContent: text }));

  function geometry(newPlace, parameters) {
    place = newPlace;
    const words = bodyNames(parameters);
    [...BODIES, "spring"].forEach((name, i) => (names[i].textContent = words[name]));
    find(".shared").textContent = fill(WORDS.shared, words);
  }

  function machine(parameters, solution, newData, from) {
    [data, seenFrom] = [newData, from];
    show(shown);
    // Sample a period only when a layer first needs it.
    measure = () => {
      findScales(onePeriod(parameters, solution, PERIOD_POINTS));
      drawScales();
      const states = onePeriod(parameters, solution, TRACE_POINTS);
      for (const name of ROLLERS) draw("traces", name, name, rimTrace(name, states, place, from));
      measure = null;
    };
  }

  const velocity = (name, known) => FORMULAS.velocity[name](known) - frameValue(FORMULAS.velocity, known, seenFrom);

  /** Set the scales of the arrows, cm per m/s and cm per newton, from the largest speed and forces of a period. */
  function findScales(states) {
    const largest = (values) => Math.max(...states.map((known) => Math.max(...values(known).map(Math.abs)))) || 1;
    const size = Math.max(place.R, SMALLEST_RADIUS);
    const strengths = (forces) => Object.values(forces).map(({ newtons }) => newtons);
    const speed = largest((known) => BODIES.map((name) => velocity(name, known)));
    const force = largest((known) => strengths(horizontalForces(known, place, 0)));
    // The normal forces on a lower roller point towards each other and must not overlap.
    const normal = (contact, known) => FORMULAS.normal_force[contact](known);
    const onRoller = (name, known) => normal(`${name}_slab`, known) + normal(`${name}_block`, known);
    const pair = largest((known) => ["hoop", "cylinder"].map((name) => onRoller(name, known)));
    const load = largest((known) => ROLLERS.map((name) => FORMULAS.normal_force[`${name}_block`](known)));
    const total = largest((known) => strengths(verticalForces(known, place, 0)));
    maxima = { speed, force, weight: pair / 2 };
    // The two arrows in a lower roller fit into its diameter. The arrow in the block fits into the lower step, and the arrow at
    // the floor into the view.
    const weight = Math.min((1.9 * place.R) / pair, place.deck / load, (0.7 * place.view.top) / total);
    unitLengths = { speed: (LONGEST.speed * size) / speed, force: (LONGEST.force * size) / force, weight };
  }

  /** Draw a scale for each kind of arrow: an arrow of a round value, with the value. */
  function drawScales() {
    const { view } = place, x = view.left + 2, head = headOf(place.R);
    // The speed's scale is at the height `first`, between the slab's marks and the top of the view; the force's is below it.
    const slabTop = place.slab.bottom + place.thick, row = Math.max(1, place.R / 10);
    const first = Math.min(slabTop + 20 * row, view.top - 3.5), lowest = slabTop + 9 * row;
    const second = (first + lowest) / 2;
    // The weight's scale is to the right of the longest force and its label, whose size grows with the view.
    const weightX = x + LONGEST.force * Math.max(place.R, SMALLEST_RADIUS) + 0.09 * (view.right - view.left);
    const scales = {
      speed: ["m/s", (length) => [velocityArrow(x, first, length, head), x + length, first]],
      force: ["N", (length) => [forceArrow(x, second, length, head), x + length, second]],
      weight: ["N", (length) => [forceArrow(weightX, second - length / 2, length, head, { isUpright: true }), weightX, second]],
    };
    for (const [name, [unit, drawn]] of Object.entries(scales)) {
      const value = roundBelow(maxima[name]), [d, end, y] = drawn(value * unitLengths[name]), label = find(`.${name} text`);
      set(find(`.${name} path`), { d });
      set(label, { x: end + 1.5, y: -y });
      const sentence = name === "speed" && seenFrom === "block" ? WORDS.relative : "{speed}";
      label.textContent = fill(sentence, { speed: withUnit(number(value, 1), unit) });
    }
  }

  function frame(known, shift, writesText) {
    if (isLayered || seenFrom === "block") measure?.();
    const origin = frameValue(FORMULAS.displacement, known, seenFrom);
    if (shown.has("traces")) set(find(".traces"), { transform: `translate(${(origin - shift) * CM})` });
    if (shown.has("arrows")) drawArrows(known, shift);
    if (seenFrom === "block") drawRolling(known, shift);
    if (shown.has("forces")) drawForces(known, shift);
    if (shown.has("weights")) drawAll("weights", verticalForces(known, place, shift), unitLengths.weight, { isUpright: true });
    if (shown.has("coordinates")) drawCoordinates(find(".coordinates"), known, place, shift);
    if (shown.has("energy")) drawEnergy(known, writesText);
  }

  function drawArrows(known, shift) {
    const displaced = displacements(known, shift);
    for (const [name, [x, y]] of Object.entries(anchors(place))) {
      const length = velocity(name, known) * unitLengths.speed;
      draw("arrows", name, name, velocityArrow(x + displaced[name], y, length, headOf(place.R)));
    }
  }

  /** Draw the velocities of a lower roller's contact, centre and top relative to the block. */
  function drawRolling(known, shift) {
    const [home, middle] = place.centre.hoop, x = home + displacements(known, shift).hoop;
    for (const [i, [point, formula]] of Object.entries(FORMULAS.rolling).entries()) {
      const y = middle + (i - 1) * place.R, length = formula(known) * unitLengths.speed, side = length < 0 ? -1 : 1;
      draw("rolling", point, "hoop", velocityArrow(x, y, length, headOf(place.R)) || `M${x} ${-y}h0.01`); // WebKit enlarges the dot of h0
      // A label of an arrow to the left must begin within the view.
      set(points[point], { x: side < 0 ? Math.max(x + length - GAP, place.view.left + LABEL_WIDTH) : x + length + GAP, y: -y });
      // The label of a short arrow would jump when the arrow changes its direction.
      const visibility = formula !== FORMULAS.rolling.contact && Math.abs(length) < 1.5 ? "hidden" : "";
      Object.assign(points[point].style, { textAnchor: side < 0 ? "end" : "start", visibility });
    }
  }

  function drawForces(known, shift) {
    const forces = horizontalForces(known, place, shift);
    drawAll("forces", forces, unitLengths.force);
    const contact = CONTACTS[data.slipping];
    find(".slipping").style.display = contact ? "" : "none";
    if (!contact) return;
    const { x } = forces[`${data.slipping} ${contact.roller}`];
    const y = place.centre[contact.roller][1] + contact.side * place.R;
    set(find(".slipping"), { transform: `translate(${x} ${-y})` });
  }

  function drawAll(layer, forces, scale, options) {
    for (const [name, { body, x, y, newtons }] of Object.entries(forces))
      draw(layer, name, body, forceArrow(x, y, newtons * scale, Math.min(headOf(place.R), LONGEST_FORCE_HEAD), options));
  }

  function drawEnergy(known, writesShares) {
    const energies = [...BODIES.map((name) => FORMULAS.kinetic_energy[name](known)), FORMULAS.potential_energy(known)];
    const total = energies.reduce((sum, energy) => sum + energy, 0) || 1;
    energies.forEach((energy, i) => {
      bars[i].style.width = `${(100 * energy) / total}%`;
      if (writesShares) shares[i].textContent = withUnit(fixed(Math.round((100 * energy) / total), 0), "%");
    });
  }

  function show(names) {
    shown = names;
    for (const name of layers) {
      for (const node of [find(`.${name}`), find(`[data-of=${name}]`)]) setVisible(node, shown.has(name));
    }
    setVisible(find(".rolling"), seenFrom === "block");
    find(".machine").classList.toggle("from-block", seenFrom === "block");
    setVisible(find(".speed"), shown.has("arrows") || seenFrom === "block");
    find(".machine").classList.toggle("weighed", shown.has("weights"));
    isLayered = [...shown].some((name) => name !== "energy");
    find(".machine").classList.toggle("layered", isLayered);
  }
  const setVisible = (node, isVisible) => node && (node.style.display = isVisible ? "" : "none");

  return { geometry, machine, frame, show };
}

/** Make a line in a body's colour, with a light rim so that it is visible on that body. Return a function that sets its path. */
function makeLine(name, body, parent) {
  const group = element("g", { "data-line": name, style: `--arrow: var(--${body}-ink)` }, parent);
  const paths = ["rim", "line"].map((kind) => element("path", { class: kind }, group));
  return (d) => paths.forEach((path) => set(path, { d }));
}
