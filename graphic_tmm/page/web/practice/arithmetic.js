/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {number | Complex} Figure
 */

/**
 * Arithmetic of numbers and of points of the plane, as numpy has it: what cannot be is NaN. The operations of the
 * board are written for it (board/script.py).
 */
export const ARITHMETIC = {
  complex,
  plus,
  minus: (/** @type {Figure} */ a, /** @type {Figure} */ b) => plus(a, opposite(b)),
  times,
  over,
  opposite,
  power,
  equal: (/** @type {Figure} */ a, /** @type {Figure} */ b) => realPart(a) === realPart(b) && imagPart(a) === imagPart(b),
  abs: (/** @type {Figure} */ z) => (typeof z === "number" ? Math.abs(z) : Math.hypot(z.re, z.im)),
  real: realPart,
  imag: imagPart,
  missing: (/** @type {Figure} */ z) => Number.isNaN(realPart(z)) || Number.isNaN(imagPart(z)),
  known: (/** @type {number} */ x) => (Number.isNaN(x) ? 0 : x),
  fmin: (/** @type {number} */ a, /** @type {number} */ b) => (Number.isNaN(a) || b < a ? b : a),
  copysign: (/** @type {number} */ x, /** @type {number} */ of) => (of < 0 || Object.is(of, -0) ? -Math.abs(x) : Math.abs(x)),
  rint,
  round: (/** @type {number} */ x, /** @type {number} */ places) => rint(x * 10 ** places) / 10 ** places,
  conj: (/** @type {Figure} */ z) => (typeof z === "number" ? z : complex(z.re, -z.im)),
  quadrant: (/** @type {number} */ q) => [complex(1, 0), complex(0, 1), complex(-1, 0), complex(0, -1)][((q % 4) + 4) % 4 || 0],
  radians: (/** @type {number} */ x) => (x * Math.PI) / 180,
  degrees: (/** @type {number} */ x) => (x * 180) / Math.PI,
};

/**
 * @param {number} re
 * @param {number} im
 * @returns {Complex}
 */
export function complex(re, im) {
  return { re, im };
}

/** @param {Figure} z */
function realPart(z) {
  return typeof z === "number" ? z : z.re;
}

/** @param {Figure} z */
function imagPart(z) {
  return typeof z === "number" ? 0 : z.im;
}

/**
 * @param {Figure} z
 * @returns {Figure}
 */
function opposite(z) {
  return typeof z === "number" ? -z : complex(-z.re, -z.im);
}

/**
 * @param {Figure} a
 * @param {Figure} b
 * @returns {Figure}
 */
function plus(a, b) {
  if (typeof a === "number" && typeof b === "number") return a + b;
  return complex(realPart(a) + realPart(b), imagPart(a) + imagPart(b));
}

/**
 * @param {Figure} a
 * @param {Figure} b
 * @returns {Figure}
 */
function times(a, b) {
  if (typeof a === "number") return typeof b === "number" ? a * b : complex(a * b.re, a * b.im);
  if (typeof b === "number") return complex(a.re * b, a.im * b);
  return complex(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

/**
 * A quotient; by Smith's rule, so that no square becomes too large.
 * @param {Figure} a
 * @param {Figure} b
 * @returns {Figure}
 */
function over(a, b) {
  if (typeof b === "number") return typeof a === "number" ? a / b : complex(a.re / b, a.im / b);
  const [re, im] = [realPart(a), imagPart(a)];
  if (Math.abs(b.re) >= Math.abs(b.im)) {
    const share = b.im / b.re;
    const whole = b.re + b.im * share;
    return complex((re + im * share) / whole, (im - re * share) / whole);
  }
  const share = b.re / b.im;
  const whole = b.re * share + b.im;
  return complex((re * share + im) / whole, (im * share - re) / whole);
}

/**
 * @param {Figure} a
 * @param {number} by whole where a is a point
 * @returns {Figure}
 */
function power(a, by) {
  if (typeof a === "number") return a ** by;
  /** @type {Figure} */
  let found = complex(1, 0);
  for (let k = 0; k < Math.abs(by); k++) found = times(found, a);
  return by < 0 ? over(1, found) : found;
}

/**
 * The nearest whole number, of two the even one.
 * @param {number} x
 */
function rint(x) {
  const below = Math.floor(x);
  const rest = x - below;
  if (rest !== 0.5) return rest < 0.5 ? below : below + 1;
  return below % 2 === 0 ? below : below + 1;
}
