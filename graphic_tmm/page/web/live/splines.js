import { ARITHMETIC } from "../practice/arithmetic.js";

/** @typedef {import("../practice/arithmetic.js").Figure} Figure */

/** Arithmetic of numbers and points. */
const OF_KNOTS = ARITHMETIC;
/** What the effect of a knot on the tangents shrinks by from knot to knot of a periodic spline. */
const FADES = Math.sqrt(3) - 2;

/**
 * Return the tangents of the periodic cubic spline through points; numbers alike (board/operations/curve.py).
 * @param {Figure[]} points
 * @returns {Figure[]}
 */
export function periodicTangents(points) {
  const count = points.length;
  if (count < 3) return points.map((one) => OF_KNOTS.times(0, one));
  const at = (/** @type {number} */ k) => points[(k + count) % count] ?? NaN;
  const right = points.map((_, k) => OF_KNOTS.times(3, OF_KNOTS.minus(at(k + 1), at(k - 1))));
  const whole = 2 * Math.sqrt(3) * (1 - FADES ** count);
  const share = points.map((_, k) => (FADES ** k + FADES ** (count - k)) / whole);
  return points.map((_, k) => right.reduce((sum, one, n) => OF_KNOTS.plus(sum, OF_KNOTS.times(share[Math.abs(n - k)] ?? NaN, one)), 0));
}

/**
 * Return the tangents of the natural cubic spline through points, two or more.
 * @param {Figure[]} points
 * @returns {Figure[]}
 */
export function naturalTangents(points) {
  const last = points.length - 1;
  const at = (/** @type {number} */ k) => points[Math.min(Math.max(k, 0), last)] ?? NaN;
  const found = points.map((_, k) => OF_KNOTS.times(3, OF_KNOTS.minus(at(k + 1), at(k - 1))));
  /** @type {number[]} */
  const main = points.map((_, k) => (k === 0 || k === last ? 2 : 4));
  for (let k = 1; k <= last; k++) {
    const share = 1 / (main[k - 1] ?? NaN);
    main[k] = (main[k] ?? NaN) - share;
    found[k] = OF_KNOTS.minus(found[k] ?? NaN, OF_KNOTS.times(share, found[k - 1] ?? NaN));
  }
  for (let k = last; k >= 0; k--) {
    const after = k === last ? 0 : (found[k + 1] ?? NaN);
    found[k] = OF_KNOTS.times(1 / (main[k] ?? NaN), OF_KNOTS.minus(found[k] ?? NaN, after));
  }
  return found;
}

/**
 * Return the tangents of the curve through points whose first two arcs, and last two, are one cubic each
 * (board/operations/graph_curves.py).
 * @param {Figure[]} points two or more
 * @returns {Figure[]}
 */
export function freeTangents(points) {
  const last = points.length - 1;
  const at = (/** @type {number} */ k) => points[k] ?? NaN;
  if (last === 1) return points.map(() => OF_KNOTS.minus(at(1), at(0)));
  if (last === 2) return [-1, 0, 1].map((by) => sumOfKnots([by - 0.5, at(0)], [-2 * by, at(1)], [by + 0.5, at(2)]));
  const right = points.map((_, k) => sumOfKnots([3, at(k + 1)], [-3, at(k - 1)]));
  right[0] = sumOfKnots([-2.5, at(0)], [2, at(1)], [0.5, at(2)]);
  right[last] = sumOfKnots([2.5, at(last)], [-2, at(last - 1)], [-0.5, at(last - 2)]);
  const [low, high] = [(/** @type {number} */ k) => (k === last ? 2 : 1), (/** @type {number} */ k) => (k === 0 ? 2 : 1)];
  /** @type {number[]} */
  const main = points.map((_, k) => (k === 0 || k === last ? 1 : 4));
  const mainAt = (/** @type {number} */ k) => main[k] ?? NaN;
  const rightAt = (/** @type {number} */ k) => right[k] ?? NaN;
  for (let k = 1; k <= last; k++) {
    const share = low(k) / mainAt(k - 1);
    main[k] = mainAt(k) - share * high(k - 1);
    right[k] = sumOfKnots([1, rightAt(k)], [-share, rightAt(k - 1)]);
  }
  right[last] = OF_KNOTS.times(1 / mainAt(last), rightAt(last));
  for (let k = last - 1; k >= 0; k--) {
    right[k] = OF_KNOTS.times(1 / mainAt(k), sumOfKnots([1, rightAt(k)], [-high(k), rightAt(k + 1)]));
  }
  return right;
}

/** @param {[number, Figure][]} parts each so many times */
function sumOfKnots(...parts) {
  return parts.reduce((/** @type {Figure} */ whole, [by, one]) => OF_KNOTS.plus(whole, OF_KNOTS.times(by, one)), 0);
}
