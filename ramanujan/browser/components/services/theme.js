// Sets the theme's colours for page.css; Streamlit provides them only to components. Every other rule overrides a rule
// of a layer, so print.css and contrast.css can replace the colours. After a switch of the theme this module requests a
// rerun of the page, because the server draws the figures.

import { dom } from "../../streamlit_dom.js";

const PAUSE = 400; // ms until the request, because a rerun right after the switch still has the old theme
const COLORS = {
  paper: "background", under: "secondary-background", faint: "border", primary: "primary",
  gray: "gray", orange: "orange", blue: "blue", green: "green", violet: "violet", red: "red",
};
const ATTEMPTS = 5; // largest number of requests after a switch
const sheet = new CSSStyleSheet();
document.adoptedStyleSheets.push(sheet);

export default function (component, signal) {
  let timer = 0, attempts = 0;
  const requestRerun = () => {
    const theme = dom.theme(component.parentElement);
    if (!theme || theme === component.data.theme || attempts >= ATTEMPTS) return;
    attempts += 1;
    component.setTriggerValue("switched", `${theme} ${attempts}`);
    timer = setTimeout(requestRerun, 4 * PAUSE);
  };
  signal.addEventListener("abort", () => clearTimeout(timer));
  return () => {
    document.documentElement.dataset.theme = component.data.theme;
    // Read the colours after the page has been drawn; reading them earlier would compute all styles twice.
    requestAnimationFrame(() => setTimeout(setColors, 0, component.parentElement));
    attempts = 0;
    clearTimeout(timer);
    timer = setTimeout(requestRerun, PAUSE);
  };
}

function setColors(parentElement) {
  const declare = ([name, streamlitName]) => `--${name}: ${dom.color(parentElement, streamlitName)};`;
  const colors = Object.entries(COLORS).map(declare);
  sheet.replaceSync(`@layer theme { :root { ${colors.join(" ")} } }`);
}
