// Hides parts of a stage: until a reader has made a prediction, or because a lecturer's link asks for it. A hidden part leaves
// the page, so that neither eye nor screen reader nor a look into the document finds it.

const SAID = ".verdict, .parting"; // what is said of the clocks, in numbers

/** Part → the nodes that belong to it. `PARTS` of __init__.py explains the names; a layer marked as still shows no motion. */
function partNodes(root) {
  const layers = layerNames(root).map((name) => [name, `.scene .${name}, [data-layer=${name}], [data-of=${name}]`]);
  const moving = layers.filter(([name]) => !root.querySelector(`.${name}.still`)).map(([, nodes]) => nodes);
  return {
    clocks: `.dial, .key, ${SAID}`,
    numbers: `.gauge, .readouts, .legend b, .scales, ${SAID}`,
    plain: ".machine > .plain",
    motion: [".trail, [data-do=play], .transport, .scrub, .show, .speeds, .viewpoint, .scales", ...moving].join(", "),
    ...Object.fromEntries(layers),
  };
}

/** The names of the layers: each has a tick box. */
export const layerNames = (root) => [...root.querySelectorAll("[data-layer]")].map((box) => box.dataset.layer);

const stores = new WeakMap(); // root → where its hidden nodes are kept

/** Find a node of a stage, also one that is hidden at present. */
export const finder = (root) => (selector) => root.querySelector(selector) ?? stores.get(root)?.querySelector(selector);

/** The parts under a root: `hide(names)` hides these and shows all others, `hides(name)` tells what is hidden. */
export function makeParts(root) {
  const owners = new Map(); // node → the parts to which it belongs
  for (const [name, selector] of Object.entries(partNodes(root)))
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
