// Returns the formulas that a line break separates from the punctuation mark after them.
() => [...document.querySelectorAll('[data-testid=stMain] .katex')].filter((formula) => {
  const after = formula.nextSibling;
  if (after?.nodeType !== Node.TEXT_NODE || !/^[.,;:!?]/.test(after.data) || !formula.checkVisibility()) return false;
  const sign = document.createRange();
  sign.setStart(after, 0);
  sign.setEnd(after, 1);
  const last = [...formula.querySelectorAll('.base')].at(-1).getBoundingClientRect();
  return sign.getBoundingClientRect().top >= last.bottom - 4;
}).map((formula) => formula.textContent)
