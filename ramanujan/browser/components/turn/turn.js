// Turns a lecture, a list of slides: the steps of a derivation or the stops of a lesson. It has two buttons, a slider
// and keys. All steps are on the page, and one is visible, so a turn does not wait for the server. The server draws one
// stop at a time. Until it answers, the control shows the requested stop.

import { bus } from "../../bus.js";
import { fill } from "../../sentences.js";
import { dom } from "../../streamlit_dom.js";

const PAUSE = 300; // ms from the last turn until the step is sent to the server
const TIMEOUT = 5000; // ms after which a request for a stop without an answer is dropped
const SHORTCUTS = [["ArrowLeft", "PageUp"], ["ArrowRight", "PageDown"]]; // of the buttons back and next
const KEYS = { ArrowRight: 1, PageDown: 1, " ": 1, ArrowLeft: -1, PageUp: -1 };

/** The number of slides that a key turns by this table; 0 for any other key. */
export const turnOf = (event, table) =>
  event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey ? 0 : table[event.key] ?? 0;

export default function (component, signal) {
  const turner = component.data.route ? new Steps(component, signal) : new Stops(component, signal);
  return () => turner.update();
}

/** The control of a lecture. Its slides are counted from 1 and have headings. */
class Turner {
  now = 0;
  hasEnding = false; // whether the last heading is that of the ending, which has no number

  /** `sliderEvent`: name of the slider's event that turns. */
  constructor(component, signal, sliderEvent) {
    const root = component.parentElement;
    const [slider, output] = root.querySelectorAll("input, output");
    Object.assign(this, { component, slider, output });
    root.querySelector("[role=group]").ariaLabel = component.data.label;
    slider.ariaLabel = output.dataset.slide = component.data.slide;
    this.buttons = [...root.querySelectorAll("button")];
    for (const button of this.buttons)
      button.addEventListener("click", () => this.go(this.now + Number(button.dataset.by)));
    slider.addEventListener(sliderEvent, () => this.go(Number(slider.value)));
    const press = (event) => {
      const space = event.key === " ", by = turnOf(event, KEYS) * (space && event.shiftKey ? -1 : 1);
      const taken = space ? dom.TAKES_SPACE : dom.TAKES_KEYS;
      if (!by || event.composedPath()[0].matches?.(taken) || !this.mayTurn(event, by)) return;
      // The space bar must not scroll the page at the last slide.
      if (this.go(this.now + by) || space) event.preventDefault();
    };
    document.addEventListener("keydown", press, { signal });
  }

  /**
   * Go to a slide, or to the nearest existing one. Return whether the slide has changed. Beyond the last one, follow
   * the link.
   */
  go(wanted) {
    const to = Math.min(Math.max(wanted, 1), this.component.data.headings.length);
    if (to === this.now) {
      if (wanted > to) this.onward()?.click();
      return false;
    }
    this.show(to);
    bus.publish("announce", { sentence: this.slider.ariaValueText, urgent: true });
    this.onTurned();
    return true;
  }

  /** The link after the last slide, if any. */
  onward() {}

  /** Update the control. */
  show(now) {
    const { headings, place, has_onward_link: hasOnwardLink } = this.component.data;
    const last = headings.length, heading = headings[now - 1], isEnding = this.hasEnding && now === last;
    const count = this.hasEnding ? last - 1 : last;
    this.now = now;
    const ariaValueText = isEnding ? heading : fill(place, { now, count, heading });
    Object.assign(this.slider, { max: last, value: now, ariaValueText });
    this.output.textContent = isEnding ? "✓" : `${now}/${count}`;
    const [back, next] = this.buttons;
    back.ariaDisabled = now === 1;
    next.ariaDisabled = now === last && !hasOnwardLink;
  }
}

class Steps extends Turner {
  constructor(component, signal) {
    super(component, signal, "input");
    this.sheet = document.head.appendChild(document.createElement("style"));
    signal.addEventListener("abort", () => this.sheet.remove());
    // The number of the step is sent later, and the server writes it into the address.
    const sendStep = () => component.setStateValue("at", { route: this.route, step: this.now });
    this.send = dom.debounceMessage(PAUSE, sendStep, signal);
  }

  /** Page Up, Page Down and the space bar also scroll the page, so they turn only while the steps are in view. */
  mayTurn({ key }) {
    return key.startsWith("Arrow") || dom.inView(dom.lecture());
  }

  onward() {
    return dom.onward();
  }

  onTurned() {
    this.reveal();
    this.send();
  }

  /** Show the present step and hide all others. */
  reveal() {
    // The doubled class takes precedence over the page's sheet, which hides all steps.
    const step = `.st-key-step-${this.now}`;
    // The result of all routes is shown at the first step, and on paper.
    const goal = this.now > 1 ? "@media screen { :root { --goal: none; } }" : "";
    this.sheet.textContent = `#root .st-key-lecture ${step}${step} { display: var(--step, flex); }${goal}`;
    bus.publish("step", this.now);
  }

  update() {
    const { route, headings } = this.component.data;
    if (route !== this.route) {
      // The lecture begins at the step in the address. After a change of route it begins at the first step.
      const inAddress = Number(new URLSearchParams(location.search).get("step"));
      this.send.cancel();
      this.now = !this.route && headings[inAddress - 1] ? inAddress : 1;
      this.route = route;
    }
    this.show(Math.min(this.now, headings.length));
    this.reveal();
  }
}

class Stops extends Turner {
  hasEnding = true;
  request = null; // { stop, time } of the last turn without an answer

  constructor(component, signal) {
    super(component, signal, "change");
  }

  /** On a projector, a clicker's page keys first turn the slides of the present stop, up to the first or last one. */
  mayTurn({ key }, by) {
    const isAtEndOfSlides = !bus.last("slides")?.has(by);
    return key.startsWith("Arrow") || (key.startsWith("Page") && this.component.data.page_keys_turn && isAtEndOfSlides);
  }

  onTurned() {
    this.request = { stop: this.now, time: performance.now() };
    bus.publish("turned", this.now);
    this.component.setTriggerValue("to", this.now);
  }

  update() {
    const { now, page_keys_turn: pageKeysTurn } = this.component.data;
    // At the desk of a class, another button is primary: the one that moves the class.
    this.buttons[1].classList.toggle("primary", pageKeysTurn);
    for (const [i, [arrow, page]] of SHORTCUTS.entries())
      this.buttons[i].setAttribute("aria-keyshortcuts", pageKeysTurn ? `${arrow} ${page}` : arrow);
    // Ignore the answer to an earlier request.
    const isPending = this.request && performance.now() - this.request.time < TIMEOUT;
    if (isPending && now !== this.request.stop) return;
    this.request = null;
    this.show(now);
  }
}
