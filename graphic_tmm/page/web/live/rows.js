import { ARITHMETIC } from "../practice/arithmetic.js";
import { along, at, depth, enterValues, ofTwoArrays, ofEachValue, shape } from "./arrays.js";
import { freeTangents, naturalTangents, periodicTangents } from "./splines.js";

/**
 * @typedef {import("./arrays.js").Nested} Nested
 * @typedef {import("../types.js").Drawn} Drawn
 */

const OF_VALUES = ARITHMETIC;
const isFinitePlace = (/** @type {any} */ z) => Number.isFinite(OF_VALUES.real(z)) && Number.isFinite(OF_VALUES.imag(z));
const inPairs = ofTwoArrays((a, b) => ({ a, b }));
const chosenOf = ofTwoArrays((mask, { a, b }) => (mask ? a : b));
const isEqual = ofTwoArrays((a, b) => OF_VALUES.equal(a, b));
const not = ofEachValue((own) => !own);
const maximum = ofTwoArrays(Math.max);
const minimum = ofTwoArrays(Math.min);

/**
 * Return a number of each row along an axis, or of all.
 * @param {(row: any[]) => any} made
 */
function reduced(made) {
  return (/** @type {Nested} */ x, /** @type {number | null} */ axis = null, /** @type {boolean} */ kept = false) => {
    if (axis === null) return made(depth(x) > 1 ? x.flat(Infinity) : x);
    return along(x, axis, kept ? (row) => [made(row)] : made);
  };
}

/** @param {any[]} row */
function sumOfRow(row) {
  return row.reduce((whole, x) => OF_VALUES.plus(whole, typeof x === "boolean" ? Number(x) : x), 0);
}

/**
 * Return the first place of a row that is before all others.
 * @param {any[]} row
 * @param {(a: any, b: any) => boolean} before
 */
function firstOf(row, before) {
  let best = 0;
  for (let k = 1; k < row.length; k++) if (before(row[k], row[best])) best = k;
  return best;
}

/**
 * @param {Nested} a
 * @param {Nested} b
 * @returns {Nested}
 */
function gathered(a, b) {
  return depth(a) === 1 ? b.map((/** @type {number} */ k) => a[k]) : a.map((/** @type {Nested} */ row, /** @type {number} */ k) => gathered(row, b[k]));
}

/**
 * @param {Nested[]} parts
 * @param {number} axis
 * @returns {Nested}
 */
function joinedArrays(parts, axis = 0) {
  const own = axis < 0 ? axis + depth(parts[0]) : axis;
  if (own === 0) return parts.flat();
  return parts[0].map((/** @type {Nested} */ _, /** @type {number} */ k) => joinedArrays(parts.map((one) => one[k]), own - 1));
}

/**
 * Return behind how many of a row that rises a number stands.
 * @param {number[]} row
 * @param {number} value
 */
function countBehind(row, value) {
  let [low, high] = [0, row.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (value < (row[middle] ?? NaN)) high = middle;
    else low = middle + 1;
  }
  return low;
}

/**
 * @param {number[]} sizes
 * @param {any} value
 * @returns {Nested}
 */
function filledWith(sizes, value) {
  const [count, ...rest] = sizes;
  return count === undefined ? value : Array.from({ length: count }, () => filledWith(rest, value));
}

/** Arithmetic of arrays as numpy has it; what the generator writes for rows calls it. */
export const ROWS = {
  at,
  enter: enterValues,
  shape,
  depth,
  plus: ofTwoArrays(OF_VALUES.plus),
  minus: ofTwoArrays(OF_VALUES.minus),
  times: ofTwoArrays(OF_VALUES.times),
  over: ofTwoArrays(OF_VALUES.over),
  power: ofTwoArrays(OF_VALUES.power),
  mod: ofTwoArrays((a, b) => ((a % b) + b) % b),
  opposite: ofEachValue(OF_VALUES.opposite),
  vector: ofTwoArrays(OF_VALUES.complex),
  complex: OF_VALUES.complex,
  real: ofEachValue(OF_VALUES.real),
  imag: ofEachValue(OF_VALUES.imag),
  conj: ofEachValue(OF_VALUES.conj),
  abs: ofEachValue(OF_VALUES.abs),
  sign: ofEachValue(Math.sign),
  sqrt: ofEachValue(Math.sqrt),
  sin: ofEachValue(Math.sin),
  arctan2: ofTwoArrays(Math.atan2),
  floor: ofEachValue(Math.floor),
  rint: ofEachValue(OF_VALUES.rint),
  degrees: ofEachValue(OF_VALUES.degrees),
  quadrant: ofEachValue(OF_VALUES.quadrant),
  copysign: ofTwoArrays(OF_VALUES.copysign),
  maximum,
  minimum,
  clip: (/** @type {Nested} */ x, /** @type {Nested} */ low, /** @type {Nested} */ high) => minimum(maximum(x, low), high),
  isfinite: ofEachValue(isFinitePlace),
  isnan: ofEachValue(OF_VALUES.missing),
  nan_to_num: (/** @type {Nested} */ x, /** @type {number} */ nan = 0) => ofEachValue((z) => (OF_VALUES.missing(z) ? nan : z))(x),
  not,
  and: ofTwoArrays((a, b) => a && b),
  or: ofTwoArrays((a, b) => a || b),
  equal: isEqual,
  unequal: (/** @type {Nested} */ a, /** @type {Nested} */ b) => not(isEqual(a, b)),
  less: ofTwoArrays((a, b) => a < b),
  less_equal: ofTwoArrays((a, b) => a <= b),
  greater: ofTwoArrays((a, b) => a > b),
  greater_equal: ofTwoArrays((a, b) => a >= b),
  where: (/** @type {Nested} */ mask, /** @type {Nested} */ a, /** @type {Nested} */ b) => chosenOf(mask, inPairs(a, b)),
  sum: reduced(sumOfRow),
  total: (/** @type {Nested[]} */ parts) => parts.reduce(ofTwoArrays(OF_VALUES.plus)),
  mean: reduced((row) => OF_VALUES.over(sumOfRow(row), row.length)),
  max: reduced((row) => Math.max(...row)),
  min: reduced((row) => Math.min(...row)),
  ptp: reduced((row) => Math.max(...row) - Math.min(...row)),
  all: reduced((row) => row.every(Boolean)),
  any: reduced((row) => row.some(Boolean)),
  argmax: reduced((row) => firstOf(row, (a, b) => a > b)),
  argmin: reduced((row) => firstOf(row, (a, b) => a < b)),
  cumsum: (/** @type {Nested} */ x, /** @type {number} */ axis) => along(x, axis, (row) => {
    let whole = /** @type {any} */ (0);
    return row.map((one) => (whole = OF_VALUES.plus(whole, one)));
  }),
  roll: (/** @type {Nested} */ x, /** @type {number} */ by, /** @type {number} */ axis) => along(x, axis, (row) => row.map((_, k) => row[(k - by + row.length) % row.length])),
  diff: (/** @type {Nested} */ x, /** @type {number} */ axis = -1, /** @type {Nested} */ append = null) =>
    along(append === null ? x : joinedArrays([x, append], -1), axis, (row) => row.slice(1).map((one, k) => OF_VALUES.minus(one, row[k]))),
  take_along_axis: gathered,
  concatenate: joinedArrays,
  append: (/** @type {Nested} */ x, /** @type {any} */ one) => [...x, one],
  array: (/** @type {Nested} */ x) => ofEachValue((one) => one)(x),
  full: filledWith,
  full_like: (/** @type {Nested} */ x, /** @type {any} */ value) => filledWith(shape(x), value),
  zeros_like: (/** @type {Nested} */ x) => filledWith(shape(x), 0),
  broadcast_to: (/** @type {Nested} */ x, /** @type {number[]} */ sizes) => ofTwoArrays((one) => one)(x, filledWith(sizes, 0)),
  broadcast_arrays: (/** @type {Nested[]} */ ...all) => {
    const like = all.reduce((a, b) => ofTwoArrays(() => 0)(a, b));
    return all.map((x) => ofTwoArrays((one) => one)(x, like));
  },
  alike: (/** @type {Nested[]} */ ...all) => all,
  arange: (/** @type {number} */ count) => Array.from({ length: count }, (_, k) => k),
  flatnonzero: (/** @type {boolean[]} */ x) => x.flatMap((own, k) => (own ? [k] : [])),
  split: (/** @type {Nested} */ x, /** @type {number[]} */ cuts) => [0, ...cuts].map((cut, k) => x.slice(cut, cuts[k])),
  knot_before: (/** @type {number[][]} */ x, /** @type {number[][]} */ feet) => feet.map((row, k) => row.map((foot) => countBehind(x[k] ?? [], foot) - 1)),
  size: (/** @type {Nested} */ x) => shape(x).reduce((a, b) => a * b, 1),
  periodic: (/** @type {Nested} */ x) => along(x, -1, periodicTangents),
  natural: naturalTangents,
  free_ends: (/** @type {Nested} */ x) => along(x, -1, freeTangents),
  take,
  put,
};

/**
 * Return a mark at all positions as an array, of a line and of an arc each of its parts; a curve is whole.
 * @param {(Drawn | undefined)[][]} positions
 * @param {number} slot
 * @returns {any}
 */
function take(positions, slot) {
  const row = positions.map((marks) => /** @type {any} */ (marks[slot]));
  const [first] = row;
  if (typeof first !== "object" || "re" in first) return [row];
  if ("knots" in first) return first;
  return Object.fromEntries(Object.keys(first).map((part) => [part, [row.map((own) => own[part])]]));
}

/**
 * Enter a mark at all positions.
 * @param {any[][]} positions
 * @param {number} slot
 * @param {any} value
 */
function put(positions, slot, value) {
  const own = (/** @type {Nested} */ x, /** @type {number} */ k) => x[0][x[0].length === 1 ? 0 : k];
  positions.forEach((marks, k) => {
    if (Array.isArray(value)) marks[slot] = own(value, k);
    else if ("knots" in value) marks[slot] = value;
    else marks[slot] = Object.fromEntries(Object.entries(value).map(([part, x]) => [part, own(x, k)]));
  });
}
