(small) => {
  const inside = (node) => (node.shadowRoot ? all(node.shadowRoot) : []);
  const all = (root) => [...root.querySelectorAll('*')].flatMap((node) => [node, ...inside(node)]);
  const around = ['.controls, .katex-mathml, .note, .pager, .bartext, [data-away], .st-key-lesson_head, .stSelectbox',
    '.body, .coordinates',
    '.stSlider, .cursor, label, button, style, .mtight, .size4, tspan[style*="font-size:70%"]'];
  const drawn = { visibilityProperty: true, opacityProperty: true };
  const seen = (node) => node.checkVisibility(drawn) && !node.closest(around);
  const size = (node) => {
    const svg = node.ownerSVGElement, scale = svg && node.getScreenCTM ? node.getScreenCTM().d : 1;
    return parseFloat(getComputedStyle(node).fontSize) * (scale || 1);
  };
  const said = (each) => each.nodeType === 3 && each.data.replaceAll('\u200b', '').trim();
  const words = (node) => [...node.childNodes].some(said);
  const small_words = all(document.querySelector('.stMainBlockContainer'))
    .filter((node) => words(node) && seen(node) && size(node) < small);
  return small_words.map((node) => `${size(node).toFixed(1)} px: ${node.textContent.trim().slice(0, 30)}`);
}
