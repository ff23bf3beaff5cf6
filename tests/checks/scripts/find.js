// Finds a visible node by a selector and its name, on the page or in a component ("component >> selector"). Scrolls to
// it, and returns its centre, its size, its text, and whether it is uncovered and the page complete.
([path, name]) => {
  const [component, selector] = path.includes(" >> ") ? path.split(" >> ") : ["", path];
  const shadows = (root) => [...root.querySelectorAll("[data-testid=stBidiComponentIsolated]")]
    .filter((node) => node.shadowRoot && (!component || node.closest(component))).map((node) => node.shadowRoot);
  const isVisible = (node) => node.getClientRects().length && node.checkVisibility({ visibilityProperty: true });
  const hasName = (node) => node.textContent.trim().endsWith(name) || node.ariaLabel === name;
  const node = [...(component ? [] : [document]), ...shadows(document)]
    .flatMap((root) => [...root.querySelectorAll(selector)]).find((each) => isVisible(each) && hasName(each));
  if (!node) return null;
  if (!node.closest("svg")) node.scrollIntoView({ block: "nearest", behavior: "instant" });
  const text = node.innerText ?? node.textContent, { x, y, width, height } = node.getBoundingClientRect();
  const place = { x: x + width / 2, y: y + height / 2 }, top = node.getRootNode().elementFromPoint(place.x, place.y);
  // An element that Streamlit still loads will move the elements below it.
  const isSteady = node.contains(top) && !document.querySelector("[data-testid=stSkeleton]");
  return { ...place, width, height, text, isSteady };
}
