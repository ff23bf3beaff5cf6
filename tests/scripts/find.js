([path, name]) => {
  const [component, selector] = path.includes(" >> ") ? path.split(" >> ") : ["", path];
  const shadows = (root) => [...root.querySelectorAll("[data-testid=stBidiComponentIsolated]")]
    .filter((node) => node.shadowRoot && (!component || node.closest(component))).map((node) => node.shadowRoot);
  const seen = (node) => node.getClientRects().length && node.checkVisibility({ visibilityProperty: true });
  const named = (node) => node.textContent.trim().endsWith(name) || node.ariaLabel === name;
  const node = [...(component ? [] : [document]), ...shadows(document)]
    .flatMap((root) => [...root.querySelectorAll(selector)]).find((each) => seen(each) && named(each));
  if (!node) return null;
  if (!node.closest("svg")) node.scrollIntoView({ block: "nearest", behavior: "instant" });
  const text = node.innerText ?? node.textContent, { x, y, width, height } = node.getBoundingClientRect();
  const place = { x: x + width / 2, y: y + height / 2 }, top = node.getRootNode().elementFromPoint(place.x, place.y);
  // What Streamlit still loads takes its place from what stands below it.
  const rests = node.contains(top) && !document.querySelector("[data-testid=stSkeleton]");
  return { ...place, width, height, text, rests };
}
