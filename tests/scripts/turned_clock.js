// A clock that the test turns by frames of a twentieth of a second: a story of half a minute is told at once.
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
