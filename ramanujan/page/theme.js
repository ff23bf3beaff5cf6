// Notices that the theme has been switched, and asks for a run of the page: figures take their colours on the server.
// Streamlit calls this function again whenever the theme changes.

export default function ({ data, parentElement, setTriggerValue }) {
  const { begun, end } = live(parentElement, () => ({ asked: null }));
  const shown = hosts.theme(parentElement);
  // Once for each switch: a server that gives another answer is not asked for ever.
  if (shown === data.theme) begun.asked = null;
  else if (shown && shown !== begun.asked) {
    begun.asked = shown;
    setTriggerValue("switched", shown);
  }
  return end;
}
