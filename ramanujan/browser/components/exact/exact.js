// The head of a slider: symbol, meaning and box. The box shows the value, with all its digits while it has the focus,
// and accepts any number or fraction. Only the slider stores the value. The box shows the slider's value, also during a
// drag, and sends each typed text to the server. When slider and server agree, the value is written into the address.

import { address } from "../../page_address.js";
import { bus } from "../../bus.js";
import { DECIMAL } from "../../language.js";
import { dom } from "../../streamlit_dom.js";
import { makeSetter } from "./snap.js";
import { observe } from "../../lasting.js";
import { readNumber } from "../../numbers.js";
import { sliders } from "../../sliders.js";

const DIGITS = 5; // the most significant digits without the focus
const firstDigits = new Intl.NumberFormat("en", {
  maximumSignificantDigits: DIGITS, roundingMode: "trunc", useGrouping: false,
});

/** Return a number with at most five digits, and dots for the others, because the rounded number is not in step. */
const shorten = (text) => (Number(Number(text).toPrecision(DIGITS)) === Number(text) ? text
  : `${firstDigits.format(text)}…`);

export default function (component, signal) {
  const { data: { key }, parentElement: root } = component, box = root.querySelector("input");
  box.id = root.querySelector("label").htmlFor = "box";

  const send = (text) => component.setTriggerValue("typed", text);
  // In some languages, a point before three digits would be a thousands separator, so send the decimal mark.
  const sendValue = (text) => send(text.replace(".", DECIMAL));
  const goals = () => component.data.snap_ratios.map((ratio) => ratio * sliders.value("m"));
  /** The last data from the server: value, text, and `processed`, the number of processed inputs. */
  const received = () => bus.last(`exact/${key}`) ?? {};

  /** Return the text of the value: all its digits, or fewer without the focus. */
  const read = (hasFocus) => {
    const { value, text: stored = "" } = received();
    const text = sliders.shows(key, value) ? stored : String(sliders.value(key));
    return (hasFocus || !text ? text : shorten(text)).replace(".", DECIMAL);
  };
  const write = () => {
    const hasFocus = root.activeElement === box, before = box.value;
    box.value = box.dataset.shown = read(hasFocus);
    if (hasFocus && box.value !== before) box.select(); // typing still replaces the whole number
  };
  /** Show all digits of the value, or fewer. A typed text remains until the server has processed it. */
  const changeDigits = () => {
    if ([read(true), read(false)].includes(box.value)) write();
  };
  const show = () => {
    // Streamlit's server always writes the complete address, which can be older than the slider.
    const { value } = received(), isCurrent = sliders.shows(key, value);
    if (isCurrent && value !== undefined) address.writeSettings([[key, value, component.data.default]]);
    showTrack(isCurrent);
    const isEdited = root.activeElement === box && box.value !== box.dataset.shown;
    if (!isEdited) write();
  };
  /** Show the values up to a multiple of m, or all values for a larger one. The track changes only at rest. */
  const showTrack = (isCurrent) => {
    const ratio = component.data.shown_ratio, m = sliders.value("m"), slider = sliders.find(key);
    if (!ratio || !m || !slider || sliders.isDragged(slider)) return;
    const isBeyond = sliders.value(key) > ratio * m;
    if (isCurrent || isBeyond) sliders.showUpTo(slider, isBeyond ? slider.max : ratio * m);
  };
  const sendTyped = () => {
    if (box.value === box.dataset.shown) return;
    const text = box.dataset.shown = box.value;
    const value = readNumber(text, DECIMAL);
    if (value !== null) set(value);
    send(text);
  };
  /** Move the thumb to the value of a pressed preset. The server sets it, and may also change m. */
  const followPreset = ({ target }) => {
    const { reset, ratios } = component.data, preset = dom.preset(target);
    if (preset && preset === reset.label) set(reset.value);
    if (!ratios?.[preset]) return;
    set(ratios[preset] * sliders.value("m"));
    if (sliders.wanted(key) === undefined) sliders.forget("m");
  };
  const set = makeSetter(key, { goals, sendText: sendValue, show }, signal);

  // Streamlit draws the slider after its head, and may redraw it.
  observe(document.body, { subtree: true, attributeFilter: ["value", "aria-valuetext"] }, show, signal);
  document.addEventListener("click", followPreset, { capture: true, signal });
  box.addEventListener("change", sendTyped);
  box.addEventListener("focus", () => {
    changeDigits();
    box.select(); // a copy contains all digits, and typing replaces them
  });
  box.addEventListener("blur", changeDigits);
  box.addEventListener("keydown", (event) => {
    if (event.key === "Enter") sendTyped();
    if (event.key !== "Escape") return;
    write();
    box.select();
  });
  bus.subscribe(`exact/${key}`, show, { signal });
  bus.subscribe(`enter/${key}`, (text) => {
    bus.forget(`enter/${key}`);
    set(Number(text));
    sendValue(text);
  }, { signal });

  return () => {
    const { symbol, unit, meaning, label, longest } = component.data;
    const texts = { ".symbol": symbol, ".unit": `[${unit}]`, small: meaning };
    for (const [selector, text] of Object.entries(texts)) root.querySelector(selector).textContent = text;
    Object.assign(box, { maxLength: longest, ariaLabel: label });
    show();
  };
}
