// The live region of a page. It announces one sentence after a pause without new sentences. An event (`urgent`) takes
// precedence over a description of the reader's own change.

import { bus } from "../../bus.js";
import { debounce } from "../../lasting.js";

const PAUSE = 500; // ms without a new sentence before one is announced

export default function ({ parentElement }, signal) {
  const region = parentElement.querySelector("[role=status]");
  let next = null;
  const announceSoon = debounce(PAUSE, () => {
    // A screen reader announces only changes, so clear the region before repeating a sentence.
    if (region.textContent === next.sentence) region.textContent = "";
    region.textContent = next.sentence;
    next = null;
    bus.forget("announce");
  }, signal);
  bus.subscribe("announce", (announcement) => {
    if (!next?.urgent || announcement.urgent) next = announcement;
    announceSoon();
  }, { signal });
}
