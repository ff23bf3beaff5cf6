// Replaces the browser's clock. turn(frames) advances it by frames of 0.05 s, so a story of half a minute passes at
// once.
() => {
  let now = performance.now(), waiting = [];
  window.requestAnimationFrame = (draw) => waiting.push(draw);
  window.cancelAnimationFrame = () => (waiting = []);
  performance.now = () => now;
  window.turn = (frames) => {
    for (let i = 0; i < frames; i++) {
      const due = waiting;
      now += 50;
      waiting = [];
      for (const draw of due) draw(now);
    }
  };
}
