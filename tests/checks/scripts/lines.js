// Returns the lines of all visible paragraphs as texts.
() => [...document.querySelectorAll(".stMarkdown :is(p, li), [data-testid=stCaptionContainer] p")]
  .filter((each) => each.checkVisibility() && !each.closest("[data-collapsed=true]")).flatMap((each) => {
    const lines = [], range = document.createRange();
    const texts = document.createTreeWalker(each, NodeFilter.SHOW_TEXT);
    for (let text = texts.nextNode(); text; text = texts.nextNode()) {
      if (text.parentElement.closest(".katex-mathml, .katex-display, [role=img]")) continue;
      [...text.data].forEach((letter, at) => {
        range.setStart(text, at);
        range.setEnd(text, at + letter.length);
        const { top, bottom, width } = range.getBoundingClientRect(), middle = (top + bottom) / 2;
        if (!width) return;
        const line = lines.find((line) => Math.abs(line.middle - middle) < 9);
        line ? (line.text += letter) : lines.push({ middle, text: letter });
      });
    }
    return lines.map(({ text }) => text.trim());
  })
