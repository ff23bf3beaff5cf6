// Moves the ring on the curve of Ω²m/k, which curve.py draws, to the present machine. A click selects a mass ratio.

import { bus } from "../browser/bus.js";
import { set } from "../browser/stage/svg.js";

const NEAR = 0.02; // relative distance at which a click selects a marked ratio

/** Follow the machine; `pick` is called with the mass ratio of a click. */
export function followMachine(svg, { range: [least, most], across: [left, right], up: [zero, one], marks }, pick) {
  const extent = Math.log(most / least), ring = svg.querySelector(".ring");
  bus.subscribe("drawn/oscillator", ({ ratio, normalized }) => {
    const cx = left + (Math.log(ratio / least) / extent) * (right - left);
    set(ring, { r: 10, cx, cy: zero + normalized * (one - zero) });
  });

  svg.addEventListener("click", (event) => {
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    const share = Math.min(Math.max((place.x - left) / (right - left), 0), 1);
    const ratio = least * Math.exp(share * extent);
    pick(marks.find((mark) => Math.abs(ratio / mark - 1) < NEAR) ?? Number(ratio.toPrecision(3)));
  });
}
