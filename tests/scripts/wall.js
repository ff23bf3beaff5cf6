// What is wrong with the wall of a class, as sentences: words that are too small, cut, or touch each other or a body.
() => {
  const roots = [document.querySelector(".st-key-class_wall")], words = [], bodies = [], found = new Set();
  for (const root of roots) for (const { shadowRoot } of root.querySelectorAll("*")) if (shadowRoot) roots.push(shadowRoot);
  // In an SVG, checkVisibility alone takes what is not drawn for visible.
  const seen = (node) => node.getClientRects().length && node.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  const outside = ({ left, right, top, bottom }) => left < 0 || top < 0 || right > innerWidth + 1 || bottom > innerHeight;
  for (const root of roots) {
    bodies.push(...[...root.querySelectorAll(".machine .body .form")].filter(seen));
    const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    for (let text; (text = texts.nextNode()); ) {
      const node = text.parentElement, said = text.data.trim(), range = document.createRange();
      // A body's own letter lies on it; what is typeset with subscripts has letters of two sizes.
      if (!said || !seen(node) || node.closest("style, title, option, .body, .katex")) continue;
      const size = parseFloat(getComputedStyle(node).fontSize) * (node.getScreenCTM?.().a ?? 1);
      const least = node.closest(".st-key-wall_asked, .st-key-class_result > * > .stHorizontalBlock") ? 0.035 : 0.022;
      if (size < least * innerHeight) found.add(`“${said}” is ${size} px high`);
      range.selectNodeContents(text);
      for (const { left, right, top, bottom } of range.getClientRects()) {
        const room = (bottom - top) / 6; // above and below the letters of a line
        if (right - left > 2) words.push({ said, left, right, top: top + room, bottom: bottom - room });
      }
    }
  }
  for (const [i, a] of words.entries()) {
    if (outside(a)) found.add(`“${a.said}” is cut`);
    for (const b of words.slice(i + 1))
      if (a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom && b.top < a.bottom)
        found.add(`“${a.said}” touches “${b.said}”`);
    for (const form of bodies)
      for (const x of [a.left, (a.left + a.right) / 2, a.right])
        for (const y of [a.top, a.bottom])
          if (form.isPointInFill(new DOMPoint(x, y).matrixTransform(form.getScreenCTM().inverse())))
            found.add(`“${a.said}” lies on ${form.parentNode.closest(".body").getAttribute("class")}`);
  }
  for (const form of bodies) if (outside(form.getBoundingClientRect())) found.add("a body is cut");
  const boxes = (selector) => roots.flatMap((root) => [...root.querySelectorAll(selector)]).filter(seen).map((node) => node.getBoundingClientRect());
  // A program or an equation shares the place with a machine that only illustrates it.
  const [place] = boxes(".st-key-wall_still, .st-key-wall_running");
  if (place && (place.width * place.height) / (innerWidth * innerHeight) < 1 / 3) found.add("the machine has less than a third of the wall");
  if (place && boxes("svg.machine").reduce((sum, box) => sum + box.width * box.height, 0) / (innerWidth * innerHeight) < 0.08) found.add("the picture is small");
  if (boxes(".face").some((box) => box.height < 0.15 * innerHeight)) found.add("the clock is small");
  if (!words.length) found.add("there are no words");
  return [...found];
}
