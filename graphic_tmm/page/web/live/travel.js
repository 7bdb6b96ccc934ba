/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").Output} Output
 * @typedef {{travel: number, ratio: number}} Strokes from end to end, m or degrees; K_v
 */

/**
 * Tell what a mechanism moves to and fro over a turn; null where it does not turn round, or its output does.
 * @param {Output} out
 * @param {(Drawn | undefined)[][]} rows marks by their slots, at equal steps of a turn
 * @param {number} scale of the plan, m/mm
 * @returns {Strokes | null}
 */
export function strokesOf(out, rows, scale) {
  const places = rows.map((marks) => placeIn(marks[out.slot]));
  const pivots = rows.map((marks) => (out.pivot === undefined ? PIVOT : placeIn(marks[out.pivot])));
  const arms = places.map((one, k) => apartFrom(one, pivots[k] ?? NOWHERE));
  if (!arms.every((arm) => Number.isFinite(arm.re + arm.im))) return null;
  const row = out.pivot === undefined ? travelOn(arms) : bearings(arms);
  if (row === null) return null;
  const [high, low] = [peak(row, 1), peak(row, -1)];
  const way = (((high.at - low.at) % row.length) + row.length) % row.length;
  const slower = Math.max(way, row.length - way);
  return {
    travel: (high.value - low.value) * (out.pivot === undefined ? scale : 180 / Math.PI),
    ratio: slower / (row.length - slower),
  };
}

const PIVOT = { re: 0, im: 0 };
const NOWHERE = { re: NaN, im: NaN };

/**
 * @param {Drawn | undefined} mark
 * @returns {Complex}
 */
function placeIn(mark) {
  return mark !== undefined && typeof mark !== "number" && "re" in mark ? mark : NOWHERE;
}

/**
 * @param {Complex} one
 * @param {Complex} other
 */
function apartFrom(one, other) {
  return { re: one.re - other.re, im: one.im - other.im };
}

/**
 * Return how far places on a line are along it.
 * @param {Complex[]} places
 */
function travelOn(places) {
  const [first = NOWHERE] = places;
  const off = places.map((one) => apartFrom(one, first));
  const far = off.reduce((held, one) => (Math.hypot(one.re, one.im) > Math.hypot(held.re, held.im) ? one : held), PIVOT);
  const size = Math.hypot(far.re, far.im);
  return size > 0 ? off.map((one) => (one.re * far.re + one.im * far.im) / size) : null;
}

/**
 * Return the bearings of arms, without jumps; null where they go round.
 * @param {Complex[]} arms
 */
function bearings(arms) {
  /** @type {number[]} */
  const row = [];
  let held = 0;
  for (const arm of [...arms, arms[0] ?? NOWHERE]) {
    const bearing = Math.atan2(arm.im, arm.re);
    held = bearing + 2 * Math.PI * Math.round((held - bearing) / (2 * Math.PI));
    row.push(held);
  }
  const round = Math.abs((row.pop() ?? 0) - (row[0] ?? 0)) > 1;
  return round ? null : row;
}

/**
 * Return the greatest (sign 1) or least value of a row, and at which step: of the parabola through three.
 * @param {number[]} row
 * @param {number} sign
 */
function peak(row, sign) {
  let k = 0;
  row.forEach((value, n) => {
    if (sign * (value - (row[k] ?? value)) > 0) k = n;
  });
  const at = (/** @type {number} */ n) => row[(n + row.length) % row.length] ?? NaN;
  const [before, there, after] = [at(k - 1), at(k), at(k + 1)];
  const bend = before - 2 * there + after;
  const off = bend === 0 ? 0 : (before - after) / (2 * bend);
  return { at: k + off, value: there - (off * (before - after)) / 4 };
}
