// Counts the visible controls in the window. A slider and its box count once.
() => {
  const inside = (node) => (node.shadowRoot ? all(node.shadowRoot) : []);
  const all = (root) => [...root.querySelectorAll("*")].flatMap((node) => [node, ...inside(node)]);
  const isVisible = (node) => {
    const { top, bottom, right, width } = node.getBoundingClientRect();
    const inView = top < innerHeight - 4 && bottom > 4 && right > 4; // a closed sidebar is at the left of the window
    return width > 1 && inView && node.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  };
  const links = "a[href]:not([aria-current], [aria-label='Link to heading'])";
  const focusable = `:is(${links}, button, input, select, summary, [role=slider])`;
  const controls = `${focusable}:not(:disabled, [role=combobox] ~ *, #box)`;
  return all(document.body).filter((node) => node.matches(controls) && isVisible(node)).length;
}
