// The standalone page. It stores the values of the sliders, in place of the server, and publishes the machine. The
// boxes, the story and the stage are modules of the app.

import { address } from "../browser/page_address.js";
import { bus } from "../browser/bus.js";
import { DECIMAL } from "../browser/language.js";
import { fill, withUnit } from "../browser/sentences.js";
import { followMachine } from "./curve.js";
import { makeSlider, mount } from "./elements.js";
import { readNumber, twoReadings } from "../browser/numbers.js";

const settings = JSON.parse(document.querySelector("#settings").textContent);
const { parameters, sentences, view } = settings;
const values = {}, inputs = {}, mounted = [];
const find = (selector) => document.querySelector(selector), note = find(".note");

const asText = (value) => String(Number(value.toPrecision(7))).replace(".", DECIMAL);
const asQuantity = (value, { unit }) => withUnit(asText(value), unit);
const isInRange = (value, { least, most }) => value >= least && value <= most;
const clamp = (value, { least, most }) => Math.min(Math.max(value, least), most);

/** Publish the machine, and the values for the boxes. */
function publish() {
  const machine = Object.fromEntries(parameters.map(({ key, scale }) => [key, values[key] * scale]));
  bus.publish("machine/oscillator", { parameters: { ...settings.machine, ...machine } });
  for (const { key } of parameters) bus.publish(`exact/${key}`, { value: values[key], text: String(values[key]) });
}

/** Set values, and show a message. */
function set(changes, message = "") {
  Object.assign(values, changes);
  for (const [key, value] of Object.entries(changes)) {
    inputs[key].value = value;
    inputs[key].setAttribute("value", inputs[key].value);
  }
  note.textContent = message;
  publish();
}

/** Set a parameter from a text, or show which numbers are accepted and keep the old value. */
function setFromText(parameter, text) {
  const { key, symbol, least, most } = parameter, old = asQuantity(values[key], parameter);
  const value = readNumber(text, DECIMAL), readings = twoReadings(text, DECIMAL);
  if (readings) set({}, fill(sentences.ambiguous, { symbol, old, ...readings }));
  else if (value === null) set({}, fill(sentences.unreadable, { symbol, old }));
  else if (isInRange(value, parameter)) set({ [key]: value });
  else set({}, fill(sentences.outside, { symbol, old, least: asText(least), most: asQuantity(most, parameter) }));
}

/** Set the mass ratio: change m′, and also m if m′ would be outside of its range. */
function setRatio(ratio) {
  const [m, rollers] = ["m", "m_prime"].map((name) => parameters.find(({ key }) => key === name));
  const wanted = ratio * values.m, bound = clamp(wanted, rollers);
  if (wanted === bound) return set({ m_prime: wanted });
  // The nearest mass on a step of the slider at which m′ is within its range.
  const steps = Number((bound / ratio / m.step).toFixed(6));
  const whole = wanted > bound ? Math.floor(steps) : Math.ceil(steps);
  const mass = clamp(Number((whole * m.step).toPrecision(10)), m);
  const limits = { old: asQuantity(values.m, m), new: asQuantity(mass, m), bound: asQuantity(bound, rollers) };
  const sentence = fill(wanted > bound ? sentences.lighter : sentences.heavier, limits);
  set({ m: mass, m_prime: clamp(ratio * mass, rollers) }, sentence);
}

/**
 * Read the settings after # in the address, or those saved in the file. Remove unknown ones, and invalid ones with a
 * message.
 */
function readSettings() {
  const isLinked = location.href.includes("#");
  const start = isLinked ? address.settings() : new URLSearchParams(document.documentElement.dataset.standalone);
  const isValid = (text, { pattern, ...range }) =>
    pattern ? RegExp(`^(${pattern})$`).test(text) : isInRange(readNumber(text), range);
  const explain = (text, { key, pattern, refusal }) => {
    const readings = pattern ? null : twoReadings(text);
    return readings ? fill(sentences.ambiguous_link, { name: key, ...readings }) : refusal;
  };
  const known = new Map([...parameters, ...view].map((setting) => [setting.key, setting])), messages = new Set();
  for (const [key, text] of [...start]) {
    if (known.has(key) && isValid(text, known.get(key))) continue;
    if (known.has(key)) messages.add(explain(text, known.get(key)));
    start.delete(key);
  }
  if (String(start) !== location.hash.slice(1)) address.replaceSettings(start);
  document.documentElement.dataset.standalone = start;
  note.textContent = [...messages].join(" ");
  return start;
}

/** Add a slider and its box to the page. */
function addSlider(parameter) {
  const { key, least, most, step, label, head } = parameter;
  const attributes = { min: least, max: most, step, value: values[key], label };
  const slider = makeSlider(key, attributes, (value) => set({ [key]: value }));
  inputs[key] = slider.querySelector("input");
  const outer = find(".sliders").appendChild(document.createElement("div"));
  const box = outer.appendChild(document.createElement("div"));
  box.className = `st-key-${key}_exact`;
  outer.append(slider);
  const setExactly = (_event, text) => setFromText(parameter, text);
  mounted.push(mount(box, "components/exact/exact", `${key}_exact`, head, setExactly));
}

// A browser that saves the page also saves what this script has added.
find(".sliders").replaceChildren();
find("[role=status]").textContent = "";
const start = readSettings();
for (const parameter of parameters) {
  values[parameter.key] = start.has(parameter.key) ? readNumber(start.get(parameter.key)) : parameter.default;
  if (parameter.head) addSlider(parameter); // the radius has no slider
}
find(".sliders").addEventListener("submit", (event) => event.preventDefault());
note.addEventListener("click", () => (note.textContent = ""));
bus.subscribe("announce", ({ sentence }) => (find("[role=status]").textContent = sentence));
publish();
mounted.push(mount(find(".st-key-stage"), "stage/stage", "stage", settings.stage));
mounted.push(mount(find(".st-key-story"), "components/story/story", "story", settings.story));
followMachine(find(".curve"), settings.curve, setRatio);
addEventListener("hashchange", () => location.reload());
await Promise.all(mounted);
document.documentElement.classList.remove("starting");
