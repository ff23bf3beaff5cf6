// The stage: joins clock, playback, picture, hand and words. All physics is in formulas.js, which SymPy prints; texts.js holds
// the words. __init__.py states the contract with Python.

import { bus } from "../components/bus.js";
import { observe } from "../components/lasting.js";
import { EYE, joinClock, wake } from "./clock.js";
import { FORMULAS } from "./formulas.js";
import { TURN, exposures, solve } from "./motion.js";
import { makeKeeper } from "./keeper.js";
import { makeParts } from "./parts.js";
import { makePicture } from "./picture.js";
import { Playback } from "./playback.js";
import { Slab } from "./slab.js";
import { linkTerms } from "./terms.js";
import { WORDS } from "./texts.js";
import { Hand } from "./thumb.js";
import { listenToControls, showControls } from "./toolbar.js";
import { description, makeVoice, moment } from "./words.js";

const STEPS = 24; // steps of the step buttons in one period
const TEXT_INTERVAL = 0.12; // s between two updates of running numbers; faster ones cannot be read
const SHAPES = ["radius", "beta_hoop", "beta_cylinder", "beta_top"];

export default (component, signal) => void new Stage(component, component.data, signal);

const arrived = new WeakMap(); // what the desk of a class shows → when this page heard of it [ms]

class Stage {
  constructor(component, options, signal) {
    const root = component.parentElement;
    const { stage, watch, clock, layers, compact, limits, periods } = options;
    Object.assign(this, { root, name: stage, clockName: clock, limits: limits.compression, compact, periods });
    this.layers = new Set(layers);
    this.host = root.querySelector(".stage");
    this.scrubber = root.querySelector(".scrub input");
    this.playback = new Playback();
    this.picture = makePicture(root, options, signal);
    this.parts = makeParts(root);
    this.voice = makeVoice(root, { compact, parts: this.parts, signal });
    this.slab = new Slab(root.querySelector(".body.slab"), this, signal);
    if (layers.includes("coordinates")) linkTerms(root, signal);
    this.hand = new Hand(watch, () => this.data.parameters);
    listenToControls(root, this, signal);
    this.calm = matchMedia("(prefers-reduced-motion: reduce)");
    this.calm.addEventListener("change", () => this.calmed(), { signal });
    this.clock = joinClock(clock, this, !this.calm.matches, signal);
    // A slider may move, and may be drawn after the stage.
    observe(document.body, { childList: true, subtree: true, attributeFilter: ["value"] }, wake, signal);
    this.keeper = makeKeeper(this, options, (seen) => component.data.tells && component.setTriggerValue("seen", seen), signal);
    signal.addEventListener("abort", () => {
      bus.forget(`seek/${stage}`);
      bus.forget(`time/${stage}`, this);
      bus.forget(`drawn/${stage}`, this);
    });
    bus.subscribe(`seek/${stage}`, (asked) => this.seek(asked), { signal });
    bus.subscribe(`story/${stage}`, (pace) => this.tell(pace), { signal });
    bus.subscribe(`machine/${stage}`, (payload) => this.receive(payload), { signal });
    bus.subscribe(`seen/${clock}`, (seen) => this.follow(seen), { signal });
  }

  // ---- what comes from Python, and what changes

  receive(data) {
    const before = this.data;
    if (!before) Object.assign(this.clock, this.keeper.clock());
    this.hide(data.hide ?? []);
    this.change(() => (this.data = data));
    const { computed } = data;
    if (before && computed && computed.run !== before.computed?.run) this.race(this.calm.matches ? null : computed.pace);
    if (data.slipping && data.slipping !== before?.slipping) this.voice.tell(WORDS.slips[data.slipping]);
    if (!this.parts.hides("motion")) this.keeper.tell();
    if (before) return;
    this.layers = new Set(this.keeper.layers() ?? this.layers);
    this.picture.show(this.layers);
    this.resume(this.keeper.paused());
    this.calmed();
    this.follow(bus.last(`seen/${this.clockName}`), true);
    this.draw(0); // at once: the machine is seen a frame earlier
  }

  /**
   * Show what is seen at the desk of a class: layers and view, and where the machine stands there or since when it runs. A stage
   * that was told so by its own desk shows that already, unless it has just begun.
   */
  follow(seen, begins = false) {
    if (seen && !arrived.has(seen)) arrived.set(seen, performance.now());
    const at = 2 * [...this.clock.stages].indexOf(this), turns = seen?.turns.split(",").slice(at, at + 2).map(Number) ?? [];
    if (!this.solution || turns.length < 2 || (seen.own && !begins)) return;
    const { Omega, plain } = this.solution, { layers, from, speed, pace, ago } = seen;
    const passed = pace * (ago + (performance.now() - arrived.get(seen)) / 1000);
    Object.assign(this.clock, { speed, seenFrom: from });
    this.picture.show((this.layers = new Set(layers.split(","))));
    this.change(() => this.resume([turns[0] * TURN + Omega * passed, turns[1] * TURN + plain * passed]));
    this.clock.playing = pace > 0 && !this.calm.matches;
    this.showClock();
  }

  /** Stand where a link has been paused. */
  resume(phases) {
    if (!phases) return;
    this.clock.playing = false;
    this.playback.goTo(phases[0]);
    this.playback.meet(phases[1]);
  }

  hide(names) {
    const stood = this.parts.hides("motion");
    this.parts.hide(names);
    this.host.classList.add("told");
    // Controls that were hidden have not heard of what was set since.
    this.showClock();
    if (stood && !this.parts.hides("motion")) this.playback.reset();
  }

  /** Make a change that may move the bodies, and let the picture flow from where it was drawn to where it is now. */
  change(make) {
    const before = this.solution && this.playback.drawn();
    make();
    const { initial, samples, computed } = this.data, set = this.hand.values(), parameters = { ...this.data.parameters, ...set };
    const solution = solve(parameters, initial), shapes = SHAPES.map((name) => parameters[name]).join();
    if (shapes !== this.shapes) this.picture.geometry(parameters);
    Object.assign(this, { parameters, solution, shapes });
    const leaves = (state) => this.picture.leaves({ ...parameters, ...state });
    this.playback.take({ parameters, solution, samples, computed, leaves, seenFrom: this.clock.seenFrom });
    if (before && !this.calm.matches) this.playback.flowFrom(before);
    this.picture.machine(this);
    const normalized = this.parts.hides("numbers") ? undefined : solution.normalized;
    bus.publish(`drawn/${this.name}`, { ratio: FORMULAS.mass_ratio(parameters), normalized, parameters }, this);
    this.slab.show();
    if (!Object.keys(set).length || this.hand.isHolding) this.voice.describe(description(solution));
    this.showSlowing();
    this.redraw();
  }

  period() {
    return this.solution ? TURN / this.solution.Omega : Infinity;
  }

  // ---- time

  /** Go on by so many seconds; return whether there is more to come. */
  advance(elapsed) {
    if (!this.solution) return false;
    if (this.hand.look()) this.change(() => {});
    const stands = this.hand.isHolding || this.parts.hides("motion");
    const running = this.clock.playing && !stands;
    if (running) this.run(elapsed * this.pace());
    const fading = this.playback.fade(elapsed);
    if (running || fading || this.dirty) this.draw(elapsed);
    return running || fading || this.hand.held !== null;
  }

  /** How many seconds of the machine pass in one of the beholder's. */
  pace() {
    return this.lapse ? TURN / this.solution.plain / this.lapse : this.clock.speed * this.clock.slowing;
  }

  /** Tell a story, in which a period of the plain mass lasts so many seconds; null ends it. */
  tell(lapse) {
    this.lapse = lapse;
    this.root.host?.toggleAttribute("data-told", Boolean(lapse));
    this.playback.keeps = Boolean(lapse);
    if (lapse) {
      this.playback.reset();
      this.setClock({ playing: true });
    } else this.showSlowing();
  }

  /** Show a computed machine against the exact one, a period in so many seconds; null shows the end. */
  race(pace) {
    this.tell(pace);
    if (pace) return;
    this.still = false;
    this.stay((playback) => playback.goTo(playback.end));
  }

  /** Have the picture drawn with the next frame. */
  redraw() {
    this.dirty = true;
    wake();
  }

  run(seconds) {
    const left = this.playback.advance(seconds, this.periods);
    if (!left) return;
    if (left === "ended" && this.lapse) return this.race(null);
    this.releaseAll();
    if (left === "again") return;
    this.voice.note(WORDS[left]);
    this.voice.tell(WORDS[left], true);
  }

  release() {
    this.change(() => this.playback.reset());
    this.keeper.tell();
  }

  /** What runs on one clock begins again together, or the comparison would be lost. */
  releaseAll() {
    for (const stage of this.clock.stages) if (stage.solution) stage.release();
  }

  play(playing = !this.clock.playing) {
    this.setClock({ playing });
    this.voice.tell(playing ? WORDS.playing : WORDS.paused);
  }

  /** Go somewhere and stay there, with every stage on the clock. */
  stay(go) {
    this.clock.playing = false;
    this.keeper.set();
    for (const stage of this.clock.stages) {
      if (!stage.solution || stage.parts.hides("motion")) continue;
      const left = go(stage.playback);
      if (left) stage.voice.note(WORDS[`${left}_ahead`]);
      stage.showClock();
    }
  }

  step(by) {
    this.stay((playback) => playback.goTo(TURN * ((Math.round((playback.phase / TURN) * STEPS) + by) / STEPS)));
    this.voice.tell(moment(this.playback.phase, this.playback.time, this.parts));
  }

  scrub(share) {
    this.stay((playback) => playback.goTo(TURN * (Math.floor(playback.phase / TURN) + Math.min(share, 0.9999))));
  }

  seek({ time }) {
    if (this.solution && !this.hand.isHolding) this.stay((playback) => playback.goToTime(time));
  }

  /** Set the clock, { playing, speed, seenFrom }, for every stage on it. */
  setClock(clock) {
    Object.assign(this.clock, clock);
    this.keeper.set();
    if (clock.seenFrom) this.voice.tell(clock.seenFrom === "block" ? WORDS.from_block : WORDS.from_ground);
    for (const stage of this.clock.stages) {
      if (clock.seenFrom && stage.solution) stage.change(() => {});
      stage.showClock();
    }
  }

  layer(name) {
    if (!this.layers.delete(name)) this.layers.add(name);
    this.picture.show(this.layers);
    this.keeper.set();
    this.showClock();
  }

  // ---- what is shown

  draw(elapsed) {
    const { playback, dirty } = this;
    this.dirty = false; // whoever hears of this frame may ask for another
    this.sinceText = (this.sinceText ?? 0) + elapsed;
    const write = this.sinceText >= TEXT_INTERVAL || dirty;
    if (write) this.sinceText = 0;
    const { shift, ...state } = playback.drawn();
    const known = { ...this.parameters, ...state, Omega: this.solution.Omega };
    const { phase, time, periods } = playback;
    this.picture.frame({ known, playback, shift, write });
    if (dirty && this.still && !this.parts.hides("motion")) this.picture.ghosts(exposures(this.parameters, this.solution));
    this.scrubber.value = (((phase / TURN) % 1) + 1) % 1;
    if (write) this.scrubber.setAttribute("aria-valuetext", moment(phase, time, this.parts));
    bus.publish(`time/${this.name}`, { time, phase, periods, playing: this.clock.playing }, this);
    if (dirty && !this.clock.playing) this.keeper.update();
  }

  /** Follow the wish for less motion: stand still then, and go on as before when it ends. */
  calmed() {
    const wasStill = this.still;
    this.still = this.calm.matches;
    this.clock.playing = !this.still && (wasStill || this.clock.playing);
    for (const stage of this.clock.stages) stage.showClock();
    if (this.still && this.lapse && this.data.computed) this.race(null);
  }

  showClock() {
    if (this.clock.playing) this.still = false;
    if (!this.still) this.picture.ghosts([]);
    showControls(this.root, this.clock, this.layers);
    this.showSlowing();
    this.redraw();
  }

  showSlowing() {
    this.voice.paced(this.lapse ? this.pace() : Math.min(1, this.period() / EYE) * this.clock.speed, this.clock.speed);
  }
}
