// The machine on the page: plays it, draws its frames, and listens to the slab, the buttons and the sidebar's sliders.
// Before this text stand FORMULAS (all physics, printed by SymPy), WORDS, and picture.js. The contract with Python is in
// __init__.py: the numbers of each stage arrive in globalThis.ramanujanFeed.

const STEPS = 24; // steps of the step buttons in one period
const EYE = 0.7; // s, the shortest period that an eye can follow; what is faster is slowed
const SMOOTHING = 0.07; // s, the time in which a change of parameters fades into the picture
const TEXT_INTERVAL = 0.12; // s between two updates of running numbers; faster ones cannot be read

const mounted = new Map(); // parentElement → Stage
const clocks = new Map(); // name → {playing, speed}: stages with one clock run together
let frame = 0;

export default function ({ data, parentElement, setTriggerValue }) {
  if (!mounted.has(parentElement)) mounted.set(parentElement, new Stage(parentElement, data));
  mounted.get(parentElement).sendReleased = (compression) => setTriggerValue("released", compression);
  frame ||= requestAnimationFrame(tick);
  return () => {
    mounted.get(parentElement)?.dispose();
    mounted.delete(parentElement);
  };
}

let lastTick = 0;
function tick(now) {
  frame = mounted.size ? requestAnimationFrame(tick) : 0; // first of all: one bad frame must not be the last
  const elapsed = Math.min((now - lastTick) / 1000, 0.1); // a hidden tab does not catch up
  lastTick = now;
  const stages = [...mounted.values()];
  for (const stage of stages) {
    const data = globalThis.ramanujanFeed?.[stage.name];
    if (data && data !== stage.data) stage.receive(data);
  }
  for (const clock of clocks.values()) {
    const periods = stages.filter((stage) => stage.clock === clock).map((stage) => stage.period());
    clock.slowing = Math.min(1, ...periods.map((period) => period / EYE));
  }
  for (const stage of stages) stage.advance(elapsed);
}

// ---------------------------------------------------------------- the model, evaluated

/** The motion of a machine as numbers: Ω, and a + b·t + c·cos Ωt + d·sin Ωt for each coordinate. */
function solve(parameters, initial) {
  const Omega = FORMULAS.natural_frequency(parameters);
  const start = initial ?? { X: 0, phi: FORMULAS.released_angle(parameters), Phi: 0, X_dot: 0, phi_dot: 0, Phi_dot: 0 };
  const known = { ...parameters, ...start, Omega };
  return {
    Omega,
    plain: FORMULAS.plain_frequency(parameters),
    normalized: FORMULAS.normalized_frequency_squared(parameters),
    motion: mapValues(FORMULAS.motion, (parts) => mapValues(parts, (part) => part(known))),
  };
}

/** Coordinates and rates at a phase Ωt of the oscillation and a time t of the drift. */
function stateAt({ Omega, motion }, phase, time) {
  const [cosine, sine] = [Math.cos(phase), Math.sin(phase)];
  const state = {};
  for (const [name, { a, b, c, d }] of Object.entries(motion)) {
    state[name] = a + b * time + c * cosine + d * sine;
    state[`${name}_dot`] = b + Omega * (d * cosine - c * sine);
  }
  return state;
}

/** The same from samples at equal steps, straight between two of them: an integrator's idea of the motion. */
function sampleAt(samples, time) {
  const last = samples.phi.length - 2;
  const i = clamp(Math.floor(time / samples.step), 0, last);
  const part = clamp(time / samples.step - i, 0, 1);
  const state = {};
  for (const name of ["X", "phi", "Phi"]) {
    const [from, to] = [samples[name][i], samples[name][i + 1]];
    state[name] = from + part * (to - from);
    state[`${name}_dot`] = (to - from) / samples.step;
  }
  return state;
}

const digits = (value, precision) => Number(value).toPrecision(precision);
const fill = (sentence, values) => sentence.replace(/\{(\w+)\}/g, (_, name) => values[name]);

// ---------------------------------------------------------------- one stage

class Stage {
  constructor(root, { stage, limits, watch, clock, layers, compact, dials, label }) {
    this.name = stage;
    this.limits = limits;
    this.watch = watch;
    this.compact = compact;
    this.calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!clocks.has(clock)) clocks.set(clock, { playing: !this.calm, speed: 1, slowing: 1 });
    this.clock = clocks.get(clock);
    this.layers = mapValues({ energy: 0, arrows: 0, traces: 0, forces: 0 }, () => false);
    for (const name of layers) this.layers[name] = true;

    this.find = (selector) => root.querySelector(selector);
    this.all = (selector) => [...root.querySelectorAll(selector)];
    this.host = this.find(".stage");
    this.phase = this.plainPhase = this.time = this.shift = 0;
    this.live = {}; // parameter → value, while a slider is being moved or the slab has been let go
    this.moving = new Map(); // key of a slider being moved → its value when that began
    this.pressed = false;
    this.offset = { X: 0, phi: 0, Phi: 0, plain: 0 }; // what is left of the last jump
    this.sinceText = TEXT_INTERVAL;
    this.stop = new AbortController();
    this.host.classList.toggle("compact", compact);
    this.host.classList.toggle("no-dials", !dials);
    this.buildOnce(label);
    this.listen();
    this.sizes = new ResizeObserver(() => this.fitText());
    this.sizes.observe(this.find(".machine"));
  }

  dispose() {
    this.stop.abort();
    this.sizes.disconnect();
    for (const timer of [this.speaking, this.sending, this.noting]) clearTimeout(timer);
  }

  // ---- what comes from Python

  receive(data) {
    const first = !this.data;
    this.change(() => {
      this.data = data;
      this.live = {};
    });
    // Whatever the server now shows is the new rest position of a slider that is still held.
    for (const key of this.moving.keys()) {
      if (this.pressed) this.moving.set(key, this.slider(key)?.value);
      else this.moving.delete(key);
    }
    if (!first) return;
    if (this.calm) this.drawGhosts();
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
    const { radius, beta_hoop, beta_cylinder, beta_top } = this.parameters;
    const geometry = [radius, beta_hoop, beta_cylinder, beta_top].join();
    if (geometry !== this.geometry) this.drawGeometry();
    this.geometry = geometry;
    if (before && !this.calm) {
      const now = this.coordinates();
      for (const name of Object.keys(this.offset)) this.offset[name] = before[name] - now[name];
    }
    this.drawParameters();
    this.dirty = true;
  }

  period() {
    return this.solution ? TURN / this.solution.Omega : Infinity;
  }

  // ---- time

  advance(elapsed) {
    if (!this.solution) return;
    this.readSliders();
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
    const left = this.leftPlace();
    if (!left) return;
    // What runs on one clock begins again together, or the comparison would be lost.
    for (const stage of mounted.values()) if (stage.clock === this.clock && stage.solution) stage.release();
    this.tell(WORDS[left]);
  }

  /** Go to a phase of the machine; the plain mass keeps its own time. */
  moveTo(phase) {
    this.moveTime((phase - this.phase) / this.solution.Omega);
    this.dirty = true;
  }

  release() {
    this.change(() => (this.phase = this.plainPhase = this.time = 0));
  }

  /** Tell what has left its place, if anything has: a machine that was pushed, or an integrator gone wrong. */
  leftPlace() {
    const g = this.place, known = { ...this.parameters, ...this.coordinates() };
    const over = (FORMULAS.displacement.top(known) - FORMULAS.displacement.block(known)) * CM + g.centre.top[0];
    if (over < g.riser || over > g.right) return "edge";
    if (Math.abs(FORMULAS.deformation(known)) * CM > g.travel + 8) return "struck";
    const { samples } = this.data;
    return samples && this.time > samples.step * (samples.phi.length - 1) ? "ended" : null;
  }

  play(playing) {
    this.clock.playing = playing;
    for (const stage of mounted.values()) if (stage.clock === this.clock) stage.showClock();
  }

  step(direction) {
    this.play(false);
    this.moveTo(TURN * ((Math.round((this.phase / TURN) * STEPS) + direction) / STEPS));
  }

  // ---- the sliders of the sidebar, read in the frame in which they move

  slider(key) {
    return document.querySelector(`.st-key-${CSS.escape(key)} input[type="range"]`);
  }

  readSliders() {
    for (const [key, atRest] of this.moving) {
      const value = this.slider(key)?.value;
      if (value === undefined || value === atRest) continue;
      const { parameter, scale } = this.watch[key];
      const moved = Number(value) * scale;
      if (moved !== this.parameters[parameter]) this.change(() => (this.live[parameter] = moved));
    }
  }

  // ---- listening

  listen() {
    const on = (target, type, handler, options = {}) =>
      target.addEventListener(type, handler, { ...options, signal: this.stop.signal });
    const begin = (event) => {
      const key = Object.keys(this.watch).find((name) => event.target.closest?.(`.st-key-${CSS.escape(name)}`));
      const value = key && this.slider(key)?.value;
      if (value !== undefined) this.moving.set(key, value);
      this.pressed = event.type === "pointerdown";
    };
    on(document, "pointerdown", begin, { capture: true });
    on(document, "keydown", begin, { capture: true });
    for (const type of ["pointerup", "pointercancel"]) on(document, type, () => (this.pressed = false), { capture: true });

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
        this.layers[button.dataset.layer] = !this.layers[button.dataset.layer];
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
    if (!this.compact) this.listenToSlab(on);
  }

  listenToSlab(on) {
    const slab = this.find(".body.slab");
    const pointer = (event) => {
      const toPicture = this.find(".machine").getScreenCTM().inverse();
      return new DOMPoint(event.clientX, event.clientY).matrixTransform(toPicture).x / CM;
    };
    on(slab, "pointerdown", (event) => {
      slab.setPointerCapture(event.pointerId);
      const deformation = FORMULAS.deformation({ ...this.parameters, ...this.coordinates() });
      this.held = { from: pointer(event), deformation };
      this.host.classList.add("held");
      this.compress(deformation);
      event.preventDefault();
      slab.focus();
    });
    on(slab, "pointermove", (event) => {
      if (this.held) this.compress(this.held.deformation + pointer(event) - this.held.from);
    });
    for (const type of ["pointerup", "pointercancel"])
      on(slab, type, () => {
        if (!this.held) return;
        this.held = null;
        this.host.classList.remove("held");
        this.letGo(0);
      });
    on(slab, "keydown", (event) => {
      const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 5, PageDown: -5 }[event.key];
      if (!by) return;
      event.preventDefault();
      this.compress(this.parameters.compression + (by * 0.5) / CM);
      this.letGo(400); // one message for a run of key strokes
    });
  }

  /** Hold the machine at rest with the spring compressed by so much, rounded to a tenth of a millimetre. */
  compress(compression) {
    const [least, most] = this.limits.compression;
    this.live.compression = Math.round(clamp(compression, least, most) * 1e4) / 1e4;
    this.release();
    this.tell(`x₀ = ${digits(this.live.compression * CM, 3)} cm`);
  }

  letGo(delay) {
    clearTimeout(this.sending);
    const { compression } = this.live;
    this.sending = setTimeout(() => this.sendReleased(compression), delay);
  }

  // ---- drawing: once, for a geometry, for parameters, for a frame

  buildOnce(label) {
    this.find(".label").textContent = label ?? "";
    if (label) set(this.host, { "aria-label": label });
    if (this.compact) for (const name of ["tabindex", "role", "aria-label"]) this.find(".body.slab").removeAttribute(name);
    for (let i = 0; i < 12; i++) element("line", { y1: -46, y2: -52, transform: `rotate(${30 * i})` }, this.find(".dial .ticks"));
    for (const name of [...BODIES, "spring"]) {
      const part = document.createElement("i");
      const entry = document.createElement("li");
      entry.append(document.createElement("span"), " ", document.createElement("b"));
      for (const node of [part, entry]) node.style.setProperty("--fill", `var(--${name})`);
      this.find(".bar").append(part);
      this.find(".legend").append(entry);
    }
    const path = (name, layer) => element("path", { stroke: `var(--${name}-ink)` }, this.find(`.${layer}`));
    const arrow = (name, layer) => {
      const drawn = path(name, layer);
      set(drawn, { "marker-end": "url(#tip)" });
      return drawn;
    };
    this.arrows = Object.fromEntries(BODIES.map((name) => [name, arrow(name, "arrows")]));
    this.traces = Object.fromEntries(ROLLERS.map((name) => [name, path(name, "traces")]));
    this.forces = mapValues(CONTACTS, ([roller]) => arrow(roller, "forces"));
    this.bars = this.all(".bar i");
    this.shares = this.all(".legend b");
    this.names = this.all(".legend span");
    this.reads = Object.fromEntries(["normalized", "omega", "period"].map((name) => [name, this.find(`[data-read=${name}]`)]));
    this.parts = movingParts(this.find(".moving"));
  }

  drawGeometry() {
    const g = (this.place = layout(this.parameters, this.limits.compression));
    const svg = this.find(".machine"), { left, right, bottom, top } = g.view;
    set(svg, { viewBox: `${left} ${-top} ${right - left} ${top - bottom}` });
    drawFloor(svg, g);
    drawBodies(this.find(".moving"), g, this.parameters);
    const names = { ...bodyNames(this.parameters), spring: "spring" };
    [...BODIES, "spring"].forEach((name, i) => (this.names[i].textContent = names[name]));
    const wide = 10, high = 6.5, end = g.slab.right, start = end - g.travel - wide - 2;
    set(this.find(".shelf"), { d: `M${start} ${-g.shelf}H${g.riser}` });
    set(this.find(".wall"), { d: `M${g.riser} ${-g.shelf + 1.5}V${-g.shelf - high - 3}` });
    set(this.find(".plain rect"), { x: end - wide, y: -g.shelf - high, width: wide, height: high });
    set(this.find(".plain .body text"), { x: end - wide / 2, y: -g.shelf - high / 2 });
    set(this.find(".plain .caption"), { x: g.riser - 1, y: -g.shelf - high - 4 });
    this.fitText();
  }

  /** Tell the style sheet how many picture units a pixel is. */
  fitText() {
    const svg = this.find(".machine"), scale = svg.getScreenCTM()?.a;
    if (scale) svg.style.setProperty("--u", String(1 / scale));
  }

  drawParameters() {
    const p = this.parameters, { Omega, normalized } = this.solution;
    for (const name of BODIES) this.parts[name].group.style.setProperty("--weight", weight(FORMULAS.mass[name](p)));
    this.find(".plain .body").style.setProperty("--weight", weight(p.m));
    this.reads.normalized.textContent = digits(normalized, 7);
    this.reads.omega.textContent = `${digits(Omega, 5)} rad/s`;
    this.reads.period.textContent = `${digits(TURN / Omega, 4)} s`;
    const [least, most] = this.limits.compression;
    if (!this.compact)
      set(this.find(".body.slab"), {
        "aria-valuemin": least * CM,
        "aria-valuemax": most * CM,
        "aria-valuenow": p.compression * CM,
        "aria-valuetext": `${digits(p.compression * CM, 3)} cm`,
      });
    this.drawGauge(normalized);
    (globalThis.ramanujanMachines ??= {})[this.name] = { ratio: FORMULAS.mass_ratio(p), normalized }; // for a ring on a curve
    this.drawTraces();
    this.findPeaks();
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => this.speak(), 500);
    this.showNote();
  }

  drawGauge(normalized) {
    const limit = FORMULAS.normalized_limit({}), at = (value) => 10 + (180 * value) / limit;
    set(this.find(".scale"), { d: "M10 26H190" });
    set(this.find(".unity"), { x: at(1) });
    this.find(".unity").textContent = this.data.unity ?? WORDS.unity;
    set(this.find(".pointer"), { transform: `translate(${at(Math.min(normalized, limit))} 26)` });
    const ticks = this.find(".gauge .ticks");
    ticks.replaceChildren();
    for (let value = 0; value <= limit; value += 0.5) {
      element("path", { d: `M${at(value)} ${value === 1 ? 14 : 26}V32` }, ticks);
      element("text", { x: at(value), y: 44 }, ticks).textContent = value;
    }
  }

  /** The states of one period, from the present one on. */
  *onePeriod(points) {
    for (let i = 0; i <= points; i++) {
      const phase = (TURN * i) / points;
      const state = stateAt(this.solution, phase, phase / this.solution.Omega);
      yield { ...this.parameters, ...state, Omega: this.solution.Omega };
    }
  }

  /** The greatest speed and the greatest contact force of a period: they set the scale of the arrows. */
  findPeaks() {
    this.peak = { speed: 0, force: 0 };
    for (const known of this.onePeriod(STEPS)) {
      const largest = (formulas) => Math.max(...Object.values(formulas).map((formula) => Math.abs(formula(known))));
      this.peak.speed = Math.max(this.peak.speed, largest(FORMULAS.velocity));
      this.peak.force = Math.max(this.peak.force, largest(FORMULAS.contact_force));
    }
  }

  drawTraces() {
    const { centre, R } = this.place, points = 90;
    const states = [...this.onePeriod(points)];
    for (const name of ROLLERS) {
      const rim = states.map((known) => {
        const angle = FORMULAS.angle[name](known), [x, y] = centre[name];
        return `${x + FORMULAS.displacement[name](known) * CM + R * Math.sin(angle)} ${-(y + R * Math.cos(angle))}`;
      });
      set(this.traces[name], { d: `M${rim.join("L")}` });
    }
  }

  coordinates() {
    const { samples } = this.data;
    const state = samples ? sampleAt(samples, this.time) : stateAt(this.solution, this.phase, this.time);
    return { ...state, plain: this.parameters.compression * Math.cos(this.plainPhase) };
  }

  drawn() {
    const state = this.coordinates();
    for (const [name, rest] of Object.entries(this.offset)) state[name] += rest;
    return state;
  }

  draw(elapsed) {
    const state = this.drawn(), g = this.place, svg = this.find(".machine");
    const known = { ...this.parameters, ...state, Omega: this.solution.Omega };
    this.followCentre(known);
    moveBodies(this.parts, known, g, this.shift);
    const plain = state.plain * CM;
    set(this.find(".plain .body"), { transform: `translate(${plain})` });
    set(this.find(".plain .coil"), { d: coil(g.slab.right + plain, g.riser, g.shelf + 3.2, 1.8) });
    slideFloor(svg, this.shift);
    if (this.layers.traces) set(this.find(".traces"), { transform: `translate(${-this.shift})` });
    if (this.layers.arrows) this.drawArrows(known);
    if (this.layers.forces) this.drawForces(known);
    this.drawClocks();
    (globalThis.ramanujanTimes ??= {})[this.name] = this.time; // for a cursor over the page's figures
    this.sinceText += elapsed;
    const write = this.sinceText >= TEXT_INTERVAL || this.dirty;
    if (this.layers.energy) this.drawEnergy(known, write);
    if (write) this.writeNumbers();
    this.dirty = false;
  }

  /** Nothing outside pushes the machine along the floor: its centre of mass keeps its pace, and the view goes with it. */
  followCentre(known) {
    const home = centresOfMass(this.place);
    let before = 0, moment = 0, total = 0;
    for (const name of BODIES) {
      const mass = FORMULAS.mass[name](known);
      total += mass;
      before += mass * home[name];
      moment += mass * FORMULAS.displacement[name](known) * CM;
    }
    const { b } = this.solution.motion.X;
    this.shift = Math.abs(b) > 1e-12 ? moment / total : 0;
    set(this.find(".centre"), { transform: `translate(${(before + moment) / total - this.shift} -2.4)` });
  }

  drawArrows(known) {
    const from = anchors(this.place), scale = (1.5 * Math.max(this.place.R, 8)) / (this.peak.speed || 1);
    for (const name of BODIES) {
      const start = from[name][0] + FORMULAS.displacement[name](known) * CM - this.shift;
      const length = FORMULAS.velocity[name](known) * scale;
      set(this.arrows[name], { d: Math.abs(length) < 0.4 ? "" : `M${start} ${-from[name][1]}h${length}` });
    }
  }

  drawForces(known) {
    const { centre, R } = this.place, scale = (1.1 * Math.max(R, 8)) / (this.peak.force || 1);
    for (const [contact, [roller, side]] of Object.entries(CONTACTS)) {
      const [x, y] = centre[roller];
      const start = x + FORMULAS.displacement[roller](known) * CM - this.shift;
      const height = -(y + side * R * 0.93); // on the roller's own side of the contact
      const length = FORMULAS.contact_force[contact](known) * scale;
      set(this.forces[contact], { d: Math.abs(length) < 0.4 ? "" : `M${start} ${height}h${length}` });
      if (contact === this.data.slipping) set(this.find(".slipping"), { transform: `translate(${start} ${-(y + side * R)})` });
    }
    this.find(".slipping").style.display = this.data.slipping ? "" : "none";
  }

  drawEnergy(known, write) {
    const energies = [...BODIES.map((name) => FORMULAS.kinetic_energy[name](known)), FORMULAS.potential_energy(known)];
    const total = energies.reduce((sum, energy) => sum + energy, 0) || 1;
    energies.forEach((energy, i) => {
      this.bars[i].style.width = `${(100 * energy) / total}%`;
      if (write) this.shares[i].textContent = `${Math.round((100 * energy) / total)} %`;
    });
  }

  drawClocks() {
    const degrees = (phase) => ((phase % TURN) * 360) / TURN;
    set(this.find(".hand.machine"), { transform: `rotate(${degrees(this.phase)})` });
    set(this.find(".hand.plain"), { transform: `rotate(${degrees(this.plainPhase)})` });
    const lead = (this.phase - this.plainPhase) % TURN, r = 36;
    const point = (phase) => `${r * Math.sin(phase)} ${-r * Math.cos(phase)}`;
    const large = Math.abs(lead) > Math.PI ? 1 : 0, sweep = lead > 0 ? 1 : 0;
    const sector = `M0 0L${point(this.plainPhase)}A${r} ${r} 0 ${large} ${sweep} ${point(this.phase)}z`;
    set(this.find(".lead"), { d: Math.abs(lead) < 1e-3 ? "" : sector });
    this.find(".scrub input").value = (((this.phase / TURN) % 1) + 1) % 1;
  }

  /** The still of someone who asked for less motion: half a period in five exposures. */
  drawGhosts() {
    for (let i = 0; i < 5; i++) {
      const ghost = this.find(".moving").cloneNode(true);
      set(ghost, { class: "ghost" });
      for (const node of ghost.querySelectorAll("[tabindex]")) node.removeAttribute("tabindex");
      for (const node of ghost.querySelectorAll("text, title")) node.remove();
      this.find(".ghosts").append(ghost);
      moveBodies(movingParts(ghost), { ...this.parameters, ...stateAt(this.solution, (Math.PI * i) / 4, 0) }, this.place);
    }
  }

  // ---- words

  writeNumbers() {
    this.sinceText = 0;
    const turns = (this.phase - this.plainPhase) / TURN;
    const lead = Math.abs(turns) < 0.005 ? WORDS.in_step : fill(turns > 0 ? WORDS.ahead : WORDS.behind, { turns: Math.abs(turns).toFixed(2) });
    const text = fill(WORDS.lead, { lead, periods: Math.abs(this.plainPhase / TURN).toFixed(1) });
    const verdict = this.find(".verdict");
    if (verdict.textContent !== text) verdict.textContent = text;
  }

  showClock() {
    if (this.clock.playing) this.find(".ghosts").replaceChildren();
    const play = this.find("[data-do=play]");
    play.textContent = this.clock.playing ? "⏸" : "▶";
    play.setAttribute("aria-label", this.clock.playing ? "Pause" : "Play");
    for (const button of this.all("[data-speed]"))
      button.setAttribute("aria-checked", String(Number(button.dataset.speed) === this.clock.speed));
    this.showNote();
  }

  showLayers() {
    for (const button of this.all("[data-layer]")) button.setAttribute("aria-pressed", String(this.layers[button.dataset.layer]));
    this.find(".energy").hidden = !this.layers.energy;
    for (const name of ["arrows", "traces", "forces"]) this.find(`.${name}`).style.display = this.layers[name] ? "" : "none";
    this.dirty = true;
  }

  /** Say something for a few seconds. */
  tell(sentence) {
    this.message = sentence;
    clearTimeout(this.noting);
    this.noting = setTimeout(() => {
      this.message = null;
      this.showNote();
    }, 3000);
    this.showNote();
  }

  showNote() {
    const slowing = Math.min(1, this.period() / EYE);
    const slowed = slowing < 1 ? fill(WORDS.slowed, { factor: digits(slowing * this.clock.speed, 2) }) : "";
    this.find(".note").textContent = this.message ?? slowed;
  }

  speak() {
    const { Omega, plain } = this.solution;
    const apart = Math.abs(Omega / plain - 1);
    const sentence = fill(apart < 1e-12 ? WORDS.together : WORDS.apart, {
      period: digits(TURN / Omega, 3),
      side: Omega > plain ? "ahead" : "behind",
      turns: digits(1 / apart, 3),
    });
    this.find(".live").textContent = this.clock.playing ? sentence : `${sentence} ${WORDS.paused}`;
  }
}
