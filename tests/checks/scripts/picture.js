// Measures the drawn picture of the stage; all positions are in pixels of the window. See tests/checks/picture.py.
() => {
  const root = document.querySelector('.st-key-stage [data-testid=stBidiComponentIsolated]').shadowRoot;
  const all = (selector) => [...root.querySelectorAll(selector)];
  const at = (node, x, y) => {
    const { x: left, y: top } = new DOMPoint(x, y).matrixTransform(node.getScreenCTM());
    return [left, top];
  };
  const box = (node) => {
    const { x, y, width, height } = node.getBBox();
    return [...at(node, x, y), ...at(node, x + width, y + height)];
  };
  const middle = (node) => {
    const { x, y, width, height } = node.getBBox();
    return at(node, x + width / 2, y + height / 2);
  };
  const direction = ([x0, y0], [x1, y1]) => (Math.atan2(x1 - x0, y0 - y1) * 180) / Math.PI;
  const byKey = (selector, key, read) =>
    Object.fromEntries(all(selector).map((node) => [node.dataset[key], read(node)]));
  const roller = (name) => {
    const form = root.querySelector(`.moving .${name} .form`), mark = root.querySelector(`.moving .${name} .mark`);
    const end = mark.getPointAtLength(mark.getTotalLength()), centre = middle(form), scale = form.getScreenCTM();
    const radius = (form.getBBox().width / 2) * Math.hypot(scale.a, scale.b);
    return { centre, radius, angle: direction(centre, at(mark, end.x, end.y)) };
  };
  const hand = (name) => {
    const line = root.querySelector(`.hand.${name}`);
    return direction(at(line, 0, 0), at(line, line.x2.baseVal.value, line.y2.baseVal.value));
  };
  // The arrow of the drift: the directions of its tail and tip, the length of its shaft, and the size of its head.
  const driftArrow = () => {
    const arc = root.querySelector(".dial .drift circle"), head = root.querySelector(".dial .drift path");
    const centre = at(root.querySelector(".dial"), 0, 0), box = head.getBBox();
    const tip = at(head, box.x + box.width, box.y + box.height / 2), start = arc.getPointAtLength(0);
    const shaft = 360 * parseFloat(arc.getAttribute("stroke-dasharray"));
    const ends = { tail: direction(centre, at(arc, start.x, start.y)), tip: direction(centre, tip) };
    return { ...ends, shaft, head: head.getBoundingClientRect().width };
  };
  const labels = (selector) => all(selector).map((node) => {
    const { x, width } = node.getBoundingClientRect();
    return [parseFloat(node.textContent.replace("−", "-")), x + width / 2];
  });
  const arrow = (group) => {
    const path = group.querySelector("path:last-of-type");
    if (!path.getAttribute("d")) return null;
    const tail = path.getPointAtLength(0).matrixTransform(path.getScreenCTM());
    return { box: box(path), tail: [tail.x, tail.y] };
  };
  const scale = (name) => {
    const group = root.querySelector(`.scales .${name}`), text = group.querySelector("text").textContent;
    return group.style.display === "none" ? null : { value: parseFloat(text), text, arrow: arrow(group) };
  };
  // The lines of every layer, and its reference arrow with the value, if any.
  const layer = (name) => {
    const reference = root.querySelector(`.scales [data-of=${name}]`);
    const text = reference?.querySelector("text").textContent;
    const lines = byKey(`.scene .${name}:not(.rolling) [data-line]`, "line", arrow);
    return { lines, scale: reference && { value: parseFloat(text), text, arrow: arrow(reference) } };
  };
  const layerNames = all("[data-layer]").map((box) => box.dataset.layer);
  const mark = (path) => {
    const point = (length) => { const { x, y } = path.getPointAtLength(length); return at(path, x, y); };
    if (!path.getAttribute("d")) return null;
    const start = point(0), end = point(path.getTotalLength());
    return { start, end, arrow: { box: box(path), tail: start } };
  };
  const corners = (group) => {
    const path = group.querySelector("path"), pairs = path.getAttribute("d")?.slice(1).split("L") ?? [];
    return pairs.map((pair) => at(path, ...pair.split(" ").map(Number)));
  };
  const whole = root.querySelector(".bar").getBoundingClientRect().width;
  return {
    rollers: Object.fromEntries(['hoop', 'cylinder', 'top'].map((name) => [name, roller(name)])),
    ruler: labels(".ruler text"),
    drift: driftArrow(),
    bars: byKey(".bar i", "body", (bar) => bar.getBoundingClientRect().width / whole),
    shares: all(".legend b").map((text) => parseFloat(text.textContent)),
    block: box(root.querySelector(".moving .block .form")),
    slab: box(root.querySelector(".moving .slab .form")),
    spring: box(root.querySelector(".moving .spring")),
    plain: box(root.querySelector(".plain .form")),
    centre: middle(root.querySelector(".centre circle")),
    hands: { machine: hand("machine"), plain: hand("plain") },
    arrows: byKey(".arrows:not(.rolling) [data-line]", "line", arrow),
    rolling: byKey(".rolling [data-line]", "line", arrow),
    forces: byKey(".forces [data-line]", "line", arrow),
    scales: { speed: scale("speed"), force: scale("force") },
    layers: Object.fromEntries(layerNames.map((name) => [name, layer(name)])),
    traces: byKey(".traces [data-line]", "line", corners),
    marks: byKey(".coordinates path[data-mark]", "mark", mark),
    step: root.querySelector("[data-step]").dataset.step,
  };
}
