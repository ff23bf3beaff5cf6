// Reads numbers from a box by the rules of shell/parameters.py: a decimal or a fraction, with a point or a comma.

import { DECIMAL } from "../components/language.js";

const LONGEST = 60; // characters
const NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d{1,3})?(\/\d+([.,]\d*)?)?$/;
const OTHER_MARK = DECIMAL === "." ? "," : ".";
const MAYBE_THOUSANDS = new RegExp(`^[+-]?[1-9]\\d{0,2}\\${OTHER_MARK}\\d{3}$`);

/** Return the value of a text, or null. */
export function readNumber(text) {
  const trimmed = text.trim();
  if (trimmed.length > LONGEST || !NUMBER.test(trimmed)) return null;
  const [numerator, denominator = 1] = trimmed.replaceAll(",", ".").split("/").map(Number);
  const value = numerator / denominator;
  return Number.isFinite(value) ? value : null;
}

/** Return the decimal and the integer that an ambiguous text can mean, or null. */
export function twoReadings(text) {
  const parts = text.trim().split("/");
  const withMark = (mark) =>
    parts.map((part) => (MAYBE_THOUSANDS.test(part) ? part.replace(OTHER_MARK, mark) : part)).join("/");
  return withMark(DECIMAL) === withMark("") ? null : [withMark(DECIMAL), withMark("")];
}
