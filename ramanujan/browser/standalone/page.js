// The standalone page. It stores the values of the sliders, in place of the server, and publishes the machine. The boxes, the
// story and the stage are modules of the app.

import { begin } from "../begin.js";
import { bus } from "../components/bus.js";
import { DECIMAL } from "../components/language.js";
import { fill, withUnit } from "../components/sentences.js";
import { dom } from "../components/streamlit_dom.js";
import { drawCurve } from "./curve.js";
import { readNumber, twoReadings } from "./numbers.js";
import { makeSlider } from "./slider.js";

const settings = JSON.parse(document.querySelector("#settings").textContent);
const { parameters, sentences } = settings;
const values = {}, inputs = {}, published = new Map();
const note = document.querySelector(".note"), live = document.querySelector("[role=status]");
let judged = 0; // number of processed texts; a box shows its value again when it changes

const asText = (value, { unit }) => withUnit(String(Number(value.toPrecision(7))).replace(".", DECIMAL), unit);
const isInRange = (value, { least, most }) => value >= least && value <= most;

function publish(topic, value) {
  const text = JSON.stringify(value);
  if (published.get(topic) === text) return;
  published.set(topic, text);
  bus.publish(topic, value);
}

function publishAll() {
  const machine = Object.fromEntries(parameters.map(({ key, scale }) => [key, values[key] * scale]));
  publish("machine/oscillator", { version: 1, parameters: { ...settings.machine, ...machine } });
  for (const { key } of parameters) publish(`exact/${key}`, { value: values[key], text: String(values[key]), judged });
}

note.addEventListener("click", () => (note.textContent = ""));

/** Set values, and show a message. A click on the message removes it. */
function set(changes, sentence = "") {
  Object.assign(values, changes);
  for (const [key, value] of Object.entries(changes)) {
    inputs[key].value = value;
    inputs[key].setAttribute("value", inputs[key].value);
  }
  note.textContent = sentence;
  publishAll();
}

/** Set a parameter from a text, or show which numbers are accepted and keep the old value. */
function setFromText(parameter, text) {
  const { key, symbol, least, most } = parameter, value = readNumber(text), readings = twoReadings(text);
  const old = asText(values[key], parameter);
  judged += 1;
  if (value === null) return set({}, fill(sentences.unreadable, { symbol, old }));
  if (readings) return set({}, fill(sentences.ambiguous, { text, decimal: readings[0], whole: readings[1], old }));
  if (isInRange(value, parameter)) return set({ [key]: value });
  const limits = { least: asText(least, { unit: "" }).trim(), most: asText(most, parameter) };
  set({}, fill(sentences.outside, { symbol, old, ...limits }));
}

/** Set the mass ratio: change m′, and also m if m′ would be outside of its range. */
function setRatio(ratio) {
  const [m, rollers] = ["m", "m_prime"].map((name) => parameters.find(({ key }) => key === name));
  const wanted = ratio * values.m, bound = Math.min(Math.max(wanted, rollers.least), rollers.most);
  if (wanted === bound) return set({ m_prime: wanted });
  const onStep = Number((Math.round(bound / ratio / m.step) * m.step).toPrecision(10));
  const mass = Math.min(Math.max(onStep, m.least), m.most);
  const limits = { old: asText(values.m, m), new: asText(mass, m), bound: asText(bound, rollers) };
  const sentence = fill(wanted > bound ? sentences.lighter : sentences.heavier, limits);
  set({ m: mass, m_prime: Math.min(Math.max(ratio * mass, rollers.least), rollers.most) }, sentence);
}

/** Mount one of the app's components in an element of this page. */
function mount(host, name, key, data, trigger = () => {}) {
  const inner = host.appendChild(document.createElement("div"));
  inner.dataset.testid = "stBidiComponentIsolated";
  const parentElement = inner.attachShadow({ mode: "open" });
  return begin({ name, key, data, parentElement, setTriggerValue: trigger, setStateValue: trigger });
}

// Settings after # in the address take precedence over those saved in the file.
const start = new URLSearchParams(dom.settings().size ? dom.settings() : document.documentElement.dataset.standalone);
const ignored = [];
for (const parameter of parameters) {
  const { key, least, most, step, label, head } = parameter, text = start.get(key), value = text && readNumber(text);
  const isValid = value !== null && isInRange(value, parameter);
  if (text && !isValid) ignored.push(parameter.ignored);
  values[key] = text && isValid ? value : parameter.default;
  if (!head) continue; // the radius has no slider
  const attributes = { min: least, max: most, step, value: values[key], label };
  const slider = makeSlider(key, attributes, (value) => set({ [key]: value }));
  const outer = document.querySelector(".sliders").appendChild(document.createElement("div"));
  const box = outer.appendChild(document.createElement("div"));
  box.className = `st-key-${key}_exact`;
  outer.append(slider);
  inputs[key] = slider.querySelector("input");
  mount(box, "components/exact", `${key}_exact`, head, (_event, typed) => setFromText(parameter, typed));
}
document.querySelector(".sliders").addEventListener("submit", (event) => event.preventDefault());
bus.subscribe("announce", ({ sentence }) => (live.textContent = sentence));
publishAll();
note.textContent = ignored.join(" ");
mount(document.querySelector(".st-key-stage"), "stage/stage", "stage", settings.stage);
mount(document.querySelector(".st-key-story"), "components/story", "story", settings.story);
drawCurve(document.querySelector(".curve"), settings.curve, setRatio);
addEventListener("hashchange", () => location.reload());
