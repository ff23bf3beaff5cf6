// The story of the first page. It begins with equal masses, and moves the slider of m′ to the mass ratio at which both
// hands stay together. Then it sends the exact value. The scenes come from Python; the stage's clock (topic time/NAME)
// measures the progress. Any touch or key ends the story: the slider stays at its value and sends it.

import { bus } from "../../bus.js";
import { sliders } from "../../sliders.js";
import { fill, fixed } from "../../sentences.js";
import { between } from "../../stage/motion.js";

const SAME = 1e-12; // relative; the rounding errors of ε* are smaller
// Whether the slider has reached the ratio since the page was loaded; then the ratio is marked.
let hasReachedGoal = false;
let isCompleted = false; // whether a story has been completed since the page was loaded

export default ({ data, parentElement }, signal) => void new Story(data, parentElement, signal);

class Story {
  scenes = null; // of the running story
  isWaiting = false; // for the machine and its slider, after a press
  machine = null; // parameters of the drawn machine
  lastPeriods = 0; // progress at the last frame, in periods

  constructor(data, root, signal) {
    const find = (selector) => root.querySelector(selector);
    Object.assign(this, { data, signal, button: find("button"), output: find(".sentence"), stills: find(".stills") });
    this.reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
    this.button.title = data.words.hint;
    find(".stills p").textContent = data.words.stills;
    find("ol").innerHTML = data.stills.map(clockFace).join("");
    this.listen();
  }

  listen() {
    const { data: { stage, slider }, button, signal } = this;
    button.addEventListener("click", () => (this.scenes ? this.stop() : this.begin()));
    // A pointer event has no key.
    const isPress = (event) => event.composedPath().includes(button) && [undefined, " ", "Enter"].includes(event.key);
    const interrupt = (event) => {
      if (isPress(event)) return;
      this.isWaiting = false;
      if (this.scenes) this.stop();
    };
    for (const type of ["pointerdown", "keydown"]) addEventListener(type, interrupt, { capture: true, signal });
    this.reducedMotion.addEventListener("change", () => this.scenes && this.begin(), { signal });
    signal.addEventListener("abort", () => {
      if (this.scenes) bus.publish(`story/${stage}`, null);
    });
    bus.subscribe(`time/${stage}`, ({ periods }) => this.scenes && this.goTo(periods), { signal });
    bus.subscribe(`drawn/${stage}`, (drawn) => this.follow(drawn), { signal });
  }

  /** The value of m′ [kg] at which the drawn machine is in step. */
  get goal() {
    return this.data.ratio * this.machine.m;
  }

  /** Begin the story. If Streamlit has not drawn the slider yet, wait for it: an early press counts, too. */
  begin() {
    const { data: { slider, scenes }, machine, reducedMotion } = this, input = sliders.find(slider);
    this.isWaiting = !machine || !input || input.disabled;
    if (this.isWaiting) return void requestAnimationFrame(() => this.isWaiting && !this.signal.aborted && this.begin());
    this.stills.hidden = !reducedMotion.matches;
    if (reducedMotion.matches) return this.complete();
    sliders.move(slider, scenes[0].ratios[0] * machine.m);
    this.lastPeriods = 0;
    this.setScenes(scenes);
  }

  /** End the story at the slider's present value. */
  stop() {
    const { slider } = this.data;
    this.setScenes(null);
    sliders.send(slider, sliders.value(slider));
  }

  /** End the story at the goal. */
  complete() {
    hasReachedGoal = isCompleted = true;
    this.setScenes(null);
    this.show(this.data.words.in_step);
    bus.publish(`enter/${this.data.slider}`, String(this.goal));
  }

  setScenes(scenes) {
    const { stage, slider, screen_period: screenPeriod, words } = this.data;
    this.scenes = scenes;
    bus.publish(`story/${stage}`, scenes && screenPeriod);
    this.button.textContent = scenes ? words.stop : this.startLabel();
  }

  /** Show the story at its progress in periods of the plain mass. */
  goTo(now) {
    // The ratio applies to the next frame, so take that at the middle of this frame.
    const frame = Math.max(0, now - this.lastPeriods);
    const periods = now + frame / 2;
    this.lastPeriods = now;
    let start = 0;
    for (const scene of this.scenes) {
      if (periods >= start + scene.periods) {
        start += scene.periods;
        continue;
      }
      const share = (periods - start) / scene.periods;
      sliders.move(this.data.slider, between(scene.ratios, share) * this.machine.m);
      this.show(scene.sentence);
      return;
    }
    this.complete();
  }

  /** Follow the drawn machine while no story runs. */
  follow({ ratio, parameters }) {
    this.machine = parameters;
    if (this.scenes) return;
    const { words, slider } = this.data, isInStep = Math.abs(ratio / this.data.ratio - 1) < SAME;
    if (isInStep && !hasReachedGoal) bus.publish("announce", { sentence: words.in_step, urgent: false });
    hasReachedGoal ||= isInStep;
    this.output.textContent = isInStep ? words.in_step : fill(words.ratio, { ratio: fixed(ratio, 4) });
    this.output.classList.toggle("in-step", isInStep);
    this.button.textContent = this.startLabel();
    this.mark();
  }

  /**
   * Mark the goal on the slider if it has been reached. Without a slider, which Streamlit may draw later, try again.
   */
  mark() {
    const { slider, words } = this.data;
    if (!hasReachedGoal || sliders.mark(slider, this.goal, words.mark) || this.signal.aborted) return;
    requestAnimationFrame(() => this.mark());
  }

  show(sentence) {
    if (this.output.textContent === sentence) return;
    this.output.textContent = sentence;
    bus.publish("announce", { sentence, urgent: false });
  }

  startLabel() {
    return isCompleted ? this.data.words.again : this.data.words.begin;
  }
}

/** A clock with both hands, as HTML. */
const clockFace = ({ label, turns }) => `<li>
  <svg viewBox="-56 -56 112 112" aria-hidden="true"><circle r="52" /><line y2="-38" class="plain" />
  <line y2="-48" transform="rotate(${360 * turns})" /></svg>${label}</li>`;
