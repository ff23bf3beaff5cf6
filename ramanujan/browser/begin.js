// Begins the components of the app: a component's own script names its module, and this one finds it and what it looks like.

import { LOOKS } from "./looks.js";

const dressed = new WeakSet(); // parentElements that have their HTML

export async function begin(name, component) {
  const module = await import(`./${name}.js`);
  const { parentElement } = component;
  if (!dressed.has(parentElement)) {
    dressed.add(parentElement);
    const look = document.createElement("template");
    look.innerHTML = LOOKS[name] ?? "";
    parentElement.append(look.content);
  }
  return module.default(component);
}
