// Returns the sentences of a projector's present slide that are smaller than a share of its height, if it has free
// room.
([share, full]) => {
  const slide = document.querySelector("[class*=st-key-slide-]:not([data-away])");
  const { top, height } = slide.getBoundingClientRect();
  const boxes = [...slide.children].map((node) => node.getBoundingClientRect());
  const bottoms = boxes.filter((box) => box.height > 2).map((box) => box.bottom);
  if (Math.max(...bottoms) - top > full * height) return [];
  return [...slide.querySelectorAll("p, li")]
    .filter((node) => node.checkVisibility({ visibilityProperty: true }))
    .filter((node) => node.innerText.trim().split(/\s+/).length > 3)
    .filter((node) => parseFloat(getComputedStyle(node).fontSize) < share * innerHeight)
    .map((node) => `${getComputedStyle(node).fontSize}: ${node.innerText.slice(0, 30)}`);
}
