() => {
  const found = [];
  const cut = (node) => {
    const style = getComputedStyle(node);
    const hides = ["hidden", "clip"].includes(style.overflowX) || style.textOverflow === "ellipsis";
    return hides && node.clientWidth > 1 && node.scrollWidth > node.clientWidth + 1 && node.innerText?.trim()
      && node.checkVisibility() && !node.closest(".katex, .js-plotly-plot, .rc-overflow");
  };
  const walk = (root) => {
    for (const node of root.querySelectorAll("*")) {
      if (node.shadowRoot) walk(node.shadowRoot);
      if (cut(node)) found.push(`${node.className}: ${node.innerText.slice(0, 60)}`);
    }
  };
  walk(document.body);
  const main = document.querySelector("[data-testid=stMain]");
  if (main.scrollWidth > main.clientWidth) found.push("the page scrolls sideways");
  return found;
}
