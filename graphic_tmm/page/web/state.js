/** @typedef {import("./types.js").View} View */

/**
 * Where a person is: the way of looking, the view (its index), the picture (its number; its count: ready).
 * @typedef {{tab: string, view: number, picture: number}} Place
 */

/** The part of an address that stands for what belongs to all positions. */
const WHOLE = "all";

/**
 * What is looked at; the address of the page follows it, and it follows the address: #velocities/5/12.
 */
export class State {
  /**
   * @param {View[]} views
   * @param {string[]} tabs
   */
  constructor(views, tabs) {
    this.views = views;
    this.tabs = tabs;
    /** @type {Place} */
    this.place = { tab: tabs[0] ?? "play", view: 0, picture: 0 };
    /** @type {((place: Place, before: Place) => void)[]} */
    this.told = [];
    window.addEventListener("hashchange", () => this.follow());
  }

  /** @returns {View} */
  get view() {
    return /** @type {View} */ (this.views[this.place.view]);
  }

  /**
   * Be told of every change, and of what is there now.
   * @param {(place: Place, before: Place) => void} listener
   */
  hear(listener) {
    this.told.push(listener);
    listener(this.place, this.place);
  }

  /**
   * Go somewhere; what is left out stays.
   * @param {Partial<Place>} where
   */
  go(where) {
    const before = this.place;
    const view = Math.min(Math.max(where.view ?? before.view, 0), Math.max(this.views.length - 1, 0));
    const most = this.views[view]?.pictures.length ?? 0;
    const wanted = where.picture ?? (view === before.view ? before.picture : 0);
    this.place = {
      tab: this.tabs.includes(where.tab ?? "") ? (where.tab ?? "") : before.tab,
      view,
      picture: Math.min(Math.max(wanted, 0), most),
    };
    const address = this.address();
    if (location.hash !== address) history.replaceState(null, "", address);
    for (const listener of this.told) listener(this.place, before);
  }

  /** The address of the place. */
  address() {
    const view = this.views[this.place.view];
    const tab = this.place.tab === this.tabs[0] ? "" : `${this.place.tab}:`;
    if (view === undefined) return `#${tab}`;
    const parts = [view.plan, view.position || WHOLE, this.place.picture];
    return `#${tab}${parts.map((part) => encodeURIComponent(String(part))).join("/")}`;
  }

  /** Go where the address says; what it does not say stays. */
  follow() {
    const found = /^#(?:(\w+):)?(?:([^/]*)(?:\/([^/]*))?(?:\/(\d+))?)?$/.exec(location.hash);
    if (found === null) return this.go({});
    const [plan, position] = [found[2], found[3]].map((part) => decoded(part ?? ""));
    const view = this.views.findIndex(
      (one) => one.plan === plan && (one.position || WHOLE) === (position || one.position || WHOLE),
    );
    this.go({
      tab: found[1] ?? this.tabs[0] ?? "",
      view: view < 0 ? this.place.view : view,
      picture: view < 0 ? this.place.picture : Number(found[4] ?? 0),
    });
  }
}

/**
 * @param {string} part
 */
function decoded(part) {
  try {
    return decodeURIComponent(part);
  } catch {
    return "";
  }
}
