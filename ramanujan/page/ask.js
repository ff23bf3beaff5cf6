export default (component) => {
const app = (globalThis.ramanujan ??= {});
let end, left;
const begin = () => left || (end = app.begin(NAME, component));
app.begin ? begin() : (app.waiting ??= []).push(begin);
return () => ((left = true), end?.());
};
