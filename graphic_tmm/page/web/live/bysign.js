import { covered } from "./covered.js";

/**
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {{re: Float64Array, im: Float64Array, of: Int32Array, numbers: number[], marks: (Drawn | undefined)[],
 *   turned: Map<number, number>}} Reckoning values of nodes so far, of which nodes each is made, what they begin with
 * @typedef {(on: Reckoning, k: number, from: number) => void} Operation enters the value of node k, made of what
 *   stands in `of` from there on
 */

const HALF_TURN = 180;
/** Numbers that are compared are rounded to so many parts. */
const PARTS_OF_ONE = 1e6;

/**
 * An operation on one number that leaves a real one.
 * @param {(x: number, y: number) => number} made
 * @returns {Operation}
 */
function ofOne(made) {
  return ({ re, im, of }, k, from) => {
    const a = of[from] ?? 0;
    re[k] = made(re[a] ?? NaN, im[a] ?? NaN);
  };
}

/**
 * An operation on the real parts of two numbers that leaves a real one.
 * @param {(x: number, y: number) => number} made
 * @returns {Operation}
 */
function ofTwo(made) {
  return ({ re, of }, k, from) => {
    re[k] = made(re[of[from] ?? 0] ?? NaN, re[of[from + 1] ?? 0] ?? NaN);
  };
}

/**
 * An operation on two numbers that leaves any.
 * @param {(x: number, y: number, u: number, v: number) => number} real
 * @param {(x: number, y: number, u: number, v: number) => number} imaginary
 * @returns {Operation}
 */
function ofBoth(real, imaginary) {
  return ({ re, im, of }, k, from) => {
    const a = of[from] ?? 0;
    const b = of[from + 1] ?? 0;
    const [x, y, u, v] = [re[a] ?? NaN, im[a] ?? NaN, re[b] ?? NaN, im[b] ?? NaN];
    re[k] = real(x, y, u, v);
    im[k] = imaginary(x, y, u, v);
  };
}

/**
 * Return a number of a mark: of a line where it begins or its direction, of an arc its centre or its radius.
 * @param {Drawn | undefined} mark
 * @param {number} part
 * @returns {number | import("../types.js").Complex}
 */
function partOf(mark, part) {
  if (mark === undefined) return NaN;
  if (typeof mark === "number" || "re" in mark) return mark;
  if ("at" in mark) return part === 0 ? mark.at : mark.along;
  return part === 0 ? mark.centre : mark.radius;
}

/** @param {number} degrees */
function radiansOf(degrees) {
  return (degrees * Math.PI) / HALF_TURN;
}

/** What operations make, by their signs: page/tied_pack.py says which, paper/expressions.py does the same. @type {Record<string, Operation>} */
export const BY_SIGN = {
  m: ({ re, im, of, marks }, k, from) => {
    const value = partOf(marks[of[from] ?? 0], of[from + 1] ?? 0);
    re[k] = typeof value === "number" ? value : value.re;
    im[k] = typeof value === "number" ? 0 : value.im;
  },
  n: ({ re, im, of, numbers }, k, from) => {
    re[k] = numbers[of[from] ?? 0] ?? NaN;
    im[k] = numbers[of[from + 1] ?? 0] ?? NaN;
  },
  "+": ofBoth((x, _y, u) => x + u, (_x, y, _u, v) => y + v),
  "-": ofBoth((x, _y, u) => x - u, (_x, y, _u, v) => y - v),
  "*": ofBoth((x, y, u, v) => x * u - y * v, (x, y, u, v) => x * v + y * u),
  "/": ofBoth(
    (x, y, u, v) => (v === 0 ? x / u : (x * u + y * v) / (u * u + v * v)),
    (x, y, u, v) => (v === 0 ? y / u : (y * u - x * v) / (u * u + v * v)),
  ),
  "~": ({ re, im, of }, k, from) => {
    re[k] = re[of[from] ?? 0] ?? NaN;
    im[k] = -(im[of[from] ?? 0] ?? NaN);
  },
  r: ofOne((x) => x),
  i: ofOne((_x, y) => y),
  c: ({ re, im, of }, k, from) => {
    re[k] = re[of[from] ?? 0] ?? NaN;
    im[k] = re[of[from + 1] ?? 0] ?? NaN;
  },
  a: ofOne((x, y) => (y === 0 ? Math.abs(x) : Math.sqrt(x * x + y * y))),
  b: ofOne((x, y) => (Math.atan2(y, x) * HALF_TURN) / Math.PI),
  h: ({ re, im, of }, k, from) => {
    const angle = radiansOf(re[of[from] ?? 0] ?? NaN);
    re[k] = Math.cos(angle);
    im[k] = Math.sin(angle);
  },
  t: ofOne((x) => Math.tan(radiansOf(x))),
  s: ofOne((x) => (Math.asin(x) * HALF_TURN) / Math.PI),
  g: ofOne((x) => (x < 0 || Object.is(x, -0) ? -1 : 1)),
  f: ofOne((x) => Math.floor(x)),
  o: ofOne((x) => Math.round(x * PARTS_OF_ONE) / PARTS_OF_ONE),
  _: ofTwo((x, u) => Math.min(x, u)),
  "=": ofTwo((x, u) => Math.max(x, u)),
  "<": ofTwo((x, u) => (Number.isFinite(x) && Number.isFinite(u) ? Number(x < u) : NaN)),
  "?": ({ re, im, of }, k, from) => {
    const which = of[from + (re[of[from] ?? 0] === 0 ? 2 : 1)] ?? 0;
    re[k] = re[which] ?? NaN;
    im[k] = im[which] ?? NaN;
  },
  "#": ({ re, im, of }, k, from) => {
    re[k] = covered(re, im, of, from);
  },
  v: ({ re, turned }, k) => {
    re[k] = turned.get(k) ?? NaN;
  },
  "^": ({ re, turned }, k) => {
    re[k] = turned.get(k) ?? NaN;
  },
};
