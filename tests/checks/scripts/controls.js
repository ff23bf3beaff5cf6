// Collects the visible controls of the page and its components in `controls`: the drawn element, its kind, and the
// element that takes the focus. The selector `skipped` excludes elements. A slider's drawn element is its track with
// the thumb; that of a switch or an option is the part before its label.
(skipped) => {
  const CONTROLS = "button, select, summary, textarea, input, a[href], [role=tab], span.grip";
  const drawn = (node) => {
    const label = node.closest("[data-testid=stRadioOption], .stCheckbox label");
    const shapes = "[data-testid=stRadioOption] > span + div > :first-child, .stCheckbox label > span + div";
    if (label) return label.querySelector(shapes);
    if (node.matches(".stSlider input")) return node.closest("[role=group]").firstElementChild;
    if (node.matches(".stTextInput input, .stNumberInput input, [role=combobox]")) return node.parentElement;
    return node;
  };
  const controls = [];
  const collect = (root, place) => {
    for (const node of root.querySelectorAll("*")) {
      const key = node.closest("[class*=st-key-]")?.className.match(/st-key-(\w+)/)[1];
      if (node.shadowRoot && !node.closest(skipped)) collect(node.shadowRoot, key);
      if (!node.matches(CONTROLS) || node.closest(`.js-plotly-plot, [hidden], ${skipped}`)) continue;
      const shape = drawn(node), box = shape.getBoundingClientRect();
      const properties = { opacityProperty: true, visibilityProperty: true };
      const isOutside = box.right < 1 || box.left > innerWidth - 1;
      if (!shape.checkVisibility(properties) || box.width < 3 || box.height < 3 || isOutside) continue;
      const at = place ?? node.closest("[data-testid]")?.dataset.testid;
      const kind = [at, node.localName, node.type, node.role, node.dataset.variant].join(" ");
      controls.push({ node, shape, kind, isDisabled: node.disabled === true || node.ariaDisabled === "true" });
    }
  };
  collect(document);
  globalThis.controls = controls;
  return controls.map(({ node, kind, isDisabled }) => ({
    kind, isDisabled, words: (node.innerText || node.ariaLabel || node.getAttribute("class") || "").trim().slice(0, 30),
    tag: node.localName,
    type: node.getAttribute("role") ?? node.type ?? "",
  }));
}
