// Collects the page's visible controls, also those of components, as `controls`: what is drawn of each, its kind, and what takes
// the focus, outside of what is skipped. A slider's control is its rail with the thumb, a switch's or an option's the part before its words.
(skipped) => {
  const DRAWN = "button, select, summary, textarea, input, a[href], [role=tab], span.grip";
  const drawn = (node) => {
    const label = node.closest("[data-testid=stRadioOption], .stCheckbox label");
    if (label) return label.querySelector("[data-testid=stRadioOption] > span + div > :first-child, .stCheckbox label > span + div");
    if (node.matches(".stSlider input")) return node.closest("[role=group]").firstElementChild;
    if (node.matches(".stTextInput input, .stNumberInput input, [role=combobox]")) return node.parentElement;
    return node;
  };
  const controls = [];
  const collect = (root, place) => {
    for (const node of root.querySelectorAll("*")) {
      if (node.shadowRoot && !node.closest(skipped)) collect(node.shadowRoot, node.closest("[class*=st-key-]")?.className.match(/st-key-(\w+)/)[1]);
      if (!node.matches(DRAWN) || node.closest(`.js-plotly-plot, [hidden], ${skipped}`)) continue;
      const shape = drawn(node), box = shape.getBoundingClientRect();
      const is = { opacityProperty: true, visibilityProperty: true };
      if (!shape.checkVisibility(is) || box.width < 3 || box.height < 3 || box.right < 1 || box.left > innerWidth - 1) continue;
      const kind = [place ?? node.closest("[data-testid]")?.dataset.testid, node.localName, node.type, node.role, node.dataset.variant].join(" ");
      controls.push({ node, shape, kind, isDisabled: node.disabled === true || node.ariaDisabled === "true" });
    }
  };
  collect(document);
  globalThis.controls = controls;
  return controls.map(({ node, kind, isDisabled }) => ({
    kind, isDisabled, words: (node.innerText || node.ariaLabel || node.getAttribute("class") || "").trim().slice(0, 30), tag: node.localName,
    type: node.getAttribute("role") ?? node.type ?? "",
  }));
}
