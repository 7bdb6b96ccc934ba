/** As in paper/covering.py: what is nearer lies on a stroke, mm; pieces of a line; how a stroke begins. */
const ON = 1;
const PIECES = 72;
const FILLED_STROKE = -2;
const A_TURN = -3;

/**
 * Return 1 where most of a line lies on strokes, else 0; NaN where something of it is not there.
 * @param {Float64Array} re
 * @param {Float64Array} im
 * @param {Int32Array} of how many numbers follow: the ends of the line, then stroke by stroke how it begins, its vertices
 * @param {number} from
 */
export function covered(re, im, of, from) {
  const end = from + 1 + (of[from] ?? 0);
  /** @type {number[]} */
  const strokes = [];
  for (let n = from + 3; n < end; n++) {
    if ((of[n] ?? 0) < 0) strokes.push(n);
  }
  let count = 0;
  // once most of it is known nothing more can be
  for (let piece = 0; piece < PIECES && 2 * count <= PIECES && 2 * (piece - count) < PIECES; piece++) {
    const share = (piece + 0.5) / PIECES;
    const [u, v] = [valueBetween(re, of, from, share), valueBetween(im, of, from, share)];
    if (strokes.some((n, k) => onStroke(u, v, re, im, of, n, strokes[k + 1] ?? end))) count++;
  }
  return Number(2 * count > PIECES);
}

/**
 * Return a coordinate of a place on the line.
 * @param {Float64Array} values
 * @param {Int32Array} of
 * @param {number} from
 * @param {number} share
 */
function valueBetween(values, of, from, share) {
  const [a = NaN, b = NaN] = [values[of[from + 1] ?? 0], values[of[from + 2] ?? 0]];
  return a + share * (b - a);
}

/**
 * Return whether a place lies on a stroke.
 * @param {number} u
 * @param {number} v
 * @param {Float64Array} re
 * @param {Float64Array} im
 * @param {Int32Array} of
 * @param {number} from where the stroke begins
 * @param {number} end
 */
function onStroke(u, v, re, im, of, from, end) {
  const kind = of[from];
  const test = kind === A_TURN ? nearRing : nearStroke;
  let inside = false;
  for (let n = from + 1; n + 1 < end; n++) {
    const [k = 0, l = 0] = [of[n], of[n + 1]];
    const [a = 0, b = 0, c = 0, d = 0] = [re[k], im[k], re[l], im[l]];
    if (test(u, v, a, b, c, d)) return true;
    if (leftOf(u, v, a, b, c, d)) inside = !inside;
  }
  return kind === FILLED_STROKE && inside;
}

/**
 * @param {number} u
 * @param {number} v
 * @param {number} a
 * @param {number} b
 * @param {number} c
 * @param {number} d
 */
function nearStroke(u, v, a, b, c, d) {
  const [p, q] = [c - a, d - b];
  const share = ((u - a) * p + (v - b) * q) / Math.max(p * p + q * q, 1e-18);
  const along = Math.min(Math.max(share, 0), 1);
  const [s, t] = [u - a - along * p, v - b - along * q];
  return s * s + t * t <= ON * ON;
}

/**
 * @param {number} u
 * @param {number} v
 * @param {number} a
 * @param {number} b
 * @param {number} c
 * @param {number} d
 */
function nearRing(u, v, a, b, c, d) {
  const [x, y, p, q] = [2 * u - a - c, 2 * v - b - d, c - a, d - b];
  return Math.abs(Math.sqrt(x * x + y * y) - Math.sqrt(p * p + q * q)) <= 2 * ON;
}

/**
 * @param {number} u
 * @param {number} v
 * @param {number} a
 * @param {number} b
 * @param {number} c
 * @param {number} d
 */
function leftOf(u, v, a, b, c, d) {
  return b > v !== d > v && u < a + ((v - b) / (d - b)) * (c - a);
}
