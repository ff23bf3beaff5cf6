// The picture of one stage: sets the attributes from drawing.js on the nodes of stage.html. The layers with tick boxes
// are in layers.js; the clock hands, their drift and the readouts are in dial.js.

import { fill, fixed, withUnit } from "../sentences.js";
import { makeDial } from "./dial.js";
import {
  BODIES, CM, STRETCH, centreOfMass, coil, collision, density, displacements, layout, outlines, positions, rollerWords,
  scenery,
} from "./drawing.js";
import { FORMULAS } from "./formulas.js";
import { makeLayers } from "./layers.js";
import { TURN } from "./motion.js";
import { finder } from "./parts.js";
import { element, put, set, strip } from "./svg.js";
import { WORDS } from "./texts.js";

const SUNKEN_FLOOR = 1.5; // cm between the floor and the lower edge of the view while the bodies are drawn apart
const CHARACTER = 0.54; // width of a character of the ruler's labels, at most, relative to the picture's font size

/**
 * Make the picture of a stage with these functions:
 *
 * - geometry(parameters): draw a new radius or shape of a body
 * - machine({ parameters, solution, data, playback }): draw any new parameter or computed motion
 * - frame({ known, playback, shift, writesText }): draw a frame. known: parameters, state, Omega; shift: of the view
 *   [m]; writesText: whether the running numbers are updated, too
 * - explainDrift(sentence): replace the sentence about the drift until the drift changes
 * - show(layers): show this set of layers
 * - ghosts(states): draw copies of the machine in these states, for reduced motion
 * - collision(known): return the end of the motion in this state, or null
 * - toMetres(clientX): convert a pointer's x to metres along the floor
 */
export function makePicture(root, { compact, dials, narrow, limits, label, rest_after: asked }, signal) {
  const find = finder(root);
  const host = find(".stage"), svg = find(".machine"), moving = find(".moving");
  const inMoving = finder(moving), layers = makeLayers(root, asked), dial = makeDial(root, asked);
  const sizes = new ResizeObserver(fitText);
  signal.addEventListener("abort", () => sizes.disconnect());
  let place = null; // the geometry from `layout`
  let shifted = 0; // cm, the shift of the view in the last frame
  let floorShown = { left: 0, right: 0, character: 0 }; // the visible ends, and the width of a character below them

  host.classList.toggle("compact", compact);
  host.classList.toggle("no-dials", !dials);
  host.classList.toggle("narrow", Boolean(narrow));
  find(".label").textContent = label ?? "";
  if (label) set(host, { "aria-label": label });

  /** Set the style sheet's --u, the picture units per pixel. */
  function fitText() {
    if (!place) return;
    const scale = svg.getScreenCTM()?.a;
    if (!scale) return;
    svg.style.setProperty("--u", String(1 / scale));
    // The screen can show more than the view.
    const { left, right } = place.view, middle = (left + right) / 2, half = svg.clientWidth / 2 / scale;
    const character = (CHARACTER * parseFloat(getComputedStyle(svg).fontSize)) / scale;
    floorShown = { left: middle - half, right: middle + half, character };
    // The scales of the arrows are at the left end of the visible area.
    set(find(".scales"), { transform: `translate(${Math.min(0, (right - left - svg.clientWidth / scale) / 2)})` });
    slideFloor(svg, shifted, floorShown);
  }

  function geometry(parameters) {
    place = layout(parameters, limits);
    const { left, right, bottom, top } = place.view;
    set(svg, { viewBox: `${left} ${-top} ${right - left} ${top - bottom}` });
    moving.style.setProperty("--R", place.R);
    // The bodies are drawn apart as far as the floor can sink within the view.
    svg.style.setProperty("--gap", -bottom - SUNKEN_FLOOR);
    put(find, scenery(place));
    put(inMoving, outlines(place, parameters));
    drawRuler(svg, place);
    layers.geometry(place, parameters);
    // Measure the text with the next layout, because an additional layout would be slow.
    sizes.unobserve(svg);
    sizes.observe(svg);
  }

  function machine({ parameters, solution, data, clock, playback, parts: { hides } }) {
    for (const name of BODIES) {
      const mass = FORMULAS.mass[name](parameters);
      inMoving(`.${name}`).style.setProperty("--weight", density(mass));
    }
    find(".plain .body").style.setProperty("--weight", density(parameters.m));
    const [left, right, top] = rollerWords(parameters);
    set(find(".picture"), { role: "img", "aria-label": fill(WORDS.picture, { left, right, top }) });
    find(".computed").replaceChildren(...(data.computed ? [copyMachine({ ...parameters, ...playback.now() })] : []));
    dial.machine(solution, !data.computed && !hides("clocks") && !hides("motion"));
    if (data.computed) dial.compare(data.computed);
    host.classList.toggle("race", Boolean(data.computed));
    layers.machine(parameters, solution, data, clock.seenFrom);
  }

  function frame({ known, playback, shift, writesText }) {
    const plain = known.plain * CM;
    put(inMoving, positions(known, place, shift));
    put(find, {
      ".plain .body": { transform: `translate(${plain})` },
      ...coil(".plain .coil", place.slab.right + plain, place.riser, place.shelf + 3.2, 2),
      ".centre": { transform: `translate(${centreOfMass(known, place, shift)} -2.4)` },
    });
    if (shift * CM !== shifted) slideFloor(svg, (shifted = shift * CM), floorShown);
    if (playback.computed) drawComputed(known, playback, shift);
    layers.frame(known, shift, playback, writesText);
    dial.frame(playback, writesText);
  }

  /** Return a copy of the machine in a state, without labels and without interaction. */
  function copyMachine(known) {
    const ghost = moving.cloneNode(true);
    set(ghost, { class: "ghost" });
    for (const node of ghost.querySelectorAll("text, title, .grip, .handle, .rest")) node.remove();
    for (const node of ghost.querySelectorAll("*")) strip(node, /^(tabindex$|role$|aria-)/);
    put(finder(ghost), positions(known, place));
    return ghost;
  }

  /**
   * Draw the computed machine, and mark the gap between the left ends of both slabs. Write the run and its evaluations
   * below the picture.
   */
  function drawComputed(known, playback, shift) {
    const { run_name: run, evaluations } = playback.computed, periods = evaluations.length - 1;
    const period = Math.min(Math.floor(playback.phase / TURN + 1e-9), periods);
    const computed = { ...known, ...playback.computedState() };
    put(finder(find(".computed")), positions(computed, place, shift));
    const [from, to] = [known, computed].map((values) => place.slab.left + displacements(values, shift).slab);
    const height = -place.slab.bottom - place.thick - 2.5;
    put(find, {
      ".gap path": { d: `M${from} ${height - 1.5}v3m0 -1.5H${to}m0 -1.5v3` },
      ".gap text": { x: (from + to) / 2, y: height - 5 },
    });
    find(".gap text").textContent = fill(WORDS.gap, { gap: withUnit(fixed(Math.abs(to - from), 1), "cm") });
    find(".label").textContent = fill(WORDS.counted, { run, period, periods, evaluations: evaluations[period] });
  }

  return {
    geometry,
    machine,
    frame,
    explainDrift: dial.explain,
    show: layers.show,
    ghosts: (states) => find(".ghosts").replaceChildren(...states.map(copyMachine)),
    collision: (known) => collision(known, place),
    toMetres: (clientX) => new DOMPoint(clientX, 0).matrixTransform(svg.getScreenCTM().inverse()).x / CM,
  };
}

/** Draw the ticks of the ruler, and its labels without their text. */
function drawRuler(root, { floor: [from, to], view }) {
  const ruler = root.querySelector(".ruler");
  ruler.replaceChildren();
  delete ruler.dataset.at;
  let ticks = "";
  for (let x = from; x <= to; x += 10) ticks += `M${x} 0V${x % STRETCH ? 1.6 : 2.8}`;
  element("path", { d: ticks }, ruler);
  for (let x = from; x <= to; x += STRETCH) element("text", { x, y: -0.69 * view.bottom }, ruler);
}

/**
 * Slide the ruler under a view that has moved by `shift`. Show only the labels that the ends of the view do not cut.
 */
function slideFloor(root, shift, { left, right, character }) {
  const ruler = root.querySelector(".ruler");
  const stretches = Math.floor(shift / STRETCH), moved = stretches * STRETCH - shift;
  set(ruler, { transform: `translate(${moved})` });
  for (const label of ruler.querySelectorAll("text")) {
    const x = Number(label.getAttribute("x"));
    if (ruler.dataset.at !== String(stretches)) label.textContent = withUnit(fixed(x + stretches * STRETCH, 0), "cm");
    const half = (character * label.textContent.length) / 2;
    label.style.visibility = x + moved - half > left && x + moved + half < right ? "" : "hidden";
  }
  ruler.dataset.at = stretches;
}
