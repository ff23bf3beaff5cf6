// Hides parts of a stage, until a reader has made a prediction or because a lecturer's link requests it. A hidden part
// is removed from the document, so that neither a screen reader nor the page's source reveals it.

const CLOCK_SENTENCES = ".verdict, .parting";

/**
 * Part → selector of its nodes. `PARTS` in __init__.py explains the names. A layer of the class `still` shows no
 * motion.
 */
function partNodes(root) {
  const layers = layerNames(root).map((name) => [name, `.scene .${name}, [data-layer=${name}], [data-of=${name}]`]);
  const moving = layers.filter(([name]) => !root.querySelector(`.${name}.still`)).map(([, nodes]) => nodes);
  return {
    clocks: `.dial, .key, .heard, .hands, ${CLOCK_SENTENCES}`,
    hands: `.dial, .key, .together, .heard, ${CLOCK_SENTENCES}`,
    numbers: `.readouts, .legend b, .scales, ${CLOCK_SENTENCES}`,
    plain: ".machine > .plain",
    motion: [
      "[data-do=play], .hands, .heard, .transport, .scrub, .show, .speeds, .viewpoint, .scales",
      ...moving,
    ].join(", "),
    ...Object.fromEntries(layers),
  };
}

/** The names of the layers, read from their tick boxes. */
export const layerNames = (root) => [...root.querySelectorAll("[data-layer]")].map((box) => box.dataset.layer);

const stores = new WeakMap(); // root → the element that contains its hidden nodes

/** Return a function that finds a node of a stage by its selector, including hidden nodes. */
export const finder = (root) => (selector) => root.querySelector(selector) ?? stores.get(root)?.querySelector(selector);

/**
 * The parts of a stage. `hide(names)` hides these and shows all others; `hides(name)` returns whether one is hidden.
 */
export function makeParts(root) {
  const owners = new Map(); // node → its parts
  for (const [name, selector] of Object.entries(partNodes(root)))
    for (const node of root.querySelectorAll(selector)) owners.set(node, [...(owners.get(node) ?? []), name]);
  // A comment takes the place of a hidden node in the document.
  const placeholders = new Map([...owners.keys()].map((node) => [node, document.createComment("")]));
  const store = document.createElement("div");
  let hidden = new Set();
  stores.set(root, store);
  return {
    hides: (name) => hidden.has(name) || (name === "clocks" && hidden.has("hands")),
    hide(names) {
      hidden = new Set(names);
      for (const [node, parts] of owners) {
        const placeholder = placeholders.get(node), wasHidden = Boolean(placeholder.parentNode);
        const isHidden = parts.some((name) => hidden.has(name));
        if (isHidden === wasHidden) continue;
        if (isHidden) {
          node.replaceWith(placeholder);
          store.append(node);
        } else placeholder.replaceWith(node);
      }
    },
  };
}
