// One picture of the page at a time, for a projector. A page is a column of pieces: figures, stages, headings, paragraphs,
// formulas. They are put on sheets as high as the screen: a heading begins a sheet, a sheet has one figure or stage.

const AWAY = "data-away"; // projector.css takes such a piece out of sight; it keeps its size

export default function ({ data, parentElement }) {
  return live(parentElement, (signal) => new Pager(parentElement, data, signal)).end;
}

/** Put pieces on sheets, each { top, height, heading, figure, link }, with this much room. Pure. */
function sheetsOf(pieces, room) {
  const sheets = [];
  let sheet = null;
  for (const piece of pieces) {
    const bottom = piece.top + piece.height;
    const full = sheet && (bottom - sheet.top > room || (piece.figure && sheet.figure) || (piece.heading && sheet.body));
    if (!sheet || full) {
      // A link alone would leave a sheet empty: it takes the words before it along.
      const last = sheet?.pieces.at(-1), along = full && piece.link && sheet.pieces.length > 1 && !last.figure;
      if (along) sheet.pieces.pop();
      sheets.push((sheet = { top: (along ? last : piece).top, pieces: along ? [last] : [], figure: false, body: along }));
    }
    sheet.pieces.push(piece);
    sheet.figure ||= piece.figure;
    sheet.body ||= !piece.heading;
  }
  return sheets;
}

class Pager {
  constructor(root, words, signal) {
    Object.assign(this, { words, signal, sheets: [], now: 0, place: root.querySelector(".place") });
    [this.back, this.next] = root.querySelectorAll("button");
    root.querySelector(".pager").setAttribute("aria-label", words.label);
    for (const [button, by, name] of [[this.back, -1, words.back], [this.next, 1, words.next]]) {
      button.setAttribute("aria-label", name);
      button.addEventListener("click", () => this.turn(by), { signal });
    }
    // Bubbling up to the window: what the page itself does with a key comes first.
    window.addEventListener("keydown", (event) => this.press(event), { signal });
    window.addEventListener("resize", () => this.look(), { signal });
    const changes = new MutationObserver(() => this.look());
    changes.observe(document.body, { childList: true, subtree: true, attributes: true, attributeFilter: ["style", "hidden", "open"] });
    this.sizes = new ResizeObserver(() => this.look());
    bus.subscribe("turned", () => (this.now = 0), { signal }); // another stop of the lesson begins with its first sheet
    bus.publish("sheets", { has: (by) => Boolean(this.sheets[this.now + by]) });
    signal.addEventListener("abort", () => {
      bus.forget("sheets");
      changes.disconnect();
      this.sizes.disconnect();
      for (const node of document.querySelectorAll(`[${AWAY}]`)) node.removeAttribute(AWAY);
    });
    this.look();
  }

  /** Lay out anew in the next frame; what changes once changes often. */
  look() {
    this.waiting ||= requestAnimationFrame(() => {
      this.waiting = 0;
      if (!this.signal.aborted) this.layOut();
    });
  }

  layOut() {
    const all = hosts.pieces();
    // What takes no place may take some later: a stage is drawn when its script has come.
    for (const node of all) this.sizes.observe(node);
    const nodes = all.filter((node) => {
      const { width, height } = node.getBoundingClientRect();
      return width > 2 && height > 2;
    });
    if (!nodes.length) return;
    const page = location.pathname;
    if (page !== this.page) Object.assign(this, { page, now: 0 });
    let top = 0;
    const gap = parseFloat(getComputedStyle(document.documentElement).fontSize) / 2;
    const pieces = nodes.map((node) => {
      const height = node.getBoundingClientRect().height, piece = { node, top, height };
      top += height + gap;
      return { ...piece, heading: hosts.isHeading(node), figure: hosts.isPicture(node), link: hosts.isLink(node) };
    });
    this.sheets = sheetsOf(pieces, hosts.roomForPictures());
    this.show();
  }

  show() {
    this.now = Math.min(this.now, this.sheets.length - 1);
    const pieces = new Set(this.sheets.flatMap((sheet) => sheet.pieces.map(({ node }) => node)));
    // What was a piece of its own may be a part of a larger one now.
    for (const node of document.querySelectorAll(`[${AWAY}]`)) if (!pieces.has(node)) node.removeAttribute(AWAY);
    this.sheets.forEach((sheet, i) => sheet.pieces.forEach(({ node }) => node.toggleAttribute(AWAY, i !== this.now)));
    const text = fill(this.words.place, { now: this.now + 1, count: this.sheets.length });
    if (this.place.textContent !== text) this.place.textContent = text;
    this.back.disabled = this.now === 0;
    this.next.disabled = this.now === this.sheets.length - 1;
  }

  turn(by) {
    const to = Math.min(Math.max(this.now + by, 0), this.sheets.length - 1);
    if (to === this.now) return false;
    this.now = to;
    this.show();
    hosts.main()?.scrollTo(0, 0);
    return true;
  }

  press(event) {
    const by = turnOf(event, { PageDown: 1, PageUp: -1 });
    if (by && this.turn(by)) event.preventDefault();
  }
}
