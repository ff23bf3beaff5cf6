// Tells the server which of the values that it gave to the widgets have arrived; why it must know is in shell/pending_updates.py.
// A value has arrived when its slider shows it: what the page sends before then still carries the old one.

const LOOK = 50; // ms between two looks at the sliders
const LOOKS = 40; // after which a slider that shows something else is believed

let told = 0;

export default function ({ data, parentElement, setStateValue }) {
  const { begun, end } = live(parentElement, receipts);
  begun.receive(data, (number) => setStateValue("received", number));
  return end;
}

function receipts(signal) {
  let timer;
  signal.addEventListener("abort", () => clearTimeout(timer));

  const receive = (data, send) => {
    clearTimeout(timer);
    if (data.number <= told) return;
    const look = (left) => {
      if (left && !Object.entries(data.values).every(([key, value]) => hosts.shows(hosts.slider(key), value))) {
        timer = setTimeout(() => look(left - 1), LOOK);
        return;
      }
      told = data.number;
      send(told);
    };
    timer = setTimeout(() => look(LOOKS), LOOK);
  };
  return { receive };
}
