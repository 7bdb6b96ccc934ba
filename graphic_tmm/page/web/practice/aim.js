/**
 * Where a point is about to be pricked: a cross that is moved by pointer, by arrows, by its coordinates, and the loupe
 * that shows it large.
 *
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {import("./figures.js").Frame} Frame
 */

/** How much the loupe enlarges. */
export const LOUPE = 4;
/** What an arrow moves the cross by, and with the shift key, mm. */
export const NUDGE = { fine: 0.1, broad: 5 };
/** To so much coordinates are told and kept, mm. */
export const GRAIN = 0.01;

/** @type {Record<string, Spot>} */
const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/**
 * Return where an arrow moves a cross to, within a frame; null if the key is none.
 * @param {Spot} spot
 * @param {string} key
 * @param {boolean} broad
 * @param {Frame} frame
 * @returns {Spot | null}
 */
export function nudged(spot, key, broad, frame) {
  const way = WAYS[key];
  if (way === undefined) return null;
  const by = broad ? NUDGE.broad : NUDGE.fine;
  return heldIn([spot[0] + by * way[0], spot[1] + by * way[1]], frame);
}

/**
 * Return a place to the grain of coordinates, within a frame.
 * @param {Spot} spot
 * @param {Frame} frame
 * @returns {Spot}
 */
export function heldIn(spot, [left, low, right, high]) {
  return [grained(Math.min(Math.max(spot[0], left), right)), grained(Math.min(Math.max(spot[1], low), high))];
}

/** @param {number} value */
function grained(value) {
  return Math.round(value / GRAIN) * GRAIN + 0;
}

/**
 * Return where a drag within the loupe moves the cross to: it goes as much slower as the loupe enlarges, against the hand.
 * @param {Spot} spot
 * @param {Spot} by what the pointer moved, mm of the board
 * @param {Frame} frame
 */
export function dragged(spot, by, frame) {
  return heldIn([spot[0] - by[0] / LOUPE, spot[1] - by[1] / LOUPE], frame);
}

/**
 * Return the corner in which the loupe hides neither the cross nor what is beside it: [right, low], as 0 or 1.
 * @param {Spot} spot
 * @param {Frame} frame
 * @param {[number, number]} taken the corner in which something else stands
 * @returns {[number, number]}
 */
export function cornerFor(spot, [left, low, right, high], taken) {
  const [x, y] = [spot[0] > (left + right) / 2 ? 0 : 1, spot[1] > (low + high) / 2 ? 1 : 0];
  if (x !== taken[0] || y !== taken[1]) return [x, y];
  return [x, 1 - y];
}
