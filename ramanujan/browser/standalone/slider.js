// A slider that the modules of the page can use like one of Streamlit's: it sends its value when a hand lets go of it and after
// a key stroke, and it marks itself while it is dragged.

export function makeSlider(key, { min, max, step, value, label = "" }, send) {
  const outer = document.createElement("div");
  outer.className = `st-key-${key} slider`;
  outer.innerHTML = '<div role="group"><input type="range" /></div>';
  const group = outer.firstChild, input = group.firstChild;
  Object.assign(input, { min, max, step, ariaLabel: label });
  input.value = value;
  const report = () => send(Number(input.value));
  input.addEventListener("input", () => input.setAttribute("value", input.value)); // the modules observe the attribute
  input.addEventListener("change", report);
  input.addEventListener("keydown", (event) => {
    if (event.isTrusted) return; // the browser itself moves the thumb
    input[event.key === "ArrowRight" ? "stepUp" : "stepDown"]();
    input.dispatchEvent(new Event("input", { bubbles: true }));
    report();
  });
  input.addEventListener("pointerdown", () => group.toggleAttribute("data-dragging", true));
  for (const type of ["pointerup", "pointercancel"])
    input.addEventListener(type, () => group.toggleAttribute("data-dragging", false));
  return outer;
}
