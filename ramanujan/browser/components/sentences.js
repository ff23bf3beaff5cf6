// Sentences come from Python as templates with named slots, and numbers are written here by the rules of numerals.py: so many
// significant digits, a thin space between groups of digits and before a unit, a true minus sign, powers of ten.

import { DECIMAL } from "./language.js";

const THIN = "\u202f";

/** Put values into the slots of a template. */
export const fill = (template, values) => template.replace(/\{(\w+)\}/g, (_, name) => values[name]);

/** A number with so many decimal places. */
export const fixed = (value, places) => {
  const [whole, decimals] = Math.abs(value).toFixed(places).split(".");
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, THIN) : whole;
  return `${value < 0 ? "−" : ""}${grouped}${decimals ? DECIMAL + decimals : ""}`;
};

/** A number with so many significant digits. */
export const number = (value, precision = 2) => {
  if (!value) return "0";
  const [mantissa, exponent] = Math.abs(value).toExponential(precision - 1).split("e"), power = Number(exponent);
  const rounded = Number(`${value < 0 ? "-" : ""}${mantissa}e${power}`);
  if (power >= -4 && power < 6) return fixed(rounded, Math.max(precision - 1 - power, 0));
  const raised = [...String(power)].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit] ?? "⁻").join("");
  const size = String(Number(mantissa)).replace(".", DECIMAL);
  return `${value < 0 ? "−" : ""}${size === "1" ? "" : `${size}×`}10${raised}`;
};

/** A number that is text already with its unit. */
export const withUnit = (text, unit) => `${text}${THIN}${unit}`;
