// One sheet of the page at a time, for a projector. Python declares the sheets (shell/display_mode.py) and projector.css lays
// them out; here it is decided which one is seen.

import { bus } from "./bus.js";
import { atRest, observe } from "./lasting.js";
import { dom } from "./streamlit_dom.js";
import { fill } from "./sentences.js";
import { turnOf } from "./turning.js";

const AWAY = "data-away"; // projector.css takes such a sheet out of sight; it keeps its size
const TELL = 400; // ms from the last turn to the message that keeps the sheet in the address

let page; // whose sheets were seen last, by this pager or the one before

export default function (component, signal) {
  const pager = new Pager(component, signal);
  return () => pager.look();
}

class Pager {
  constructor(component, signal) {
    const root = component.parentElement;
    Object.assign(this, { component, sheets: [], now: 0, list: root.querySelector("select") });
    this.wanted = new URLSearchParams(location.search).get("sheet");
    [this.back, this.next] = root.querySelectorAll("button");
    for (const [button, by] of [[this.back, -1], [this.next, 1]]) button.addEventListener("click", () => this.turn(by));
    this.list.addEventListener("change", () => this.turn(this.list.selectedIndex - this.now));
    this.tell = atRest(TELL, () => component.setStateValue("at", this.now ? this.sheets[this.now].name : ""), signal);
    // Bubbling up to the window: what the page itself does with a key comes first.
    window.addEventListener("keydown", (event) => this.press(event), { signal });
    bus.subscribe("turned", () => this.turn(-this.now), { signal }); // another stop of the lesson begins with its first sheet
    bus.publish("sheets", { has: (by) => Boolean(this.sheets[this.now + by]) });
    document.documentElement.dataset.pager = "";
    observe(document.body, { childList: true, subtree: true }, () => this.look(), signal);
    signal.addEventListener("abort", () => {
      bus.forget("sheets");
      delete document.documentElement.dataset.pager;
      for (const { node } of this.sheets) node.removeAttribute(AWAY);
    });
  }

  /** Take in the page's sheets where they have changed: while Streamlit draws the page, any of them may come first. The sheet
   * that was asked for stays, and without one the first; a new page begins where its address says. */
  look() {
    const sheets = dom.sheets();
    if (sheets.length === this.sheets.length && sheets.every(({ node }, i) => node === this.sheets[i].node && node.hasAttribute(AWAY) === (i !== this.now))) return;
    const turned = page && page !== location.pathname;
    page = location.pathname;
    if (turned) this.wanted = null;
    this.sheets = sheets;
    const title = (sheet, i) => new Option(fill(this.component.data.place, { now: i + 1, count: sheets.length, title: sheet.title }));
    this.list.replaceChildren(...sheets.map(title));
    this.show(Math.max(sheets.findIndex(({ name }) => name === this.wanted), 0), turned);
  }

  show(now, tell = true) {
    this.now = now;
    this.sheets.forEach(({ node }, i) => node.toggleAttribute(AWAY, i !== now));
    this.list.selectedIndex = now;
    this.back.disabled = now === 0;
    this.next.disabled = now >= this.sheets.length - 1;
    if (tell) this.tell();
    else this.tell.cancel();
  }

  turn(by) {
    if (!this.sheets[this.now + by]) return false;
    this.wanted = this.sheets[this.now + by].name;
    this.show(this.now + by);
    return true;
  }

  press(event) {
    const by = turnOf(event, { PageDown: 1, PageUp: -1 });
    if (by && this.turn(by)) event.preventDefault();
  }
}
