/** @typedef {import("./types.js").View} View */

/**
 * Where a person is: the way of looking, the view (its index), the picture (its number; its count: ready), the
 * angle of the crank in degrees, whether steps follow by themselves.
 * @typedef {{tab: string, view: number, picture: number, turn: number, running: boolean}} Place
 */

/** The part of an address that stands for what belongs to all positions. */
const WHOLE = "all";
/** After so long an angle is written into the address, and what a browser refused is tried again, ms. */
const LATER = 500;

/**
 * What is looked at, in one place for all ways of looking.
 *
 * `go({picture: 3})` changes what is named and leaves the rest; what is beyond the ends is the end; who goes to a
 * picture without saying `running: true` stops what runs. It tells every
 * listener, `hear((place, before) => …)`, of each change, and at once of what is there; a way of looking that is
 * not `place.tab` has nothing to show then. The address follows: #velocities/5/12, #lecture:velocities/5/12,
 * #crank:velocities/5/12@137.5. Another tab or view is a new entry of the browser's history, a step or an angle
 * changes the present one; back, forward and a link that is followed go where the address says.
 */
export class State {
  /**
   * @param {View[]} views
   * @param {string[]} tabs
   * @param {number} [turn] where the crank stands if nobody says, degrees
   */
  constructor(views, tabs, turn = 0) {
    this.views = views;
    this.tabs = tabs;
    this.rest = turn;
    /** @type {Place} */
    this.place = { tab: tabs[0] ?? "play", view: 0, picture: 0, turn, running: false };
    /** @type {((place: Place, before: Place) => void)[]} */
    this.told = [];
    this.timer = 0;
    /** Whether the address itself says which picture, or position, is meant. */
    this.named = false;
    window.addEventListener("hashchange", () => this.follow());
    window.addEventListener("pagehide", () => {
      if (this.timer !== 0) this.note();
    });
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
    this.named = false;
    const after = this.within(where);
    if (after.tab !== this.place.tab || after.view !== this.place.view) this.leave(after);
    else this.arrive(after);
  }

  /**
   * Return a place with what is left out as it is, within the ends.
   * @param {Partial<Place>} where
   * @returns {Place}
   */
  within(where) {
    const before = this.place;
    const view = between(where.view ?? before.view, this.views.length - 1);
    const wanted = where.picture ?? (view === before.view ? before.picture : 0);
    const still = where.picture === undefined && where.tab === undefined;
    return {
      tab: where.tab !== undefined && this.tabs.includes(where.tab) ? where.tab : before.tab,
      view,
      picture: between(wanted, this.views[view]?.pictures.length ?? 0),
      turn: where.turn ?? before.turn,
      running: where.running ?? (still && before.running),
    };
  }

  /**
   * Leave for another tab or view: the place left stays in the history as it was.
   * @param {Place} after
   */
  leave(after) {
    this.note();
    const before = this.place;
    this.place = after;
    if (!record("pushState", this.address())) this.noteLater();
    for (const listener of this.told) listener(after, before);
  }

  /**
   * @param {Place} after
   */
  arrive(after) {
    const before = this.place;
    this.place = after;
    if (after.turn === before.turn) this.note();
    else this.noteLater();
    for (const listener of this.told) listener(after, before);
  }

  /** Let the address say what is there; a browser refuses to write it hundreds of times in seconds. */
  note() {
    window.clearTimeout(this.timer);
    this.timer = 0;
    if (!record("replaceState", this.address())) this.noteLater();
  }

  /** Let the address say soon what is there then. */
  noteLater() {
    if (this.timer === 0) this.timer = window.setTimeout(() => this.note(), LATER);
  }

  /** The address of the place. */
  address() {
    const view = this.views[this.place.view];
    const tab = this.place.tab === this.tabs[0] ? "" : `${this.place.tab}:`;
    if (view === undefined) return `#${tab}`;
    const parts = [view.plan, view.position || WHOLE, this.place.picture];
    const turn = this.place.turn === this.rest ? "" : `@${Number(this.place.turn.toFixed(2))}`;
    return `#${tab}${parts.map((part) => encodeURIComponent(String(part))).join("/")}${turn}`;
  }

  /**
   * Return the number of the view of a plan in a position, else of the plan's main one; less than 0: none.
   * @param {string} plan
   * @param {string} position
   */
  seen(plan, position) {
    const among = this.views.flatMap((one, k) => (one.plan === plan ? [k] : []));
    return viewAt(this.views, among, position === WHOLE ? "" : position) ?? -1;
  }

  /** Go where the address says; what it does not say stays. */
  follow() {
    const found = ADDRESS.exec(location.hash);
    if (found === null) return this.arrive(this.within({}));
    const [plan = "", position = ""] = found.slice(2, 4).map((part) => decoded(part ?? ""));
    const view = this.seen(plan, position);
    const known = view >= 0;
    this.named = known && found[4] !== undefined;
    const usual = !known && this.tabs.includes(plan) ? plan : this.tabs[0];
    this.arrive(
      this.within({
        tab: found[1] ?? usual,
        view: known ? view : this.place.view,
        picture: known ? Number(found[4] ?? 0) : this.place.picture,
        turn: Number(found[5] ?? this.place.turn),
      }),
    );
  }
}

/**
 * Return the view (its index) among those of a plan that is in a position, else the main one, else the first.
 * @param {View[]} views
 * @param {number[]} among
 * @param {string} position
 * @returns {number | undefined}
 */
export function viewAt(views, among, position) {
  return among.find((k) => views[k]?.position === position) ?? among.find((k) => views[k]?.main) ?? among[0];
}

/** Tab, plan, position, picture, angle. */
const ADDRESS = /^#(?:(\w+):)?(?:([^/@]*)(?:\/([^/@]*))?(?:\/(\d+))?(?:@(-?\d+(?:\.\d+)?))?)?$/;

/**
 * @param {number} wanted
 * @param {number} most
 */
function between(wanted, most) {
  return Math.max(Math.min(wanted, most), 0);
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

/**
 * Write an address into the history if it is another; return whether it stands there.
 * @param {"pushState" | "replaceState"} how
 * @param {string} address
 */
function record(how, address) {
  try {
    if (location.hash !== address) history[how](null, "", address);
  } catch {
    return false;
  }
  return location.hash === address;
}
