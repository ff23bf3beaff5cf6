// One slide of the page at a time, for a projector. Python declares the slides (shell/display_mode.py) and projector.css lays
// them out. This file decides which one is seen.

import { bus } from "./bus.js";
import { atRest, observe } from "./lasting.js";
import { dom } from "./streamlit_dom.js";
import { fill } from "./sentences.js";
import { turnOf } from "./turning.js";

const AWAY = "data-away"; // projector.css hides such a slide, which keeps its size
const SIZES = [1.2, 1.15, 1.1, 1.05, 1, 0.96, 0.92, 0.88, 0.84, 0.8, 0.76, 0.72]; // of the words (projector.css)
const TELL = 400; // ms from the last turn to the message that keeps the slide in the address

let page; // whose slides were seen last, by this pager or the one before

const project = (on) => (document.querySelector("link[href$='projector.css']").media = on ? "all" : "not all");
const asked = () => new URLSearchParams(location.search).get("slide");
const indexOf = (name, slides) => slides.findIndex((slide) => slide.name === name);
const see = (now, slides) => slides.forEach(({ node }, i) => node.toggleAttribute(AWAY, i !== now));

// Where the address asks for a projector, services.js loads this file first. So one slide is seen before there is a pager.
const soon = new AbortController();
const seeAsked = (slides = dom.slides()) => see(asked() ? indexOf(asked(), slides) : 0, slides);
project(true);
seeAsked();
observe(document.body, { childList: true, subtree: true }, () => seeAsked(), soon.signal);

export default function (component, signal) {
  soon.abort();
  const pager = new Pager(component, signal);
  return () => pager.look();
}

class Pager {
  constructor(component, signal) {
    const root = component.parentElement;
    Object.assign(this, { component, slides: [], now: 0, list: root.querySelector("select") });
    this.wanted = asked();
    [this.back, this.next] = root.querySelectorAll("button");
    for (const [button, by] of [[this.back, -1], [this.next, 1]]) button.addEventListener("click", () => this.turn(by));
    this.list.addEventListener("change", () => this.turn(this.list.selectedIndex - this.now));
    this.tell = atRest(TELL, () => component.setStateValue("at", this.now > 0 ? this.slides[this.now].name : ""), signal);
    // The window hears a key last, after the page itself has used it.
    window.addEventListener("keydown", (event) => {
      const by = turnOf(event, { PageDown: 1, PageUp: -1 });
      if (by && this.turn(by)) event.preventDefault();
    }, { signal });
    bus.subscribe("turned", () => this.turn(-this.now), { signal }); // another stop of the lesson begins with its first slide
    const refit = () => {
      this.fitted = null;
      this.fit();
    };
    bus.subscribe("step", refit, { signal });
    addEventListener("resize", refit, { signal });
    document.fonts.addEventListener("loadingdone", refit, { signal });
    bus.publish("slides", { has: (by) => Boolean(this.slides[this.now + by]) });
    document.documentElement.dataset.pager = "";
    project(true);
    observe(document.body, { childList: true, subtree: true }, () => this.look(), signal);
    dom.watchRuns(() => this.look(), signal);
    signal.addEventListener("abort", () => {
      bus.forget("slides");
      delete document.documentElement.dataset.pager;
      project(false);
      for (const { node } of this.slides) node.removeAttribute(AWAY);
    });
  }

  /** Take in the page's slides. Streamlit draws them one after another, so this runs after every change of the page. */
  look() {
    const isNewPage = page && page !== location.pathname, before = this.now;
    page = location.pathname;
    if (isNewPage) this.wanted = null;
    this.slides = dom.slides();
    this.listTitles();
    this.show(this.place());
    if (isNewPage) this.tell();
    else if (this.now !== before) this.tell.cancel();
  }

  /**
   * The index of the wanted slide, else of the first one. While more slides may come, the wanted one may be among them: until
   * every slide has its title and, for a page that has shown none yet, until the server's run has ended.
   */
  place() {
    const index = indexOf(this.wanted, this.slides);
    const mayCome = this.slides.some(({ title }) => !title) || (!this.hasShown && dom.isRunning());
    return this.wanted && mayCome ? index : Math.max(index, 0);
  }

  listTitles() {
    const count = this.slides.length;
    const titles = this.slides.map(({ title }, i) => fill(this.component.data.place, { now: i + 1, count, title }));
    if (titles.join() === this.titles) return;
    this.titles = titles.join();
    this.list.replaceChildren(...titles.map((title) => new Option(title)));
  }

  show(now) {
    this.now = now;
    this.hasShown ||= now >= 0;
    see(now, this.slides);
    this.list.selectedIndex = now;
    this.back.disabled = now <= 0;
    this.next.disabled = now >= this.slides.length - 1;
    this.fit();
  }

  /** Choose the largest words with which the present slide shows all of its content, once for each content. */
  fit() {
    const node = this.slides[this.now]?.node, text = node?.textContent;
    if (!node || (node === this.fitted?.node && text === this.fitted.text)) return;
    this.fitted = { node, text };
    for (const size of SIZES.filter((size) => size <= 1 || !dom.hasFigure(node))) {
      node.style.setProperty("--fit", size);
      node.style.setProperty("--formulas", 1);
      node.style.setProperty("--formulas", dom.formulaSize(node));
      if (!dom.overflows(node)) break;
    }
  }

  turn(by) {
    if (!this.slides[this.now + by]) return false;
    this.wanted = this.slides[this.now + by].name;
    this.show(this.now + by);
    this.tell();
    return true;
  }
}
