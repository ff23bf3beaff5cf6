// The layer Coordinates: X, φ and Φ with their positive sense, x₀, R, and a bracket for the lower rollers' common mass.
// Lengths are centimetres of the picture; y points up. `place` is the geometry from `layout`. Numbers without a name
// are gaps and sizes that keep marks and labels clear of each other.

import { CM, ROLLERS, arc, displacements, headOf, velocityArrow } from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { TURN } from "./motion.js";
import { element, put } from "./svg.js";
import { WORDS } from "./texts.js";

const ARC = 0.5; // radius of the arc that shows an angle, in radii of the roller
// The arrow of the positive sense outside the rim [degrees, radii], between the forces at the top and at the bottom.
const SENSE = { from: 66, to: 96, label: 90, radius: 1.12 };

/** Return mark → attributes: `d` of a line, or x and y of a label. Pure. */
function coordinateMarks(known, place, shift) {
  const x = displacements(known, shift);
  const angles = ROLLERS.map((name) => angleMarks(name, FORMULAS.angle[name](known), x[name], place));
  return {
    ...blockMarks(x.block, -shift * CM, place),
    ...Object.assign({}, ...angles),
    ...slabMarks(x.block, x.slab, known.compression * CM, place),
    ...radiusMarks(x.top, place),
    ...sharedMarks(x.hoop, place),
  };
}

/**
 * X, the block's displacement to the left of its initial position, in the floor; and its positive sense at the block's
 * edge.
 */
function blockMarks(edge, origin, place) {
  const y = place.deck + 4.5, length = -7.5;
  return {
    X_guide: { d: `M${edge} ${-place.deck}V${-y - 2}M${origin} 0V2.6` },
    X_value: { d: `M${origin} 1.3H${edge}` },
    X_sense: { d: velocityArrow(edge, y, length, headOf(place.R)) },
    X_label: { x: edge + length + 2.6, y: -y - 2.2 },
  };
}

/** An angle from the vertical to the mark on the rim. Outside the rim an arrow shows the positive sense, clockwise. */
function angleMarks(name, angle, displacement, place) {
  const [x0, y0] = place.centre[name], x = x0 + displacement, { R } = place;
  const point = (radii, direction) => `${x + radii * R * Math.sin(direction)} ${-y0 - radii * R * Math.cos(direction)}`;
  const turn = ((angle % TURN) + TURN) % TURN, signed = turn > Math.PI ? turn - TURN : turn;
  const [from, to, labelAngle] = [SENSE.from, SENSE.to, SENSE.label].map((degrees) => (degrees * TURN) / 360);
  const value = `M${x} ${-y0}L${point(ARC, 0)}${arc(x, -y0, ARC * R, ARC * R, 0, signed)}z`;
  const radius = SENSE.radius * R;
  const headStart = to - 1.8 / radius; // angle at which the arrow's head begins
  const [outer, inner] = [SENSE.radius + 0.9 / R, SENSE.radius - 0.9 / R];
  const head = `M${point(outer, headStart)}L${point(SENSE.radius, to)}L${point(inner, headStart)}`;
  return {
    [`${name}_guide`]: { d: `M${x} ${-y0}L${point(1, 0)}` },
    [`${name}_value`]: { d: Math.abs(signed) < 1e-3 ? "" : value },
    [`${name}_radius`]: { d: `M${x} ${-y0}L${point(1, signed)}` },
    [`${name}_sense`]: { d: `M${point(SENSE.radius, from)}${arc(x, -y0, radius, radius, from, to)}${head}` },
    [`${name}_label`]: { x: x + (radius + 1.2) * Math.sin(labelAngle), y: -y0 - (radius + 1.2) * Math.cos(labelAngle) },
  };
}

/**
 * Lengths from the slab's end at the spring's natural length: x₀ to the point of release, 2Rφ to the present position.
 * The label of 2Rφ is at the right end of its arrow, whatever its direction.
 */
function slabMarks(block, slab, compression, place) {
  const [right, left, end] = [place.slab.right + block, place.slab.left + block, place.slab.left + slab];
  const above = place.slab.bottom + place.thick, y0 = above + 4.4, y = above + 8.4 * Math.max(1, place.R / 10);
  const guide = (from, to, y) => ({ d: `M${from} ${-above}V${-y - 1.2}M${to} ${-above}V${-y - 1.2}` });
  return {
    x0_guide: guide(right, right + compression, y0),
    x0_value: { d: `M${right} ${-y0}h${compression}` },
    x0_label: { x: right - 1, y: -y0 - 0.7 },
    slab_guide: guide(left, end, y),
    slab_value: { d: velocityArrow(left, y, end - left, headOf(place.R)) },
    slab_label: { x: Math.max(left, end) + 1, y: -y },
  };
}

/** R, drawn in the top roller; all three have the same radius. */
function radiusMarks(displacement, place) {
  const [x0, y0] = place.centre.top, x = x0 + displacement;
  const direction = (-60 * TURN) / 360; // of the line, from the vertical
  // Distance of the label from the centre, in radii. Inside the circle, it would cover the letter of the mass.
  const outside = 1.54;
  const [dx, dy] = [place.R * Math.sin(direction), place.R * Math.cos(direction)];
  return {
    R_value: { d: `M${x} ${-y0}l${dx} ${-dy}` },
    R_label: { x: x + outside * dx, y: -y0 - outside * dy },
  };
}

/** A bracket under the two lower rollers, which have the same mass. */
function sharedMarks(displacement, place) {
  const [left, right] = ["hoop", "cylinder"].map((name) => place.centre[name][0] + displacement), y = place.deck - 2;
  return {
    shared_value: { d: `M${left} ${-y - 1}V${-y}H${right}V${-y - 1}` },
    shared_label: { x: (left + right) / 2, y: -y + 2.8 },
  };
}

const LABELS = {
  X_label: "X", hoop_label: "φ", cylinder_label: "φ", top_label: "Φ", x0_label: "x", R_label: "R",
  slab_label: WORDS.deformation, shared_label: WORDS.each,
};

/** Draw the marks below a node. Each mark's element is created once and reused. */
export function drawCoordinates(root, known, place, shift) {
  const find = (name) => root.querySelector(`[data-mark=${name}]`) ?? makeMark(name, root);
  put(find, coordinateMarks(known, place, shift));
}

function makeMark(name, root) {
  const [quantity, kind] = name.split("_"), body = { X: "block", x0: "spring" }[quantity] ?? quantity;
  const data = { "data-mark": name, "data-of": quantity, style: `--of: var(--${body}-ink, var(--ink))` };
  if (kind !== "label") return element("path", { class: kind, ...data }, root);
  const text = Object.assign(element("text", data, root), { textContent: LABELS[name] });
  // The small zero of the text font looks like an o.
  if (name === "x0_label") element("tspan", { class: "subscript", dy: ".2em" }, text).textContent = "0";
  return text;
}
