// Returns all words on the page and in its components, also hidden ones, and all names and values for screen readers.
() => {
  const texts = [];
  const walk = (root) => {
    for (const node of root.querySelectorAll("*")) {
      if (["SCRIPT", "STYLE"].includes(node.tagName)) continue;
      for (const { name, value } of node.attributes)
        if (name.startsWith("aria-") || name === "title") texts.push(value);
      for (const child of node.childNodes) if (child.nodeType === 3) texts.push(child.data);
      if (node.shadowRoot) walk(node.shadowRoot);
    }
  };
  walk(document);
  return texts.join("\n");
}
