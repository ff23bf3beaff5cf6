// Counts the visible controls in the window.
() => {
  const inside = (node) => (node.shadowRoot ? all(node.shadowRoot) : []);
  const all = (root) => [...root.querySelectorAll("*")].flatMap((node) => [node, ...inside(node)]);
  const isVisible = (node) => {
    const { top, bottom, width } = node.getBoundingClientRect(), inView = top < innerHeight - 4 && bottom > 4;
    return width > 1 && inView && node.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  };
  const links = "a[href]:not([aria-current], [aria-label='Link to heading'])";
  const controls = `:is(${links}, button, input, select, summary, [role=slider]):not(:disabled, [role=combobox] ~ *)`;
  const hasFrame = (node) => node.id !== "box" || getComputedStyle(node).borderTopColor !== "rgba(0, 0, 0, 0)";
  return all(document.body).filter((node) => node.matches(controls) && isVisible(node) && hasFrame(node)).length;
}
