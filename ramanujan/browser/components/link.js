// The button that copies the address of the page. Browsers keep the clipboard from pages that are not served securely:
// there the text itself is offered. Before it the languages, each with the place of its server: the rest of the address stays.

import { bus } from "./bus.js";

export default function ({ data, parentElement }, signal) {
  // The names of the pages have the room that the bar with this button leaves them.
  const bar = parentElement.host?.closest(".st-key-bar");
  const sizes = new ResizeObserver(() => document.documentElement.style.setProperty("--beside", `${bar.offsetWidth}px`));
  if (bar) sizes.observe(bar);
  signal.addEventListener("abort", () => sizes.disconnect());
  const [select, button, told, input] = parentElement.querySelectorAll("select, button, .told, input");
  select.hidden = !data.languages.length;
  select.replaceChildren(
    ...data.languages.map(({ lang, name, place, spoken }) => Object.assign(new Option(name, place, spoken, spoken), { lang })),
  );
  select.onchange = () => location.assign(select.value + location.pathname.split("/").pop() + location.search);
  const tell = (sentence) => {
    told.textContent = sentence;
    bus.publish("say", { sentence, urgent: true });
  };
  button.onclick = async () => {
    const url = new URL(location.href); // as others may have it
    for (const key of data.private) if (url.searchParams.has(key)) url.searchParams.delete(key);
    try {
      await navigator.clipboard.writeText(url.href);
      tell(data.copied);
    } catch {
      tell(data.by_hand);
      input.hidden = false;
      input.value = url.href;
      input.select();
    }
  };
}
