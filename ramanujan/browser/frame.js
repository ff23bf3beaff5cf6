// Writes the browser's random name into the address of a page in a frame, before Streamlit connects.
//
// A browser sends no cookie of the app to a frame of another site (SameSite=Lax). The frame has a name of its own instead, in a
// cookie for this frame on this site alone (Partitioned), or in the frame's own storage, which also works over HTTP. If the
// browser allows neither, the name is "none". The start page contains this script; outside a frame it does nothing.

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
    const rules = `Max-Age=${lifetime}; Path=/; SameSite=None; Secure; Partitioned`;
    if (location.protocol === "https:" && !read()) document.cookie = `${key}=${newName()}; ${rules}`;
    return read();
  }

  function fromStorage() {
    const [name, since] = (localStorage.getItem(key) ?? "").split(" ");
    if (Date.now() - Number(since) < 1000 * lifetime) return name;
    const fresh = newName();
    localStorage.setItem(key, `${fresh} ${Date.now()}`);
    return fresh;
  }

  function unlessRefused(read) {
    try {
      return read();
    } catch {
      return undefined;
    }
  }

  const url = new URL(location.href);
  url.searchParams.set("frame", unlessRefused(fromCookie) ?? unlessRefused(fromStorage) ?? "none");
  history.replaceState(history.state, "", url);
})();
