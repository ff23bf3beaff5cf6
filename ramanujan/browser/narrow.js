// Whether the rules of the style sheets for a narrow screen apply. In the projector view they do not, at any width: a
// desktop at 150 % has only 853×480 pixels, but the page on it is not on a phone.

const LIMITS = [[/\b999px/g, "0.999px"], [/\b1000px/g, "1px"]]; // the limits of these rules, and limits below any width
const BACK = [[/\b0\.999px/g, "999px"], [/\b1px/g, "1000px"]];

let areOff = false;

function replaceLimits(rules) {
  for (const rule of rules) {
    if (rule instanceof CSSMediaRule) {
      for (const [limit, other] of areOff ? LIMITS : BACK) {
        rule.media.mediaText = rule.media.mediaText.replace(limit, other);
      }
    }
    replaceLimits(rule.cssRules ?? []);
  }
}

const replaceIn = (root) => [...root.styleSheets].forEach((sheet) => replaceLimits(sheet.cssRules));
const rootsOfComponents = () => [...document.querySelectorAll("*")].flatMap(({ shadowRoot }) => shadowRoot ?? []);

export const narrow = {
  /** Switch the rules for a narrow screen on or off, in the page and in its components. */
  setOff(value) {
    if (value === areOff) return;
    areOff = value;
    [document, ...rootsOfComponents()].forEach(replaceIn);
  },

  /** Apply the switch to the style sheets of a new component. */
  apply(component) {
    if (areOff && component.styleSheets) replaceIn(component);
  },
};
