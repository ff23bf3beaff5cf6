// Returns the defects of a class's wall as sentences: texts that are too small, cut, or touch each other or a body.
() => {
  const LARGE = ".st-key-wall_asked, .st-key-wall_reason, .st-key-wall_shares";
  const roots = [document.querySelector(".st-key-class_wall")], pieces = [], bodies = [], defects = new Set();
  for (const root of roots)
    for (const { shadowRoot } of root.querySelectorAll("*")) if (shadowRoot) roots.push(shadowRoot);
  // In an SVG, checkVisibility is also true for elements that are not drawn.
  const properties = { visibilityProperty: true, opacityProperty: true };
  const isVisible = (node) => node.getClientRects().length && node.checkVisibility(properties);
  const outside = ({ left, right, top, bottom }) =>
    left < 0 || top < 0 || right > innerWidth + 1 || bottom > innerHeight;
  for (const root of roots) {
    bodies.push(...[...root.querySelectorAll(".machine .body .form")].filter(isVisible));
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    for (let text; (text = texts.nextNode()); ) {
      const node = text.parentElement, words = text.data.trim(), range = document.createRange();
      // A body's letter is on the body; a formula with subscripts has letters of two sizes.
      if (!words || !isVisible(node) || node.closest("style, title, option, .body, .katex")) continue;
      const size = parseFloat(getComputedStyle(node).fontSize) * (node.getScreenCTM?.().a ?? 1);
      const least = node.closest(LARGE) ? 0.035 : 0.022;
      if (size < least * innerHeight) defects.add(`“${words}” is ${size} px high`);
      range.selectNodeContents(text);
      for (const { left, right, top, bottom } of range.getClientRects()) {
        const margin = (bottom - top) / 6; // above and below the letters of a line
        if (right - left > 2) pieces.push({ words, left, right, top: top + margin, bottom: bottom - margin });
      }
    }
  }
  for (const [i, a] of pieces.entries()) {
    if (outside(a)) defects.add(`“${a.words}” is cut`);
    for (const b of pieces.slice(i + 1))
      if (a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom && b.top < a.bottom)
        defects.add(`“${a.words}” touches “${b.words}”`);
    for (const form of bodies)
      for (const x of [a.left, (a.left + a.right) / 2, a.right])
        for (const y of [a.top, a.bottom])
          if (form.isPointInFill(new DOMPoint(x, y).matrixTransform(form.getScreenCTM().inverse())))
            defects.add(`“${a.words}” lies on ${form.parentNode.closest(".body").getAttribute("class")}`);
  }
  for (const form of bodies) if (outside(form.getBoundingClientRect())) defects.add("a body is cut");
  const nodesOf = (selector) => roots.flatMap((root) => [...root.querySelectorAll(selector)]);
  const boxes = (selector) => nodesOf(selector).filter(isVisible).map((node) => node.getBoundingClientRect());
  // A program or an equation shares its area with a machine that illustrates it.
  const [place] = boxes(".st-key-wall-still, .st-key-wall-running");
  const share = (boxes) => boxes.reduce((sum, box) => sum + box.width * box.height, 0) / (innerWidth * innerHeight);
  if (place && share([place]) < 1 / 3) defects.add("the machine has less than a third of the wall");
  if (place && share(boxes("svg.machine")) < 0.08) defects.add("the picture is small");
  if (boxes(".face").some((box) => box.height < 0.15 * innerHeight)) defects.add("the clock is small");
  if (!pieces.length) defects.add("there are no words");
  return [...defects];
}
