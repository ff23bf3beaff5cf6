// Draws Ω²m/k as a function of the mass ratio, as SVG. The picture contains the curve, its limits, two marked machines, and a
// ring at the present machine.

import { bus } from "../components/bus.js";
import { DECIMAL } from "../components/language.js";
import { FORMULAS } from "../stage/formulas.js";
import { element, set } from "../stage/svg.js";

const BOX = { left: 48, right: 628, top: 12, bottom: 290 };
const TICKS = { x: [0.01, 0.1, 1, 10], y: [0, 0.5, 1, 1.5] };
const POINTS = 240;
const NEAR = 0.02; // relative distance at which a click selects a marked ratio

/** Draw the curve; `pick` is called with the mass ratio of a click. */
export function drawCurve(svg, { range, light, heavy, equal, unit, words, shape }, pick) {
  const [least, most] = range, top = 1.16 * light;
  const x = (ratio) => BOX.left + (Math.log(ratio / least) / Math.log(most / least)) * (BOX.right - BOX.left);
  const y = (value) => BOX.bottom - (value / top) * (BOX.bottom - BOX.top);
  const value = (ratio) => FORMULAS.normalized_frequency_squared({ ...shape, m: 1, m_prime: ratio });
  const ratios = Array.from({ length: POINTS + 1 }, (_, i) => least * (most / least) ** (i / POINTS));
  const path = (points, height) => `M${points.map((ratio) => `${x(ratio).toFixed(2)} ${y(height(ratio)).toFixed(2)}`).join("L")}`;

  const add = (name, attributes, text = "") => Object.assign(element(name, attributes, svg), { textContent: text });

  // The axes.
  const label = (number) => String(number).replace(".", DECIMAL);
  for (const ratio of TICKS.x) {
    add("line", { class: "grid", x1: x(ratio), x2: x(ratio), y1: BOX.top, y2: BOX.bottom });
    add("text", { class: "axis", x: x(ratio), y: BOX.bottom + 16 }, label(ratio));
  }
  for (const height of TICKS.y) {
    add("line", { class: "grid", x1: BOX.left, x2: BOX.right, y1: y(height), y2: y(height) });
    add("text", { class: "scale", x: BOX.left - 6, y: y(height) + 4 }, label(height));
  }
  add("text", { class: "axis", x: (BOX.left + BOX.right) / 2, y: BOX.bottom + 34 }, words.axis);
  add("text", { x: 4, y: BOX.top + 2 }, "Ω²m/k");

  // The curve with its limits. The asymptote heavy/ε begins near the curve.
  const low = ratios.filter((ratio) => heavy / ratio < 0.75 * light);
  add("path", { class: "limit", d: path([least, most], () => light) });
  add("path", { class: "limit", d: path(low, (ratio) => heavy / ratio) });
  add("path", { class: "unity", d: path([least, most], () => 1) });
  add("text", { x: BOX.left + 6, y: y(light) - 5 }, words.light);
  add("text", { x: x(low[0]) + 8, y: y(heavy / low[0]) + 4 }, words.heavy);
  add("text", { class: "scale unity", x: BOX.right, y: y(1) - 6 }, words.step);
  add("path", { class: "line", d: path(ratios, value) });

  // The marked machines, with lines from their labels, and the present machine.
  add("circle", { class: "equal", cx: x(equal), cy: y(value(equal)), r: 5 });
  add("line", { x1: x(0.7), x2: x(equal) - 5, y1: y(0.9), y2: y(value(equal)) + 5 });
  add("text", { class: "scale", x: x(0.68), y: y(0.87) }, words.equal);
  add("circle", { class: "unit", cx: x(unit), cy: y(1), r: 5 });
  add("text", { class: "scale unit number", x: x(0.5), y: y(0.55) }, words.number);
  add("text", { class: "scale unit", x: x(0.5), y: y(0.55) + 20 }, words.unit);
  add("line", { x1: x(0.53), x2: x(unit) - 3, y1: y(0.62), y2: y(1) + 6 });
  const ring = add("circle", { class: "ring", r: 10 });
  bus.subscribe("drawn/oscillator", ({ ratio, normalized }) => set(ring, { cx: x(ratio), cy: y(normalized) }));

  svg.addEventListener("click", (event) => {
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    const share = Math.min(Math.max((place.x - BOX.left) / (BOX.right - BOX.left), 0), 1);
    const ratio = least * (most / least) ** share;
    pick([equal, unit].find((mark) => Math.abs(ratio / mark - 1) < NEAR) ?? Number(ratio.toPrecision(3)));
  });
}
