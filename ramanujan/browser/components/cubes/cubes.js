// Stacks of cubes as SVG. The reader turns them by a slider or a drag; each direction is a new drawing.

import { fill } from "../../sentences.js";
import { element, set } from "../../stage/svg.js";

const EYE = [0.85, 0.42]; // direction of the eye from the centre: horizontal and vertical part
const TILT = Math.atan2(EYE[1], EYE[0]);
const EDGE = 10; // length of a unit cube's edge in the picture
const SPACING = 2; // the gap between two cubes, in unit cubes
const GAP = 0.5; // the gap between two layers that are pulled apart, in unit cubes
const DEGREES = Math.PI / 180;
const DEGREES_PER_PIXEL = 0.5; // of a drag

/**
 * Return the visible faces of cubes side by side, the farthest first: { cube, face, outline, grid, layers, rise }. A
 * face is repeated once per layer, each time shifted by `rise`. `turn` [degrees] is the direction of view.
 */
function faces(sides, apart, turn) {
  const angle = turn * DEGREES, [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const largestSide = Math.max(...sides);
  const across = [-Math.sin(angle), Math.cos(angle), 0];
  const upright = [-Math.cos(angle) * Math.sin(TILT), -Math.sin(angle) * Math.sin(TILT), Math.cos(TILT)];
  const dot = (a, b) => a.reduce((sum, component, i) => sum + component * b[i], 0);
  const add = (point, edge, times) => point.map((component, i) => component + edge[i] * times);
  /** Project a point to the picture: its coordinates as text. */
  const project = (point) => {
    const coordinates = [EDGE * dot(across, point), -EDGE * dot(upright, point)];
    return coordinates.map((coordinate) => coordinate.toFixed(2)).join(" ");
  };
  let start = 0;
  const cubes = sides.map((side, cube) => {
    const corner = [start, Math.floor((largestSide - side) / 2), 0], layerHeight = apart ? 1 : side;
    start += side + SPACING;
    const towards = [Math.cos(angle), Math.sin(angle), 0];
    const nearCorner = (edge) => (dot(edge, towards) > 0 ? add(corner, edge, side) : corner);
    const rectangles = [
      { face: "x", from: nearCorner(x), along: y, upwards: z, length: side, height: layerHeight },
      { face: "y", from: nearCorner(y), along: x, upwards: z, length: side, height: layerHeight },
      { face: "top", from: add(corner, z, layerHeight), along: x, upwards: y, length: side, height: side },
    ];
    return rectangles.map(({ face, from, along, upwards, length, height }) => {
      const end = add(from, along, length), lines = [];
      for (let n = 0; n <= length; n++) {
        const foot = add(from, along, n);
        lines.push(`M${project(foot)}L${project(add(foot, upwards, height))}`);
      }
      for (let n = 0; n <= height; n++)
        lines.push(`M${project(add(from, upwards, n))}L${project(add(end, upwards, n))}`);
      const corners = [from, end, add(end, upwards, height), add(from, upwards, height)];
      const outline = `M${corners.map(project).join("L")}z`;
      const rise = -EDGE * (1 + GAP) * Math.cos(TILT);
      return { cube, face, outline, grid: lines.join(""), layers: apart ? side : 1, rise };
    });
  });
  return (Math.cos(angle) > 0 ? cubes : cubes.reverse()).flat();
}

/** The largest height of a stack over all directions. The picture always has this height, so nothing below it moves. */
const largestHeight = (sides, apart, width) => {
  const largestSide = Math.max(...sides), stackHeight = largestSide * (apart ? 1 + GAP : 1);
  return EDGE * (stackHeight * Math.cos(TILT) + Math.hypot(width, largestSide) * Math.sin(TILT) + 1);
};

export default function ({ data: { sums, alternatives, captions, total, words }, parentElement: root }, signal) {
  const [box, slider] = root.querySelectorAll("input");
  const widest = Math.max(...sums.flatMap((sides) => sides.reduce((sum, side) => sum + side)));
  const pictures = sums.map((sides, i) => {
    const figure = document.createElement("figure"), label = alternatives[i];
    const svg = element("svg", { role: "img", "aria-label": label }, figure);
    const caption = figure.appendChild(document.createElement("figcaption"));
    caption.append(captions[i], Object.assign(document.createElement("b"), { textContent: total }));
    root.querySelector(".stacks").append(figure);
    svg.addEventListener("pointerdown", (event) => svg.setPointerCapture(event.pointerId), { signal });
    svg.addEventListener("pointermove", (event) => {
      if (event.buttons) turnTo((Number(slider.value) + DEGREES_PER_PIXEL * event.movementX + 360) % 360);
    }, { signal });
    return [sides, svg];
  });
  const draw = () => {
    const pictureHeight = Math.max(...sums.map((sides) => largestHeight(sides, box.checked, widest + SPACING)));
    for (const [sides, svg] of pictures) {
      const layers = new Map();
      // A cube that is pulled apart has `count` equal layers, and each is shifted by `rise` from the previous one.
      for (const { cube, face, outline, grid, layers: count, rise } of faces(sides, box.checked, Number(slider.value)))
        for (let n = 0; n < count; n++) {
          const key = `${cube} ${n}`, place = { class: `cube-${cube}`, transform: `translate(0 ${n * rise})` };
          const group = layers.get(key) ?? element("g", place);
          layers.set(key, group);
          element("path", { class: face, d: outline }, group);
          element("path", { class: "grid", d: grid }, group);
        }
      svg.replaceChildren(...layers.values());
      const { x, y, width, height } = svg.getBBox(), pictureWidth = EDGE * (widest + SPACING + 2);
      // All stacks have the same scale and stand on the same floor.
      const [left, top] = [x + (width - pictureWidth) / 2, y + height - pictureHeight];
      set(svg, { viewBox: `${left} ${top} ${pictureWidth} ${pictureHeight}` });
    }
    slider.ariaValueText = fill(words.degrees, { angle: slider.value });
  };
  const turnTo = (degrees) => {
    slider.value = degrees;
    draw();
  };
  box.addEventListener("change", draw, { signal });
  slider.addEventListener("input", draw, { signal });
  // A hidden element has no size, so draw the stacks again when they become visible.
  const sizes = new ResizeObserver(draw);
  sizes.observe(root.querySelector(".stacks"));
  signal.addEventListener("abort", () => sizes.disconnect());
}
