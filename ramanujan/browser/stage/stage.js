// The stage connects clock, playback, picture, live values and voice. The physics is in formulas.js, printed by SymPy;
// the texts are in texts.js. __init__.py documents the data from Python.

import { bus } from "../bus.js";
import { observe } from "../lasting.js";
import { VISIBLE_PERIOD, joinClock, wake } from "./clock.js";
import { followStage } from "./follow.js";
import { FORMULAS } from "./formulas.js";
import { TURN, exposures, solve } from "./motion.js";
import { listLayers, makeKeeper } from "./keeper.js";
import { makeListener } from "./listen.js";
import { makeParts } from "./parts.js";
import { makePicture } from "./picture.js";
import { Playback } from "./playback.js";
import { Slab } from "./slab.js";
import { linkTerms } from "./terms.js";
import { WORDS } from "./texts.js";
import { LiveValues } from "./live_values.js";
import { listenToControls, showControls } from "./toolbar.js";
import { description, makeVoice, moment, sameDriftSentence } from "./words.js";

const STEPS = 24; // presses of a step button for one period
const TEXT_INTERVAL = 0.12; // s between two updates of the running numbers, so that they can be read
const REMEMBERED = 100; // number of earlier machines with which a new one is compared
const SHAPES = ["radius", "beta_hoop", "beta_cylinder", "beta_top"];

export default (component, signal) => {
  if (component.data.follows) followStage(component, signal);
  else new Stage(component, component.data, signal);
};

const arrivals = new WeakMap(); // view of a class's desk → time of its arrival on this page [ms]

class Stage {
  data; // the last message of `publish` in __init__.py
  layers; // the layers shown
  chosenLayers = null; // the layers that a person or a class's desk has chosen, if any
  followedFrame = "ground"; // the frame of reference of the view that was shown last
  parameters; // of the drawn machine: those in the message, with the visitor's changes
  solution; // the motion of the drawn machine, from `solve`
  shapes; // the radius and the shapes in the drawn geometry
  screenPeriod = null; // s, the duration of a plain-mass period on the screen during a story or a race
  showsGhosts = false; // whether copies of the machine replace its motion, for a reader who prefers reduced motion
  playsAfterHold = false; // whether the machine was playing before the data paused it at its release
  needsDrawing = false; // whether the next frame draws the stage even if nothing moves
  drifts = new Map(); // Ω²m/k with nine digits → parameters of the last machine with this value
  sinceText = 0; // s since the running numbers were updated

  constructor(component, options, signal) {
    const root = component.parentElement;
    const { stage, watch, clock, layers, compact, dials, limits, periods, rest_after: restAfter } = options;
    Object.assign(this, { root, name: stage, clockName: clock, limits: limits.compression });
    Object.assign(this, { compact, dials, periods, restAngle: (restAfter ?? NaN) * TURN, firstLayers: layers });
    this.layers = new Set(layers);
    this.host = root.querySelector(".stage");
    this.scrubber = root.querySelector(".scrub input");
    this.playback = new Playback();
    this.picture = makePicture(root, options, signal);
    this.parts = makeParts(root);
    this.voice = makeVoice(root, { compact, parts: this.parts, signal });
    this.listener = makeListener(root, this, signal);
    this.slab = new Slab(root.querySelector(".body.slab"), this, signal);
    if (layers.includes("coordinates")) linkTerms(root, signal);
    this.live = new LiveValues(watch, () => this.data.parameters);
    listenToControls(root, this, signal);
    this.reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
    this.reducedMotion.addEventListener("change", () => this.applyMotionPreference(), { signal });
    this.clock = joinClock(clock, this, !this.reducedMotion.matches, signal);
    // A slider may move, and Streamlit may draw it after the stage.
    observe(document.body, { childList: true, subtree: true, attributeFilter: ["value"] }, wake, signal);
    const sendView = (view) => component.data.sends_view && component.setTriggerValue("view", view);
    this.keeper = makeKeeper(this, options, sendView, signal);
    signal.addEventListener("abort", () => {
      document.body.removeAttribute("data-in-step");
      document.body.removeAttribute("data-observing");
      bus.forget(`seek/${stage}`); // published by other components, without an owner
      bus.forget(`time/${stage}`, this);
      bus.forget(`drawn/${stage}`, this);
    });
    bus.subscribe(`seek/${stage}`, (request) => this.seek(request), { signal });
    bus.subscribe(`story/${stage}`, (screenPeriod) => this.setScreenPeriod(screenPeriod), { signal });
    bus.subscribe(`machine/${stage}`, (payload) => this.receive(payload), { signal });
    bus.subscribe(`view/${clock}`, (view) => this.follow(view), { signal });
    bus.subscribe("slide", () => this.data && this.showView(), { signal });
  }

  // ---- data from Python, and changes

  /**
   * Receive the data of `publish` in __init__.py. The first data also restore the view in the address and the desk's
   * view.
   */
  receive(data) {
    const before = this.data;
    this.hide(data.hide ?? []);
    this.change(() => {
      this.data = data;
      this.followFrame();
      if (!before) Object.assign(this.clock, this.keeper.clock());
      if (before && data.releases !== before.releases) this.reset();
    });
    const { computed } = data;
    const isNewRun = before && computed && computed.run !== before.computed?.run;
    if (isNewRun) this.race(this.reducedMotion.matches ? null : computed.screen_period);
    if (data.slipping && data.slipping !== before?.slipping) this.voice.announce(WORDS.slips[data.slipping]);
    if (!this.parts.hides("motion")) this.keeper.send();
    if (!before) this.chosenLayers = this.keeper.layers();
    this.showLayers();
    if (!before) {
      this.pauseAt(this.keeper.paused());
      this.applyMotionPreference();
      this.follow(bus.last(`view/${this.clockName}`), { begins: true });
    }
    if (data.held !== before?.held) this.hold(data.held);
    if (!before) this.draw(0); // now, so that the machine appears one frame earlier
  }

  /** Pause at the release, or play again if the machine was playing before this pause. */
  hold(isHeld) {
    if (!isHeld) {
      if (this.playsAfterHold) this.setPlaying(true);
      return;
    }
    this.playsAfterHold = this.clock.playing;
    if (!this.clock.playing) return;
    this.setPlaying(false);
    this.change(() => this.reset());
  }

  /**
   * Show the view of a class's desk: its layers, its reference frame and its hands. The hands are advanced by the time
   * since they were sent, at the desk's rates, because this stage may receive the desk's machine later. They rest where
   * the desk's hands rest. `begins`:
   * whether this stage has just received its first data. A desk also receives its own view (`own`), and applies it only
   * in this case.
   */
  follow(view, { begins = false } = {}) {
    if (view && !arrivals.has(view)) arrivals.set(view, performance.now());
    const start = 2 * [...this.clock.stages].indexOf(this); // two numbers for each stage on the clock
    const numbersOf = (text) => text.split(",").slice(start, start + 2).map(Number);
    const turns = view ? numbersOf(view.turns) : [];
    if (!this.solution || turns.length < 2 || (view.own && !begins)) return;
    const { layers, from, speed, ago } = view;
    const rates = numbersOf(view.rates);
    const elapsed = ago + (performance.now() - arrivals.get(view)) / 1000;
    const untilRest = (this.restAngle / TURN - turns[1]) / rates[1];
    const rests = untilRest > 0 && elapsed >= untilRest, passed = rests ? untilRest : elapsed;
    Object.assign(this.clock, { speed, seenFrom: from });
    this.chosenLayers = layers.split(",");
    this.showLayers();
    this.change(() => this.pauseAt(turns.map((turn, i) => (turn + rates[i] * passed) * TURN)));
    this.clock.playing = rates[0] > 0 && !rests && !this.reducedMotion.matches;
    if (rests) this.playback.plainPhase = this.restAngle;
    this.showClock();
  }

  /** Pause with the hands of the machine and the plain mass at these phases; without phases, do nothing. */
  pauseAt(phases) {
    if (!phases) return;
    this.clock.playing = false;
    this.playback.goTo(phases[0]);
    this.playback.plainPhase = phases[1];
  }

  hide(names) {
    const hidMotion = this.parts.hides("motion");
    this.parts.hide(names);
    if (this.parts.hides("motion")) this.listener.silence();
    this.host.classList.add("ready");
    // Controls that were hidden do not show later changes.
    this.showClock();
    if (hidMotion !== this.parts.hides("motion")) this.reset();
  }

  /**
   * Call a function that may move the bodies, and fade the picture to the new state. Without a function, show the
   * sliders' new values, or the new reference frame.
   */
  change(act = () => {}) {
    const before = this.solution && this.playback.drawn();
    act();
    const { initial, samples, computed } = this.data, changed = this.live.values();
    const parameters = { ...this.data.parameters, ...changed };
    const solution = solve(parameters, initial), shapes = SHAPES.map((name) => parameters[name]).join();
    if (shapes !== this.shapes) this.picture.geometry(parameters);
    Object.assign(this, { parameters, solution, shapes });
    const collision = (state) => this.picture.collision({ ...parameters, ...state });
    this.playback.setMachine({ parameters, solution, samples, computed, collision, seenFrom: this.clock.seenFrom });
    // The graphs show a motion since one release of both machines.
    if (this.periods) this.playback.plainPhase = solution.plain * this.playback.time;
    if (before && !this.reducedMotion.matches) this.playback.flowFrom(before);
    this.picture.machine(this);
    const normalized = this.parts.hides("numbers") ? undefined : solution.normalized;
    this.markLockedHands();
    bus.publish(`drawn/${this.name}`, { ratio: FORMULAS.mass_ratio(parameters), normalized, parameters }, this);
    this.listener.tune(solution);
    this.slab.show();
    // A slider's new value is described when the server has sent it. During a drag of the slab the server sends
    // nothing.
    const isFromServer = !Object.keys(changed).length;
    if (isFromServer || this.live.isDragging) this.voice.describe(description(solution));
    this.compareDrifts(isFromServer);
    this.showSlowing();
    this.redraw();
  }

  /** Mark the page while the hands are locked and no story runs. */
  markLockedHands() {
    if (!this.dials) return;
    const { step } = this.root.querySelector(".step").dataset;
    // On the body, because a rule with `:has` would restyle the page at each of its changes.
    document.body.toggleAttribute("data-in-step", step === "in-step" && !this.screenPeriod);
  }

  /**
   * Explain why the drift is that of an earlier machine, if this machine has another k, or other masses of the same
   * ratio. `isAtRest`: whether later machines are compared with this one.
   */
  compareDrifts(isAtRest) {
    if (!this.dials || this.parts.hides("clocks") || this.parts.hides("numbers")) return;
    const drift = this.solution.normalized.toPrecision(9), before = this.drifts.get(drift);
    const sentence = before && sameDriftSentence(before, this.parameters);
    if (sentence) this.picture.explainDrift(sentence);
    if (!isAtRest) return;
    this.drifts.delete(drift); // so that the oldest machine is the first
    this.drifts.set(drift, this.parameters);
    if (this.drifts.size > REMEMBERED) this.drifts.delete(this.drifts.keys().next().value);
  }

  period() {
    return this.solution ? TURN / this.solution.Omega : Infinity;
  }

  // ---- time

  /** Advance by a number of seconds. Return whether another frame is needed. */
  advance(elapsed) {
    if (!this.solution) return false;
    if (this.live.update()) this.change();
    const isStill = this.live.isDragging || this.parts.hides("motion");
    const running = this.clock.playing && !isStill;
    if (running) this.run(elapsed * this.pace());
    const fading = this.playback.fade(elapsed);
    if (running || fading || this.needsDrawing) this.draw(elapsed);
    return running || fading || this.live.isDragging;
  }

  /** The speed of the playback: seconds of the machine per second of the clock. */
  pace() {
    return this.screenPeriod ? TURN / this.solution.plain / this.screenPeriod : this.clock.speed * this.clock.slowing;
  }

  /**
   * Begin a story or a race, in which a period of the plain mass lasts `screenPeriod` seconds on the screen; null ends
   * it.
   */
  setScreenPeriod(screenPeriod) {
    this.screenPeriod = screenPeriod;
    this.root.host?.toggleAttribute("data-screen-period", Boolean(screenPeriod));
    this.markLockedHands();
    if (screenPeriod) {
      this.playback.reset();
      this.setClock({ playing: true });
    } else this.showSlowing();
  }

  /**
   * Compare a computed machine with the exact one, as in `setScreenPeriod`. With null, pause at the end of the computed
   * motion.
   */
  race(screenPeriod) {
    this.setScreenPeriod(screenPeriod);
    if (screenPeriod) return;
    this.showsGhosts = false;
    this.pauseAndMove((playback) => playback.goTo(playback.end));
  }

  /** Request a drawing in the next frame. */
  redraw() {
    this.needsDrawing = true;
    wake();
  }

  run(seconds) {
    const untilRest = (this.restAngle - this.playback.plainPhase) / this.solution.plain;
    const rests = untilRest > 0 && seconds >= untilRest;
    const reason = this.playback.advance(rests ? untilRest : seconds, this.periods);
    if (rests) return this.rest();
    if (!reason) return;
    if (reason === "ended" && this.screenPeriod) return this.race(null);
    this.releaseAll();
    if (reason === "repeat") return;
    this.voice.say(WORDS[reason], { once: true });
  }

  /** Pause all machines on the clock at the moment of a question, which shows its answer. A person may play on. */
  rest() {
    for (const { playback, restAngle } of this.clock.stages) {
      playback.goTo(this.playback.phase);
      playback.plainPhase = restAngle; // exact, so that the next start is not before this moment
    }
    this.setPlaying(false);
  }

  setPlaying(playing) {
    this.clock.playing = playing;
    for (const stage of this.clock.stages) stage.showClock();
    this.keeper.send();
  }

  /** Whether the machine runs towards the moment of a question. */
  isBeforeRest() {
    return this.clock.playing && !this.parts.hides("motion") && this.playback.plainPhase < this.restAngle;
  }

  /** Set both hands to the start. If they rest at the moment of a question, play again. */
  reset() {
    const rests = this.playback.plainPhase === this.restAngle;
    this.playback.reset();
    if (rests && !this.reducedMotion.matches) this.setPlaying(true);
  }

  release() {
    this.change(() => this.reset());
    this.keeper.send();
  }

  /** Release all stages on the clock together, so that they stay comparable. */
  releaseAll() {
    for (const stage of this.clock.stages) if (stage.solution) stage.release();
  }

  play(playing = !this.clock.playing) {
    this.setClock({ playing });
    this.voice.announce(playing ? WORDS.playing : WORDS.paused);
  }

  /**
   * Pause the clock, and move all of its stages. `move` is called with each playback. It returns the reason if the
   * motion ends before the requested time, or null.
   */
  pauseAndMove(move) {
    this.clock.playing = false;
    this.keeper.storeInAddress();
    for (const stage of this.clock.stages) {
      if (!stage.solution || stage.parts.hides("motion")) continue;
      const reason = move(stage.playback);
      if (reason) stage.voice.note(WORDS[`${reason}_ahead`]);
      stage.showClock();
    }
  }

  /** Pause, and go forward by a number of steps from the nearest step. */
  step(number) {
    this.pauseAndMove((playback) => {
      const nearest = Math.round((playback.phase / TURN) * STEPS);
      return playback.goTo((TURN * (nearest + number)) / STEPS);
    });
    this.voice.announce(moment(this.playback.phase, this.playback.time, this.parts));
  }

  /** Pause at a fraction of the present period. */
  scrub(fraction) {
    this.pauseAndMove((playback) => {
      const period = Math.floor(playback.phase / TURN);
      return playback.goTo(TURN * (period + Math.min(fraction, 0.9999))); // 1 would begin the next period
    });
  }

  seek({ time }) {
    if (this.solution && !this.live.isDragging) this.pauseAndMove((playback) => playback.goToTime(time));
  }

  /** Set values of the clock, { playing, speed, seenFrom }, and update all of its stages. */
  setClock(values) {
    Object.assign(this.clock, values);
    this.keeper.storeInAddress();
    if (values.seenFrom) this.voice.announce(values.seenFrom === "block" ? WORDS.from_block : WORDS.from_ground);
    for (const stage of this.clock.stages) {
      if (values.seenFrom && stage.solution) stage.change();
      stage.showClock();
    }
  }

  /** The view of the present slide, from the last message. */
  view() {
    return this.data?.views?.[bus.last("slide") ?? ""] ?? {};
  }

  /** Show the layers of a new slide, and see the machine from its frame of reference. */
  showView() {
    this.change(() => this.followFrame());
    this.showLayers();
  }

  /** The frame of reference of the present view. A person may choose the other one, until a view with another frame. */
  defaultFrame() {
    return this.view().from ?? "ground";
  }

  followFrame() {
    const frame = this.defaultFrame();
    if (frame === this.followedFrame) return;
    this.followedFrame = this.clock.seenFrom = frame;
  }

  /** The layers that are shown until a person chooses others. */
  defaultLayers() {
    return this.view().layers ?? this.firstLayers;
  }

  showLayers() {
    this.layers = new Set(this.chosenLayers ?? this.defaultLayers());
    this.picture.show(this.layers);
    this.showClock();
  }

  /** Show or hide a layer, as a person chose. The layers follow the view again when they are its own. */
  layer(name) {
    if (!this.layers.delete(name)) this.layers.add(name);
    this.chosenLayers = listLayers(this.layers) === listLayers(this.defaultLayers()) ? null : [...this.layers];
    this.showLayers();
    this.keeper.storeInAddress();
  }

  // ---- the display

  draw(elapsed) {
    const { playback, needsDrawing } = this;
    this.needsDrawing = false; // first, because a subscriber to this frame may request another one
    this.sinceText += elapsed;
    const writesText = this.sinceText >= TEXT_INTERVAL || needsDrawing;
    if (writesText) this.sinceText = 0;
    const { shift, ...state } = playback.drawn();
    const known = { ...this.parameters, ...state, Omega: this.solution.Omega };
    const { phase, plainPhase, time, periods } = playback;
    this.picture.frame({ known, playback, shift, writesText });
    if (needsDrawing && this.showsGhosts && !this.parts.hides("motion")) {
      this.picture.ghosts(exposures(this.parameters, this.solution));
    }
    // The page of a question hides its result meanwhile.
    if (this.restAngle) document.body.toggleAttribute("data-observing", this.isBeforeRest());
    this.scrubber.value = (((phase / TURN) % 1) + 1) % 1;
    if (writesText) this.scrubber.setAttribute("aria-valuetext", moment(phase, time, this.parts));
    bus.publish(`time/${this.name}`, { time, phase, plainPhase, periods, playing: this.clock.playing }, this);
    if (needsDrawing && !this.clock.playing) this.keeper.update();
  }

  /** Follow the browser's preference for reduced motion: stop while it is set, and continue afterwards. */
  applyMotionPreference() {
    const showedGhosts = this.showsGhosts;
    this.showsGhosts = this.reducedMotion.matches;
    this.clock.playing = !this.showsGhosts && (showedGhosts || this.clock.playing);
    for (const stage of this.clock.stages) stage.showClock();
    if (this.showsGhosts && this.screenPeriod && this.data.computed) this.race(null);
  }

  showClock() {
    if (this.clock.playing) this.showsGhosts = false;
    if (!this.showsGhosts) this.picture.ghosts([]);
    // Without motion, for example for a reader who prefers reduced motion, the tones may sound.
    const wasPlaying = this.host.classList.contains("playing");
    if (wasPlaying && !this.clock.playing) this.listener.silence();
    showControls(this.root, this.clock, this.layers);
    this.showSlowing();
    this.redraw();
  }

  showSlowing() {
    const ownPace = Math.min(1, this.period() / VISIBLE_PERIOD) * this.clock.speed;
    this.voice.showPace(this.screenPeriod ? this.pace() : ownPace, this.clock.speed);
  }
}
