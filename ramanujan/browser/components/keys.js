// Gives the arrow keys back to the page after a click on a choice, so that they turn the steps of a lecture again. Somebody
// who chooses by keyboard needs the arrow keys at the choice, so there they stay.

export default function ({ data }, signal) {
  const giveBack = ({ detail, target }) => {
    // A click that a key made has no detail. After such a click the focus has to stay.
    if (!detail) return;
    // A group may give the focus back to the button that had it before the click. An open menu keeps it until one has chosen.
    setTimeout(() => {
      const held = document.activeElement, ready = held.ariaExpanded !== "true" || target.closest?.('[role="option"]');
      if (ready && held.closest(data.choices)) held.blur();
    });
  };
  // In the capture phase, because the choices stop their clicks.
  document.addEventListener("click", giveBack, { capture: true, signal });
}
