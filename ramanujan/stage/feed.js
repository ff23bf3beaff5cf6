// Carries the numbers of a machine from Python to its stage; it has no content of its own.

export default function ({ data, parentElement }) {
  const { end } = live(parentElement, (signal) => signal.addEventListener("abort", () => bus.forget(`machine/${data.stage}`)));
  bus.publish(`machine/${data.stage}`, data.payload);
  return end;
}
