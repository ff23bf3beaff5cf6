// The machine on the page, put together: clock, motion, picture, slab, sliders and words. Before this text stand FORMULAS
// (all physics, printed by SymPy), WORDS and the other modules. The contract with Python is in __init__.py.

const STEPS = 24; // steps of the step buttons in one period
const SMOOTHING = 0.07; // s, the time in which a change of parameters fades into the picture
const TEXT_INTERVAL = 0.12; // s between two updates of running numbers; faster ones cannot be read
const NO_OFFSET = { X: 0, phi: 0, Phi: 0, plain: 0, shift: 0 };
const SHAPES = ["radius", "beta_hoop", "beta_cylinder", "beta_top"];

export default function ({ data, parentElement, setTriggerValue }) {
  const { begun, end } = live(parentElement, (signal) => new Stage(parentElement, data, signal));
  begun.sendReleased = (compression) => setTriggerValue("released", compression);
  return end;
}

class Stage {
  constructor(root, options, signal) {
    const { stage, watch, clock, layers, compact } = options;
    Object.assign(this, { name: stage, limits: options.limits, compact, signal });
    this.calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.layers = new Set(layers);
    this.find = (selector) => root.querySelector(selector);
    this.all = (selector) => [...root.querySelectorAll(selector)];
    this.host = this.find(".stage");
    this.phase = this.plainPhase = this.time = 0;
    this.live = {}; // parameter → value, while a slider is being moved or the slab has been let go
    this.offset = NO_OFFSET; // what is left of the last jump
    this.sinceText = TEXT_INTERVAL;
    this.picture = makePicture(root, options);
    this.voice = makeVoice(root, signal);
    this.sliders = watchSliders(watch, signal);
    this.listen();
    this.clock = joinClock(clock, this, !this.calm, signal);
    signal.addEventListener("abort", () => this.dispose());
    bus.subscribe(`machine/${stage}`, (payload) => this.receive(payload), { signal });
  }

  dispose() {
    this.picture.dispose();
    clearTimeout(this.sending);
    for (const topic of ["time", "present"]) bus.forget(`${topic}/${this.name}`);
  }

  // ---- what comes from Python

  receive(data) {
    const first = !this.data;
    this.change(() => {
      this.data = data;
      this.live = {};
    });
    this.sliders.answered();
    if (!first) return;
    if (this.calm) this.showGhosts();
    this.showLayers();
    this.showClock();
  }

  /** Make a change that may move the bodies, and let the picture flow from where it was drawn to where it is now. */
  change(make) {
    const before = this.solution && this.drawn();
    const ratio = this.solution && this.solution.Omega / this.solution.plain;
    make();
    this.parameters = { ...this.data.parameters, ...this.live };
    this.solution = solve(this.parameters, this.data.initial);
    // The clocks compare frequencies: they start together whenever these change.
    if (ratio !== this.solution.Omega / this.solution.plain) this.plainPhase = this.phase;
    const shapes = SHAPES.map((name) => this.parameters[name]).join();
    if (shapes !== this.shapes) this.picture.geometry(this.parameters);
    this.shapes = shapes;
    if (before && !this.calm) {
      const now = this.coordinates();
      this.offset = mapValues(NO_OFFSET, (_, name) => before[name] - now[name]);
    }
    this.picture.machine(this);
    const { mass_ratio } = FORMULAS;
    bus.publish(`present/${this.name}`, {
      ratio: mass_ratio(this.parameters),
      normalized: this.solution.normalized,
      parameters: this.parameters,
    });
    if (!this.compact) this.showCompression();
    this.voice.speak(() => description(this.solution, this.clock.playing));
    this.showSlowing();
    this.dirty = true;
  }

  period() {
    return this.solution ? TURN / this.solution.Omega : Infinity;
  }

  // ---- time

  advance(elapsed) {
    if (!this.solution) return;
    for (const [parameter, value] of this.sliders.read())
      if (value !== this.parameters[parameter]) this.change(() => (this.live[parameter] = value));
    const running = this.clock.playing && !this.held;
    if (running) this.moveTime(elapsed * this.clock.speed * this.clock.slowing);
    const fading = Object.values(this.offset).some((rest) => Math.abs(rest) > 1e-6);
    if (fading) this.offset = mapValues(this.offset, (rest) => rest * Math.exp(-elapsed / SMOOTHING));
    if (running || fading || this.dirty) this.draw(elapsed);
  }

  moveTime(seconds) {
    this.time += seconds;
    this.phase += this.solution.Omega * seconds;
    this.plainPhase += this.solution.plain * seconds;
    const left = this.left();
    if (!left) return;
    // What runs on one clock begins again together, or the comparison would be lost.
    for (const stage of this.clock.stages) if (stage.solution) stage.release();
    this.voice.note(WORDS[left]);
  }

  /** Go to a phase of the machine; the plain mass keeps its own time. */
  moveTo(phase) {
    this.moveTime((phase - this.phase) / this.solution.Omega);
    this.dirty = true;
  }

  release() {
    this.change(() => (this.phase = this.plainPhase = this.time = 0));
  }

  left() {
    const { samples } = this.data;
    const left = leftPlace({ ...this.parameters, ...this.coordinates() }, this.picture.place);
    return left ?? (samples && this.time > samples.step * (samples.phi.length - 1) ? "ended" : null);
  }

  play(playing) {
    this.clock.playing = playing;
    for (const stage of this.clock.stages) stage.showClock();
  }

  step(direction) {
    this.play(false);
    this.moveTo(TURN * ((Math.round((this.phase / TURN) * STEPS) + direction) / STEPS));
  }

  // ---- listening

  listen() {
    const on = (target, type, handler) => target.addEventListener(type, handler, { signal: this.signal });
    const actions = {
      restart: () => this.release(),
      play: () => this.play(!this.clock.playing),
      back: () => this.step(-1),
      forward: () => this.step(1),
    };
    for (const button of this.all("[data-do]")) on(button, "click", actions[button.dataset.do]);
    for (const button of this.all("[data-speed]"))
      on(button, "click", () => {
        this.clock.speed = Number(button.dataset.speed);
        this.showClock();
      });
    for (const button of this.all("[data-layer]"))
      on(button, "click", () => {
        const { layer } = button.dataset;
        if (!this.layers.delete(layer)) this.layers.add(layer);
        this.showLayers();
      });
    const scrub = this.find(".scrub input");
    on(scrub, "input", () => {
      this.play(false);
      this.moveTo(TURN * (Math.floor(this.phase / TURN) + Math.min(Number(scrub.value), 0.9999)));
    });
    on(this.host, "keydown", (event) => {
      const inControl = event.target.matches("input, button, [role=slider]");
      const action = { " ": "play", ArrowLeft: "back", ArrowRight: "forward", Home: "restart" }[event.key];
      if (!action || inControl) return;
      event.preventDefault();
      actions[action]();
    });
    const slab = this.find(".body.slab");
    if (!this.compact) listenToSlab(slab, this.picture, this, this.signal);
    else for (const name of ["tabindex", "role", "aria-label"]) slab.removeAttribute(name);
  }

  // ---- the slab in a hand

  deformation() {
    return FORMULAS.deformation({ ...this.parameters, ...this.coordinates() });
  }

  take(held) {
    this.held = held;
    this.host.classList.toggle("held", held);
  }

  /** Hold the machine at rest with the spring compressed by so much, rounded to a tenth of a millimetre. */
  compress(compression) {
    const [least, most] = this.limits.compression;
    this.live.compression = Math.round(clamp(compression, least, most) * 1e4) / 1e4;
    this.release();
    this.voice.note(`x₀ = ${digits(this.live.compression * CM, 3)} cm`);
  }

  letGo(delay) {
    clearTimeout(this.sending);
    const { compression } = this.live;
    this.sending = setTimeout(() => this.sendReleased(compression), delay);
  }

  // ---- drawing

  /** Coordinates and rates now, with the plain mass's displacement and the way of the view over the floor [m]. */
  coordinates() {
    const { samples } = this.data;
    const state = samples ? sampleAt(samples, this.time) : stateAt(this.solution, this.phase, this.time);
    const plain = this.parameters.compression * Math.cos(this.plainPhase);
    return { ...state, plain, shift: this.solution.drift * this.time };
  }

  drawn() {
    const state = this.coordinates();
    for (const [name, rest] of Object.entries(this.offset)) state[name] += rest;
    return state;
  }

  draw(elapsed) {
    this.sinceText += elapsed;
    const write = this.sinceText >= TEXT_INTERVAL || this.dirty;
    if (write) this.sinceText = 0;
    const { shift, ...state } = this.drawn();
    const known = { ...this.parameters, ...state, Omega: this.solution.Omega };
    this.picture.frame({ known, phase: this.phase, plainPhase: this.plainPhase, shift, write, dirty: this.dirty });
    this.find(".scrub input").value = (((this.phase / TURN) % 1) + 1) % 1;
    bus.publish(`time/${this.name}`, { time: this.time, phase: this.phase, playing: this.clock.playing });
    this.dirty = false;
  }

  /** The still of someone who asked for less motion: half a period in five exposures. */
  showGhosts() {
    const exposures = [0, 1, 2, 3, 4].map((i) => stateAt(this.solution, (Math.PI * i) / 4, 0));
    this.picture.ghosts(exposures.map((state) => ({ ...this.parameters, ...state })));
  }

  showCompression() {
    const { compression } = this.parameters;
    const [least, most] = this.limits.compression;
    set(this.find(".body.slab"), {
      "aria-valuemin": least * CM,
      "aria-valuemax": most * CM,
      "aria-valuenow": compression * CM,
      "aria-valuetext": `${digits(compression * CM, 3)} cm`,
    });
  }

  showClock() {
    if (this.clock.playing) this.picture.ghosts(null);
    const play = this.find("[data-do=play]");
    this.host.classList.toggle("playing", this.clock.playing);
    play.setAttribute("aria-label", this.clock.playing ? "Pause" : "Play");
    for (const button of this.all("[data-speed]"))
      button.setAttribute("aria-checked", String(Number(button.dataset.speed) === this.clock.speed));
    this.showSlowing();
  }

  showSlowing() {
    this.voice.slowed(Math.min(1, this.period() / EYE), this.clock.speed);
  }

  showLayers() {
    for (const button of this.all("[data-layer]")) button.setAttribute("aria-pressed", String(this.layers.has(button.dataset.layer)));
    this.picture.show(this.layers);
    this.dirty = true;
  }
}
