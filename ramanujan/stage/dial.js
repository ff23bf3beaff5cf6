// What compares the machine with the plain mass: two clock hands, the sentence below them, the gauge, the readouts.

function makeDial(root) {
  const find = (selector) => root.querySelector(selector);
  const reads = Object.fromEntries(["normalized", "omega", "period"].map((name) => [name, find(`[data-read=${name}]`)]));
  for (let i = 0; i < 12; i++) element("line", { y1: -46, y2: -52, transform: `rotate(${30 * i})` }, find(".dial .ticks"));

  function machine({ Omega, normalized }, { unity }) {
    reads.normalized.textContent = digits(normalized, 7);
    reads.omega.textContent = `${digits(Omega, 5)} rad/s`;
    reads.period.textContent = `${digits(TURN / Omega, 4)} s`;
    drawGauge(normalized, unity ?? WORDS.unity);
  }

  function drawGauge(normalized, unity) {
    const limit = FORMULAS.normalized_limit({}), at = (value) => 10 + (180 * value) / limit;
    set(find(".scale"), { d: "M10 26H190" });
    set(find(".unity"), { x: at(1) });
    find(".unity").textContent = unity;
    set(find(".pointer"), { transform: `translate(${at(Math.min(normalized, limit))} 26)` });
    const ticks = find(".gauge .ticks");
    ticks.replaceChildren();
    for (let value = 0; value <= limit; value += 0.5) {
      element("path", { d: `M${at(value)} ${value === 1 ? 14 : 26}V32` }, ticks);
      element("text", { x: at(value), y: 44 }, ticks).textContent = value;
    }
  }

  function frame(phase, plainPhase, write) {
    const degrees = (angle) => ((angle % TURN) * 360) / TURN;
    set(find(".hand.machine"), { transform: `rotate(${degrees(phase)})` });
    set(find(".hand.plain"), { transform: `rotate(${degrees(plainPhase)})` });
    const lead = (phase - plainPhase) % TURN, r = 36;
    const point = (angle) => `${r * Math.sin(angle)} ${-r * Math.cos(angle)}`;
    const large = Math.abs(lead) > Math.PI ? 1 : 0, sweep = lead > 0 ? 1 : 0;
    const sector = `M0 0L${point(plainPhase)}A${r} ${r} 0 ${large} ${sweep} ${point(phase)}z`;
    set(find(".lead"), { d: Math.abs(lead) < 1e-3 ? "" : sector });
    if (write) say(phase, plainPhase);
  }

  function say(phase, plainPhase) {
    const turns = (phase - plainPhase) / TURN;
    const lead = Math.abs(turns) < 0.005 ? WORDS.in_step : fill(turns > 0 ? WORDS.ahead : WORDS.behind, { turns: Math.abs(turns).toFixed(2) });
    const text = fill(WORDS.lead, { lead, periods: Math.abs(plainPhase / TURN).toFixed(1) });
    const verdict = find(".verdict");
    if (verdict.textContent !== text) verdict.textContent = text;
  }

  return { machine, frame };
}
