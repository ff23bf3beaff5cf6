// Begins the components of the app, which ask for it by their names (ask.js); those that asked too early have waited.

const dressed = new WeakSet();

bus.begin ??= (name, component) => {
  const { parentElement } = component;
  if (!dressed.has(parentElement)) {
    dressed.add(parentElement);
    const look = document.createElement("template");
    look.innerHTML = parts[name].look;
    parentElement.append(look.content);
  }
  return parts[name].begin(component);
};
// A figure is drawn as wide as the page on the screen, and on paper it must be as wide as the paper (A4: 180 mm).
const fitPaper = () => document.documentElement.style.setProperty("--printed", Math.min(1, 660 / hosts.contentWidth()));
window.addEventListener("resize", fitPaper);
fitPaper();
bus.kept ??= hosts.keepOneEntry() ?? true;

for (const begin of bus.waiting?.splice(0) ?? []) begin();

// The parts that every page has live in this one element, each in a room of its own.
const rooms = new WeakMap(); // parentElement → part → its room

export default (component) => {
  const { data, parentElement } = component;
  for (const [key, box] of Object.entries(data.boxes)) bus.publish(`box/${key}`, box);
  if (!rooms.has(parentElement)) {
    const own = ["theme", "voice", "reach", "ring", "connection"].map((name) => [name, parentElement.appendChild(document.createElement("div"))]);
    rooms.set(parentElement, own);
  }
  const ends = rooms.get(parentElement).map(([name, room]) => bus.begin(name, { ...component, parentElement: room }));
  return () => ends.forEach((end) => end());
};
