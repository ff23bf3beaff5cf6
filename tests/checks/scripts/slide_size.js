// Measures the visible slide of a projector: the number of visible slides, the overflow, and the used share of its
// height.
() => {
  const main = document.querySelector('[data-testid=stMain]');
  const slides = [...document.querySelectorAll('[class*=st-key-slide-]')];
  const visible = slides.filter((node) => !node.hasAttribute("data-away"));
  const [slide] = visible, { top, height } = slide.getBoundingClientRect();
  const drawn = [...slide.children].map((node) => node.getBoundingClientRect()).filter((box) => box.height > 2);
  return {
    visible: visible.length,
    over: Math.max(...[slide, main].map((node) => node.scrollHeight - node.clientHeight)),
    wide: Math.max(...[slide, main].map((node) => node.scrollWidth - node.clientWidth)),
    filled: (Math.max(...drawn.map((box) => box.bottom)) - top) / height,
  };
}
