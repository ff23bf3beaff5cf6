// Gives the arrow keys back to the page after a click on a choice, so that they turn the steps of a lecture again. Somebody
// who chooses by keyboard needs the arrow keys at the choice, so there they stay.

export default function ({ data }, signal) {
  const giveBack = (event) => {
    // A click made by a key has no pointer, hence no detail: there the focus has to stay.
    if (!event.detail || !event.target.closest?.(data.choices)) return;
    // Not always the button that was clicked: a group gives the focus back to where it was before.
    setTimeout(() => document.activeElement.closest(data.choices) && document.activeElement.blur());
  };
  // On the way down, since the choices keep their clicks to themselves.
  document.addEventListener("click", giveBack, { capture: true, signal });
}
