() => {
  const pieces = [], clips = new Map();
  const up = (node) => node.assignedSlot ?? node.parentElement ?? node.getRootNode().host;
  const main = document.querySelector("[data-testid=stMain]");
  // What an element shows of its content, and the layer that it lies on: a bar that is fixed covers what scrolls.
  const clip = (node) => {
    if (!node || node === document.body) return { left: -1e6, right: 1e6, top: -1e6, bottom: 1e6, layer: null };
    if (clips.has(node)) return clips.get(node);
    const style = getComputedStyle(node);
    let found = clip(up(node));
    if (style.clipPath === "inset(50%)") found = { ...found, right: -1e6 }; // for a screen reader alone
    if (["fixed", "sticky"].includes(style.position)) found = { ...clip(document.body), layer: node };
    if (style.overflow !== "visible" && style.display !== "inline" && !node.contains(main)) {
      const box = node.getBoundingClientRect();
      found = { ...found, left: Math.max(found.left, box.left), right: Math.min(found.right, box.right),
        top: Math.max(found.top, box.top), bottom: Math.min(found.bottom, box.bottom) };
    }
    clips.set(node, found);
    return found;
  };
  const add = (owner, box, text, parent) => {
    const seen = clip(parent), rest = 0.2 * box.height;
    const left = Math.max(box.left, seen.left), right = Math.min(box.right, seen.right);
    const top = Math.max(box.top + rest, seen.top), bottom = Math.min(box.bottom - rest, seen.bottom);
    if (right - left > 2 && bottom - top > 2) pieces.push({ owner, left, right, top, bottom, text, layer: seen.layer });
  };
  // A slanted text fills little of the box around it: it counts as small squares along its middle line.
  const boxes = (node) => {
    const { a, b, c, d, e, f } = node.getScreenCTM(), box = node.getBBox();
    if (Math.abs(a * b) < 0.01) return [node.getBoundingClientRect()];
    const side = box.height * Math.hypot(a, b), count = Math.max(1, Math.floor(box.width / box.height));
    return Array.from({ length: count }, (_, index) => {
      const x = box.x + ((index + 0.5) * box.width) / count, y = box.y + box.height / 2;
      return new DOMRect(a * x + c * y + e - 0.3 * side, b * x + d * y + f - side / 2, 0.6 * side, side);
    });
  };
  const shown = (node) => node?.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  const walk = (root) => {
    for (const node of root.querySelectorAll("svg text")) {
      const text = node.textContent.trim();
      if (text && shown(node)) for (const box of boxes(node)) add(node, box, text, node.parentElement);
    }
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT), range = document.createRange();
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      const parent = node.parentElement, text = node.textContent.trim();
      if (!text || parent?.closest("svg, .katex, script, style, noscript") || !shown(parent)) continue;
      range.selectNodeContents(node);
      for (const box of range.getClientRects()) add(node, box, text, parent);
    }
    for (const node of root.querySelectorAll("*")) if (node.shadowRoot) walk(node.shadowRoot);
  };
  walk(document.body);
  const found = new Set();
  pieces.sort((one, other) => one.top - other.top);
  pieces.forEach((one, index) => {
    for (const other of pieces.slice(index + 1)) {
      if (other.top > one.bottom - 2) break;
      const wide = Math.min(one.right, other.right) - Math.max(one.left, other.left);
      if (wide > 2 && one.owner !== other.owner && one.layer === other.layer)
        found.add(`${one.text.slice(0, 40)} × ${other.text.slice(0, 40)}`);
    }
  });
  return [...found];
}
