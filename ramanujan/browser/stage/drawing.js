// The drawing: pure functions from a machine and its state to lengths, outlines and attributes. No page, no clock, no
// events. Lengths are centimetres of the picture; x points to the right, and y up from the floor. `place` is the
// geometry from `layout`. Numbers without a name are gaps and sizes that keep parts and letters clear of each other.

import { fill } from "../sentences.js";
import { FORMULAS } from "./formulas.js";
import { TURN, clamp, mapValues } from "./motion.js";
import { WORDS } from "./texts.js";

export const CM = 100; // per metre
export const BODIES = ["block", "hoop", "cylinder", "slab", "top"];
export const ROLLERS = ["hoop", "cylinder", "top"];
const RING = 0.78; // inner radius of a hoop divided by its outer radius
const BEVEL = 0.9; // distance between the block's edges and their highlights
const ASPECT = 2; // width of every picture divided by its height, as in stage.css
export const STRETCH = 50; // distance between two labels of the ruler
const BEYOND = 3 * STRETCH; // distance by which the floor extends beyond the view

/**
 * Return the geometry at φ = 0, to scale, with room for the largest travel. The view has the same shape for every
 * radius. Beside machines with larger rollers, it is as large as theirs, `widest` being the largest radius.
 */
export function layout({ radius }, { compression: [, largest], radius: widest }) {
  const R = radius * CM;
  const travel = largest * CM; // of the slab relative to the block, to either side
  const roll = travel / 2;
  const deck = 8, thick = 4.5, step = 3, gap = 2.5;
  const hoop = roll + R + gap;
  const cylinder = hoop + FORMULAS.spacing({ radius }) * CM;
  const slab = { left: hoop - roll - 4, right: cylinder + roll + 4, bottom: deck + 2 * R };
  const riser = slab.right + travel + 8;
  const upper = slab.bottom + thick + step;
  const top = riser - FORMULAS.edge.left({ radius, compression: largest }) * CM;
  const right = top + FORMULAS.edge.right({ radius }) * CM;
  const shelf = upper + R * 0.45; // the top of the bench for the plain mass
  const bottom = -Math.max(8.5, 3.5 + R / 2); // room for the ruler's numbers, which grow with the picture
  const own = fitView({ left: -9, right: right + travel + 2, bottom, top: Math.max(upper + 2 * R + 3, shelf + 14) });
  const view = widest > radius ? widen(own, layout({ radius: widest }, { compression: [0, largest] }).view) : own;
  const centre = { hoop: [hoop, deck + R], cylinder: [cylinder, deck + R], top: [top, upper + R] };
  // The block consists of two rectangles. Its centre of mass is the mean of their centres, weighted by their areas.
  const lowArea = riser * deck, highArea = (right - riser) * upper, area = lowArea + highArea;
  const blockX = (lowArea * (riser / 2) + highArea * ((riser + right) / 2)) / area;
  // The x of the centres of mass at φ = 0.
  const home = { block: blockX, slab: (slab.left + slab.right) / 2, hoop, cylinder, top };
  const floor = [-BEYOND, Math.ceil((view.right + BEYOND) / STRETCH) * STRETCH];
  return { R, travel, deck, thick, slab, riser, upper, right, view, centre, home, shelf, floor };
}

/** Widen a view to both sides, or upwards, until its aspect ratio is ASPECT. */
function fitView({ left, right, bottom, top }) {
  const width = Math.max(right - left, ASPECT * (top - bottom));
  const margin = (width - (right - left)) / 2;
  return { left: left - margin, right: right + margin, bottom, top: bottom + width / ASPECT };
}

/** Widen a view to the size of a larger one, with the floor at the same height and the machine in the middle. */
function widen({ left, right }, larger) {
  const margin = (larger.right - larger.left - (right - left)) / 2;
  return { ...larger, left: left - margin, right: right + margin };
}

/**
 * The displacement of each body [cm] in a view that has moved by `shift` [m]. `values`: symbol → value for the
 * formulas.
 */
export const displacements = (values, shift) =>
  mapValues(FORMULAS.displacement, (displacement) => (displacement(values) - shift) * CM);

/** The points at which the velocity arrows begin, at φ = 0. */
export function anchors(place) {
  return {
    block: [(place.riser + place.right) / 2, place.upper * 0.35],
    ...place.centre,
    // Between the slab and the row of 2Rφ; its head stays clear of x₀.
    slab: [0.7 * place.slab.left + 0.3 * place.slab.right, place.slab.bottom + place.thick + 2.5],
  };
}

const SHORTEST = 0.05; // the shortest arrow that is drawn

/** The largest length of an arrow's head, in proportion to a roller, so that it never covers the letter on it. */
export const headOf = (R) => clamp(0.28 * R, 1.4, 2.8);

/** The signed length of an arrow's head: at most half of the arrow, because a head alone looks like a wedge. */
const headLength = (length, longest) => Math.sign(length) * Math.min(Math.abs(length) / 2, longest);

/** A velocity: a slender arrow with an open head. Its length is signed. */
export function velocityArrow(x, y, length, longestHead) {
  if (Math.abs(length) < SHORTEST) return "";
  const head = headLength(length, longestHead);
  return `M${x} ${-y}h${length}m${-head} ${-0.6 * head}l${head} ${0.6 * head}l${-head} ${0.6 * head}`;
}

/** A displacement: a slender arrow with a filled head, and with a tick where the body was before the compression. */
export function displacementArrow(x, y, length, longestHead) {
  const tick = `M${x} ${-y - 1.8}v3.6`, head = headLength(length, longestHead);
  return `${tick}M${x} ${-y}h${length - head}v${-head / 2}l${head} ${head / 2}l${-head} ${head / 2}v${-head / 2}`;
}

/** A force: a broad, filled arrow. Its length is signed, and its head is like that of a velocity. */
export function forceArrow(x, y, length, longestHead) {
  if (Math.abs(length) < SHORTEST) return "";
  const head = headLength(length, longestHead), shaft = length - head;
  const [thick, wide] = [0.2 * head, 0.5 * head];
  const upper = [[0, thick], [shaft, thick], [shaft, wide], [length, 0]];
  const corners = [...upper, [shaft, -wide], [shaft, -thick], [0, -thick]];
  const points = corners.map(([along, across]) => `${x + along} ${-y - across}`);
  return `M${points.join("L")}z`;
}

/** The largest of 1, 2, 5, 10, 20, … that does not exceed a value. */
export function roundBelow(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const factor = [5, 2, 1].find((factor) => factor * power <= value * (1 + 1e-9));
  return factor * power;
}

/** Contact → its roller, the other body, and the contact's height above the roller's centre in radii (1 or −1). */
export const CONTACTS = mapValues(FORMULAS.contact_force, (_force, contact) => {
  const [roller, other] = contact.split("_");
  return { roller, other, side: other === "slab" ? 1 : -1 };
});

/** Whether a force, named by its contact and its body, acts on the roller of the contact. */
export function isOnRoller(name) {
  const [contact, body] = name.split(" ");
  return CONTACTS[contact]?.roller === body;
}

// cm, by which a force is drawn beside its contact or the spring, so that opposite arrows do not overlap.
const MAX_OFFSET = 1.5;

/**
 * The forces parallel to the floor, name → { body, x, y, newtons to the right, isPull }. A contact has two opposite and
 * equal forces. If the bodies are drawn apart, the force on a roller is outside its rim, and the other has room for its
 * letter within slab or block.
 */
export function horizontalForces(values, place, shift, areApart) {
  const displaced = displacements(values, shift), offset = Math.min(0.22 * place.R, MAX_OFFSET), forces = {};
  const [onRoller, onOther] = areApart ? [-offset, place.thick / 2] : [offset, offset];
  for (const [contact, { roller, other, side }] of Object.entries(CONTACTS)) {
    const x = place.centre[roller][0] + displaced[roller], y = place.centre[roller][1] + side * place.R;
    const friction = FORMULAS.contact_force[contact](values);
    forces[`${contact} ${roller}`] = { body: roller, x, y: y - side * onRoller, newtons: friction };
    forces[`${contact} ${other}`] = { body: other, x, y: y + side * onOther, newtons: -friction };
  }
  // The spring's forces are drawn on their bodies, so that they do not cover it: a push begins at the spring, and a
  // pull ends there. Both are clear of the letters of friction, above the slab and below the block's upper surface.
  const axis = place.slab.bottom + place.thick / 2, { slab, block } = FORMULAS.spring_force;
  const [from, to] = [place.slab.right + displaced.slab, place.riser + displaced.block], isPull = slab(values) > 0;
  forces["spring slab"] = { body: "slab", x: from, y: axis + 2.6 * offset, newtons: slab(values), isPull };
  forces["spring block"] = { body: "block", x: to, y: axis - 1.2 * offset, newtons: block(values), isPull };
  return forces;
}

/**
 * The two paths of a spring between two points at the same height. The front path has both ends and the strands in
 * front of the spring's axis; the back path has the strands behind it.
 */
export function coil(selector, from, to, y, height) {
  const turns = 10, lead = clamp((to - from) / 8, 0, 3), across = (to - from - 2 * lead) / turns / 2;
  // Each turn: draw a strand of this path, then move past the strand of the other path.
  const strands = (rise) => `l${across} ${-rise}m${across} ${rise}`.repeat(turns);
  return {
    [`${selector} .front`]: { d: `M${from} ${-y}h${lead}v${height}${strands(2 * height)}v${-height}H${to}` },
    [`${selector} .back`]: { d: `M${from + lead + across} ${-y - height}${strands(-2 * height)}` },
  };
}

/** The density of a body's fill: nearly empty for the lightest mass of the sliders, nearly full for the heaviest. */
export const density = (mass) => clamp(0.5 + 0.4 * Math.log10(mass), 0.12, 0.95);

/** The shape of a roller with the shape factor β = I/(mass·R²). */
function shapeOf(beta) {
  if (beta > 0.8) return "hoop";
  if (beta > 0.6) return "shell";
  return beta > 0.45 ? "cylinder" : "sphere";
}

/** The path along an ellipse between two angles, measured clockwise from the top. */
export function arc(x, y, across, upright, from, to) {
  // An SVG arc cannot be a full turn.
  const pieces = Math.ceil(Math.abs(to - from) / (TURN / 4)), step = (to - from) / pieces;
  const sweep = step > 0 ? 1 : 0;
  const point = (angle) => `${x + across * Math.sin(angle)} ${y - upright * Math.cos(angle)}`;
  const piece = (end) => `A${across} ${upright} 0 0 ${sweep} ${point(end)}`;
  return Array.from({ length: pieces }, (_, i) => piece(from + (i + 1) * step)).join("");
}

/** A roller's outline, the mark that shows its angle, and an inlay that makes its rotation visible from a distance. */
function rollerPaths(shape, R) {
  const circle = (r, sense = 1) => `M0 ${-r}${arc(0, 0, r, r, 0, sense * TURN)}z`;
  const ring = (outer, inner) => circle(outer * R) + circle(inner * R, -1);
  const meridian = `M0 ${-R}${arc(0, 0, 0.4 * R, R, 0, TURN)}z`;
  const sector = (from, to, r) => `M0 0L${r * Math.sin(from)} ${-r * Math.cos(from)}${arc(0, 0, r, r, from, to)}z`;
  const spot = (direction, r) => {
    const [x, y] = [0.55 * R * Math.sin(direction), -0.55 * R * Math.cos(direction)];
    return `M${x} ${y - r}${arc(x, y, r, r, 0, TURN)}z`;
  };
  const spots = [1, 3, 5].map((i) => spot((i / 6) * TURN, 0.2 * R));
  const sectors = [0, 1, 2].map((i) => sector((i / 3 - 1 / 12) * TURN, (i / 3 + 1 / 12) * TURN, 0.86 * R));
  return {
    hoop: { form: ring(1, RING), mark: `M0 ${-RING * R}V${-R}`, inlay: ring(0.92, 0.86) },
    shell: { form: circle(R), mark: circle(0.9 * R) + meridian, inlay: "" },
    cylinder: { form: circle(R), mark: `M0 ${-0.5 * R}V${-R}`, inlay: sectors.join("") },
    sphere: { form: circle(R), mark: `M0 ${-0.5 * R}V${-R}`, inlay: spots.join("") },
  }[shape];
}

/** The names of the three rollers' shapes. */
export const rollerWords = (parameters) => ROLLERS.map((name) => WORDS.bodies[shapeOf(parameters[`beta_${name}`])]);

/**
 * The names of the bodies. If both lower rollers have the same shape, their names contain the words left and right.
 * Otherwise the name of a lower roller with the shape of the top roller contains the word lower.
 */
export function bodyNames(parameters) {
  const words = WORDS.bodies, [left, right, top] = rollerWords(parameters);
  const lowerName = (side, body) => {
    if (left === right) return fill(words[side], { body });
    return body === top ? fill(words.lower, { body }) : body;
  };
  const [hoop, cylinder] = [lowerName("left", left), lowerName("right", right)];
  return { ...words, hoop, cylinder, top: fill(words.top, { body: top }) };
}

/**
 * The floor, and the shelf behind the machine on which the plain mass slides. The floor extends beyond the view, to the
 * edge of the screen. Both springs begin at the same x, and the plain mass's rest mark is above the slab's. The shelf
 * has a leg only beside the machine: through the bodies, one behind them would look like the end of the lower spring.
 */
export function scenery({ floor: [from, to], slab, travel, shelf, riser }) {
  const wide = 10, high = 6.5, end = slab.right, post = 1.4, left = -6, brace = 6;
  return {
    ".earth": { d: `M${from} 0H${to}V2.2H${from}z` },
    ".ground": { d: `M${from} 0H${to}` },
    ".bench": {
      d: `M${left} 0V${-shelf}H${riser}V${-shelf - high - 3}h${post}V${post - shelf}` +
        `H${left + post + brace}l${-brace} ${brace}V0z`,
    },
    ".plain .rest": { d: `M${end} ${-shelf}v${-high - 0.5}` },
    ".plain .form": { x: end - wide, y: -shelf - high, width: wide, height: high },
    ".plain .body text": { x: end - wide / 2, y: -shelf - high / 2 },
    ".plain .caption": { x: riser - 1, y: -shelf - high - 2 },
  };
}

/** The outlines of the bodies, and the positions of their letters. */
export function outlines(place, parameters) {
  const { R, riser, upper, right, deck, thick } = place;
  const { left: slabLeft, right: slabRight, bottom: slabBottom } = place.slab;
  const slab = { x: slabLeft, y: -slabBottom - thick, width: slabRight - slabLeft, height: thick };
  const handle = slab.x + 0.77 * slab.width; // clear of the letter, the velocity arrow and x₀
  const shadow = `M${0.55 * R} ${R}${arc(0, R, 0.55 * R, 0.1 * R, TURN / 4, (3 * TURN) / 4)}z`; // below the contact
  const rollers = ROLLERS.map((name) => {
    const { form, mark, inlay } = rollerPaths(shapeOf(parameters[`beta_${name}`]), R);
    const parts = { form, mark, inlay, shade: form, shadow };
    const drawn = Object.entries(parts).map(([part, d]) => [`.${name} .${part}`, { d }]);
    // The letter is below the centre, because an arrow begins at the centre.
    return { ...Object.fromEntries(drawn), [`.${name} text`]: { y: 0.44 * R } };
  });
  const block = { d: `M0 0V${-deck}H${riser}V${-upper}H${right}V0z` };
  return Object.assign({
    ".block .form": block,
    ".block .shade": block,
    ".block .bevel": { d: `M${BEVEL} ${-BEVEL}V${BEVEL - deck}H${riser + BEVEL}V${BEVEL - upper}H${right - BEVEL}` },
    ".block .rest": { d: `M${slabRight} ${-deck}V${-slabBottom - thick - 2}` }, // rest position of the slab's end
    ".block text": { x: (riser + right) / 2, y: -upper * 0.6 },
    ".slab .form": slab,
    ".slab .shade": slab,
    ".slab .grip": { ...slab, y: slab.y - 3, height: slab.height + 6 }, // a finger needs a taller target than the slab
    ".slab text": { x: slab.x + slab.width / 2, y: slab.y + slab.height / 2 },
    ".handle path": { d: [-1.2, 0, 1.2].map((x) => `M${handle + x} ${slab.y + 1}v${slab.height - 2}`).join("") },
    ".handle text": { x: handle, y: -(slabBottom + thick + place.shelf) / 2 },
    ".stiffness": { y: -slabBottom - thick / 2 + 5.4 },
  }, ...rollers);
}

/**
 * The positions of the bodies and the spring in a view that has moved by `shift` [m]; `values` as in `displacements`.
 */
export function positions(values, place, shift = 0) {
  const x = displacements(values, shift), [from, to] = [place.slab.right + x.slab, place.riser + x.block];
  const axis = place.slab.bottom + place.thick / 2;
  const table = { ...coil(".spring", from, to, axis, 2), ".stiffness": { x: (from + to) / 2 } };
  for (const [name, [x0, y0]] of Object.entries({ block: [0, 0], slab: [0, 0], ...place.centre }))
    table[`.${name}`] = { transform: `translate(${x0 + x[name]} ${-y0})` };
  for (const name of ROLLERS) {
    const degrees = (FORMULAS.angle[name](values) * 360) / TURN;
    table[`.${name} .spin`] = { transform: `rotate(${degrees})` };
  }
  return table;
}

/** The centre of mass of the whole machine in a view that has moved by `shift` [m]. */
export function centreOfMass(values, place, shift) {
  const displaced = displacements(values, shift);
  return FORMULAS.centre({ ...values, ...mapValues(place.home, (x, name) => x + displaced[name]) });
}

/** A quantity of the reference frame: the block's value of these formulas, or 0 for the ground. */
export const frameValue = (formulas, values, seenFrom) => (seenFrom === "block" ? formulas.block(values) : 0);

/** The path of the mark on a roller's rim through these states, relative to the ground or the block. */
export function rimTrace(name, states, place, seenFrom) {
  const [x, y] = place.centre[name];
  const points = states.map((values) => {
    const angle = FORMULAS.angle[name](values), origin = frameValue(FORMULAS.displacement, values, seenFrom);
    const displacement = displacements(values, origin)[name];
    return `${x + displacement + place.R * Math.sin(angle)} ${-(y + place.R * Math.cos(angle))}`;
  });
  return `M${points.join("L")}`;
}

/** The end of the motion, or null: the top roller beyond an edge ("edge"), or the slab against the block ("struck"). */
export function collision(values, place) {
  const { top, block } = FORMULAS.displacement;
  const x = (top(values) - block(values)) * CM + place.centre.top[0]; // of the top roller's centre on the block
  if (x < place.riser || x > place.right) return "edge";
  return Math.abs(FORMULAS.deformation(values)) * CM > place.travel + 8 ? "struck" : null;
}
