// Reads numbers from a box by the rules of shell/parameters.py: a decimal or a fraction, with a point or a comma.

import { DECIMAL } from "../components/language.js";

const NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d{1,3})?(\/\d+([.,]\d*)?)?$/;
// A decimal mark of another language before three digits, which may separate thousands.
const MAYBE_THOUSANDS = new RegExp(`(?<=(?:^[+-]?|/)[1-9]\\d{0,2})\\${DECIMAL === "." ? "," : "."}(?=\\d{3}(?:/|$))`, "g");

/** Return the value of a text, or null. */
export function readNumber(text) {
  if (!NUMBER.test(text.trim())) return null;
  const [numerator, denominator = 1] = text.replaceAll(",", ".").split("/").map(Number);
  const value = numerator / denominator;
  return Number.isFinite(value) ? value : null;
}

/** Return the decimal and the integer that an ambiguous text can mean, or null. */
export function twoReadings(text) {
  const [decimal, whole] = [DECIMAL, ""].map((mark) => text.trim().replace(MAYBE_THOUSANDS, mark));
  return decimal === whole ? null : [decimal, whole];
}
