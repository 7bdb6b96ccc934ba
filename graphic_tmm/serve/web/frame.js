import { element } from "../../page/web/dom.js";

/** @typedef {import("./types.js").State} State */
/** @typedef {import("./types.js").Words} Words */

/** The page of the scene in a frame: made when it is looked at first, made anew behind the one before it. */
export class PageFrame {
  /**
   * @param {Words} words
   * @param {string} place where it is to begin: the part of its address behind #
   * @param {() => void} again has it drawn once more
   * @param {((values: string) => Promise<string>) | null} put takes values that were changed in it, as TOML, and
   *   returns what is said of that; null where they cannot be put anywhere
   */
  constructor(words, place, again, put) {
    this.words = words;
    this.put = put;
    this.begin = place;
    /** The page that there is, and whether somebody looks at it. */
    this.hash = "";
    this.seen = false;
    /** @type {HTMLIFrameElement | null} */
    this.frame = null;
    /** @type {HTMLIFrameElement | null} */
    this.next = null;
    this.nothing = element("p", { class: "hint" }, words["no page"] ?? "");
    this.again = element("button", { type: "button", class: "again" }, words["again"] ?? "");
    this.again.addEventListener("click", again);
    this.old = element("p", { class: "old" }, element("span", {}, words["page old"] ?? ""), this.again);
    this.old.hidden = true;
    this.element = element("div", { class: "frame" }, this.old, this.nothing);
  }

  /** The place in the page that is looked at. */
  get place() {
    return this.frame?.contentWindow?.location.hash || this.begin;
  }

  /**
   * Take notice of a page; where it could not be made anew it says that it is of before.
   * @param {State} state
   */
  show({ page, ok, busy, failed }) {
    this.nothing.textContent = this.words[ok || busy ? "no page" : "page failed"] ?? "";
    this.hash = page ?? this.hash;
    this.old.hidden = ok || busy || this.hash === "";
    this.again.hidden = failed === "";
    this.load();
  }

  /**
   * Take notice of somebody who looks, or looks away.
   * @param {boolean} seen
   */
  look(seen) {
    this.seen = seen;
    this.load();
  }

  load() {
    const address = `page/${this.hash}.html`;
    if (!this.seen || this.hash === "" || (this.next ?? this.frame)?.dataset["hash"] === this.hash) return;
    this.next?.remove();
    const made = document.createElement("iframe");
    made.title = this.words["page of"] ?? "";
    made.dataset["hash"] = this.hash;
    made.className = "coming";
    made.src = address + this.place;
    made.addEventListener("load", () => this.swap(made));
    this.next = made;
    this.element.append(made);
  }

  /** Make the page as dark as the studio, if a person said how dark that is. */
  dress() {
    const theme = document.documentElement.dataset["theme"];
    const inner = this.frame?.contentDocument?.documentElement;
    if (theme !== undefined && inner) inner.dataset["theme"] = theme;
  }

  /**
   * Let the page offer to put what is changed in it into the scene; it tells that by an event, and hears by one.
   * @param {Document | null} page
   */
  offer(page) {
    const { put } = this;
    if (page === null || put === null) return;
    page.documentElement.dataset["scene"] = "";
    page.addEventListener("own values", async (event) => {
      const says = await put(String(/** @type {CustomEvent} */ (event).detail));
      page.dispatchEvent(new CustomEvent("own values put", { detail: says }));
    });
  }

  /** @param {HTMLIFrameElement} made */
  swap(made) {
    if (made !== this.next) return;
    const focused = document.activeElement === this.frame && this.frame !== null;
    const place = this.place;
    const before = this.frame?.contentDocument ?? null;
    if (made.contentWindow !== null && made.contentWindow.location.hash !== place && place !== "") {
      made.contentWindow.location.replace(place);
    }
    this.frame?.remove();
    this.frame = made;
    this.next = null;
    made.className = "";
    this.nothing.hidden = true;
    made.contentDocument?.documentElement.classList.add("framed");
    this.dress();
    this.offer(made.contentDocument);
    handOn(before, made.contentDocument);
    if (focused) made.contentWindow?.focus();
  }
}

/**
 * Hand on what a person has changed in a page to the page that takes its place.
 * @param {Document | null} before
 * @param {Document | null} page
 */
function handOn(before, page) {
  const own = before?.documentElement.dataset["own"];
  if (own === undefined || page === null) return;
  page.documentElement.dataset["own"] = own;
  page.dispatchEvent(new CustomEvent("own values left"));
}
