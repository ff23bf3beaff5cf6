// Saves the picture as a file: self-contained SVG, PNG, or TikZ for LaTeX, always in the light theme. All three are read from
// the elements on the page, so that no length is written twice.

import { element, set, strip } from "./svg.js";
import { LIGHT } from "./texts.js";

const STYLES = [
  "fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width", "stroke-dasharray", "stroke-linecap", "stroke-linejoin",
  "opacity", "font-family", "font-size", "font-style", "text-anchor", "dominant-baseline", "paint-order",
];
const PNG_WIDTH = 2400; // pixels
const TIKZ_WIDTH = 330; // pt, for a slide or a page
const FILE = "ramanujan-machine";
const SHAPES = "path, rect, circle, line, text";

/** Return whether a node is visible and part of the drawing: not an area for a pointer, a ghost or a trail. */
const isDrawn = (node, style) =>
  style.visibility !== "hidden" && node.getClientRects().length > 0 && !node.closest(".grip, .handle, .ghosts, .trail");

/** Call a function while the stage has the colours of the light theme. The browser draws nothing before they are restored. */
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

// ---- TikZ

const SYMBOLS = {
  "φ̇": "\\dot\\varphi ", φ: "\\varphi ", Φ: "\\Phi ", "′": "'", "₀": "_0", "\u202f": "\\,", "−": "$-$", "√": "$\\surd$",
  "↔": "$\\leftrightarrow$",
};
const inTex = (text) => text.replace(/φ̇|[φΦ′₀\u202f−√↔]/g, (symbol) => SYMBOLS[symbol]);
const colourOf = (value) => (value.match(/^rgba?\((\d+), (\d+), (\d+)/) ?? []).slice(1);
/** Return a CSS colour for TikZ, or undefined for a transparent one. */
function tikzColour(value) {
  const [r, g, b] = colourOf(value);
  // r is a text, so the "0" of black counts as true.
  return r && `{rgb,255:red,${r};green,${g};blue,${b}}`;
}
const rounded = (value) => Number(value.toFixed(4));

/** Return the picture as TikZ: each shape with its outline and its transformation on the page. */
function tikz(svg, { x, y, width, height }) {
  const inverse = svg.getScreenCTM().inverse();
  const lines = [];
  for (const node of svg.querySelectorAll(SHAPES)) {
    const style = getComputedStyle(node);
    if (node.closest("defs") || !isDrawn(node, style)) continue;
    const { a, b, c, d, e, f } = inverse.multiply(node.getScreenCTM());
    const cm = `cm={${[a, b, c, d].map(rounded).join(",")},(${rounded(e - x)}pt,${rounded(f - y)}pt)}`;
    const line = node.matches("text") ? label(node, style, cm) : shape(node, style, cm);
    if (line) lines.push(line);
  }
  const scale = rounded(TIKZ_WIDTH / width);
  return `% Needs \\usepackage{tikz} and \\usetikzlibrary{svg.path}
\\begin{tikzpicture}[xscale=${scale}, yscale=-${scale}, line join=round]
  \\clip (0pt,0pt) rectangle (${rounded(width)}pt,${rounded(height)}pt);
${lines.join("\n")}
\\end{tikzpicture}
`;
}

/** Return a shape with its outline as TikZ, or an empty text if it has neither a fill nor a stroke. */
function shape(node, style, cm) {
  const fill = tikzColour(style.fill), stroke = tikzColour(style.stroke), opacity = Number(style.opacity);
  const dash = style.strokeDasharray.match(/[\d.]+/g)?.map((length, i) => `${i % 2 ? "off" : "on"} ${length * 0.5}pt`);
  const options = [];
  if (fill) options.push(`fill=${fill}, fill opacity=${style.fillOpacity * opacity}`);
  if (stroke) {
    const width = rounded(parseFloat(style.strokeWidth) * 0.5);
    options.push(`draw=${stroke}, draw opacity=${opacity}, line width=${width}pt`);
  }
  if (dash) options.push(`dash pattern=${dash.join(" ")}, line cap=${style.strokeLinecap}`);
  return options.length ? `  \\path[${cm}, ${options.join(", ")}] ${outline(node)};` : "";
}

/** Return a function that reads an attribute of a node as a rounded length. */
const lengthsOf = (node) => (name) => rounded(Number(node.getAttribute(name) ?? 0));

/** Return the outline of a shape as TikZ. */
function outline(node) {
  const of = lengthsOf(node);
  if (node.matches("circle")) return `(${of("cx")}pt,${of("cy")}pt) circle[radius=${of("r")}pt]`;
  if (node.matches("rect")) return `(${of("x")}pt,${of("y")}pt) rectangle ++(${of("width")}pt,${of("height")}pt)`;
  if (node.matches("line")) return `(${of("x1")}pt,${of("y1")}pt) -- (${of("x2")}pt,${of("y2")}pt)`;
  return `svg {${node.getAttribute("d")}}`;
}

/** Return a text as TikZ, or an empty text. */
function label(node, style, cm) {
  if (!node.textContent) return "";
  const of = lengthsOf(node), ends = { start: "west", end: "east" }[style.textAnchor];
  const anchor = style.dominantBaseline === "auto" ? `base${ends ? ` ${ends}` : ""}` : ends ?? "center";
  // A letter on a line has a rim in the background's colour.
  const rim = style.paintOrder === "stroke" ? `fill=${tikzColour(style.stroke)}, fill opacity=0.6, text opacity=1, ` : "";
  const text = style.fontStyle === "italic" ? `$${inTex(node.textContent)}$` : inTex(node.textContent);
  const options = `anchor=${anchor}, ${rim}inner sep=1pt, text=${tikzColour(style.fill)}`;
  return `  \\begin{scope}[${cm}]\\node[${options}] at (${of("x")}pt,${of("y")}pt) {${text}};\\end{scope}`;
}

// ----

/** Download a stage's picture as a file of this kind: svg, png or tex. */
export async function save(root, kind) {
  const [svg, host] = [root.querySelector("svg.machine"), root.querySelector(".stage")];
  const content = inLightTheme(host, () => (kind === "tex" ? tikz(svg, svg.viewBox.baseVal) : textOf(standalone(svg))));
  const written = new Blob([content], { type: kind === "tex" ? "text/plain" : "image/svg+xml" });
  const file = kind === "png" ? await rasterize(written) : written;
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(file), download: `${FILE}.${kind}` });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
