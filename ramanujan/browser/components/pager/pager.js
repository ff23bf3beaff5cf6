// Shows one slide of the page at a time, for a projector. Python declares the slides (shell/display_mode.py), and
// projector.css contains their layout.

import { bus } from "../../bus.js";
import { observe } from "../../lasting.js";
import { narrow } from "../../narrow.js";
import { dom } from "../../streamlit_dom.js";
import { fill } from "../../sentences.js";
import { turnOf } from "../turn/turn.js";

const AWAY = "data-away"; // projector.css hides slides with this attribute, without a change of their size
const SIZES = [1.2, 1.15, 1.1, 1.05, 1, 0.99, 0.96, 0.92, 0.88, 0.84, 0.8, 0.76, 0.72]; // of the words (projector.css)
const PAUSE = 400; // ms from the last turn until the slide's name is sent to the server

let page; // path of the page whose slides were shown last, by this pager or an earlier one

function applyProjectorStyle(isOn) {
  document.querySelector("link[href$='projector.css']").media = isOn ? "all" : "not all";
  narrow.setOff(isOn);
}
const slideInAddress = () => new URLSearchParams(location.search).get("slide");
const indexOf = (name, slides) => slides.findIndex((slide) => slide.name === name);
const reveal = (now, slides) => slides.forEach(({ node }, i) => node.toggleAttribute(AWAY, i !== now));

// On a projector, services.js loads this file early, and only one slide is visible before the pager is mounted.
const untilMounted = new AbortController();
function revealFirst() {
  const slides = dom.slides(), name = slideInAddress();
  reveal(name ? indexOf(name, slides) : 0, slides);
}
applyProjectorStyle(true);
revealFirst();
observe(document.body, { childList: true, subtree: true }, () => revealFirst(), untilMounted.signal);

export default function (component, signal) {
  untilMounted.abort();
  const pager = new Pager(component, signal);
  return () => pager.update();
}

class Pager {
  constructor(component, signal) {
    const root = component.parentElement;
    Object.assign(this, { component, slides: [], now: 0, list: root.querySelector("select") });
    this.wanted = slideInAddress();
    [this.back, this.next] = root.querySelectorAll("button");
    for (const [button, by] of [[this.back, -1], [this.next, 1]]) button.addEventListener("click", () => this.turn(by));
    this.list.addEventListener("change", () => this.turn(this.list.selectedIndex - this.now));
    const name = () => (this.now > 0 ? this.slides[this.now].name : "");
    this.send = dom.debounceMessage(PAUSE, () => component.setTriggerValue("at", name()), signal);
    // The window receives a key event last, so other elements can use the key first.
    window.addEventListener("keydown", (event) => {
      const by = turnOf(event, { PageDown: 1, PageUp: -1 });
      if (by && this.turn(by)) event.preventDefault();
    }, { signal });
    // The next stop of the lesson begins with its first slide.
    bus.subscribe("turned", () => this.turn(-this.now), { signal });
    const refit = () => {
      this.fitted = null;
      this.fit();
    };
    bus.subscribe("step", refit, { signal });
    addEventListener("resize", refit, { signal });
    document.fonts.addEventListener("loadingdone", refit, { signal });
    bus.publish("slides", { has: (by) => Boolean(this.slides[this.now + by]) });
    document.documentElement.dataset.pager = "";
    applyProjectorStyle(true);
    observe(document.body, { childList: true, subtree: true }, () => this.update(), signal);
    dom.watchRuns(() => this.update(), signal);
    signal.addEventListener("abort", () => {
      bus.forget("slides");
      bus.forget("slide");
      delete document.documentElement.dataset.pager;
      delete document.body.dataset.shown;
      applyProjectorStyle(false);
      for (const { node } of this.slides) node.removeAttribute(AWAY);
    });
  }

  /** Read the page's slides. Streamlit draws them one after another, so this runs after every change of the page. */
  update() {
    const isNewPage = page && page !== location.pathname, before = this.now;
    page = location.pathname;
    if (isNewPage) this.wanted = null;
    this.slides = dom.slides();
    this.listTitles();
    this.show(this.wantedIndex());
    // The present slide is another one than that whose name was about to be sent.
    if (this.now !== before) this.send.cancel();
  }

  /**
   * The index of the wanted slide, or 0 if the page lacks it. -1 while the slide may still follow. It may follow until
   * every slide has its title. If no slide has been shown yet, it may follow until the end of the server's run.
   */
  wantedIndex() {
    const index = indexOf(this.wanted, this.slides);
    const mayFollow = this.slides.some(({ title }) => !title) || (!this.hasShown && dom.isRunning());
    return this.wanted && mayFollow ? index : Math.max(index, 0);
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
    reveal(now, this.slides);
    const name = this.slides[now]?.name;
    if (name !== bus.last("slide")) {
      bus.publish("slide", name);
      document.body.dataset.shown = name ?? ""; // with it, a page hides the settings that do not concern a slide
    }
    this.list.selectedIndex = now;
    // A single slide needs no pager, and a lesson counts its stops itself.
    this.list.parentElement.style.display = this.slides.length > 1 ? "" : "none";
    this.back.disabled = now <= 0;
    this.next.disabled = now >= this.slides.length - 1;
    this.fit();
  }

  /** Choose the largest size of text at which the content of the present slide fits, once for each content. */
  fit() {
    const node = this.slides[this.now]?.node, text = node?.textContent;
    if (!node || (node === this.fitted?.node && text === this.fitted.text)) return;
    this.fitted = { node, text };
    for (const size of SIZES.filter((size) => size <= 1 || !dom.hasFigure(node))) {
      node.style.setProperty("--fit", size);
      dom.fitFormulas(node);
      if (!dom.overflows(node)) break;
    }
  }

  turn(by) {
    if (!by || !this.slides[this.now + by]) return false;
    this.wanted = this.slides[this.now + by].name;
    this.show(this.now + by);
    this.send();
    return true;
  }
}
