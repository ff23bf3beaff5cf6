// One press shows the idea: the slider of m′ moves slowly, as in a hand, until the machine is in step, and then its exact value is
// sent. Whatever is touched meanwhile takes over: the slider stays where it is, and sends that.

import { bus } from "./bus.js";
import { dom } from "./streamlit_dom.js";
import { fill, fixed } from "./sentences.js";

const DURATION = 4000; // ms
const SAME = 1e-12; // relative: the floats of ε* lie closer

export default function ({ data: { stage, slider, ratio, said }, parentElement }, signal) {
  const [button, output] = parentElement.querySelectorAll("button, p");
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  let frame = 0; // of the sweep, while it goes on
  let machine = null; // m′ and m [kg] as they are drawn
  const goal = () => ratio * machine.m;

  // Streamlit may draw the slider later than this.
  const mark = () => dom.markSlider(slider, goal(), said.mark) || signal.aborted || requestAnimationFrame(mark);
  const stop = () => {
    cancelAnimationFrame(frame);
    frame = 0;
    button.textContent = said.begin;
  };
  /** Stop where the slider is. */
  const yieldTo = () => {
    stop();
    dom.sendSlider(dom.slider(slider), Number(dom.slider(slider).value));
  };
  const begin = () => {
    if (!machine || dom.slider(slider)?.disabled) return;
    const from = machine.m_prime, began = performance.now(), duration = calm.matches ? 0 : DURATION;
    const move = () => {
      const share = duration ? Math.min(1, (performance.now() - began) / duration) : 1;
      dom.moveSlider(dom.slider(slider), from + (goal() - from) * share * share * (3 - 2 * share));
      if (share < 1) return (frame = requestAnimationFrame(move));
      stop();
      bus.publish(`enter/${slider}`, String(goal()));
    };
    button.textContent = said.stop;
    move();
  };

  button.addEventListener("click", () => (frame ? yieldTo() : begin()));
  const touched = (event) => frame && !event.composedPath().includes(button) && yieldTo();
  for (const type of ["pointerdown", "keydown"]) addEventListener(type, touched, { capture: true, signal });
  signal.addEventListener("abort", () => cancelAnimationFrame(frame));
  bus.subscribe(`present/${stage}`, ({ ratio: present, parameters }) => {
    machine = parameters;
    const there = Math.abs(present / ratio - 1) < SAME;
    output.textContent = there ? said.there : fill(said.ratio, { ratio: fixed(present, 4) });
    output.classList.toggle("there", there);
    mark();
  }, { signal });
  Object.assign(button, { textContent: said.begin, title: said.hint });
}
