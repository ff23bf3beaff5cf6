// Nodes of SVG: making one, and giving one its attributes.

export const set = (node, attributes) => {
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
};
export const element = (name, attributes = {}, parent) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(node, attributes);
  parent?.append(node);
  return node;
};
