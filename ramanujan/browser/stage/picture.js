// The picture of one stage: puts the drawing's attributes on the nodes of stage.html, and is the only one that does. The
// layers that can be chosen are in layers.js, the clock hands, gauge and readouts in dial.js.

import { fixed, withUnit } from "../page/sentences.js";
import { makeDial } from "./dial.js";
import { BODIES, CM, ROLLERS, centreOfMass, coil, layout, placed, rollerPaths, shapeOf, weight } from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { makeLayers } from "./layers.js";
import { finder } from "./parts.js";
import { element, set } from "./svg.js";
import { WORDS } from "./texts.js";
import { pictured } from "./words.js";

/**
 * The picture under a root.
 *
 * geometry(parameters)                              the radius or a body's shape has changed
 * machine({ parameters, solution, data, parts })     any parameter has changed
 * frame({ known, phase, plainPhase, shift, write })  a frame: known = parameters, state, Omega; shift [m] of the view;
 *                                                   write: the running numbers, too
 * show(layers)                                      the set of layers that are seen
 * ghosts(states | null)                             the still of the present machine
 * place                                             the layout's lengths
 * toMetres(clientX)                                 from the pointer to metres along the floor, in the view
 */
export function makePicture(root, { compact, dials, narrow, limits, label }, signal) {
  const find = finder(root);
  const host = find(".stage"), svg = find(".machine"), moving = find(".moving");
  const parts = movingParts(moving), layers = makeLayers(root), dial = makeDial(root);
  const sizes = new ResizeObserver(fitText);
  signal.addEventListener("abort", () => sizes.disconnect());
  let place = null, ghosts = [], shifted = 0, ends = [0, 0];

  host.classList.toggle("compact", compact);
  host.classList.toggle("no-dials", !dials);
  host.classList.toggle("narrow", Boolean(narrow));
  find(".label").textContent = label ?? "";
  if (label) set(host, { "aria-label": label });

  /** Tell the style sheet how many picture units a pixel is. */
  function fitText() {
    if (!place) return;
    const scale = svg.getScreenCTM()?.a;
    if (!scale) return;
    svg.style.setProperty("--u", String(1 / scale));
    // What the screen shows can be wider than the view, and a label of the ruler is whole or not there.
    const { left, right } = place.view, word = 2 * parseFloat(getComputedStyle(svg).fontSize);
    const half = (svg.clientWidth / 2 - word) / scale;
    ends = [(left + right) / 2 - half, (left + right) / 2 + half];
    // The arrows of known size stand at the left end of what is seen.
    set(find(".scales"), { transform: `translate(${Math.min(0, (right - left - svg.clientWidth / scale) / 2)})` });
    slideFloor(svg, shifted, ends);
  }

  function geometry(parameters) {
    place = layout(parameters, limits.compression);
    const { left, right, bottom, top } = place.view;
    set(svg, { viewBox: `${left} ${-top} ${right - left} ${top - bottom}` });
    drawFloor(svg, place);
    drawBodies(moving, place, parameters);
    layers.geometry(place, parameters);
    drawPlain();
    // Its size is told anew with the next layout, so that none is made for it alone.
    sizes.unobserve(svg);
    sizes.observe(svg);
  }

  function drawPlain() {
    const wide = 10, high = 6.5, end = place.slab.right, start = end - place.travel - wide - 2;
    set(find(".shelf"), { d: `M${start} ${-place.shelf}H${place.riser}` });
    set(find(".wall"), { d: `M${place.riser} ${-place.shelf + 1.5}V${-place.shelf - high - 3}` });
    set(find(".plain .form"), { x: end - wide, y: -place.shelf - high, width: wide, height: high });
    set(find(".plain .body text"), { x: end - wide / 2, y: -place.shelf - high / 2 });
    set(find(".plain .caption"), { x: place.riser - 1, y: -place.shelf - high - 4 });
  }

  function machine({ parameters, solution, data, clock, parts: { hides } }) {
    for (const name of BODIES) parts[name].group.style.setProperty("--weight", weight(FORMULAS.mass[name](parameters)));
    find(".plain .body").style.setProperty("--weight", weight(parameters.m));
    set(find(".picture"), { role: "img", "aria-label": pictured(parameters) });
    light(data.lit);
    dial.machine(solution, !hides("clocks"));
    layers.machine(parameters, solution, data, clock.seenFrom);
  }

  /** Let one body, or the spring, stand out; without a name, all are alike. */
  function light(name) {
    host.classList.toggle("one-lit", Boolean(name));
    for (const body of BODIES) parts[body].group.classList.toggle("lit", body === name);
    parts.spring.classList.toggle("lit", name === "spring");
  }

  function frame({ known, phase, plainPhase, shift, write }) {
    moveBodies(parts, known, place, shift);
    const plain = known.plain * CM;
    set(find(".plain .body"), { transform: `translate(${plain})` });
    set(find(".plain .coil"), { d: coil(place.slab.right + plain, place.riser, place.shelf + 3.2, 1.8) });
    set(find(".centre"), { transform: `translate(${centreOfMass(known, place, shift)} -2.4)` });
    if (shift * CM !== shifted) slideFloor(svg, (shifted = shift * CM), ends);
    layers.frame(known, shift, write);
    dial.frame(phase, plainPhase, write);
  }

  /** The still of someone who asked for less motion: the machine in several exposures, that nobody can take hold of. */
  function drawGhosts(states) {
    for (const ghost of ghosts) ghost.remove();
    ghosts = (states ?? []).map((known) => {
      const ghost = moving.cloneNode(true);
      set(ghost, { class: "ghost" });
      for (const node of ghost.querySelectorAll("text, title, .grip, .handle")) node.remove();
      for (const node of ghost.querySelectorAll("*"))
        for (const name of node.getAttributeNames()) if (name === "tabindex" || name === "role" || name.startsWith("aria-")) node.removeAttribute(name);
      find(".ghosts").append(ghost);
      moveBodies(movingParts(ghost), known, place);
      return ghost;
    });
  }

  return {
    geometry,
    machine,
    frame,
    show: layers.show,
    ghosts: drawGhosts,
    get place() {
      return place;
    },
    toMetres: (clientX) => new DOMPoint(clientX, 0).matrixTransform(svg.getScreenCTM().inverse()).x / CM,
  };
}

function drawBodies(root, g, parameters) {
  const body = (name, selector) => root.querySelector(`.body.${name} ${selector}`);
  root.style.setProperty("--R", g.R);
  set(body("block", ".form"), { d: `M0 0V${-g.deck}H${g.riser}V${-g.upper}H${g.right}V0z` });
  set(body("block", "text"), { x: (g.riser + g.right) / 2, y: -g.upper * 0.6 });
  for (const name of ROLLERS) {
    const { form, mark } = rollerPaths(shapeOf(parameters[`beta_${name}`]), g.R);
    set(body(name, ".form"), { d: form });
    set(body(name, ".mark"), { d: mark });
    // Below the centre, where no arrow begins.
    set(body(name, "text"), { y: 0.44 * g.R });
  }
  const slab = { x: g.slab.left, y: -g.slab.bottom - g.thick, width: g.slab.right - g.slab.left, height: g.thick };
  set(body("slab", ".form"), slab);
  // A finger needs more than the slab's own height.
  set(body("slab", ".grip"), { ...slab, y: slab.y - 3, height: slab.height + 6 });
  set(body("slab", "text"), { x: slab.x + slab.width / 2, y: slab.y + slab.height / 2 });
  const held = slab.x + 0.77 * slab.width; // clear of the letter, of the velocity's arrow and of x₀
  set(body("slab", ".handle path"), { d: [-1.2, 0, 1.2].map((x) => `M${held + x} ${slab.y + 1}v${slab.height - 2}`).join("") });
  set(body("slab", ".handle text"), { x: held, y: -(g.slab.bottom + g.thick + g.shelf) / 2 });
  body("slab", ".handle text").textContent = WORDS.drag;
  set(root.querySelector(".stiffness"), { y: -g.slab.bottom - g.thick / 2 + 4.5 });
  root.querySelector(".stiffness").textContent = WORDS.stiffness;
}

/** The nodes that move, looked up once. */
function movingParts(root) {
  const found = { spring: root.querySelector(".spring"), stiffness: root.querySelector(".stiffness") };
  for (const name of BODIES) {
    const group = root.querySelector(`.body.${name}`);
    found[name] = { group, spin: group.querySelector(".spin") };
  }
  return found;
}

function moveBodies(parts, known, g, shift) {
  const at = placed(known, g, shift);
  for (const name of BODIES) {
    set(parts[name].group, { transform: at.bodies[name] });
    if (parts[name].spin) set(parts[name].spin, { transform: at.spins[name] });
  }
  set(parts.spring, { d: at.spring });
  if (parts.stiffness) set(parts.stiffness, { x: at.stiffness });
}

/** The floor and its ruler: both far beyond the view, so that they end at the edge of the screen and not before. */
const STRETCH = 50, BEYOND = 3 * STRETCH;
function drawFloor(root, g) {
  const from = -BEYOND, to = Math.ceil((g.view.right + BEYOND) / STRETCH) * STRETCH;
  set(root.querySelector(".earth"), { d: `M${from} 0H${to}V2.2H${from}z` });
  set(root.querySelector(".ground"), { d: `M${from} 0H${to}` });
  const ruler = root.querySelector(".ruler");
  ruler.replaceChildren();
  delete ruler.dataset.at;
  let ticks = "";
  for (let x = from; x <= to; x += 10) ticks += `M${x} 0V${x % STRETCH ? 1.6 : 2.8}`;
  element("path", { d: ticks }, ruler);
  for (let x = from; x <= to; x += STRETCH) element("text", { x, y: 5.9 }, ruler);
}

/** Slide the ruler under a view that has moved; the labels between the ends say where on the floor one looks. */
function slideFloor(root, shift, [left, right]) {
  const ruler = root.querySelector(".ruler"), stretches = Math.floor(shift / STRETCH), moved = stretches * STRETCH - shift;
  set(ruler, { transform: `translate(${moved})` });
  for (const label of ruler.querySelectorAll("text")) {
    const x = Number(label.getAttribute("x"));
    label.style.visibility = x + moved > left && x + moved < right ? "" : "hidden";
    if (ruler.dataset.at !== String(stretches)) label.textContent = withUnit(fixed(x + stretches * STRETCH, 0), "cm");
  }
  ruler.dataset.at = stretches;
}
