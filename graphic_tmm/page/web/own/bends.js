import { asideAt, footOf, noCurl } from "./curl.js";
import { leftOfLine } from "./fitting.js";
import { bowOf, straightening } from "./lens.js";
import { inverseOf, projected } from "./projection.js";

/**
 * @typedef {import("./curl.js").Curl} Curl
 * @typedef {import("./lens.js").Lens} Lens
 * @typedef {import("./lens.js").SeenLine} SeenLine
 * @typedef {import("./shot.js").Shot} Shot
 * @typedef {import("./strip.js").Seeking} Seeking
 * A lens and a curl, and the squares that they leave of the lines' distance from straight, px²
 * @typedef {{lens: Lens, curl: Curl, left: number}} Bends
 */

/** The edges of a frame: a curl is told from the lens only where all are seen. */
const ALL_EDGES = 4;

/**
 * Return the lens and the curl that make the frame's lines straight, as checking/photo/camera.py finds them.
 * @param {Shot} shot
 * @param {SeenLine[]} lines
 * @param {Seeking} how
 * @returns {{lens: Lens, curl: Curl}}
 */
export function unbending(shot, lines, how) {
  const lens = straightening(shot.lens, lines, how.share);
  const alone = { lens, curl: noCurl(shot.box), left: 0 };
  if (lines.length < ALL_EDGES) return alone;
  alone.left = how.clearer * leftByLens(lens, lines);
  const tried = [curledBends(shot, lines, true, how), curledBends(shot, lines, false, how)];
  return tried.reduce((best, one) => (one.left < best.left ? one : best), alone);
}

/**
 * Return the squares that a lens leaves.
 * @param {Lens} lens
 * @param {SeenLine[]} lines
 */
function leftByLens(lens, lines) {
  let sum = 0;
  for (const line of lines) {
    const { off, by } = bowOf(lens, line);
    line.weights.forEach((weight, k) => (sum += weight * ((off[k] ?? 0) + lens.share * (by[k] ?? 0)) ** 2));
  }
  return sum;
}

/**
 * Return lens and curl by least squares, the curl about one of the sheet's two directions.
 * @param {Shot} shot
 * @param {SeenLine[]} lines
 * @param {boolean} upright
 * @param {Seeking} how
 * @returns {Bends}
 */
function curledBends(shot, lines, upright, how) {
  const tried = { ...noCurl(shot.box), foot: footOf(shot.matrix, shot.lens, how), upright };
  const normal = new Array(9).fill(0);
  const due = [0, 0, 0];
  let whole = 0;
  let dots = 0;
  for (const line of lines) {
    const { off, by } = bowOf(shot.lens, line);
    const columns = [by, ...shiftsOf(shot, tried, line)];
    columns.forEach((one, j) => {
      columns.forEach((other, k) => (normal[3 * j + k] += weightedSum(line.weights, one, other)));
      due[j] = (due[j] ?? 0) - weightedSum(line.weights, one, off);
    });
    whole += weightedSum(line.weights, off, off);
    dots += line.weights.reduce((sum, one) => sum + one, 0) * dotsAlong(shot, line) ** 2;
  }
  normal[4] += how.stiff * dots;
  normal[8] += how.stiff * dots;
  const back = inverseOf(normal);
  const [share = 0, middle = 0, more = 0] = due.map((_, j) =>
    due.reduce((sum, one, k) => sum + (back[3 * j + k] ?? 0) * one, 0),
  );
  const lens = { ...shot.lens, share: Math.min(Math.max(share, -how.share), how.share) };
  const taken = [share, middle, more].reduce((sum, one, k) => sum + one * (due[k] ?? 0), 0);
  return { lens, curl: { ...tried, parts: [middle, more] }, left: whole - taken };
}

/**
 * @param {Float64Array} weights
 * @param {Float64Array} one
 * @param {Float64Array} other
 */
function weightedSum(weights, one, other) {
  return weights.reduce((sum, weight, k) => sum + weight * (one[k] ?? 0) * (other[k] ?? 0), 0);
}

/**
 * Return how many dots of the photograph a millimetre along a line is.
 * @param {Shot} shot
 * @param {SeenLine} line
 */
function dotsAlong(shot, { x, y }) {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = [x[0], y[0], x.at(-1), y.at(-1)];
  const [[ax, ay], [bx, by]] = [shot.onSheet(x0, y0), shot.onSheet(x1, y1)];
  return Math.hypot(x1 - x0, y1 - y0) / Math.hypot(bx - ax, by - ay);
}

/**
 * Return what a millimetre of each part of a curl, taken out, moves a line across, px, beside straight.
 * @param {Shot} shot
 * @param {Curl} curl
 * @param {SeenLine} line
 */
function shiftsOf(shot, curl, { x, y, weights }) {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = [x[0], y[0], x.at(-1), y.at(-1)];
  const far = Math.hypot(x1 - x0, y1 - y0);
  const [wx, wy] = [(x1 - x0) / far, (y1 - y0) / far];
  const along = x.map((one, k) => (one - x0) * wx + ((y[k] ?? 0) - y0) * wy);
  const flat = Array.from(x, (one, k) => shot.onSheet(one, y[k] ?? 0));
  return [false, true].map((more) => {
    const across = Float64Array.from(flat, ([px, py]) => {
      const [dx, dy, place] = asideAt(curl, px, py);
      const part = more ? place : 1;
      const [hx, hy] = projected(shot.matrix, px, py);
      const [mx, my] = projected(shot.matrix, px + part * dx, py + part * dy);
      return -((my - hy) * wx - (mx - hx) * wy);
    });
    return leftOfLine(along, across, weights);
  });
}
