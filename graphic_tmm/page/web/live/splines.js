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
