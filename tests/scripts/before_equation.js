() => {
  const top = [...document.querySelectorAll('.st-key-lecture .katex-display')].find((each) => each.checkVisibility())
    .getBoundingClientRect().top;
  const found = [];
  const look = (root) => [...root.querySelectorAll('*')].forEach((node) => {
    if (node.shadowRoot) look(node.shadowRoot);
    const { width, height, top: y } = node.getBoundingClientRect();
    const seen = node.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && width > 1 && height > 1;
    const offered = node.matches('button, input, select, summary') && !node.closest('.st-key-bar');
    if (seen && y < top && offered) found.push(node.ariaLabel ?? node.innerText);
  });
  look(document.querySelector('[data-testid=stMain]'));
  return found;
}
