// What the parts that turn something by buttons, a slider and keys have in common.

import { bus } from "./bus.js";
import { fill } from "./sentences.js";

/** How far a key turns by this table, 0 if it is not meant for turning. */
export const turnOf = (event, table) =>
  event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey ? 0 : table[event.key] ?? 0;

/** Show on the buttons and the slider of steps.html where one is. `data`: the headings, and the template of a place. */
export function showPlace(root, data, now, speak) {
  const [back, next] = root.querySelectorAll("button");
  const slider = root.querySelector("input");
  const count = data.headings.length;
  const place = fill(data.place, { now, count, heading: data.headings[now - 1] });
  slider.value = now;
  slider.setAttribute("aria-valuetext", place);
  root.querySelector("output").textContent = `${now}/${count}`;
  back.setAttribute("aria-disabled", String(now === 1));
  next.setAttribute("aria-disabled", String(now === count));
  if (speak) bus.publish("say", { sentence: place, urgent: true });
}
