// The layers that can be chosen: energy bars by body, velocity arrows, contact forces, traces of the rims.

const PERIOD_POINTS = 24; // in which the greatest speed and force of a period are looked for

function makeLayers(root) {
  const find = (selector) => root.querySelector(selector);
  let shown = new Set(), place = null, peak = { speed: 0, force: 0 }, data = {};

  const bars = [], shares = [], names = [];
  for (const name of [...BODIES, "spring"]) {
    const bar = document.createElement("i"), entry = document.createElement("li");
    entry.append(document.createElement("span"), " ", document.createElement("b"));
    for (const node of [bar, entry]) node.style.setProperty("--fill", `var(--${name})`);
    find(".bar").append(bar);
    find(".legend").append(entry);
    bars.push(bar);
    shares.push(entry.lastChild);
    names.push(entry.firstChild);
  }
  const path = (name, layer) => element("path", { stroke: `var(--${name}-ink)` }, find(`.${layer}`));
  const arrow = (name, layer) => {
    const drawn = path(name, layer);
    set(drawn, { "marker-end": "url(#tip)" });
    return drawn;
  };
  const arrows = Object.fromEntries(BODIES.map((name) => [name, arrow(name, "arrows")]));
  const traces = Object.fromEntries(ROLLERS.map((name) => [name, path(name, "traces")]));
  const forces = mapValues(CONTACTS, ([roller]) => arrow(roller, "forces"));

  function geometry(newPlace, parameters) {
    place = newPlace;
    const words = { ...bodyNames(parameters), spring: "spring" };
    [...BODIES, "spring"].forEach((name, i) => (names[i].textContent = words[name]));
  }

  function machine(parameters, solution, newData) {
    data = newData;
    findPeaks(onePeriod(parameters, solution, PERIOD_POINTS));
    drawTraces(onePeriod(parameters, solution, 90));
  }

  /** The greatest speed and the greatest contact force of a period: they set the scale of the arrows. */
  function findPeaks(states) {
    const largest = (formulas, known) => Math.max(...Object.values(formulas).map((formula) => Math.abs(formula(known))));
    peak = {
      speed: Math.max(...states.map((known) => largest(FORMULAS.velocity, known))),
      force: Math.max(...states.map((known) => largest(FORMULAS.contact_force, known))),
    };
  }

  function drawTraces(states) {
    const { centre, R } = place;
    for (const name of ROLLERS) {
      const rim = states.map((known) => {
        const angle = FORMULAS.angle[name](known), [x, y] = centre[name];
        return `${x + FORMULAS.displacement[name](known) * CM + R * Math.sin(angle)} ${-(y + R * Math.cos(angle))}`;
      });
      set(traces[name], { d: `M${rim.join("L")}` });
    }
  }

  function frame(known, shift, write) {
    if (shown.has("traces")) set(find(".traces"), { transform: `translate(${-shift * CM})` });
    if (shown.has("arrows")) drawArrows(known, shift);
    if (shown.has("forces")) drawForces(known, shift);
    if (shown.has("energy")) drawEnergy(known, write);
  }

  function drawArrows(known, shift) {
    const from = anchors(place), scale = (1.5 * Math.max(place.R, 8)) / (peak.speed || 1);
    for (const name of BODIES) {
      const start = from[name][0] + (FORMULAS.displacement[name](known) - shift) * CM;
      const length = FORMULAS.velocity[name](known) * scale;
      set(arrows[name], { d: Math.abs(length) < 0.4 ? "" : `M${start} ${-from[name][1]}h${length}` });
    }
  }

  function drawForces(known, shift) {
    const { centre, R } = place, scale = (1.1 * Math.max(R, 8)) / (peak.force || 1);
    for (const [contact, [roller, side]] of Object.entries(CONTACTS)) {
      const [x, y] = centre[roller];
      const start = x + (FORMULAS.displacement[roller](known) - shift) * CM;
      const height = -(y + side * R * 0.93); // on the roller's own side of the contact
      const length = FORMULAS.contact_force[contact](known) * scale;
      set(forces[contact], { d: Math.abs(length) < 0.4 ? "" : `M${start} ${height}h${length}` });
      if (contact === data.slipping) set(find(".slipping"), { transform: `translate(${start} ${-(y + side * R)})` });
    }
    find(".slipping").style.display = data.slipping ? "" : "none";
  }

  function drawEnergy(known, write) {
    const energies = [...BODIES.map((name) => FORMULAS.kinetic_energy[name](known)), FORMULAS.potential_energy(known)];
    const total = energies.reduce((sum, energy) => sum + energy, 0) || 1;
    energies.forEach((energy, i) => {
      bars[i].style.width = `${(100 * energy) / total}%`;
      if (write) shares[i].textContent = `${Math.round((100 * energy) / total)} %`;
    });
  }

  function show(layers) {
    shown = layers;
    find(".energy").hidden = !shown.has("energy");
    for (const name of ["arrows", "traces", "forces"]) find(`.${name}`).style.display = shown.has(name) ? "" : "none";
  }

  return { geometry, machine, frame, show };
}
