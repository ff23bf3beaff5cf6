// Reads numbers from a box by the rules of shell/parameters.py: a decimal or a fraction, with a point or a comma.

const NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d{1,3})?(\/\d+([.,]\d*)?)?$/;

/** Return the value of a text, or null. */
export function readNumber(text) {
  if (!NUMBER.test(text.trim())) return null;
  const [numerator, denominator = 1] = text.replaceAll(",", ".").split("/").map(Number);
  const value = numerator / denominator;
  return Number.isFinite(value) ? value : null;
}
