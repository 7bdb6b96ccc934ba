/** @typedef {import("./types.js").Place} Place */
/** @typedef {import("./types.js").Target} Target */
/** @typedef {import("./types.js").Click} Click */
/** @typedef {import("./types.js").Plan} Plan */
/** @typedef {import("./types.js").Proposal} Proposal */
/** @typedef {import("./types.js").Spot} Spot */

export const CORNERS = 4;
/** A corner of the sheet, which is of no plan. @type {Target} */
export const CORNER = { what: "corner", plan: "", position: "" };

/**
 * Whether two are of one plan in one position.
 * @param {{plan: string, position: string}} one
 * @param {{plan: string, position: string}} other
 */
export function together(one, other) {
  return one.plan === other.plan && one.position === other.position;
}

/**
 * Whether something of a plan was clicked.
 * @param {Click[]} clicks
 * @param {{plan: string, position: string}} place
 * @param {string} what
 */
export function has(clicks, place, what) {
  return clicks.some((one) => one.what === what && together(one, place));
}

/** @param {Click[]} clicks */
export function cornersOf(clicks) {
  return clicks.filter((one) => one.what === "corner");
}

/**
 * Return what is to be clicked next: of the first plan of a kind pole and first vector, of further ones the pole;
 * null if all were.
 * @param {Place[]} places
 * @param {Click[]} clicks
 * @returns {Target | null}
 */
export function proposed(places, clicks) {
  const last = clicks.findLast((one) => one.what !== "corner");
  const at = last === undefined ? -1 : places.findIndex((one) => together(one, last));
  if (last !== undefined && has(clicks, last, "pole")) {
    const known = clicks.some((one) => one.what === "first" && one.plan === last.plan);
    if (!known) return { what: "first", plan: last.plan, position: last.position };
  }
  const order = [...places.slice(at + 1), ...places.slice(0, at + 1)];
  const next = order.find((one) => !has(clicks, one, "pole"));
  return next === undefined ? null : { what: "pole", plan: next.plan, position: next.position };
}

/**
 * Return the clicks with one more; it takes the place of one before it.
 * @param {Click[]} clicks
 * @param {Click} click
 * @returns {Click[]}
 */
export function withClick(clicks, click) {
  const others = clicks.filter((one) => click.what === "corner" || one.what !== click.what || !together(one, click));
  return [...others, click];
}

/**
 * Return what was clicked, plan by plan, in the order of the poles.
 * @param {Click[]} clicks
 * @returns {{pole: Click, first: Click | undefined}[]}
 */
export function clickedPlans(clicks) {
  const firsts = clicks.filter((one) => one.what === "first");
  return clicks
    .filter((one) => one.what === "pole")
    .map((pole) => ({ pole, first: firsts.find((one) => together(one, pole)) }));
}

/**
 * Return what the check of a photograph is asked with, as the command `photo` has its options.
 * @param {Click[]} clicks
 * @param {string} sheet "paper A4" for a sheet of one's own, "sheet 1" for one as the scene lays it out
 * @returns {[string, string][]}
 */
export function optionsOf(clicks, sheet) {
  const [name = "", value = ""] = sheet.split(" ");
  const corners = cornersOf(clicks);
  /** @type {[string, string][]} */
  const told = [[name, value]];
  if (corners.length === CORNERS) told.push(["corners", corners.map(dots).join(" ")]);
  for (const { pole, first } of clickedPlans(clicks)) {
    const places = [pole, ...(first === undefined ? [] : [first])].map(dots).join();
    told.push(["plan", `${pole.plan}:${pole.position}=${places}`]);
  }
  return told;
}

/** Dots of the photograph from the centre of the first one. @param {Click} click */
function dots({ spot: [x, y] }) {
  return `${x.toFixed(1)},${y.toFixed(1)}`;
}

/** What was clicked in a photograph, and what is to be clicked next. */
export class Clicks {
  /** @param {() => void} changed */
  constructor(changed) {
    this.changed = changed;
    /** Where one may click. @type {Place[]} */
    this.places = [];
    /** @type {Click[]} */
    this.list = [];
    /** What a person has chosen to click; null: what is proposed. @type {Target | null} */
    this.chosen = null;
    /** The one that may still be moved. @type {Click | null} */
    this.last = null;
  }

  /** What is to be clicked next; null: nothing. */
  get target() {
    return this.chosen ?? proposed(this.places, this.list);
  }

  /**
   * Take notice of the plans that the scene has; what was clicked of others is gone.
   * @param {Plan[]} plans
   */
  offer(plans) {
    this.places = plans.flatMap((one) => one.positions.map((position) => ({ ...one, position })));
    this.list = this.list.filter((one) => one.what === "corner" || this.places.some((place) => together(place, one)));
    this.chosen = this.last = null;
  }

  /**
   * Return the plan in the position of something that is clicked.
   * @param {{plan: string, position: string}} of
   * @returns {Place}
   */
  placeOf(of) {
    return this.places.find((one) => together(one, of)) ?? { ...of, name: "", pole: "", first: "", positions: [] };
  }

  /** @param {Spot} spot */
  place(spot) {
    const { target } = this;
    if (target === null) return;
    this.last = { ...target, spot };
    this.list = withClick(this.list, this.last);
    const more = target.what === "corner" && cornersOf(this.list).length < CORNERS;
    this.chosen = more ? CORNER : null;
    this.changed();
  }

  /** @param {Spot} spot */
  move(spot) {
    const { last } = this;
    if (last === null) return;
    const moved = { ...last, spot };
    this.list = this.list.map((one) => (one === last ? moved : one));
    this.last = moved;
    this.changed();
  }

  /**
   * Take plans for clicked that seem to be there, but for those that were clicked.
   * @param {Proposal[]} proposals
   */
  take(proposals) {
    const others = proposals.filter((one) => !has(this.list, one, "pole"));
    for (const { plan, position, pole, first } of others) {
      this.list = withClick(this.list, { what: "pole", plan, position, spot: pole });
      if (first !== null) this.list = withClick(this.list, { what: "first", plan, position, spot: first });
    }
    this.chosen = this.last = null;
    this.changed();
  }

  undo() {
    const gone = this.list.at(-1);
    if (gone === undefined) return;
    this.list = this.list.slice(0, -1);
    this.chosen = { what: gone.what, plan: gone.plan, position: gone.position };
    this.last = this.list.at(-1) ?? null;
    this.changed();
  }

  /** @param {(click: Click) => boolean} which */
  remove(which) {
    this.list = this.list.filter((one) => !which(one));
    this.chosen = this.last = null;
    this.changed();
  }

  clear() {
    this.remove(() => true);
  }

  /** @param {Target} target */
  choose(target) {
    if (target.what === "corner") this.list = this.list.filter((one) => one.what !== "corner");
    this.chosen = target;
    this.last = null;
  }
}
