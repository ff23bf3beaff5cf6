// Saves the picture as PNG, always in the light theme. It is read from the elements on the page, so that no length is
// written twice.

import { element, set, strip } from "./svg.js";
import { LIGHT } from "./texts.js";

const STYLES = [
  "fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width", "stroke-dasharray", "stroke-linecap",
  "stroke-linejoin", "opacity", "font-family", "font-size", "font-style", "text-anchor", "dominant-baseline",
  "paint-order",
];
const PNG_WIDTH = 2400; // pixels
const FILE = "ramanujan-machine.png";

/** Return whether a node is visible and part of the drawing: not an area for a pointer, or a ghost. */
const isDrawn = (node, style) =>
  style.visibility !== "hidden" && node.getClientRects().length > 0 && !node.closest(".grip, .handle, .ghosts");

/**
 * Call a function while the stage has the colours of the light theme. The browser draws nothing before they are
 * restored.
 */
function inLightTheme(host, make) {
  for (const [name, colour] of Object.entries(LIGHT)) host.style.setProperty(name, colour);
  const content = make();
  for (const name of Object.keys(LIGHT)) host.style.removeProperty(name);
  return content;
}

/** Return a copy of the picture that contains its styles and only its visible nodes. */
function standalone(svg) {
  const copy = svg.cloneNode(true), scale = svg.getScreenCTM().a, { x, y, width, height } = svg.viewBox.baseVal;
  const copies = [...copy.querySelectorAll("*")], hidden = [];
  [...svg.querySelectorAll("*")].forEach((node, i) => {
    const style = getComputedStyle(node);
    if (!node.closest("defs") && !isDrawn(node, style)) return hidden.push(copies[i]);
    const styles = Object.fromEntries(STYLES.map((name) => [name, style.getPropertyValue(name)]));
    // The width of a stroke is in pixels of the screen at every scale.
    const strokeScale = style.getPropertyValue("vector-effect") === "non-scaling-stroke" ? 1 / scale : 1;
    styles["stroke-width"] = parseFloat(styles["stroke-width"]) * strokeScale;
    const toUserUnits = (length) => parseFloat(length) * strokeScale;
    styles["stroke-dasharray"] = styles["stroke-dasharray"].replace(/[\d.]+(px)?/g, toUserUnits);
    styles["font-family"] = styles["font-family"].replaceAll('"', "'");
    strip(copies[i], /^(class|style|role|tabindex|aria-.*|data-.*)$/);
    set(copies[i], styles);
  });
  for (const node of hidden) node.remove();
  strip(copy, /./);
  const size = { width: PNG_WIDTH, height: Math.round((PNG_WIDTH * height) / width) };
  set(copy, { xmlns: "http://www.w3.org/2000/svg", viewBox: `${x} ${y} ${width} ${height}`, ...size });
  copy.prepend(element("rect", { x, y, width, height, fill: LIGHT["--st-background-color"] }));
  return copy;
}

const textOf = (svg) => `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(svg)}\n`;

/** Return an SVG file as a PNG file. */
async function rasterize(svg) {
  const source = URL.createObjectURL(svg), image = Object.assign(new Image(), { src: source });
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
  canvas.getContext("2d").drawImage(image, 0, 0);
  URL.revokeObjectURL(source);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

/** Download a stage's picture. */
export async function save(root) {
  const [svg, host] = [root.querySelector("svg.machine"), root.querySelector(".stage")];
  const text = inLightTheme(host, () => textOf(standalone(svg)));
  const file = await rasterize(new Blob([text], { type: "image/svg+xml" }));
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(file), download: FILE });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
