// The machine on the page: draws it, plays it, and listens to the slab, the buttons and the sidebar's sliders.
// Physics is not written here: FORMULAS, printed by SymPy, and WORDS stand before this text. The contract with Python is
// in __init__.py: the numbers of each stage arrive in globalThis.ramanujanFeed. All lengths here are centimetres of the picture, x to the right and y UP from the floor.

const CM = 100; // per metre
const STEPS = 24; // steps of the step buttons in one period
const EYE = 0.7; // s, the shortest period that an eye can follow; what is faster is slowed
const SMOOTHING = 0.07; // s, the time in which a change of parameters fades into the picture
const TEXT_INTERVAL = 0.12; // s between two updates of running numbers; faster ones cannot be read
const TURN = 2 * Math.PI;
const BODIES = ["block", "hoop", "cylinder", "slab", "top"];
const NAMES = { block: "block", hoop: "hoop", cylinder: "cylinder", slab: "slab", top: "top cylinder", spring: "spring" };

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
  frame = mounted.size ? requestAnimationFrame(tick) : 0;
}

// ---------------------------------------------------------------- the model, evaluated

const mapValues = (object, change) => Object.fromEntries(Object.entries(object).map(([key, value]) => [key, change(value)]));

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

// ---------------------------------------------------------------- the picture's geometry

/** Where things stand at φ = 0, to scale: room for the largest travel, nothing more. */
function layout({ radius }, [, largest]) {
  const R = radius * CM;
  const travel = largest * CM; // of the slab over the block, to either side
  const roll = travel / 2;
  const deck = 8, thick = 4.5, step = 3, gap = 2.5;
  const hoop = roll + R + gap;
  const cylinder = hoop + 2.4 * R + 5;
  const slab = { left: hoop - roll - 4, right: cylinder + roll + 4, bottom: deck + 2 * R };
  const riser = slab.right + travel + 8;
  const upper = slab.bottom + thick + step;
  const top = riser + R + roll + gap; // rolls left by at most 2λ·roll < 4/3 roll, of which the block's edge may take some
  const right = top + R + gap + 2;
  const view = { left: -7, right: right + travel + 3, bottom: -8.5, top: upper + 2 * R + 3 };
  return { R, travel, deck, thick, hoop, cylinder, slab, riser, upper, top, right, view, shelf: upper + R * 0.45 };
}

/** A spring between two points at one height: a zigzag whose ends are straight. */
function coil(from, to, y, height) {
  const turns = 10, lead = Math.min(3, (to - from) / 8);
  const pitch = (to - from - 2 * lead) / turns;
  let path = `M${from} ${-y}H${from + lead}`;
  for (let i = 0; i < turns; i++) path += `l${pitch / 4} ${-height}l${pitch / 2} ${2 * height}l${pitch / 4} ${-height}`;
  return `${path}H${to}`;
}

const element = (name, attributes = {}, parent) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  parent?.append(node);
  return node;
};
const set = (node, attributes) => {
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
};
/** Heavier looks heavier: 0.12 for the lightest body that the sliders allow, 0.95 for the heaviest. */
const weight = (mass) => Math.min(0.95, Math.max(0.12, 0.5 + 0.4 * Math.log10(mass)));
const digits = (value, precision) => Number(value).toPrecision(precision);
const fill = (sentence, values) => sentence.replace(/\{(\w+)\}/g, (_, name) => values[name]);

// ---------------------------------------------------------------- one stage

class Stage {
  constructor(root, { stage, limits, watch, clock }) {
    this.name = stage;
    this.limits = limits;
    this.watch = watch;
    this.calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!clocks.has(clock)) clocks.set(clock, { playing: !this.calm, speed: 1, slowing: 1 });
    this.clock = clocks.get(clock);
    this.find = (selector) => root.querySelector(selector);
    this.all = (selector) => [...root.querySelectorAll(selector)];
    this.host = this.find(".stage");
    this.phase = this.plainPhase = this.time = 0;
    this.live = {}; // parameter → value, while a slider is being moved or the slab has been let go
    this.moving = new Map(); // key of a slider being moved → its value when that began
    this.pressed = false;
    this.offset = { X: 0, phi: 0, Phi: 0, plain: 0 }; // what is left of the last jump
    this.sinceText = TEXT_INTERVAL;
    this.layers = { energy: true, arrows: false, traces: false };
    this.stop = new AbortController();
    this.buildOnce();
    this.listen();
    this.sizes = new ResizeObserver(() => this.fitText());
    this.sizes.observe(this.find(".machine"));
  }

  dispose() {
    this.stop.abort();
    this.sizes.disconnect();
    clearTimeout(this.speaking);
    clearTimeout(this.sending);
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
    if (first) {
      this.find(".unity").textContent = WORDS.unity;
      this.offset = mapValues(this.offset, () => 0);
      if (this.calm) this.drawGhosts();
      this.showLayers();
      this.showClock();
    }
  }

  /** Make a change that may move the bodies, and let the picture flow from where it was drawn to where it is now. */
  change(make) {
    const before = this.solution && this.drawn();
    make();
    const parameters = { ...this.data.parameters, ...this.live };
    const ratio = this.solution && this.solution.Omega / this.solution.plain;
    const geometry = `${parameters.radius}`;
    this.parameters = parameters;
    this.solution = solve(parameters, this.data.initial);
    // The clocks compare frequencies: they start together whenever these change.
    if (ratio !== this.solution.Omega / this.solution.plain) this.plainPhase = this.phase;
    if (geometry !== this.geometry) this.drawGeometry();
    this.geometry = geometry;
    if (before && !this.calm) {
      const now = this.coordinates();
      this.offset = mapValues(this.offset, () => 0);
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
  }

  /** Go to a phase of the machine; the plain mass keeps its own time. */
  moveTo(phase) {
    this.moveTime((phase - this.phase) / this.solution.Omega);
    this.dirty = true;
  }

  release() {
    this.change(() => (this.phase = this.plainPhase = this.time = 0));
  }

  play(playing) {
    this.clock.playing = playing;
    this.find(".ghosts").replaceChildren();
    for (const stage of mounted.values()) if (stage.clock === this.clock) stage.showClock();
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
      const keys = Object.keys(this.watch);
      const key = keys.find((name) => event.target.closest?.(`.st-key-${CSS.escape(name)}`));
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
    this.listenToSlab(on);
  }

  step(direction) {
    this.play(false);
    this.moveTo(TURN * ((Math.round((this.phase / TURN) * STEPS) + direction) / STEPS));
  }

  listenToSlab(on) {
    const slab = this.find(".body.slab");
    const pointer = (event) => new DOMPoint(event.clientX, event.clientY).matrixTransform(this.find(".machine").getScreenCTM().inverse()).x / CM;
    on(slab, "pointerdown", (event) => {
      slab.setPointerCapture(event.pointerId);
      const deformation = FORMULAS.deformation({ ...this.parameters, ...stateAt(this.solution, this.phase, this.time) });
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
    this.live.compression = Math.round(Math.min(most, Math.max(least, compression)) * 1e4) / 1e4;
    this.release();
  }

  letGo(delay) {
    clearTimeout(this.sending);
    const compression = this.live.compression;
    this.sending = setTimeout(() => this.sendReleased(compression), delay);
  }

  // ---- drawing: once, for a geometry, for parameters, for a frame

  buildOnce() {
    for (let i = 0; i < 12; i++) element("line", { y1: -46, y2: -52, transform: `rotate(${30 * i})` }, this.find(".dial .ticks"));
    for (const name of [...BODIES, "spring"]) {
      const part = document.createElement("i");
      const entry = document.createElement("li");
      entry.append(NAMES[name], " ", document.createElement("b"));
      for (const node of [part, entry]) node.style.setProperty("--fill", `var(--${name})`);
      this.find(".bar").append(part);
      this.find(".legend").append(entry);
    }
    for (const name of BODIES) element("path", { stroke: `var(--${name}-ink)`, "marker-end": "url(#tip)" }, this.find(".arrows"));
    for (const name of ["hoop", "cylinder", "top"]) element("path", { stroke: `var(--${name}-ink)` }, this.find(".traces"));
    this.bars = this.all(".bar i");
    this.shares = this.all(".legend b");
    this.arrows = this.all(".arrows path");
    this.reads = mapValues({ normalized: 0, omega: 0, period: 0 }, () => null);
    for (const name of Object.keys(this.reads)) this.reads[name] = this.find(`[data-read=${name}]`);
    this.moved = parts(this.find(".moving"));
  }

  drawGeometry() {
    const g = (this.place = layout(this.parameters, this.limits.compression));
    const { left, right, bottom, top } = g.view;
    set(this.find(".machine"), { viewBox: `${left} ${-top} ${right - left} ${top - bottom}` });
    set(this.find(".earth"), { d: `M${left} 0H${right}V2.2H${left}z` });
    set(this.find(".ground"), { d: `M${left} 0H${right}` });
    set(this.find(".unit"), { x: right - 1, y: 5.6 });
    const ruler = this.find(".ruler");
    ruler.replaceChildren();
    let ticks = "";
    for (let x = 0; x <= right; x += 10) ticks += `M${x} 0V${x % 50 ? 1.6 : 2.8}`;
    element("path", { d: ticks }, ruler);
    for (let x = 0; x <= right - 30; x += 50) element("text", { x, y: 5.6 }, ruler).textContent = x;

    drawBodies(this.find(".moving"), g);
    const wide = 10, high = 6.5, end = g.slab.right;
    set(this.find(".shelf"), { d: `M${end - g.travel - wide - 2} ${-g.shelf}H${g.riser}` });
    set(this.find(".wall"), { d: `M${g.riser} ${-g.shelf + 1.5}V${-g.shelf - high - 3}` });
    set(this.find(".plain rect"), { x: end - wide, y: -g.shelf - high, width: wide, height: high });
    set(this.find(".plain .body text"), { x: end - wide / 2, y: -g.shelf - high / 2 });
    set(this.find(".plain .caption"), { x: end - g.travel - wide - 2, y: -g.shelf - high - 4 });
    this.fitText();
  }

  /** Tell the style sheet how many picture units a pixel is. */
  fitText() {
    const svg = this.find(".machine");
    const scale = svg.getScreenCTM()?.a;
    if (scale) svg.style.setProperty("--u", String(1 / scale));
  }

  drawParameters() {
    const p = this.parameters;
    for (const name of BODIES) this.moved[name].group.style.setProperty("--weight", weight(FORMULAS.mass[name](p)));
    this.find(".plain .body").style.setProperty("--weight", weight(p.m));
    const { Omega, plain, normalized } = this.solution;
    this.reads.normalized.textContent = digits(normalized, 7);
    this.reads.omega.textContent = `${digits(Omega, 5)} rad/s`;
    this.reads.period.textContent = `${digits(TURN / Omega, 4)} s`;

    const limit = FORMULAS.normalized_limit({}), at = (value) => 10 + (180 * value) / limit;
    set(this.find(".scale"), { d: `M10 26H190` });
    set(this.find(".unity"), { x: at(1) });
    set(this.find(".pointer"), { transform: `translate(${at(normalized)} 26)` });
    const ticks = this.find(".gauge .ticks");
    ticks.replaceChildren();
    for (let value = 0; value <= limit; value += 0.5) {
      element("path", { d: `M${at(value)} ${value === 1 ? 14 : 26}V32` }, ticks);
      element("text", { x: at(value), y: 44 }, ticks).textContent = value;
    }
    set(this.find(".body.slab"), {
      "aria-valuemin": this.limits.compression[0] * CM,
      "aria-valuemax": this.limits.compression[1] * CM,
      "aria-valuenow": p.compression * CM,
      "aria-valuetext": `${digits(p.compression * CM, 3)} cm`,
    });
    this.drawTraces();
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => this.speak(), 500);
    this.showNote();
  }

  coordinates() {
    const state = stateAt(this.solution, this.phase, this.time);
    return { ...state, plain: this.parameters.compression * Math.cos(this.plainPhase) };
  }

  drawn() {
    const state = this.coordinates();
    for (const [name, rest] of Object.entries(this.offset)) state[name] += rest;
    return state;
  }

  draw(elapsed) {
    const state = this.drawn();
    const known = { ...this.parameters, ...state };
    const g = this.place;
    moveBodies(this.moved, known, g);
    const plain = state.plain * CM;
    set(this.find(".plain .body"), { transform: `translate(${plain})` });
    set(this.find(".plain .coil"), { d: coil(g.slab.right + plain, g.riser, g.shelf + 3.2, 1.8) });
    this.drawCentre(known);
    if (this.layers.arrows) this.drawArrows(known);
    this.drawClocks();
    this.sinceText += elapsed;
    const write = this.sinceText >= TEXT_INTERVAL || this.dirty;
    if (this.layers.energy) this.drawEnergy(known, write);
    if (write) this.writeNumbers();
    this.dirty = false;
  }

  drawCentre(known) {
    const g = this.place;
    const home = { block: blockCentre(g), hoop: g.hoop, cylinder: g.cylinder, slab: (g.slab.left + g.slab.right) / 2, top: g.top };
    let moment = 0, total = 0;
    for (const name of BODIES) {
      const mass = FORMULAS.mass[name](known);
      moment += mass * (home[name] + FORMULAS.displacement[name](known) * CM);
      total += mass;
    }
    set(this.find(".centre"), { transform: `translate(${moment / total} ${-2.4})` });
    if (!this.centreLabelled) set(this.find(".centre text"), { x: 3.2, y: 0 });
    this.centreLabelled = true;
  }

  drawArrows(known) {
    const g = this.place;
    // The arrow of the greatest speed that the slab can have over the block is a radius and a half long.
    const scale = (1.5 * Math.max(g.R, 8)) / (this.solution.Omega * Math.max(this.parameters.compression, 1e-9));
    const from = anchors(g);
    BODIES.forEach((name, i) => {
      const [x, y] = from[name];
      const start = x + FORMULAS.displacement[name](known) * CM;
      const length = FORMULAS.velocity[name](known) * scale;
      this.arrows[i].setAttribute("d", Math.abs(length) < 0.4 ? "" : `M${start} ${-y}h${length}`);
    });
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
    const lead = (this.phase - this.plainPhase) % TURN;
    const [x1, y1] = [36 * Math.sin(this.plainPhase), -36 * Math.cos(this.plainPhase)];
    const [x2, y2] = [36 * Math.sin(this.phase), -36 * Math.cos(this.phase)];
    const large = Math.abs(lead) > Math.PI ? 1 : 0, sweep = lead > 0 ? 1 : 0;
    set(this.find(".lead"), { d: Math.abs(lead) < 1e-3 ? "" : `M0 0L${x1} ${y1}A36 36 0 ${large} ${sweep} ${x2} ${y2}z` });
    const scrub = this.find(".scrub input");
    scrub.value = (((this.phase / TURN) % 1) + 1) % 1;
  }

  drawTraces() {
    const g = this.place, points = 90;
    const centres = { hoop: [g.hoop, g.deck + g.R], cylinder: [g.cylinder, g.deck + g.R], top: [g.top, g.upper + g.R] };
    Object.entries(centres).forEach(([name, [x, y]], i) => {
      const path = [];
      for (let j = 0; j <= points; j++) {
        const phase = (TURN * j) / points;
        const known = { ...this.parameters, ...stateAt(this.solution, phase, phase / this.solution.Omega) };
        const angle = FORMULAS.angle[name](known);
        path.push(`${x + FORMULAS.displacement[name](known) * CM + g.R * Math.sin(angle)} ${-(y + g.R * Math.cos(angle))}`);
      }
      set(this.find(".traces").children[i], { d: `M${path.join("L")}` });
    });
  }

  /** The still of someone who asked for less motion: half a period in five exposures. */
  drawGhosts() {
    for (let i = 0; i < 5; i++) {
      const ghost = this.find(".moving").cloneNode(true);
      for (const node of ghost.querySelectorAll("[tabindex]")) node.removeAttribute("tabindex");
      for (const node of ghost.querySelectorAll("text, title")) node.remove();
      this.find(".ghosts").append(ghost);
      moveBodies(parts(ghost), { ...this.parameters, ...stateAt(this.solution, (Math.PI * i) / 4, 0) }, this.place);
    }
  }

  // ---- words

  writeNumbers() {
    this.sinceText = 0;
    const turns = (this.phase - this.plainPhase) / TURN;
    const lead = Math.abs(turns) < 0.005 ? "In step" : `Machine ${turns > 0 ? "ahead" : "behind"} by ${Math.abs(turns).toFixed(2)} turn`;
    const text = `${lead} after ${Math.abs(this.plainPhase / TURN).toFixed(1)} periods of the plain mass`;
    const verdict = this.find(".verdict");
    if (verdict.textContent !== text) verdict.textContent = text;
  }

  showClock() {
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
    for (const name of ["arrows", "traces"]) this.find(`.${name}`).style.display = this.layers[name] ? "" : "none";
    this.dirty = true;
  }

  showNote() {
    const slow = Math.min(1, this.period() / EYE);
    const note = this.held
      ? `x₀ = ${digits(this.parameters.compression * CM, 3)} cm`
      : slow < 1 ? fill(WORDS.slowed, { factor: digits(slow * this.clock.speed, 2) }) : "";
    this.find(".note").textContent = note;
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

// ---------------------------------------------------------------- bodies, drawn and moved

function parts(root) {
  const found = { spring: root.querySelector(".spring") };
  for (const name of BODIES) {
    const group = root.querySelector(`.body.${name}`);
    found[name] = { group, spin: group.querySelector(".spin") };
  }
  return found;
}

const blockCentre = (g) => {
  const low = g.riser * g.deck, high = (g.right - g.riser) * g.upper;
  return (low * (g.riser / 2) + high * ((g.riser + g.right) / 2)) / (low + high);
};

const anchors = (g) => ({
  block: [(g.riser + g.right) / 2, g.upper * 0.35],
  hoop: [g.hoop, g.deck + g.R],
  cylinder: [g.cylinder, g.deck + g.R],
  slab: [(g.slab.left + g.slab.right) / 2, g.slab.bottom + g.thick + 2.5],
  top: [g.top, g.upper + g.R],
});

function drawBodies(root, g) {
  const { R } = g;
  const body = (name, selector) => root.querySelector(`.body.${name} ${selector}`);
  set(body("block", "path"), { d: `M0 0V${-g.deck}H${g.riser}V${-g.upper}H${g.right}V0z` });
  set(body("block", "text"), { x: (g.riser + g.right) / 2, y: -g.upper * 0.6 });
  const inner = 0.78 * R;
  const ring = (r, turn) => `M0 ${-r}A${r} ${r} 0 1 ${turn} 0 ${r}A${r} ${r} 0 1 ${turn} 0 ${-r}z`;
  set(body("hoop", ".spin path"), { d: `${ring(R, 1)}${ring(inner, 0)}` });
  set(body("hoop", ".mark"), { d: `M0 ${-inner}V${-R}` });
  for (const name of ["cylinder", "top"]) {
    set(body(name, "circle"), { r: R });
    set(body(name, ".mark"), { d: `M0 ${-0.5 * R}V${-R}` });
  }
  const slab = { x: g.slab.left, y: -g.slab.bottom - g.thick, width: g.slab.right - g.slab.left, height: g.thick };
  set(body("slab", "rect:not(.grip)"), slab);
  // A finger needs more than the slab's own height.
  set(body("slab", ".grip"), { ...slab, y: slab.y - 3, height: slab.height + 6 });
  set(body("slab", "text"), { x: slab.x + slab.width / 2, y: slab.y + slab.height / 2 });
}

function moveBodies(moved, known, g) {
  const x = mapValues(FORMULAS.displacement, (displacement) => displacement(known) * CM);
  const home = { block: [0, 0], slab: [0, 0], hoop: [g.hoop, g.deck + g.R], cylinder: [g.cylinder, g.deck + g.R], top: [g.top, g.upper + g.R] };
  for (const name of BODIES) {
    const [x0, y0] = home[name];
    set(moved[name].group, { transform: `translate(${x0 + x[name]} ${-y0})` });
    if (moved[name].spin) set(moved[name].spin, { transform: `rotate(${(FORMULAS.angle[name](known) * 360) / TURN})` });
  }
  set(moved.spring, { d: coil(g.slab.right + x.slab, g.riser + x.block, g.slab.bottom + g.thick / 2, 2) });
}
