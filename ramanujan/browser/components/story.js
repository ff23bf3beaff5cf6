// The story of the first page: one press moves the slider of m′ as a hand does, from heavy rollers to the mass ratio at which
// both hands turn together, and then sends the exact value. The scenes come from Python; the stage's clock tells how far the
// story is. Any touch or key takes over: the slider stays where it is and sends its value.

import { bus } from "./bus.js";
import { dom } from "./streamlit_dom.js";
import { fill, fixed } from "./sentences.js";

const SAME = 1e-12; // relative: the floats of ε* lie closer
let found = false; // whether the ratio has been found since the page was loaded: only then does the slider mark it
let ended = false; // whether the story has been told to its end

export default function ({ data, parentElement }, signal) {
  const { stage, slider, ratio, openings, rest, pace, stills: clocks, marked, said } = data;
  const find = (selector) => parentElement.querySelector(selector);
  const button = find("button"), output = find(".said"), stills = find(".stills");
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  let scenes = null; // of the story that is being told
  let machine = null; // m′ and m [kg] as they are drawn
  let before = 0; // how far the story was a frame ago
  const goal = () => ratio * machine.m;
  found ||= marked;
  const still = ({ label, turns }) => `<li>
    <svg viewBox="-56 -56 112 112" aria-hidden="true"><circle r="52" /><line y2="-38" class="plain" />
    <line y2="-48" transform="rotate(${360 * turns})" /></svg>${label}</li>`;
  find("ol").innerHTML = clocks.map(still).join("");

  // Streamlit may draw the slider later.
  const mark = () => found && (dom.markSlider(slider, goal(), said.mark) || signal.aborted || requestAnimationFrame(mark));
  const say = (sentence) => {
    if (output.textContent === sentence) return;
    output.textContent = sentence;
    bus.publish("say", { sentence, urgent: false });
  };
  const tell = (story) => {
    scenes = story;
    bus.publish(`story/${stage}`, story && pace);
    bus.publish(`goal/${slider}`, null);
    button.textContent = story ? said.stop : ended ? said.again : said.begin;
  };
  const finish = () => {
    found = ended = true;
    tell(null);
    say(said.there);
    bus.publish(`enter/${slider}`, String(goal()));
  };
  /** Stop where the slider is. */
  const yieldTo = () => {
    tell(null);
    dom.sendSlider(dom.slider(slider), Number(dom.slider(slider).value));
  };
  const begin = () => {
    const input = dom.slider(slider);
    if (!machine || !input || input.disabled) return;
    stills.hidden = !calm.matches;
    if (calm.matches) return finish();
    const story = [...openings.find(([{ ratios }]) => ratios[0] * machine.m <= input.max), ...rest];
    dom.moveSlider(input, story[0].ratios[0] * machine.m);
    before = 0;
    tell(story);
  };
  /** Show the story as it is after so many periods of the plain mass. */
  const goTo = (now) => {
    const periods = now + Math.max(0, now - before) / 2; // this ratio holds for the next frame: take that of its middle
    let begun = 0;
    before = now;
    const scene = scenes.find((each) => periods < (begun += each.periods));
    if (!scene) return finish();
    const { ratios, sentence } = scene, at = (1 - (begun - periods) / scene.periods) * (ratios.length - 1), i = Math.floor(at);
    dom.moveSlider(dom.slider(slider), (ratios[i] + (at - i) * (ratios[i + 1] - ratios[i])) * machine.m);
    say(sentence);
  };

  button.addEventListener("click", () => (scenes ? yieldTo() : begin()));
  const presses = (event) => event.composedPath().includes(button) && [undefined, " ", "Enter"].includes(event.key);
  const touched = (event) => scenes && !presses(event) && yieldTo();
  for (const type of ["pointerdown", "keydown"]) addEventListener(type, touched, { capture: true, signal });
  calm.addEventListener("change", () => scenes && begin(), { signal });
  signal.addEventListener("abort", () => {
    bus.forget(`goal/${slider}`);
    if (scenes) bus.publish(`story/${stage}`, null);
  });
  bus.subscribe(`time/${stage}`, ({ periods }) => scenes && goTo(periods), { signal });
  bus.subscribe(`drawn/${stage}`, ({ ratio: present, parameters }) => {
    machine = parameters;
    if (scenes) return;
    const there = Math.abs(present / ratio - 1) < SAME;
    bus.publish(`goal/${slider}`, goal());
    if (there && !found) bus.publish("say", { sentence: said.there, urgent: false });
    found ||= there;
    output.textContent = there ? said.there : fill(said.ratio, { ratio: fixed(present, 4) });
    output.classList.toggle("there", there);
    button.textContent = ended ? said.again : said.begin;
    mark();
  }, { signal });
  button.title = said.hint;
  find(".stills p").textContent = said.stills;
}
