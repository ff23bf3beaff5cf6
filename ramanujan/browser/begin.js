// Begins the components of the app: a component has the name of its module, and this one finds it and its HTML and CSS.

import { MARKUP } from "./markup.js";

const filled = new WeakSet(); // parentElements that have their HTML

export async function begin(component) {
  const { name, parentElement } = component;
  const module = await import(`./${name}.js`);
  if (!filled.has(parentElement)) {
    filled.add(parentElement);
    const markup = document.createElement("template");
    markup.innerHTML = MARKUP[name] ?? "";
    parentElement.append(markup.content);
  }
  return module.default(component);
}
