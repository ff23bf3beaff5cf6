// Gives the arrow keys back to the page after a click on a choice, so that they turn the steps of a lecture again. Somebody
// who chooses by keyboard needs the arrow keys at the choice, so there they stay.

export default function ({ data }, signal) {
  const giveBack = ({ detail, target }) => {
    const chosen = target.closest?.('[role="option"]');
    // A click that a key made has no detail. After such a click the focus has to stay.
    if (!detail || !(chosen ?? target.closest?.(data.choices))) return;
    // A group may give the focus back to the button that had it before the click. A menu that has opened keeps it.
    setTimeout(() => {
      const held = document.activeElement;
      if (held.closest(data.choices) && (chosen || held.ariaExpanded !== "true")) held.blur();
    });
  };
  // In the capture phase, because the choices stop their clicks.
  document.addEventListener("click", giveBack, { capture: true, signal });
}
