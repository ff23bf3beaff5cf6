// The controls under the picture: what each does, and how the keyboard goes from one to the next.

import { finder } from "./parts.js";
import { save } from "./save.js";
import { set } from "./svg.js";
import { WORDS } from "./texts.js";

/**
 * Listen to the controls of a stage. `stage` answers: play(), step(by), release(), scrub(share), speed(value), layer(name),
 * slab.undo(). Return a function to be called when controls have been hidden or shown.
 */
export function listenToControls(root, stage, signal) {
  const all = (selector) => [...root.querySelectorAll(selector)];
  const on = (target, type, handler) => target.addEventListener(type, handler, { signal });
  const more = root.querySelector(".more");
  const actions = {
    restart: () => stage.release(),
    play: () => stage.play(),
    back: () => stage.step(-1),
    forward: () => stage.step(1),
    undo: () => stage.slab.undo(),
    viewpoint: () => stage.setClock({ seenFrom: stage.clock.seenFrom === "block" ? "ground" : "block" }),
    show: ({ currentTarget: button }) => set(button, { "aria-expanded": !(more.hidden = !more.hidden) }),
  };
  for (const button of all("[data-do]")) on(button, "click", actions[button.dataset.do]);
  for (const button of all("[data-clock]")) on(button, "click", () => stage.setClock(JSON.parse(button.dataset.clock)));
  for (const button of all("[data-layer]")) on(button, "click", () => stage.layer(button.dataset.layer));
  for (const button of all("[data-save]")) on(button, "click", () => save(root, button.dataset.save));
  const scrub = root.querySelector(".scrub input");
  on(scrub, "input", () => stage.scrub(Number(scrub.value)));

  on(root.querySelector(".stage"), "keydown", (event) => {
    if ((event.ctrlKey || event.metaKey) && event.key === "z" && stage.slab.undo()) event.preventDefault();
    const inControl = event.target.closest("input, button, [role=slider]");
    const action = { " ": "play", ArrowLeft: "back", ArrowRight: "forward", Home: "restart" }[event.key];
    if (!action || inControl || stage.parts.hides("motion") || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    actions[action]();
  });

  const groups = [
    rove(all(".transport button"), { signal }),
    rove(all("[data-clock]"), { signal, choose: (button) => button.click() }),
    rove(all("[data-layer]"), { signal }),
  ];
  return () => groups.forEach((mend) => mend());
}

/**
 * One stop for Tab in a group, arrows within it; in a radio group the arrows choose as well. Return a function that gives Tab
 * a stop among the items that are on the page.
 */
function rove(all, { signal, choose }) {
  let items = all;
  const move = (to) => {
    for (const item of items) item.tabIndex = item === to ? 0 : -1;
  };
  move(items.find((item) => item.getAttribute("aria-checked") === "true") ?? items[0]);
  all.forEach((item) => {
    const on = (type, handler) => item.addEventListener(type, handler, { signal });
    on("focus", () => move(item));
    on("keydown", (event) => {
      const i = items.indexOf(item);
      const to = {
        ArrowRight: i + 1, ArrowDown: i + 1, ArrowLeft: i - 1, ArrowUp: i - 1, Home: 0, End: items.length - 1,
      }[event.key];
      if (to === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      const next = items[(to + items.length) % items.length];
      next.focus();
      choose?.(next);
    });
  });
  return () => {
    items = all.filter((item) => item.isConnected);
    if (items.length && items.every((item) => item.tabIndex < 0)) move(items[0]);
  };
}

/** Show what is set: what the clock says, { playing, speed, seenFrom }, and which layers are seen. */
export function showControls(root, clock, layers) {
  root.querySelector(".stage").classList.toggle("playing", clock.playing);
  finder(root)("[data-do=play]").setAttribute("aria-label", clock.playing ? WORDS.pause : WORDS.play);
  set(finder(root)(".viewpoint"), { "aria-pressed": clock.seenFrom === "block" });
  for (const button of root.querySelectorAll("[data-clock]")) {
    const checked = Object.entries(JSON.parse(button.dataset.clock)).every(([name, value]) => clock[name] === value);
    button.setAttribute("aria-checked", String(checked));
    button.tabIndex = checked ? 0 : -1;
  }
  for (const button of root.querySelectorAll("[data-layer]"))
    button.setAttribute("aria-pressed", String(layers.has(button.dataset.layer)));
}
