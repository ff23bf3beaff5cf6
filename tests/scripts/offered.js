() => {
  const inside = (node) => (node.shadowRoot ? all(node.shadowRoot) : []);
  const all = (root) => [...root.querySelectorAll("*")].flatMap((node) => [node, ...inside(node)]);
  const seen = (node) => {
    const { top, bottom, width } = node.getBoundingClientRect();
    return width > 1 && top < innerHeight - 4 && bottom > 4 && node.checkVisibility({ visibilityProperty: true });
  };
  const links = "a[href]:not([aria-current], [aria-label='Link to heading'])";
  const controls = `${links}, button, input, select, summary, [role=slider]`;
  const framed = (node) => node.id !== "box" || getComputedStyle(node).borderTopColor !== "rgba(0, 0, 0, 0)";
  const offered = all(document.body).filter((node) => node.matches(controls) && !node.disabled);
  return offered.filter((node) => seen(node) && framed(node)).length;
}
