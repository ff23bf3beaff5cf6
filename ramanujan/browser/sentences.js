// Fills templates of sentences, which come from Python, and writes numbers by the rules of numerals.py. A number has
// significant digits, a thin space between groups of digits and before a unit, a minus sign (−), and a power of ten.

import { DECIMAL } from "./language.js";

const THIN = "\u202f";

/** Put values into the slots of a template. */
export const fill = (template, values) => template.replace(/\{(\w+)\}/g, (_, name) => values[name]);

/** Write a number with a fixed number of decimal places. */
export const fixed = (value, places) => {
  const [whole, decimals] = Math.abs(value).toFixed(places).split(".");
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, THIN) : whole;
  return `${value < 0 ? "−" : ""}${grouped}${decimals ? DECIMAL + decimals : ""}`;
};

/** Write a number with a number of significant digits. */
export const number = (value, precision = 2) => {
  if (!value) return "0";
  const [mantissa, exponent] = Math.abs(value).toExponential(precision - 1).split("e"), power = Number(exponent);
  const rounded = Number(`${value < 0 ? "-" : ""}${mantissa}e${power}`);
  if (power >= -4 && power < 6) return fixed(rounded, Math.max(precision - 1 - power, 0));
  const raised = [...String(power)].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit] ?? "⁻").join("");
  const size = String(Number(mantissa)).replace(".", DECIMAL);
  return `${value < 0 ? "−" : ""}${size === "1" ? "" : `${size}×`}10${raised}`;
};

/** Append a unit to the text of a number. */
export const withUnit = (text, unit) => `${text}${THIN}${unit}`;
