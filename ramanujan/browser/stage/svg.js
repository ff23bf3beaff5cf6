// Nodes of SVG: making one, and giving one its attributes.

/** Give a node its attributes, if there is one. */
export const set = (node, attributes) => Object.entries(attributes).forEach((each) => node?.setAttribute(...each));
/** The same by a table, selector → attributes. */
export const put = (find, table) => Object.entries(table).forEach(([selector, attributes]) => set(find(selector), attributes));
/** Take the attributes whose names fit a pattern off a node. */
export const strip = (node, pattern) =>
  node.getAttributeNames().filter((name) => pattern.test(name)).forEach((name) => node.removeAttribute(name));
export const element = (name, attributes = {}, parent) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(node, attributes);
  parent?.append(node);
  return node;
};
