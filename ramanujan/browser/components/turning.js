// The common part of steps.js, turn.js and pager.js: turning by buttons, a slider and keys.

import { bus } from "./bus.js";
import { fill } from "./sentences.js";
import { dom } from "./streamlit_dom.js";

/** The number of steps that a key turns by this table; 0 for any other key. */
export const turnOf = (event, table) =>
  event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey ? 0 : table[event.key] ?? 0;

const KEYS = { ArrowRight: 1, PageDown: 1, " ": 1, ArrowLeft: -1, PageUp: -1 };

/** The buttons and the slider of steps.html. The steps are counted from 1 and have headings. */
export class Turner {
  now = 0;

  /**
   * `sliderEvent`: name of the slider's event that turns. `mayTurn(event, by)`: whether a key may turn by this number of steps.
   * `onTurned(to)` is called after a turn. `onward()` returns the link after the last step, if any.
   */
  constructor(component, signal, { sliderEvent, mayTurn, onTurned, onward }) {
    const root = component.parentElement;
    const [slider, output] = root.querySelectorAll("input, output");
    Object.assign(this, { component, onTurned, onward, slider, output });
    this.buttons = [...root.querySelectorAll("button")];
    for (const button of this.buttons) button.addEventListener("click", () => this.go(this.now + Number(button.dataset.by)));
    this.slider.addEventListener(sliderEvent, () => this.go(Number(this.slider.value)));
    const press = (event) => {
      const space = event.key === " ", by = turnOf(event, KEYS) * (space && event.shiftKey ? -1 : 1);
      if (!by || event.composedPath()[0].matches?.(space ? dom.TAKES_SPACE : dom.TAKES_KEYS) || !mayTurn(event, by)) return;
      // The space bar must not scroll the page at the last step.
      if (this.go(this.now + by) || space) event.preventDefault();
    };
    document.addEventListener("keydown", press, { signal });
  }

  /** Go to a step, or to the nearest existing step. Return whether the step has changed. Beyond the last step, follow the link. */
  go(wanted) {
    const to = Math.min(Math.max(wanted, 1), this.component.data.headings.length);
    if (to === this.now) {
      if (wanted > to) this.onward?.()?.click();
      return false;
    }
    this.show(to);
    bus.publish("announce", { sentence: this.slider.ariaValueText, urgent: true });
    this.onTurned(to);
    return true;
  }

  /** Update the control. */
  show(now) {
    const { headings, place, has_onward_link: hasOnwardLink, has_ending: hasEnding } = this.component.data;
    const last = headings.length, heading = headings[now - 1], isEnding = hasEnding && now === last;
    const count = hasEnding ? last - 1 : last; // the ending has a heading, but no number
    this.now = now;
    const ariaValueText = isEnding ? heading : fill(place, { now, count, heading });
    Object.assign(this.slider, { max: last, value: now, ariaValueText });
    this.output.textContent = isEnding ? "✓" : `${now}/${count}`;
    const [back, next] = this.buttons;
    back.ariaDisabled = now === 1;
    next.ariaDisabled = now === last && !hasOnwardLink;
  }
}
