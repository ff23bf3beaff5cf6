// Reads what a person types into a box, by the rules of shell/parameters.py: a decimal or a fraction, with a point or a comma.

import { DECIMAL } from "../components/language.js";

const LONGEST = 60; // characters
const NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d{1,3})?(\/\d+([.,]\d*)?)?$/;
const OTHER_MARK = DECIMAL === "." ? "," : ".";
const MAYBE_THOUSANDS = new RegExp(`^[+-]?[1-9]\\d{0,2}\\${OTHER_MARK}\\d{3}$`);

/** The value of a text, or null. */
export function readNumber(text) {
  const written = text.trim();
  if (written.length > LONGEST || !NUMBER.test(written)) return null;
  const [numerator, denominator = 1] = written.replaceAll(",", ".").split("/").map(Number);
  const value = numerator / denominator;
  return Number.isFinite(value) ? value : null;
}

/** How an ambiguous text can be written as a decimal and as a whole number, or null if it is clear. */
export function twoReadings(text) {
  const parts = text.trim().split("/");
  const written = (mark) =>
    parts.map((part) => (MAYBE_THOUSANDS.test(part) ? part.replace(OTHER_MARK, mark) : part)).join("/");
  return written(DECIMAL) === written("") ? null : [written(DECIMAL), written("")];
}
