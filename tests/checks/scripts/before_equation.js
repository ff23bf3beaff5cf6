// Returns the names of the visible controls above the first visible equation of a lecture.
() => {
  const top = [...document.querySelectorAll('.st-key-lecture .katex-display')].find((each) => each.checkVisibility())
    .getBoundingClientRect().top;
  const names = [];
  const collect = (root) => [...root.querySelectorAll('*')].forEach((node) => {
    if (node.shadowRoot) collect(node.shadowRoot);
    const { width, height, top: y } = node.getBoundingClientRect();
    const isVisible = width > 1 && height > 1 &&
      node.checkVisibility({ visibilityProperty: true, opacityProperty: true });
    const isControl = node.matches('button, input, select, summary') && !node.closest('.st-key-bar');
    if (isVisible && y < top && isControl) names.push(node.ariaLabel ?? node.innerText);
  });
  collect(document.querySelector('[data-testid=stMain]'));
  return names;
}
