// Tells the server which of the values that it gave to the widgets have arrived; why it must know is in scenes/given.py.

let told = 0;

export default function ({ data, setStateValue }) {
  if (data.number <= told) return;
  told = data.number;
  setStateValue("received", data.number);
}
