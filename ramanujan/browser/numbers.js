// Reads typed numbers by the rules of text/reading.py, whose comments explain them.

const UNSIGNED = "(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)";
const NUMBER = RegExp(`^([+-]?${UNSIGNED}(?:[eE][+-]?[0-9]{1,3})?)(?: */ *(${UNSIGNED}))?$`);
const MAYBE_THOUSANDS = {
  ".": /(?:^|[^0-9.,])([1-9][0-9]{0,2}),([0-9]{3})(?![0-9.,])/,
  ",": /(?:^|[^0-9.,])([1-9][0-9]{0,2})\.([0-9]{3})(?![0-9.,])/,
};

const normalize = (text) =>
  text
    .replace(/[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+/g, "^")
    .replace(/([0-9])\u202f(?=[0-9]{3})/g, "$1")
    .replace(/[½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞]/g, " $& ")
    .replace(/\p{Cf}/gu, "")
    .normalize("NFKD")
    .replace(/[\p{Pd}−]/gu, "-")
    .replace(/[÷∕⁄:∶]/g, "/")
    .trim();

/**
 * Return the value of a text, or null. `decimalMark` never separates thousands: it is that of the language, or the
 * point of links.
 */
export function readNumber(text, decimalMark = ".") {
  const match = NUMBER.exec(normalize(text));
  if (!match || twoReadings(text, decimalMark)) return null;
  const [numerator, denominator] = match.slice(1).map((part = "1") => Number(part.replace(",", ".")));
  const value = numerator / denominator;
  return Number.isFinite(value) ? value : null;
}

/** Return the first ambiguous number in a text with its two readings, or null. */
export function twoReadings(text, decimalMark = ".") {
  const match = MAYBE_THOUSANDS[decimalMark].exec(normalize(text));
  if (!match) return null;
  const [, before, after] = match, otherMark = decimalMark === "." ? "," : ".";
  return { text: before + otherMark + after, decimal: before + decimalMark + after, whole: before + after };
}
