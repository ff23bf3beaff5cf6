// Returns the focus from a clicked choice to the page, so that the arrow keys turn the steps of a lecture again. A
// choice that is operated by keyboard keeps the focus, because it needs the arrow keys.

export default function ({ data }, signal) {
  const returnFocus = ({ detail, target }) => {
    // A click by keyboard has the detail 0.
    if (!detail) return;
    // Wait, because a group may move the focus after the click. An open menu keeps the focus until an option is chosen.
    setTimeout(() => {
      const focused = document.activeElement;
      const isDone = focused.ariaExpanded !== "true" || target.closest?.('[role="option"]');
      if (isDone && focused.closest(data.choices)) focused.blur();
    });
  };
  // Capture, because the choices stop the propagation of their clicks.
  document.addEventListener("click", returnFocus, { capture: true, signal });
}
