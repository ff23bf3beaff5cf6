// Records in window.seen all slides that were ever visible, each with whether its letters had at least 24 px.
(() => {
  window.seen = new Set();
  const record = () => {
    const slides = [...document.querySelectorAll("[class*='st-key-slide-']")];
    const visible = slides.filter((slide) => slide.checkVisibility({ visibilityProperty: true }));
    const size = parseFloat(getComputedStyle(document.documentElement).fontSize);
    for (const { className } of visible) window.seen.add(`${/st-key-slide-(\w+)/.exec(className)[1]} ${size >= 24}`);
    requestAnimationFrame(record);
  };
  requestAnimationFrame(record);
})()
