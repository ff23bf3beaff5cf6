// A second, small picture of a stage, where the stage itself is out of view. It follows the topics of the stage.

import { bus } from "../bus.js";
import { solve } from "./motion.js";
import { makeParts } from "./parts.js";
import { makePicture } from "./picture.js";
import { Playback } from "./playback.js";

export function followStage({ parentElement: root, data: { follows: stage, limits } }, signal) {
  const host = root.querySelector(".stage"), parts = makeParts(root), playback = new Playback();
  const picture = makePicture(root, { compact: true, dials: true, limits }, signal), clock = { seenFrom: "ground" };
  let parameters = null, isVisible = false;
  host.classList.add("small", "fixed", "ready");
  host.inert = true; // the stage has the controls and the words
  picture.show(new Set());

  function frame() {
    const { phase, plainPhase } = bus.last(`time/${stage}`) ?? playback;
    Object.assign(playback, { phase, plainPhase });
    const { shift, ...state } = playback.now(), { Omega } = playback.solution;
    picture.frame({ known: { ...parameters, ...state, Omega }, playback, shift, writesText: false });
  }

  bus.subscribe(`machine/${stage}`, ({ hide = [] }) => parts.hide(hide), { signal });
  bus.subscribe(`drawn/${stage}`, (drawn) => {
    parameters = drawn.parameters;
    const solution = solve(parameters), collision = () => null;
    playback.setMachine({ parameters, solution, collision, seenFrom: clock.seenFrom });
    picture.geometry(parameters);
    picture.machine({ parameters, solution, data: {}, clock, playback, parts });
    frame();
  }, { signal });
  const frameIfVisible = () => isVisible && parameters && frame();
  bus.subscribe(`time/${stage}`, frameIfVisible, { signal });
  const visibility = new IntersectionObserver((entries) => {
    isVisible = entries.at(-1).isIntersecting;
    frameIfVisible();
  });
  visibility.observe(host);
  signal.addEventListener("abort", () => visibility.disconnect());
}
