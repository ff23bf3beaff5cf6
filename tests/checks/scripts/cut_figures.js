// Returns the texts of figures outside of the figure's frame.
() => [...document.querySelectorAll(".js-plotly-plot")]
  .filter((figure) => figure.checkVisibility({ visibilityProperty: true })).flatMap((figure) => {
    const frame = figure.getBoundingClientRect();
    const isOutside = ({ top, bottom, left, right, width }) => width
      && Math.max(frame.top - top, bottom - frame.bottom, frame.left - left, right - frame.right) > 2;
    const texts = [...figure.querySelectorAll("text")].filter((text) => isOutside(text.getBoundingClientRect()));
    return texts.map((text) => text.textContent);
  })
