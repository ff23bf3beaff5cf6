() => {
  const main = document.querySelector('[data-testid=stMain]');
  const slides = [...document.querySelectorAll('[class*=st-key-slide-]')];
  const seen = slides.filter((node) => !node.hasAttribute("data-away"));
  const [slide] = seen, { top, height } = slide.getBoundingClientRect();
  const drawn = [...slide.children].map((node) => node.getBoundingClientRect()).filter((box) => box.height > 2);
  return {
    seen: seen.length,
    over: Math.max(...[slide, main].map((node) => node.scrollHeight - node.clientHeight)),
    wide: Math.max(...[slide, main].map((node) => node.scrollWidth - node.clientWidth)),
    filled: (Math.max(...drawn.map((box) => box.bottom)) - top) / height,
  };
}
