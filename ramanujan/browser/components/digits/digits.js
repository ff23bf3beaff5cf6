// A slider over samples that Python has computed. `mount` in __init__.py documents the data.

const cell = (kind, content = "") => `<td class="${kind}">${content}</td>`;

export default function (component, signal) {
  const root = component.parentElement, find = (selector) => root.querySelector(selector);
  const slider = find("input"), output = find("output"), note = find("p");

  function show() {
    const { samples, notes, all } = component.data, [text, rows, number] = samples[slider.value];
    output.textContent = text;
    slider.setAttribute("aria-valuetext", text);
    rows.forEach(([step, right, wrong, power, digits], i) => {
      const row = find("tbody").rows[i], set = (selector, shown) => (row.querySelector(selector).textContent = shown);
      set(".step", step);
      set(".right", right);
      set(".wrong", wrong);
      set(".power", power);
      set(".count span", digits ?? "");
      row.classList.toggle("lost", digits === 0);
      row.style.setProperty("--share", digits === null ? 0 : digits / all);
    });
    if (note.textContent !== notes[number]) note.textContent = notes[number];
  }

  slider.addEventListener("input", show, { signal });
  return () => {
    const { label, start, locked, head, rows, samples } = component.data;
    find("label span").textContent = label;
    find("thead tr").innerHTML = head.map((title) => `<th scope="col">${title}</th>`).join("");
    const value = '<span class="right"></span><span class="wrong"></span><span class="power"></span>';
    const cells = cell("step") + cell("value", value) + cell("count", "<i></i><span></span>");
    const body = rows.map((formula) => `<tr><th scope="row">${formula}</th>${cells}</tr>`);
    find("tbody").innerHTML = body.join("");
    slider.max = samples.length - 1;
    if (slider.dataset.label !== label) slider.value = start;
    slider.dataset.label = label;
    slider.hidden = locked;
    show();
  };
}
