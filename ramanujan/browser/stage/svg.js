// Creates SVG nodes and sets their attributes.

/** Set attributes of a node, if there is one. */
export const set = (node, attributes) => Object.entries(attributes).forEach((each) => node?.setAttribute(...each));
/** Set the attributes of several nodes by a table, selector → attributes. */
export const put = (find, table) =>
  Object.entries(table).forEach(([selector, attributes]) => set(find(selector), attributes));
/** Remove the attributes whose names match a pattern. */
export const strip = (node, pattern) =>
  node.getAttributeNames().filter((name) => pattern.test(name)).forEach((name) => node.removeAttribute(name));
/** Create a node, append it to the parent if there is one, and return it. */
export const element = (name, attributes = {}, parent) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(node, attributes);
  parent?.append(node);
  return node;
};
