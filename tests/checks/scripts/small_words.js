// Returns the visible texts on a slide with letters smaller than `small` px.
(small) => {
  const inside = (node) => (node.shadowRoot ? all(node.shadowRoot) : []);
  const all = (root) => [...root.querySelectorAll('*')].flatMap((node) => [node, ...inside(node)]);
  const excluded = ['.controls, .katex-mathml, .note, .pager, .bartext, [data-away], .st-key-lesson_head, .stSelectbox',
    '.body, .coordinates',
    '.stSlider, .cursor, label, button, style, .mtight, .size4, tspan[style*="font-size:70%"]'];
  const properties = { visibilityProperty: true, opacityProperty: true };
  const isVisible = (node) => node.checkVisibility(properties) && !node.closest(excluded);
  const size = (node) => {
    const svg = node.ownerSVGElement, scale = svg && node.getScreenCTM ? node.getScreenCTM().d : 1;
    return parseFloat(getComputedStyle(node).fontSize) * (scale || 1);
  };
  const isText = (each) => each.nodeType === 3 && each.data.replaceAll('\u200b', '').trim();
  const hasText = (node) => [...node.childNodes].some(isText);
  const smallTexts = all(document.querySelector('.stMainBlockContainer'))
    .filter((node) => hasText(node) && isVisible(node) && size(node) < small);
  return smallTexts.map((node) => `${size(node).toFixed(1)} px: ${node.textContent.trim().slice(0, 30)}`);
}
