// Begins the components of the app: a component's own script names its module, and this one finds it and its HTML and CSS.

import { MARKUP } from "./markup.js";

const filled = new WeakSet(); // parentElements that have their HTML

export async function begin(name, component) {
  const module = await import(`./${name}.js`);
  const { parentElement } = component;
  if (!filled.has(parentElement)) {
    filled.add(parentElement);
    const markup = document.createElement("template");
    markup.innerHTML = MARKUP[name] ?? "";
    parentElement.append(markup.content);
  }
  return module.default(component);
}
