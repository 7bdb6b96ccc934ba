import { alike } from "./letters.js";

/**
 * A mechanism as it lies on the paper, and what is asked of it; nothing here changes one.
 *
 * @typedef {[number, number]} Place metres, y upward
 * @typedef {{through: Place, angle: number}} Guide degrees
 * @typedef {{on: number, along: string, cylinder?: string}} Slide
 * @typedef {{number: number, points: string[], guides: Record<string, Guide>, slides: Slide[], centre?: string, passive?: boolean, weld?: number}} Body weld: the link that it is an arm of
 * @typedef {{places: Record<string, Place>, links: Body[], drives: number[]}} Sketch its first link is the frame
 * @typedef {{letter: string} | {bar: Bar, place: Place} | {place: Place}} Target what is meant: a pin, a bar, a place
 * @typedef {{number: number, ends: [string, string]}} Bar two letters of a link
 */

/** Letters in the order in which pins get them: none of a pole, of a mass centre, of the origin. */
const LETTERS = "ABCDEFGHKLMNQRTUVWXYZ";
const GUIDES = ["x", "y", "z", "t", "n", "s", "u", "w"];

/** @returns {Sketch} */
export function blankSketch() {
  return { places: {}, links: [{ number: 0, points: [], guides: {}, slides: [] }], drives: [] };
}

/** @param {Sketch} sketch */
export function frameOf(sketch) {
  return /** @type {Body} */ (sketch.links[0]);
}

/** @param {Sketch} sketch */
export function movingOf(sketch) {
  return sketch.links.slice(1);
}

/**
 * @param {Sketch} sketch
 * @param {number} number
 */
export function bodyOf(sketch, number) {
  return sketch.links.find((one) => one.number === number);
}

/**
 * Return where a letter is; the origin if it is nowhere.
 * @param {Sketch} sketch
 * @param {string} letter
 * @returns {Place}
 */
export function placeOf(sketch, letter) {
  return sketch.places[letter] ?? [0, 0];
}

/**
 * Return the links that a letter stands on.
 * @param {Sketch} sketch
 * @param {string} letter
 */
export function bodiesAt(sketch, letter) {
  return sketch.links.filter((one) => one.points.includes(letter));
}

/**
 * Return the stones at a letter: links of this one letter that slide.
 * @param {Sketch} sketch
 * @param {string} letter
 */
export function stonesAt(sketch, letter) {
  return bodiesAt(sketch, letter).filter((one) => one.slides.length > 0 && one.points.length === 1);
}

/**
 * Tell whether a letter of a link is nothing but its mass centre.
 * @param {Sketch} sketch
 * @param {Body} body
 * @param {string} letter
 */
export function isOnlyCentre(sketch, body, letter) {
  return letter === body.centre && body.points.length > 1 && bodiesAt(sketch, letter).length === 1;
}

/**
 * Return the letters between which a link is drawn: a mass centre is drawn by itself where nothing is joined to it.
 * @param {Sketch} sketch
 * @param {Body} body
 */
export function cornersOf(sketch, body) {
  return body.points.filter((one) => !isOnlyCentre(sketch, body, one));
}

/**
 * Tell whether no pin has a letter, or one that looks as it does.
 * @param {Sketch} sketch
 * @param {string} letter
 */
export function isFree(sketch, letter) {
  return alike(Object.keys(sketch.places), letter) === undefined;
}

/**
 * Return a letter that no pin has.
 * @param {Sketch} sketch
 */
export function freeLetter(sketch) {
  const plain = [...LETTERS].find((one) => isFree(sketch, one));
  if (plain !== undefined) return plain;
  for (let k = 1; ; k += 1) if (isFree(sketch, `A${k}`)) return `A${k}`;
}

/**
 * Return the name of a guide that nothing has.
 * @param {Sketch} sketch
 */
export function freeGuide(sketch) {
  const taken = new Set(sketch.links.flatMap((one) => Object.keys(one.guides)));
  const plain = GUIDES.find((one) => !taken.has(one));
  if (plain !== undefined) return plain;
  for (let k = 1; ; k += 1) if (!taken.has(`x${k}`)) return `x${k}`;
}

/** @param {Sketch} sketch */
export function freeNumber(sketch) {
  for (let k = 1; ; k += 1) if (bodyOf(sketch, k) === undefined) return k;
}

/**
 * Return the cylinder that a rod slides in, from its pivot to the rod's pin; null of what is no rod.
 * @param {Sketch} sketch
 * @param {Body} body
 * @returns {[string, string] | null}
 */
export function cylinderOf(sketch, body) {
  const barrel = movingOf(sketch).find((one) => body.slides.some((slide) => slide.on === one.number && slide.along in one.guides));
  const [pivot] = barrel?.points ?? [];
  const [pin] = body.points;
  return pivot === undefined || pin === undefined ? null : [pivot, pin];
}

/**
 * Return the bars of a link: from letter to letter along a row, round a plate; of a rod its cylinder.
 * @param {Sketch} sketch
 * @param {Body} body
 * @returns {Bar[]}
 */
export function barsOf(sketch, body) {
  const { number } = body;
  const points = cornersOf(sketch, body);
  const pairs = points.slice(1).map((letter, k) => /** @type {[string, string]} */ ([points[k], letter]));
  if (points.length > 2) pairs.push(/** @type {[string, string]} */ ([points.at(-1), points[0]]));
  const barrel = cylinderOf(sketch, body);
  if (barrel !== null) pairs.push(barrel);
  return pairs.map((ends) => ({ number, ends }));
}

/**
 * Return the two letters that a stone's guide goes through; null of a guide with a name.
 * @param {Body} body
 * @param {string} along
 * @returns {[string, string] | null}
 */
export function alongOf(body, along) {
  for (const first of body.points) {
    const second = along.startsWith(first) ? along.slice(first.length) : "";
    if (second !== "" && body.points.includes(second)) return [first, second];
  }
  return null;
}

/**
 * Return a guide as a place and a direction of length 1.
 * @param {Sketch} sketch
 * @param {Slide} slide
 * @returns {{through: Place, way: Place} | null}
 */
export function lineOf(sketch, slide) {
  const body = bodyOf(sketch, slide.on);
  if (body === undefined) return null;
  const ends = alongOf(body, slide.along);
  if (ends !== null) {
    const [a, b] = ends.map((letter) => placeOf(sketch, letter));
    return a !== undefined && b !== undefined ? { through: a, way: unit(minus(b, a)) } : null;
  }
  const guide = body.guides[slide.along];
  return guide === undefined ? null : { through: guide.through, way: direction(guide.angle) };
}

/**
 * @param {Place} a
 * @param {Place} b
 * @returns {Place}
 */
export function minus(a, b) {
  return [a[0] - b[0], a[1] - b[1]];
}

/**
 * @param {Place} a
 * @param {Place} b
 */
export function apart(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/**
 * @param {Place} a
 * @returns {Place}
 */
export function unit(a) {
  const size = Math.hypot(...a);
  return size === 0 ? [1, 0] : [a[0] / size, a[1] / size];
}

/**
 * @param {number} degrees
 * @returns {Place}
 */
export function direction(degrees) {
  const angle = (degrees * Math.PI) / 180;
  return [Math.cos(angle), Math.sin(angle)];
}

/**
 * Return the point of a line that is nearest to a place.
 * @param {{through: Place, way: Place}} line
 * @param {Place} place
 * @returns {Place}
 */
export function footOf({ through, way }, place) {
  const along = (place[0] - through[0]) * way[0] + (place[1] - through[1]) * way[1];
  return [through[0] + along * way[0], through[1] + along * way[1]];
}

/**
 * Return how large a mechanism is, corner to corner, m.
 * @param {Sketch} sketch
 */
export function sizeOf(sketch) {
  const bounds = boundsOf(sketch);
  return bounds === null ? 1 : Math.hypot(bounds.right - bounds.left, bounds.high - bounds.low) || 1;
}

/**
 * Return how far a mechanism reaches, m.
 * @param {Sketch} sketch
 */
export function boundsOf(sketch) {
  const all = Object.values(sketch.places);
  const xs = all.map((one) => one[0]);
  const ys = all.map((one) => one[1]);
  return all.length === 0 ? null : { left: Math.min(...xs), right: Math.max(...xs), low: Math.min(...ys), high: Math.max(...ys) };
}
