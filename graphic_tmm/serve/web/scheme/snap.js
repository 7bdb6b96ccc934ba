import { alongOf, apart, barsOf, bodyOf, footOf, minus, movingOf, placeOf, unit } from "./sketch.js";

/**
 * What a pointer means: a pin, a bar, a place in line with something, a place on the squares.
 *
 * @typedef {import("./sketch.js").Bar} Bar
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./view.js").Dots} Dots
 * @typedef {import("./view.js").View} View
 * @typedef {{except?: string | undefined, from?: Place | undefined, free?: boolean, coarse?: boolean}} How except: a pin
 *   that is moved; from: where a link begins; free: nothing but pins; coarse: a finger
 * @typedef {{place: Place, letter?: string, bar?: Bar, lines: [Place, Place][]}} Meant lines: what it is in line with
 */

/** So near a pin, or a bar, it is meant, dots: half of what a finger needs. */
const NEAR_PIN = 16;
const NEAR_BAR = 9;
/** So near to being in line is in line, dots. */
const IN_LINE = 6;
/** Places stand on whole millimetres where they stand on nothing else. */
const STEP = 0.001;
/** Directions of sliders stand on so many degrees. */
export const DEGREES = 15;

/**
 * Return what is meant by a spot.
 * @param {Sketch} sketch
 * @param {View} view
 * @param {Dots} spot
 * @param {How} how
 * @returns {Meant}
 */
export function meant(sketch, view, spot, { except, from, free = false, coarse = false } = {}) {
  const reach = coarse ? 1.5 : 1;
  const letter = pinAt(sketch, view, spot, NEAR_PIN * reach, except);
  if (letter !== null) return { place: placeOf(sketch, letter), letter, lines: [] };
  const bar = barAt(sketch, view, spot, NEAR_BAR * reach, except);
  if (bar !== null) return { place: onBar(sketch, bar, view.place(spot)), bar, lines: [] };
  const raw = view.place(spot);
  return free ? { place: raw, lines: [] } : inLine(sketch, view, spot, raw, from, except);
}

/**
 * @param {Sketch} sketch
 * @param {View} view
 * @param {Dots} spot
 * @param {number} reach
 * @param {string} [except]
 */
export function pinAt(sketch, view, spot, reach, except) {
  let best = null;
  let near = reach;
  for (const [letter, place] of Object.entries(sketch.places)) {
    const off = apart(view.dots(place), spot);
    if (letter !== except && off <= near) [best, near] = [letter, off];
  }
  return best;
}

/**
 * @param {Sketch} sketch
 * @param {View} view
 * @param {Dots} spot
 * @param {number} reach
 * @param {string} [except] a pin whose own bars are not meant
 * @returns {Bar | null}
 */
export function barAt(sketch, view, spot, reach, except) {
  let best = null;
  let near = reach;
  for (const bar of movingOf(sketch).flatMap((one) => barsOf(sketch, one))) {
    if (except !== undefined && (bar.ends.includes(except) || bodyOf(sketch, bar.number)?.points.includes(except))) continue;
    const [a, b] = /** @type {[Dots, Dots]} */ (bar.ends.map((one) => view.dots(placeOf(sketch, one))));
    const long = apart(a, b);
    const foot = footOf({ through: a, way: unit(minus(b, a)) }, spot);
    const off = apart(foot, spot);
    if (off <= near && apart(foot, a) <= long && apart(foot, b) <= long) [best, near] = [bar, off];
  }
  return best;
}

/**
 * @param {Sketch} sketch
 * @param {Bar} bar
 * @param {Place} place
 */
export function onBar(sketch, { ends }, place) {
  const [a, b] = ends.map((one) => placeOf(sketch, one));
  return a === undefined || b === undefined ? place : footOf({ through: a, way: unit(minus(b, a)) }, place);
}

/**
 * Return a place on whole millimetres, or level with, above, or in one line with what is there.
 * @param {Sketch} sketch
 * @param {View} view
 * @param {Dots} spot
 * @param {Place} raw
 * @param {Place | undefined} from
 * @param {string | undefined} except
 * @returns {Meant}
 */
function inLine(sketch, view, spot, raw, from, except) {
  const others = Object.entries(sketch.places).flatMap(([letter, place]) => (letter === except ? [] : [place]));
  if (from !== undefined && !others.some((one) => apart(one, from) === 0)) others.push(from);
  let [x, y] = raw.map((one) => Math.round(one / STEP) * STEP);
  /** @type {[Place, Place][]} */
  const lines = [];
  const above = others.find((one) => Math.abs(view.dots(one)[0] - spot[0]) <= IN_LINE);
  const level = others.find((one) => Math.abs(view.dots(one)[1] - spot[1]) <= IN_LINE);
  if (above !== undefined) x = above[0];
  if (level !== undefined) y = level[1];
  const place = /** @type {Place} */ ([x, y]);
  for (const other of [above, level]) if (other !== undefined) lines.push([other, place]);
  return { place, lines };
}

/**
 * Return the two letters of a link between which a spot lies on it; those of its guide if it has a stone.
 * @param {Sketch} sketch
 * @param {Bar} bar
 * @returns {Bar}
 */
export function guideBar(sketch, bar) {
  const slide = sketch.links.flatMap((one) => one.slides).find((one) => one.on === bar.number);
  const body = bodyOf(sketch, bar.number);
  const ends = slide === undefined || body === undefined ? null : alongOf(body, slide.along);
  return ends === null ? bar : { ...bar, ends };
}
