// Writes a random name of the browser into the address of a page in a frame, before Streamlit connects.
//
// In a frame on another site, browsers do not send the app's cookie (SameSite=Lax). The name in the address replaces that cookie.
// The name is stored in a partitioned cookie, which only this frame on this site receives. If that fails, it is stored in the
// frame's storage, which also works over HTTP. If the browser allows neither, the name is "none". The start page contains this
// script; outside a frame it does nothing.

(() => {
  if (window === window.top) return;
  const key = "ramanujan_frame";
  const lifetime = 30 * 24 * 3600; // seconds

  function newName() {
    const bytes = crypto.getRandomValues(new Uint8Array(12));
    return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
  }

  function fromCookie() {
    const read = () => document.cookie.match(`${key}=([0-9a-f]{24})`)?.[1];
    const attributes = `Max-Age=${lifetime}; Path=/; SameSite=None; Secure; Partitioned`;
    if (location.protocol === "https:" && !read()) document.cookie = `${key}=${newName()}; ${attributes}`;
    return read();
  }

  function fromStorage() {
    const [name, created] = (localStorage.getItem(key) ?? "").split(" ");
    if (Date.now() - Number(created) < 1000 * lifetime) return name;
    const freshName = newName();
    localStorage.setItem(key, `${freshName} ${Date.now()}`);
    return freshName;
  }

  function tryRead(read) {
    try {
      return read();
    } catch {
      return undefined;
    }
  }

  const url = new URL(location.href);
  url.searchParams.set("frame", tryRead(fromCookie) ?? tryRead(fromStorage) ?? "none");
  history.replaceState(history.state, "", url);
})();
