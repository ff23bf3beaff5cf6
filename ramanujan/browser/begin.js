// Begins the components of the app: a component has the name of its module, and this one finds it and its HTML and CSS.
//
// Streamlit calls a component again whenever its data or the theme changes, and of all the clean-ups that these calls return it
// keeps the last. A module need not know: its function is called once for an element, with the component, whose data and
// setters are always those of the last call, and a signal that aborts when the element leaves the page. What the function
// returns, if anything, is called after each call of Streamlit's.

import { MARKUP } from "./markup.js";

const filled = new WeakSet(); // parentElements that have their HTML
const lives = new WeakMap(); // parentElement → { component, stop, calls, update }

export async function begin(component) {
  const { name, parentElement } = component;
  const module = await import(`./${name}.js`);
  if (!filled.has(parentElement)) {
    filled.add(parentElement);
    const markup = document.createElement("template");
    markup.innerHTML = MARKUP[name] ?? "";
    parentElement.append(markup.content);
    parentElement.host?.toggleAttribute("data-begun", true);
  }
  if (!lives.has(parentElement)) {
    const life = { component: { ...component }, stop: new AbortController(), calls: 0 };
    lives.set(parentElement, life);
    life.update = module.default(life.component, life.stop.signal);
  }
  const life = lives.get(parentElement), call = ++life.calls;
  Object.assign(life.component, component);
  life.update?.();
  return () => {
    // A clean-up of an earlier call may come late: the element lives on.
    if (call !== life.calls) return;
    lives.delete(parentElement);
    life.stop.abort();
  };
}
