// The slab in a hand: dragged by the pointer, moved by the keys.

/** Listen to the slab. `stage` answers: deformation() [m], parameters, hold(compression), let(go after ms). */
function listenToSlab(node, picture, stage, signal) {
  let held = null;
  const on = (type, handler) => node.addEventListener(type, handler, { signal });
  on("pointerdown", (event) => {
    node.setPointerCapture(event.pointerId);
    held = { from: picture.toMetres(event.clientX), deformation: stage.deformation() };
    stage.take(true);
    stage.compress(held.deformation);
    event.preventDefault();
    node.focus();
  });
  on("pointermove", (event) => {
    if (held) stage.compress(held.deformation + picture.toMetres(event.clientX) - held.from);
  });
  for (const type of ["pointerup", "pointercancel"])
    on(type, () => {
      if (!held) return;
      held = null;
      stage.take(false);
      stage.letGo(0);
    });
  on("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 5, PageDown: -5 }[event.key];
    if (!by) return;
    event.preventDefault();
    stage.compress(stage.parameters.compression + (by * 0.5) / CM);
    stage.letGo(400); // one message for a run of key strokes
  });
}
