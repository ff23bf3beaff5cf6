// The sliders of the sidebar, read in the frame in which they move. An input rounds a value that is off its steps, so it
// counts only while it is being moved; otherwise the value from the server does.

function watchSliders(watch, signal) {
  const moving = new Map(); // key of a slider being moved → its value when that began
  let pressed = false;
  const on = (type, handler) => document.addEventListener(type, handler, { capture: true, signal });
  const begin = (event) => {
    const key = hosts.sliderKey(event.target, Object.keys(watch));
    const value = key && hosts.slider(key)?.value;
    if (value !== undefined) moving.set(key, value);
    pressed = event.type === "pointerdown";
  };
  on("pointerdown", begin);
  on("keydown", begin);
  for (const type of ["pointerup", "pointercancel"]) on(type, () => (pressed = false));
  return {
    /** Whatever the server now shows is the new rest position of a slider that is still held. */
    answered() {
      for (const key of moving.keys()) {
        if (pressed) moving.set(key, hosts.slider(key)?.value);
        else moving.delete(key);
      }
    },
    /** The parameters that sliders are just moving: [name, value in SI units]. */
    *read() {
      for (const [key, atRest] of moving) {
        const value = hosts.slider(key)?.value;
        if (value !== undefined && value !== atRest) yield [watch[key].parameter, Number(value) * watch[key].scale];
      }
    },
  };
}
