/** @typedef {[number, number, number, number]} Box left, top, right, bottom */

/** How many numbers a command of path data takes. */
const COUNTS = /** @type {Record<string, number>} */ ({ M: 2, L: 2, H: 1, V: 1, C: 6, A: 7, Z: 0 });

/** How a pen is led: where it is, where it began. @typedef {{x: number, y: number, start: [number, number]}} Led */

/**
 * Return a box that holds a path; about arcs and curves it may be larger than need be.
 * @param {string} data path data of the sheets' writer: M, L, H, V, C, A, Z, absolute and relative
 * @returns {Box}
 */
export function pathBox(data) {
  /** @type {Box} */
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  /** @type {Led} */
  const pen = { x: 0, y: 0, start: [0, 0] };
  for (const [, letter = "", rest = ""] of data.matchAll(/([a-zA-Z])([^a-zA-Z]*)/g)) {
    const command = letter.toUpperCase();
    const numbers = (rest.match(/-?(?:\d+\.?\d*|\.\d+)/g) ?? []).map(Number);
    const count = COUNTS[command] ?? 2;
    if (count === 0) [pen.x, pen.y] = pen.start;
    for (let k = 0; count > 0 && k + count <= numbers.length; k += count) {
      lead(pen, box, command, letter !== command, numbers.slice(k, k + count));
      if (command === "M" && k === 0) pen.start = [pen.x, pen.y];
    }
  }
  return box;
}

/**
 * Lead the pen by one command, and widen the box by what it draws.
 * @param {Led} pen
 * @param {Box} box
 * @param {string} command
 * @param {boolean} relative
 * @param {number[]} own its numbers
 */
function lead(pen, box, command, relative, own) {
  const { x: lastX, y: lastY } = pen;
  const [fromX, fromY] = relative ? [lastX, lastY] : [0, 0];
  const [first, second, third, fourth] = own;
  const [endX, endY] = own.slice(-2);
  if (command !== "V") pen.x = fromX + (command === "H" ? first : endX);
  if (command !== "H") pen.y = fromY + (command === "V" ? first : endY);
  widen(box, pen.x, pen.y, 0);
  if (command === "C") {
    widen(box, fromX + first, fromY + second, 0);
    widen(box, fromX + third, fromY + fourth, 0);
  } else if (command === "A") {
    const chord = Math.hypot(pen.x - lastX, pen.y - lastY) / 2;
    // less than a half turn stays within the circle about its chord, more within the diameter about its end
    if (fourth === 0) widen(box, (pen.x + lastX) / 2, (pen.y + lastY) / 2, chord);
    else widen(box, pen.x, pen.y, 2 * Math.max(first, chord));
  }
}

/**
 * @param {Box} box
 * @param {number} x
 * @param {number} y
 * @param {number} by
 */
function widen(box, x, y, by) {
  if (x - by < box[0]) box[0] = x - by;
  if (y - by < box[1]) box[1] = y - by;
  if (x + by > box[2]) box[2] = x + by;
  if (y + by > box[3]) box[3] = y + by;
}

/**
 * Return the box that holds boxes, each of them widened.
 * @param {Box[]} boxes
 * @param {number} by
 * @returns {Box}
 */
export function boxAbout(boxes, by = 0) {
  /** @type {Box} */
  const all = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [left, top, right, bottom] of boxes) {
    widen(all, left, top, by);
    widen(all, right, bottom, by);
  }
  return all;
}

/**
 * Tell whether two boxes have points in common.
 * @param {Box} a
 * @param {Box} b
 */
export function boxesMeet(a, b) {
  return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
}
