// The choice of a language, and the menu *Share*. The menu copies the address, saves the machine as one file, or copies
// the code that embeds the file. Without HTTPS browsers deny the clipboard; the text is then shown for copying by hand.

import { address } from "../../page_address.js";
import { bus } from "../../bus.js";

const START = 'data-standalone=""'; // the attribute of the file for the machine's settings

export default function ({ data, parentElement }, signal) {
  // streamlit.css uses the width of this bar to place the names of the pages.
  const bar = parentElement.host?.closest(".st-key-bar");
  const { style } = document.documentElement;
  const sizes = new ResizeObserver(() => style.setProperty("--beside", `${bar.offsetWidth}px`));
  if (bar) sizes.observe(bar);
  signal.addEventListener("abort", () => sizes.disconnect());
  const [select, report, input] = parentElement.querySelectorAll("select, .report, input");
  select.hidden = !data.languages.length;
  select.replaceChildren(
    ...data.languages.map(({ lang, name, url_path: urlPath, is_active: isActive }) => {
      const option = new Option(name, urlPath, isActive, isActive);
      return Object.assign(option, { lang });
    }),
  );
  select.onchange = () => location.assign(select.value + location.pathname.split("/").pop() + location.search);

  const announce = (sentence) => {
    report.textContent = sentence;
    bus.publish("announce", { sentence, urgent: true });
  };
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      input.hidden = true;
      announce(data.copied);
    } catch {
      announce(data.by_hand);
      input.hidden = false;
      input.value = text;
      input.select();
    }
  }
  /** The settings in the address that the file accepts, as text. */
  function machineSettings() {
    const known = [...address.settings()].filter(([key]) => data.keys.includes(key));
    return String(new URLSearchParams(known));
  }
  const file = new URL(data.file, document.baseURI);
  /** The same address with the host for other computers, which cannot open `localhost`. */
  const forOthers = (url) => Object.assign(new URL(url), { host: data.host });
  const actions = {
    copy() {
      const url = forOthers(location.href); // a lecturer's keys are removed
      for (const key of data.private) if (url.searchParams.has(key)) url.searchParams.delete(key);
      copy(url.href);
    },
    async save() {
      try {
        const text = await (await fetch(file)).text();
        const start = START.replace('""', `"${machineSettings().replaceAll("&", "&amp;")}"`);
        const saved = URL.createObjectURL(new Blob([text.replace(START, () => start)], { type: "text/html" }));
        Object.assign(document.createElement("a"), { href: saved, download: data.file }).click();
        setTimeout(() => URL.revokeObjectURL(saved), 60000);
        announce(data.saved);
      } catch {
        announce(data.failed);
      }
    },
    embed() {
      const hash = machineSettings(), frame = document.createElement("iframe");
      const src = `${forOthers(file)}${hash && `#${hash}`}`;
      const attributes = { src, title: data.title, width: "100%", height: 800, style: "border:0" };
      for (const [name, value] of Object.entries(attributes)) frame.setAttribute(name, value);
      frame.setAttribute("sandbox", "allow-scripts allow-downloads");
      copy(frame.outerHTML);
    },
  };
  for (const button of parentElement.querySelectorAll("[data-do]")) button.onclick = () => actions[button.dataset.do]();
}
