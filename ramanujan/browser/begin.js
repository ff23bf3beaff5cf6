// Starts the components of the app. A component has the name of its module; this file loads the module, its HTML and its CSS.
//
// Streamlit calls a component again whenever its data or the theme changes, and keeps only the last cleanup. A module need not
// know that. Its function is called once for each element, with the component and a signal. The component always has the data
// and the setters of the last call; the signal aborts when the element leaves the page. If the function returns another
// function, that one is called after each of Streamlit's calls.

import { MARKUP } from "./markup.js";

// The page without a server has its modules in data: addresses, which have no folder.
const CONTRAST = import.meta.url.startsWith("data:")
  ? ""
  : `<link rel="stylesheet" media="(forced-colors: active)" href="${new URL("components/contrast.css", import.meta.url)}">`;

const filled = new WeakSet(); // parentElements that have their HTML
const lives = new WeakMap(); // parentElement → { component, stop, calls, update }

export async function begin(component) {
  const { name, parentElement } = component;
  const module = await import(`./${name}.js`);
  if (!filled.has(parentElement)) {
    filled.add(parentElement);
    const markup = document.createElement("template");
    markup.innerHTML = MARKUP[name] ? MARKUP[name] + CONTRAST : "";
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
    // The cleanup of an earlier call may come late, while the element is still on the page.
    if (call !== life.calls) return;
    lives.delete(parentElement);
    life.stop.abort();
  };
}
