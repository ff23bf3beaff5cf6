// The layers with a tick box: energy bars by body, displacements, velocity arrows, friction, traces of the rims,
// coordinates. Lengths are centimetres of the picture.

import { fill, fixed, number, withUnit } from "../sentences.js";
import { drawCoordinates } from "./coordinates.js";
import {
  BODIES, CM, CONTACTS, ROLLERS, anchors, bodyNames, displacementArrow, displacements, forceArrow, frameValue, headOf,
  horizontalForces, isOnRoller, rimTrace, roundBelow, velocityArrow,
} from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { TURN, mapValues, onePeriod } from "./motion.js";
import { finder, layerNames } from "./parts.js";
import { element, set } from "./svg.js";
import { WORDS } from "./texts.js";

const TRACE_POINTS = 90;
const PERIOD_POINTS = 24; // states of a period at which the largest speed and force are sampled
// Length of the longest arrow, in radii of a roller. Friction with letters leaves room for them between two contacts.
const LONGEST = { speed: 1.5, friction: 1.5, lettered: 0.9, spring: 3.1 };
const SMALLEST_RADIUS = 8; // cm, the least unit of these lengths, so that the arrows of small rollers are visible
const LONGEST_FORCE_HEAD = 2.7; // cm
const SHORTEST_LETTERED = 0.4; // cm, the shortest force with a visible letter
const GAP = 1.2; // cm between an arrow and its label
const HALF_A_LETTER = 2.7; // cm, half the height of a force's letter with its index
const SPRING_LETTER = { inset: 3, distance: 4 }; // cm from the spring, and from the arrow of the spring's force
const LABEL_WIDTH = 15; // cm, at least the width of the longest label of `drawRolling`

/** Make the layers. `asked`: the number of periods in the question of this stage, which a sentence counts, or null. */
export function makeLayers(root, asked) {
  const find = finder(root), layers = layerNames(root);
  // `place` is the geometry from `layout`. `maxima` has the largest value of each kind of arrow, and `unitLengths` the
  // length of an arrow of one unit [cm]. `measure` determines maxima and unit lengths when a layer first needs them.
  let shown = new Set(), place = null, maxima, unitLengths, data = {}, seenFrom = "ground", measure = null;
  let isLayered = false;

  const [bars, names, shares] = [".bar i", ".legend span", ".legend b"].map((each) => [...root.querySelectorAll(each)]);
  const lines = {}; // layer and name → the function that sets the line's path
  /** Draw a line of a layer in a body's colour. Its elements are created once and reused. */
  function draw(layer, name, body, d) {
    const key = `${layer} ${name}`;
    lines[key] ??= makeLine(name, body, find(`.${layer}`));
    const setPath = lines[key];
    setPath(d);
  }
  const letters = {}; // name of a force → its letter in the picture
  const points = mapValues(WORDS.rolling, (textContent) =>
    Object.assign(element("text", {}, find(".rolling")), { textContent }));

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

  /** Whether the velocities of the hoop's points are drawn: beside displacements their arrows would be confused. */
  const showsRolling = () => seenFrom === "block" && !shown.has("displacements");

  const velocity = (name, known) => FORMULAS.velocity[name](known) - frameValue(FORMULAS.velocity, known, seenFrom);

  /**
   * The forces that the layer shows: friction on the rollers, as in the figures. Beside equations it shows all forces.
   */
  const isDrawn = (name) => Boolean(data.forces) || isOnRoller(name);

  /** Set the scales of the arrows, cm per m/s and cm per newton, from the largest speed and forces of a period. */
  function findScales(states) {
    const largest = (values) => Math.max(...states.map((known) => Math.max(...values(known).map(Math.abs)))) || 1;
    const size = Math.max(place.R, SMALLEST_RADIUS);
    const speed = largest((known) => BODIES.map((name) => velocity(name, known)));
    const friction = largest((known) => Object.values(mapValues(FORMULAS.contact_force, (force) => force(known))));
    const spring = largest((known) => [FORMULAS.spring_force.slab(known)]);
    maxima = { speed, force: friction };
    const forBoth = Math.min(LONGEST.lettered / friction, LONGEST.spring / spring);
    unitLengths = {
      speed: (LONGEST.speed * size) / speed,
      force: size * (data.forces ? forBoth : LONGEST.friction / friction),
    };
  }

  /** Draw a scale for each kind of arrow: an arrow of a round value, with the value. */
  function drawScales() {
    const { view } = place, x = view.left + 2, head = headOf(place.R);
    // The speed's scale is at the height `first`, between the slab's marks and the top of the view; the force's is
    // below it.
    const slabTop = place.slab.bottom + place.thick, row = Math.max(1, place.R / 10);
    const first = Math.min(slabTop + 20 * row, view.top - 3.5), lowest = slabTop + 9 * row;
    const second = (first + lowest) / 2;
    const scales = {
      speed: ["m/s", (length) => [velocityArrow(x, first, length, head), x + length, first]],
      force: ["N", (length) => [forceArrow(x, second, length, head), x + length, second]],
    };
    set(find(".shift text"), { x, y: -first });
    const sentences = { speed: seenFrom === "block" ? WORDS.relative : "{speed}", force: WORDS.strength };
    for (const [name, [unit, drawn]] of Object.entries(scales)) {
      const value = roundBelow(maxima[name]), [d, end, y] = drawn(value * unitLengths[name]);
      const label = find(`.${name} text`);
      set(find(`.${name} path`), { d });
      set(label, { x: end + 1.5, y: -y });
      label.textContent = fill(sentences[name], { [name]: withUnit(number(value, 1), unit) });
    }
  }

  function frame(known, shift, playback, writesText) {
    if (isLayered || showsRolling()) measure?.();
    const origin = frameValue(FORMULAS.displacement, known, seenFrom);
    if (shown.has("traces")) set(find(".traces"), { transform: `translate(${(origin - shift) * CM})` });
    if (shown.has("displacements")) drawDisplacements(known, shift);
    if (shown.has("arrows") || data.velocities) drawArrows(known, shift);
    if (showsRolling()) drawRolling(known, shift);
    if (shown.has("forces") || data.forces) drawForces(known, shift);
    if (shown.has("coordinates")) drawCoordinates(find(".coordinates"), known, place, shift);
    if (!shown.has("energy")) return;
    if (data.most_energy) drawTotalEnergy(playback);
    else drawEnergy(known, writesText);
  }

  /** Draw arrows to scale from the places before the compression. Relative to the block, these move with it. */
  function drawDisplacements(known, shift) {
    const displaced = displacements(known, shift);
    const start = (frameValue(FORMULAS.displacement, known, seenFrom) - shift) * CM;
    for (const [name, [x, y]] of Object.entries(anchors(place))) {
      draw("displacements", name, name, displacementArrow(x + start, y, displaced[name] - start, headOf(place.R)));
    }
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
      const dot = `M${x} ${-y}h0.01`; // WebKit enlarges the dot of h0
      draw("rolling", point, "hoop", velocityArrow(x, y, length, headOf(place.R)) || dot);
      // A label of an arrow to the left must begin within the view.
      const end = x + length + side * GAP, labelX = side < 0 ? Math.max(end, place.view.left + LABEL_WIDTH) : end;
      set(points[point], { x: labelX, y: -y });
      // The label of a short arrow would jump when the arrow changes its direction.
      const visibility = formula !== FORMULAS.rolling.contact && Math.abs(length) < 1.5 ? "hidden" : "";
      Object.assign(points[point].style, { textAnchor: side < 0 ? "end" : "start", visibility });
    }
  }

  function drawForces(known, shift) {
    const forces = horizontalForces(known, place, shift, Boolean(data.forces));
    const names = Object.keys(forces).filter(isDrawn);
    const head = Math.min(headOf(place.R), LONGEST_FORCE_HEAD);
    for (const name of names) {
      const { body, x, y, newtons, isPull } = forces[name];
      const length = newtons * unitLengths.force;
      draw("forces", name, body, forceArrow(isPull ? x - length : x, y, length, head));
      if (data.forces) drawLetter(name, x, y, length);
    }
    const contact = CONTACTS[data.slipping];
    find(".slipping").style.display = contact ? "" : "none";
    if (!contact) return;
    const { x } = forces[`${data.slipping} ${contact.roller}`];
    const y = place.centre[contact.roller][1] + contact.side * place.R;
    set(find(".slipping"), { transform: `translate(${x} ${-y})` });
  }

  /** Make the letters of a force, as in the equations. */
  function makeLetter(name) {
    const letter = element("text", {}, find(`.forces [data-line="${name}"]`)), [force, body] = name.split(" ");
    const [symbol, index] = WORDS.contact_force[force] ?? [WORDS.spring_force[body]];
    const isReaction = index && !isOnRoller(name);
    const [sign, digit = "", symbols = ""] = `${isReaction ? "−" : ""}${symbol}`.split(/(\d)/);
    letter.append(sign);
    element("tspan", { class: "digit" }, letter).textContent = digit;
    letter.append(symbols);
    if (index) element("tspan", { class: "subscript", dy: ".25em" }, letter).textContent = index;
    return letter;
  }

  /**
   * Draw the letters of a force. Those of friction are at the head of its arrow; those of the spring's force are at the
   * end of its arrow at the spring. Draw the step's own forces strongly.
   */
  function drawLetter(name, x, y, length) {
    const [force, body] = name.split(" "), letter = (letters[name] ??= makeLetter(name));
    const isVisible = Math.abs(length) > SHORTEST_LETTERED;
    // A letter at a roller is clear of its rim.
    const inner = isOnRoller(name) ? Math.abs(y - place.centre[body][1]) - HALF_A_LETTER : place.R;
    const rim = Math.sqrt(Math.max(0, place.R ** 2 - inner ** 2));
    const [side, along, across] = {
      "spring slab": [-1, SPRING_LETTER.inset, SPRING_LETTER.distance],
      "spring block": [1, SPRING_LETTER.inset, -SPRING_LETTER.distance],
    }[name] ?? [length < 0 ? -1 : 1, Math.max(Math.abs(length), rim) + GAP, 0];
    set(letter, { x: x + side * along, y: -y - across });
    Object.assign(letter.style, { textAnchor: side < 0 ? "end" : "start", visibility: isVisible ? "" : "hidden" });
    // Between small rollers, an index would reach the next roller.
    const index = letter.querySelector(".subscript");
    if (index) index.style.display = place.R < SMALLEST_RADIUS ? "none" : "";
    letter.parentNode.classList.toggle("faint", !data.forces.includes(force));
  }

  /** Draw the shares of the energy in a full bar. */
  function drawEnergy(known, writesShares) {
    const energies = [...BODIES.map((name) => FORMULAS.kinetic_energy[name](known)), FORMULAS.potential_energy(known)];
    const total = energies.reduce((sum, energy) => sum + energy, 0) || 1;
    energies.forEach((energy, i) => {
      bars[i].style.width = `${(100 * energy) / total}%`;
      if (writesShares) shares[i].textContent = withUnit(fixed(Math.round((100 * energy) / total), 0), "%");
    });
  }

  /** Draw the total energy after each full period: its value, and a bar with a mark at the energy of the release. */
  function drawTotalEnergy(playback) {
    const done = playback.fullPeriods, energy = playback.energyAt(done * TURN);
    bars[0].style.width = `${(100 * energy) / data.most_energy}%`;
    const sentence = fill(WORDS.energy_share, { share: withUnit(fixed(100 * energy, 0), "%") });
    const text = asked ? fill(WORDS.counting, { done, periods: asked, sentence }) : sentence;
    if (find(".total").textContent === text) return;
    find(".total").textContent = text;
    set(find(".energy"), { "aria-label": text });
  }

  function show(names) {
    shown = names;
    for (const name of layers) {
      for (const node of [find(`.${name}`), find(`[data-of=${name}]`)]) setVisible(node, shown.has(name));
    }
    if (data.forces) setVisible(find(".forces"), true);
    if (data.velocities) setVisible(find(".arrows"), true);
    find(".machine").classList.toggle("lettered", Boolean(data.forces));
    find(".energy").classList.toggle("marked", Boolean(data.most_energy));
    find(".energy").style.setProperty("--release", `${100 / data.most_energy}%`);
    setVisible(find(".rolling"), showsRolling());
    find(".machine").classList.toggle("from-block", seenFrom === "block");
    // Both keys have the same place.
    const hasSpeeds = shown.has("arrows") || showsRolling();
    setVisible(find(".speed"), hasSpeeds);
    setVisible(find(".shift"), shown.has("displacements") && !hasSpeeds);
    const hasForces = Boolean(data.forces) || shown.has("forces");
    const atCentres = ["displacements", "arrows", "coordinates"];
    const hasArrowsAtCentres = atCentres.some((name) => shown.has(name)) || showsRolling();
    find(".machine").classList.toggle("centred", hasForces && !data.forces && !hasArrowsAtCentres);
    isLayered = data.forces || data.velocities || [...shown].some((name) => name !== "energy");
    find(".machine").classList.toggle("layered", Boolean(isLayered));
  }
  const setVisible = (node, isVisible) => node && (node.style.display = isVisible ? "" : "none");

  return { geometry, machine, frame, show };
}

/**
 * Make a line in a body's colour, with a light rim so that it is visible on that body. Return a function that sets its
 * path.
 */
function makeLine(name, body, parent) {
  const group = element("g", { "data-line": name, "data-body": body, style: `--arrow: var(--${body}-ink)` }, parent);
  const paths = ["rim", "line"].map((kind) => element("path", { class: kind }, group));
  return (d) => paths.forEach((path) => set(path, { d }));
}
