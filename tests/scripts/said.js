() => {
  // Every word on the page and in its components, seen or not, and every name and value that a screen reader hears.
  const said = [];
  const walk = (root) => {
    for (const node of root.querySelectorAll("*")) {
      if (["SCRIPT", "STYLE"].includes(node.tagName)) continue;
      for (const { name, value } of node.attributes) if (name.startsWith("aria-") || name === "title") said.push(value);
      for (const child of node.childNodes) if (child.nodeType === 3) said.push(child.data);
      if (node.shadowRoot) walk(node.shadowRoot);
    }
  };
  walk(document);
  return said.join("\n");
}
