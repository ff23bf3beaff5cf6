(() => {
  window.seen = new Set();
  const look = () => {
    const slides = [...document.querySelectorAll("[class*='st-key-slide-']")];
    const seen = slides.filter((slide) => slide.checkVisibility({ visibilityProperty: true }));
    const size = parseFloat(getComputedStyle(document.documentElement).fontSize);
    for (const { className } of seen) window.seen.add(`${/st-key-slide-(\w+)/.exec(className)[1]} ${size >= 24}`);
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
})()
