// The controls under the picture: their actions, and keyboard navigation between them.

import { finder } from "./parts.js";
import { save } from "./save.js";
import { WORDS } from "./texts.js";

/**
 * Connect the controls with the methods of a stage: play(), listener.toggle(), step(by), release(), scrub(share),
 * setClock({ speed }), layer(name).
 */
export function listenToControls(root, stage, signal) {
  const all = (selector) => [...root.querySelectorAll(selector)];
  const on = (target, type, handler) => target.addEventListener(type, handler, { signal });
  const actions = {
    restart: () => stage.releaseAll(),
    play: () => stage.play(),
    listen: () => stage.listener.toggle(),
    back: () => stage.step(-1),
    forward: () => stage.step(1),
    save: () => save(root),
  };
  for (const button of all("[data-do]")) on(button, "click", actions[button.dataset.do]);
  const connect = (selector, type, handler) => on(root.querySelector(selector), type, ({ target }) => handler(target));
  connect(".speeds select", "change", ({ value }) => stage.setClock({ speed: Number(value) }));
  connect(".viewpoint input", "change", ({ checked }) => stage.setClock({ seenFrom: checked ? "block" : "ground" }));
  connect(".scrub input", "input", ({ value }) => stage.scrub(Number(value)));
  for (const label of all("[data-layer]")) on(label, "change", () => stage.layer(label.dataset.layer));

  on(root.querySelector(".stage"), "keydown", (event) => {
    const inControl = event.target.closest("input, select, button, [role=slider]");
    const keys = { Space: "play", ArrowLeft: "back", ArrowRight: "forward", Home: "restart", KeyL: "listen" };
    const action = keys[event.code];
    if (!action || inControl || stage.parts.hides("motion") || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    actions[action]();
  });

  rove(root.querySelector(".transport"), on);
}

/** Make a group of buttons a single stop for Tab; the arrow keys move within it. */
function rove(group, on) {
  const items = [...group.children];
  const stopAt = (item) => items.forEach((each) => (each.tabIndex = each === item ? 0 : -1));
  stopAt(items[0]);
  on(group, "focusin", (event) => stopAt(event.target));
  on(group, "keydown", (event) => {
    const i = items.indexOf(event.target);
    const to = { ArrowRight: i + 1, ArrowDown: i + 1, ArrowLeft: i - 1, ArrowUp: i - 1, Home: 0, End: -1 }[event.key];
    if (to === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    items.at(to % items.length).focus();
  });
}

/** Update the controls: play or pause, speed, reference frame, layers. */
export function showControls(root, { playing, speed, seenFrom }, layers) {
  const find = finder(root);
  root.querySelector(".stage").classList.toggle("playing", playing);
  find("[data-do=play]").setAttribute("aria-label", playing ? WORDS.pause : WORDS.play);
  find(".speeds select").value = speed;
  find(".viewpoint input").checked = seenFrom === "block";
  for (const label of root.querySelectorAll("[data-layer]")) label.firstChild.checked = layers.has(label.dataset.layer);
}
