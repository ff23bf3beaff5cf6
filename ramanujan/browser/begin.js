// Starts the components of the app. A component has the name of its module. This file loads the module, its HTML and
// its CSS.
//
// Streamlit calls a component again after each change of its data or of the theme. It keeps only the last cleanup
// function. This file gives each module a simpler interface. The module's default function is called once per element,
// with the component and a signal. The component always has the data and the setters of the last call. The signal
// aborts when the element leaves the page. If the function returns an update function, it is called after each of
// Streamlit's calls.

import { MARKUP } from "./markup.js";
import { narrow } from "./narrow.js";

// In the standalone file modules have data: addresses, without a folder.
const CONTRAST = import.meta.url.startsWith("data:") ? "" : linkContrast();

function linkContrast() {
  const address = new URL("contrast.css", import.meta.url);
  return `<link rel="stylesheet" media="(forced-colors: active)" href="${address}">`;
}

const hasMarkup = new WeakSet(); // parentElements that contain their HTML
const instances = new WeakMap(); // parentElement → { component, stop, calls, update }

export async function begin(component) {
  const { name, parentElement } = component;
  const module = await import(`./${name}.js`);
  if (!hasMarkup.has(parentElement)) {
    hasMarkup.add(parentElement);
    const markup = document.createElement("template");
    markup.innerHTML = MARKUP[name] ? MARKUP[name] + CONTRAST : "";
    parentElement.append(markup.content);
    narrow.apply(parentElement);
    parentElement.host?.toggleAttribute("data-begun", true);
  }
  if (!instances.has(parentElement)) {
    const instance = { component: { ...component }, stop: new AbortController(), calls: 0 };
    instances.set(parentElement, instance);
    instance.update = module.default(instance.component, instance.stop.signal);
  }
  const instance = instances.get(parentElement);
  instance.calls += 1;
  const call = instance.calls;
  Object.assign(instance.component, component);
  instance.update?.();
  return () => {
    // Streamlit may run the cleanup of an earlier call while the element is still on the page.
    if (call !== instance.calls) return;
    instances.delete(parentElement);
    instance.stop.abort();
  };
}
