export default (c) => {
const app = (globalThis.ramanujan ??= {});
let end;
const begin = () => (end ??= app.begin(NAME, c));
app.begin ? begin() : (app.waiting ??= []).push(begin);
return () => (end ??= () => {})();
};