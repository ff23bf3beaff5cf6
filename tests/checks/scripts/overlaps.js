// Returns the pairs of texts that overlap.
() => {
  const pieces = [], clips = new Map();
  const up = (node) => node.assignedSlot ?? node.parentElement ?? node.getRootNode().host;
  const main = document.querySelector("[data-testid=stMain]");
  // The visible rectangle of an element, and its layer: a fixed bar covers content that scrolls.
  const clip = (node) => {
    if (!node || node === document.body) return { left: -1e6, right: 1e6, top: -1e6, bottom: 1e6, layer: null };
    if (clips.has(node)) return clips.get(node);
    const style = getComputedStyle(node);
    let visible = clip(up(node));
    if (style.clipPath === "inset(50%)") visible = { ...visible, right: -1e6 }; // only for screen readers
    if (["fixed", "sticky"].includes(style.position)) visible = { ...clip(document.body), layer: node };
    if (style.overflow !== "visible" && style.display !== "inline" && !node.contains(main)) {
      const box = node.getBoundingClientRect();
      visible = { ...visible, left: Math.max(visible.left, box.left), right: Math.min(visible.right, box.right),
        top: Math.max(visible.top, box.top), bottom: Math.min(visible.bottom, box.bottom) };
    }
    clips.set(node, visible);
    return visible;
  };
  const add = (owner, box, text, parent) => {
    const visible = clip(parent), rest = 0.2 * box.height;
    const left = Math.max(box.left, visible.left), right = Math.min(box.right, visible.right);
    const top = Math.max(box.top + rest, visible.top), bottom = Math.min(box.bottom - rest, visible.bottom);
    const { layer } = visible;
    if (right - left > 2 && bottom - top > 2) pieces.push({ owner, left, right, top, bottom, text, layer });
  };
  // A slanted text fills only a small part of its box, so it is represented by small squares along its middle line.
  const boxes = (node) => {
    const { a, b, c, d, e, f } = node.getScreenCTM(), box = node.getBBox();
    if (Math.abs(a * b) < 0.01) return [node.getBoundingClientRect()];
    const side = box.height * Math.hypot(a, b), count = Math.max(1, Math.floor(box.width / box.height));
    return Array.from({ length: count }, (_, index) => {
      const x = box.x + ((index + 0.5) * box.width) / count, y = box.y + box.height / 2;
      return new DOMRect(a * x + c * y + e - 0.3 * side, b * x + d * y + f - side / 2, 0.6 * side, side);
    });
  };
  const isVisible = (node) => node?.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  const walk = (root) => {
    for (const node of root.querySelectorAll("svg text")) {
      const text = node.textContent.trim();
      if (text && isVisible(node)) for (const box of boxes(node)) add(node, box, text, node.parentElement);
    }
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT), range = document.createRange();
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      const parent = node.parentElement, text = node.textContent.trim();
      if (!text || parent?.closest("svg, .katex, script, style, noscript") || !isVisible(parent)) continue;
      range.selectNodeContents(node);
      for (const box of range.getClientRects()) add(node, box, text, parent);
    }
    for (const node of root.querySelectorAll("*")) if (node.shadowRoot) walk(node.shadowRoot);
  };
  walk(document.body);
  const overlaps = new Set();
  pieces.sort((one, other) => one.top - other.top);
  pieces.forEach((one, index) => {
    for (const other of pieces.slice(index + 1)) {
      if (other.top > one.bottom - 2) break;
      const wide = Math.min(one.right, other.right) - Math.max(one.left, other.left);
      if (wide > 2 && one.owner !== other.owner && one.layer === other.layer)
        overlaps.add(`${one.text.slice(0, 40)} × ${other.text.slice(0, 40)}`);
    }
  });
  return [...overlaps];
}
