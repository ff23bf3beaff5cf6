// The parts of a stage that can be hidden, until a reader has made a prediction or by a lecturer's link. What is hidden leaves
// the page: neither the eye nor a screen reader nor a look into the document finds it.

const SAID = ".verdict, .parting"; // what is said of the clocks, in numbers
const SHOWS_MOTION = ["energy", "arrows", "forces", "weights", "traces"];
const MARKS = { arrows: ", .scales .speed", forces: ", .scales .force", weights: ", .scales .weight", coordinates: ", .shared" };
const layerNodes = (name) => `.scene .${name}, [data-layer=${name}]${MARKS[name] ?? ""}`;

/** Part → the nodes that belong to it. `PARTS` of __init__.py explains the names. */
const PART_NODES = {
  clocks: `.dial, .key, ${SAID}`,
  numbers: `.gauge, .readouts, .legend b, .scales, ${SAID}`,
  plain: ".machine > .plain",
  motion: [".transport, .scrub, .speeds, .controls .viewpoint, .scales", ...SHOWS_MOTION.map(layerNodes)].join(", "),
  ...Object.fromEntries([...SHOWS_MOTION, "coordinates"].map((name) => [name, layerNodes(name)])),
};

const stores = new WeakMap(); // root → where its hidden nodes are kept

/** Find a node of a stage, also one that is hidden at present. */
export const finder = (root) => (selector) => root.querySelector(selector) ?? stores.get(root)?.querySelector(selector);

/** The parts under a root: `hide(names)` hides these and shows all others, `hides(name)` tells what is hidden. */
export function makeParts(root) {
  const owners = new Map(); // node → the parts to which it belongs
  for (const [name, selector] of Object.entries(PART_NODES))
    for (const node of root.querySelectorAll(selector)) owners.set(node, [...(owners.get(node) ?? []), name]);
  const places = new Map([...owners.keys()].map((node) => [node, document.createComment("")]));
  const store = document.createElement("div");
  let hidden = new Set();
  stores.set(root, store);
  return {
    hides: (name) => hidden.has(name),
    hide(names) {
      hidden = new Set(names);
      for (const [node, parts] of owners) {
        const place = places.get(node), seen = !parts.some((name) => hidden.has(name));
        if (seen && place.parentNode) place.replaceWith(node);
        if (seen || place.parentNode) continue;
        node.replaceWith(place);
        store.append(node);
      }
    },
  };
}
