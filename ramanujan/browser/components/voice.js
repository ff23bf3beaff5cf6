// The one live region of a page: it says one sentence, once, when things have come to rest after a change. What happened by
// itself (urgent) comes before a description of what a person has just set.

import { bus } from "./bus.js";
import { atRest } from "./lasting.js";

const REST = 500; // ms without news before a sentence is said

export default function ({ parentElement }, signal) {
  const region = parentElement.querySelector("[role=status]");
  let next = null;
  const soon = atRest(REST, () => {
    // The same words again are news, too; a screen reader hears only what changes.
    if (region.textContent === next.sentence) region.textContent = "";
    region.textContent = next.sentence;
    next = null;
    bus.forget("say");
  }, signal);
  bus.subscribe("say", (news) => {
    if (!next?.urgent || news.urgent) next = news;
    soon();
  }, { signal });
}
