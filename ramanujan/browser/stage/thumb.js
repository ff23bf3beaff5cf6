// The hand on a value: a slider of the sidebar that moves under a thumb or by keys, or the slab. What the hand sets counts
// at once, and until the server has answered it; a message that speaks of an older value cannot take it back.

// The one state of a stage, and what leads from it to which; what is not listed does nothing.
//   idle       the picture shows what the server says
//   following  a slider moves: its input is read in every frame
//   held       the slab is in a hand: the machine stands still
//   awaiting   nothing is in a hand, and the server has not yet said what was set last
const TRANSITIONS = {
  idle: { grab: "following", take: "held" },
  following: { grab: "following", leave: "awaiting", take: "held" },
  held: { drop: "awaiting" },
  awaiting: { grab: "following", take: "held", settle: "idle" },
};
const AFTERWARDS = 0.12; // s for which a slider is still read when the hand has left it
const PATIENCE = 5; // s that the slab's value waits for the server where its slider is not on the page

class Hand {
  state = "idle";
  claims = new Map(); // key of a slider → what the hand has set
  followed = null; // the key of the slider that moves
  pressed = false;
  touched = 0; // s, when the hand last did something

  /** `watch` is the contract's; `shown(parameter)` the value that is drawn, `told(parameter)` that of the server. */
  constructor(watch, { shown, told }, signal) {
    Object.assign(this, { watch, shown, told });
    this.slabKey = Object.keys(watch).find((key) => watch[key].parameter === "compression");
    const on = (type, handler) => document.addEventListener(type, handler, { capture: true, signal });
    on("pointerdown", (event) => this.grab(event));
    on("keydown", (event) => this.grab(event));
    on("input", (event) => event.isTrusted && this.grab(event)); // aids may set a slider without pointer and keys
    for (const type of ["pointerup", "pointercancel"]) on(type, () => this.unpress());
    addEventListener("blur", () => this.unpress(), { signal });
  }

  step(event) {
    const next = TRANSITIONS[this.state][event];
    if (next) this.state = next;
    return Boolean(next);
  }

  /** The parameters that the hand has set, by name. */
  values() {
    return Object.fromEntries([...this.claims.values()].map(({ parameter, value }) => [parameter, value]));
  }

  grab({ target, type }) {
    if (type === "pointerdown") this.unpress();
    const key = hosts.sliderKey(target, Object.keys(this.watch));
    const input = key && hosts.slider(key);
    if (!input || !this.step("grab")) return;
    if (!this.claims.has(key)) this.claims.set(key, this.claim(key, input));
    this.claims.get(key).exact = false;
    this.followed = key;
    this.pressed = type === "pointerdown";
    this.touched = now();
  }

  unpress() {
    if (this.pressed) this.touched = now();
    this.pressed = false;
  }

  /** The input rounds a value that is off its steps: at rest, its text stands for the value that is drawn. */
  claim(key, input) {
    const { parameter, scale } = this.watch[key];
    const text = input?.value, value = this.shown(parameter);
    return { key, input, parameter, scale, text, value, rest: { text, value }, exact: false };
  }

  /** Look at the inputs, once a frame while there is something to look at; return whether a value has changed. */
  look() {
    if (!this.claims.size) return this.step("settle") && false;
    let changed = false;
    const following = this.claims.get(this.followed);
    if (following) {
      changed = this.read(following);
      if (!this.pressed && now() - this.touched > AFTERWARDS) {
        this.followed = null;
        this.step("leave");
      }
    }
    for (const [key, claim] of this.claims) {
      const inHand = key === this.followed || (this.state === "held" && key === this.slabKey);
      if (inHand || this.stands(claim)) continue;
      this.claims.delete(key);
      changed = true;
    }
    return changed;
  }

  read(claim) {
    if (!claim.input.isConnected) claim.input = hosts.slider(claim.key) ?? claim.input;
    const text = claim.input.value;
    if (text === claim.text) return false;
    claim.text = text;
    claim.value = text === claim.rest.text ? claim.rest.value : Number(text) * claim.scale;
    return true;
  }

  /** Whether the server still owes the answer to what the hand has set. */
  stands(claim) {
    const told = this.told(claim.parameter);
    if (Math.abs(told - claim.value) < 1e-9) return false;
    if (!claim.input?.isConnected) return claim.exact && now() - this.touched < PATIENCE;
    if (now() - this.touched < AFTERWARDS) claim.text = claim.input.value;
    // Only the server or another hand writes into a slider that is at rest.
    if (claim.input.value !== claim.text) return false;
    return claim.exact || Math.abs(told / claim.scale - Number(claim.text)) >= Number(claim.input.step) / 2;
  }

  // ---- the slab

  take() {
    if (!this.step("take")) return false;
    this.followed = null;
    this.claims.set(this.slabKey, { ...this.claim(this.slabKey, hosts.slider(this.slabKey)), exact: true });
    return true;
  }

  /** Set x₀ [m]; its slider goes along on the page. `drawn` may lie beyond the bounds, where the slab gives way. */
  hold(compression, drawn = compression) {
    const claim = this.claims.get(this.slabKey);
    claim.value = drawn;
    this.moveSlider(claim, compression);
  }

  drop(compression) {
    const claim = this.claims.get(this.slabKey);
    claim.value = compression;
    this.touched = now();
    this.step("drop");
  }

  /** Give x₀ back as it was. */
  giveUp(compression) {
    this.moveSlider(this.claims.get(this.slabKey), compression);
    this.drop(compression);
  }

  moveSlider(claim, compression) {
    if (!claim.input?.isConnected) return;
    hosts.moveSlider(claim.input, compression / claim.scale);
    claim.text = claim.input.value;
  }
}

const now = () => performance.now() / 1000;
