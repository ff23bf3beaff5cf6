// Returns the elements whose text is cut at the side, with this text.
() => {
  const cuts = [];
  const isCut = (node) => {
    const style = getComputedStyle(node);
    const hides = ["hidden", "clip"].includes(style.overflowX) || style.textOverflow === "ellipsis";
    return hides && node.clientWidth > 1 && node.scrollWidth > node.clientWidth + 1 && node.innerText?.trim()
      && node.checkVisibility() && !node.closest(".katex, .js-plotly-plot, .rc-overflow");
  };
  const walk = (root) => {
    for (const node of root.querySelectorAll("*")) {
      if (node.shadowRoot) walk(node.shadowRoot);
      if (isCut(node)) cuts.push(`${node.className}: ${node.innerText.slice(0, 60)}`);
    }
  };
  walk(document.body);
  const main = document.querySelector("[data-testid=stMain]");
  if (main.scrollWidth > main.clientWidth) cuts.push("the page scrolls sideways");
  return cuts;
}
