// Marks the address of a page in a frame, before Streamlit connects. In a frame of another site, browsers do not send
// the app's cookie (SameSite=Lax), so a class needs a new tab. In a sandboxed frame without allow-same-origin Streamlit
// cannot start; the frame then shows the sentence for a browser without scripts. The start page contains this script.

if (self.origin === "null") {
  addEventListener("DOMContentLoaded", () => {
    document.body.innerHTML = document.querySelector("noscript").textContent;
  });
} else if (window !== window.top) {
  const url = new URL(location.href);
  url.searchParams.set("frame", "on");
  history.replaceState(history.state, "", url);
}
