// Records in window.seen all slides that were ever visible, each with whether its letters had at least 24 px.
(() => {
  window.seen = new Set();
  let isWaiting = false;
  const record = () => {
    isWaiting = false;
    const slides = [...document.querySelectorAll("[class*='st-key-slide-']")];
    const visible = slides.filter((slide) => slide.checkVisibility({ visibilityProperty: true }));
    const size = parseFloat(getComputedStyle(document.documentElement).fontSize);
    for (const { className } of visible) window.seen.add(`${/st-key-slide-(\w+)/.exec(className)[1]} ${size >= 24}`);
  };
  // An unchanged page looks the same in every frame. To record each of them would take a third of a processor.
  const observer = new MutationObserver(() => {
    if (!isWaiting) requestAnimationFrame(record);
    isWaiting = true;
  });
  observer.observe(document, { attributes: true, childList: true, subtree: true });
})()
