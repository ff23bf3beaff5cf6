// The settings in the page's address, and the entries of the browser's history. Each setting has one writer: Streamlit
// and exact.js for a slider, keeper.js for the view of a stage, and the server (shell/address.py) for all others.
// Scripts write the address only with this module, except frame.js, which runs before any module.

const STANDALONE = "standalone" in document.documentElement.dataset;

export const address = {
  /** The settings in the address: after ? in the app, after # in the standalone file. */
  settings: () => new URLSearchParams(STANDALONE ? location.hash.slice(1) : location.search),

  /** Write settings into the address; an entry is [key, value, default]. Omit a value that equals its default. */
  writeSettings(entries) {
    const settings = address.settings();
    for (const [key, value, byDefault] of entries)
      value === byDefault ? settings.delete(key) : settings.set(key, value);
    if (String(settings) !== String(address.settings())) address.replaceSettings(settings);
  },

  /** Write these settings into the address, and remove all others. */
  replaceSettings(settings) {
    const url = new URL(location.href);
    url.search = settings;
    // An empty # differs from no #: a saved file then begins with the defaults.
    history.replaceState(history.state, "", STANDALONE ? `#${settings}` : url);
    // A browser that saves the page does not save what follows #.
    if (STANDALONE) document.documentElement.dataset.standalone = settings;
  },

  /**
   * Add at most one entry to the browser's history per action of the reader. Streamlit adds one for every value that
   * its server writes into the address (streamlit#9279). The way back to another page would then have several steps,
   * some with a mixture of two machines.
   */
  limitHistory() {
    let hasActed = false;
    // A screen reader can click without a pointer or a key.
    for (const type of ["pointerdown", "keydown", "click"])
      addEventListener(type, () => (hasActed = true), { capture: true });
    const push = history.pushState.bind(history);
    history.pushState = (...entry) => {
      hasActed ? push(...entry) : history.replaceState(...entry);
      hasActed = false;
    };
  },
};
