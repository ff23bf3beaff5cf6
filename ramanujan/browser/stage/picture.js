// The picture of one stage: puts the drawing's attributes on the nodes of stage.html, and is the only one that does. The
// layers that can be chosen are in layers.js, the clock hands, gauge and readouts in dial.js.

import { fill, fixed, withUnit } from "../components/sentences.js";
import { makeDial } from "./dial.js";
import {
  BODIES, CM, STRETCH, centreOfMass, coil, exposure, layout, leftPlace, outlines, placed, rollerWords, scenery, weight,
} from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { makeLayers } from "./layers.js";
import { TURN } from "./motion.js";
import { finder } from "./parts.js";
import { element, put, set, strip } from "./svg.js";
import { WORDS } from "./texts.js";

const TRAIL = { positions: 8, apart: TURN / 60 }; // the last ones, so much of a period apart

/**
 * The picture under a root.
 *
 * geometry(parameters)                              the radius or a body's shape has changed
 * machine({ parameters, solution, data, playback })  any parameter or the computed motion has changed
 * frame({ known, playback, shift, write })           a frame: known = parameters, state, Omega; shift [m] of the view;
 *                                                   write: the running numbers, too
 * show(layers)                                      the set of layers that are seen
 * ghosts(states)                                    the still for less motion, several exposures, or none
 * leaves(known)                                     what has left its place in this state, if anything has
 * toMetres(clientX)                                 from the pointer to metres along the floor, in the view
 */
export function makePicture(root, { compact, dials, narrow, limits, label }, signal) {
  const find = finder(root);
  const host = find(".stage"), svg = find(".machine"), moving = find(".moving");
  const inMoving = finder(moving), layers = makeLayers(root), dial = makeDial(root);
  const sizes = new ResizeObserver(fitText);
  signal.addEventListener("abort", () => sizes.disconnect());
  let place = null, shifted = 0, ends = [0, 0], left = 0; // phase of the last position in the trail

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
    moving.style.setProperty("--R", place.R);
    put(find, scenery(place));
    put(inMoving, outlines(place, parameters));
    drawRuler(svg, place);
    layers.geometry(place, parameters);
    // Its size is told anew with the next layout, so that none is made for it alone.
    sizes.unobserve(svg);
    sizes.observe(svg);
  }

  function machine({ parameters, solution, data, clock, playback, parts: { hides } }) {
    for (const name of BODIES) inMoving(`.${name}`).style.setProperty("--weight", weight(FORMULAS.mass[name](parameters)));
    find(".plain .body").style.setProperty("--weight", weight(parameters.m));
    const [left, right, top] = rollerWords(parameters);
    set(find(".picture"), { role: "img", "aria-label": fill(WORDS.picture, { left, right, top }) });
    find(".computed").replaceChildren(...(data.computed ? [copied({ ...parameters, ...playback.now() })] : []));
    dial.machine(solution, !hides("clocks") && !hides("motion"));
    layers.machine(parameters, solution, data, clock.seenFrom);
  }

  function frame({ known, playback, shift, write }) {
    const plain = known.plain * CM;
    put(inMoving, placed(known, place, shift));
    put(find, {
      ".plain .body": { transform: `translate(${plain})` },
      ...coil(".plain .coil", place.slab.right + plain, place.riser, place.shelf + 3.2, 2),
      ".centre": { transform: `translate(${centreOfMass(known, place, shift)} -2.4)` },
    });
    if (shift * CM !== shifted) slideFloor(svg, (shifted = shift * CM), ends);
    leave(known, playback.phase, shift);
    if (playback.computed) follow(known, playback, shift);
    layers.frame(known, shift, write);
    dial.frame(playback, write);
  }

  /** Leave a faint outline of what has just moved; none after a leap in time, nor where the machine stands. */
  function leave(known, phase, shift) {
    const trail = find(".trail"), passed = Math.abs(phase - left);
    if (!host.classList.contains("playing")) return trail.replaceChildren();
    if (passed < TRAIL.apart) return;
    left = phase;
    if (passed > 4 * TRAIL.apart) return trail.replaceChildren();
    const outline = trail.children.length < TRAIL.positions ? element("path") : trail.firstChild;
    set(outline, { d: exposure(known, place, shift) });
    trail.append(outline);
  }

  /** A copy of the machine in a state, that nobody can take hold of. */
  function copied(known) {
    const ghost = moving.cloneNode(true);
    set(ghost, { class: "ghost" });
    for (const node of ghost.querySelectorAll("text, title, .grip, .handle, .rest")) node.remove();
    for (const node of ghost.querySelectorAll("*")) strip(node, /^(tabindex$|role$|aria-)/);
    put(finder(ghost), placed(known, place));
    return ghost;
  }

  /** Draw the computed machine, and count what it has cost. */
  function follow(known, playback, shift) {
    const { log } = playback.computed, period = Math.min(Math.floor(playback.phase / TURN + 1e-9), log.length - 1);
    const [evaluations, turns] = log[period];
    put(finder(find(".computed")), placed({ ...known, ...playback.rival() }, place, shift));
    find(".label").textContent = fill(WORDS.counted, { period, periods: log.length - 1, evaluations, turns });
  }

  return {
    geometry,
    machine,
    frame,
    show: layers.show,
    ghosts: (states) => find(".ghosts").replaceChildren(...states.map(copied)),
    leaves: (known) => leftPlace(known, place),
    toMetres: (clientX) => new DOMPoint(clientX, 0).matrixTransform(svg.getScreenCTM().inverse()).x / CM,
  };
}

/** The marks of the ruler, and its labels without their words. */
function drawRuler(root, { floor: [from, to], view }) {
  const ruler = root.querySelector(".ruler");
  ruler.replaceChildren();
  delete ruler.dataset.at;
  let ticks = "";
  for (let x = from; x <= to; x += 10) ticks += `M${x} 0V${x % STRETCH ? 1.6 : 2.8}`;
  element("path", { d: ticks }, ruler);
  for (let x = from; x <= to; x += STRETCH) element("text", { x, y: -0.69 * view.bottom }, ruler);
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
