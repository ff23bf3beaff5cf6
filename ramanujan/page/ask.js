export default (c) => {
const app = (globalThis.ramanujan ??= {});
let end, left;
const begin = () => left || (end = app.begin(NAME, c));
app.begin ? begin() : (app.waiting ??= []).push(begin);
return () => ((left = 1), end?.());
};
