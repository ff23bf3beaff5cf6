// The arrow keys of a lecture: after a click on a choice they go back to the page, where they turn the steps. Without
// this the clicked choice keeps them, as it must for people who choose by keyboard.

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
