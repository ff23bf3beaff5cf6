// The bar's choice of a language and the menu *Share*: copy the address, save this machine as one file, copy the code that embeds
// the file. Browsers refuse the clipboard to pages that are not served securely: then the text is shown to be copied by hand.

import { bus } from "./bus.js";
import { dom } from "./streamlit_dom.js";

const START = 'data-standalone=""'; // the place for the saved machine in the file

export default function ({ data, parentElement }, signal) {
  // The names of the pages have the room that the bar with this button leaves them.
  const bar = parentElement.host?.closest(".st-key-bar");
  const sizes = new ResizeObserver(() => document.documentElement.style.setProperty("--beside", `${bar.offsetWidth}px`));
  if (bar) sizes.observe(bar);
  signal.addEventListener("abort", () => sizes.disconnect());
  const [select, told, input] = parentElement.querySelectorAll("select, .told, input");
  select.hidden = !data.languages.length;
  select.replaceChildren(
    ...data.languages.map(({ lang, name, place, spoken }) => Object.assign(new Option(name, place, spoken, spoken), { lang })),
  );
  select.onchange = () => location.assign(select.value + location.pathname.split("/").pop() + location.search);

  const report = (sentence) => {
    told.textContent = sentence;
    bus.publish("say", { sentence, urgent: true });
  };
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      input.hidden = true;
      report(data.copied);
    } catch {
      report(data.by_hand);
      input.hidden = false;
      input.value = text;
      input.select();
    }
  }
  /** The settings of the address that the file knows. */
  function machine() {
    const known = [...dom.settings()].filter(([key]) => data.keys.includes(key));
    return String(new URLSearchParams(known));
  }
  const file = new URL(data.file, document.baseURI);
  const actions = {
    copy() {
      const url = new URL(location.href); // without the keys of a lecturer
      for (const key of data.private) if (url.searchParams.has(key)) url.searchParams.delete(key);
      copy(url.href);
    },
    async save() {
      try {
        const text = await (await fetch(file)).text();
        const start = START.replace('""', `"${machine().replaceAll("&", "&amp;")}"`);
        const saved = URL.createObjectURL(new Blob([text.replace(START, () => start)], { type: "text/html" }));
        Object.assign(document.createElement("a"), { href: saved, download: data.file }).click();
        setTimeout(() => URL.revokeObjectURL(saved), 60000);
        report(data.saved);
      } catch {
        report(data.failed);
      }
    },
    embed() {
      const hash = machine(), frame = document.createElement("iframe");
      const attributes = { src: `${file}${hash && `#${hash}`}`, title: data.title, width: "100%", height: 800, style: "border:0" };
      for (const [name, value] of Object.entries(attributes)) frame.setAttribute(name, value);
      frame.setAttribute("sandbox", "allow-scripts allow-downloads");
      copy(frame.outerHTML);
    },
  };
  for (const button of parentElement.querySelectorAll("[data-do]")) button.onclick = () => actions[button.dataset.do]();
}
