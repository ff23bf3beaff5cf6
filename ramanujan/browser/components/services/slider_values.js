// Writes the value above a slider's thumb with the decimal mark of the server's language and a minus sign (−).
// Streamlit writes a point, or the decimal mark of the browser's language.

import { DECIMAL } from "../../language.js";
import { sliders } from "../../sliders.js";

export default function (component, signal) {
  sliders.watchValues((text) => text.replace("-", "−").replace(".", DECIMAL), signal);
}
