import { hundredths } from "../strokes.js";

/** What is off where it was by more has moved, mm or a share of it. */
const MOVED = 1e-6;

/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").DrawnCurve} DrawnCurve
 * @typedef {[Complex, Complex, Complex, Complex]} CubicArc its ends, its tangents there
 */

/**
 * Return an arc of a curve; undefined where it is broken.
 * @param {DrawnCurve} curve
 * @param {number} k
 * @returns {CubicArc | undefined}
 */
function arcOf({ knots: [knots = []], tangents: [tangents = []] }, k) {
  const after = (k + 1) % knots.length;
  const [p, q, m, n] = [knots[k], knots[after], tangents[k], tangents[after]];
  if (!p || !q || !m || !n) return undefined;
  return [p, q, m, n].every((z) => Number.isFinite(z.re + z.im)) ? [p, q, m, n] : undefined;
}

/**
 * @param {CubicArc} arc
 * @param {number[]} by how much of each of its numbers
 */
function mixed(arc, by) {
  const sum = (/** @type {"re" | "im"} */ part) => arc.reduce((whole, z, k) => whole + (by[k] ?? 0) * z[part], 0);
  return { re: sum("re"), im: sum("im") };
}

/**
 * @param {CubicArc} arc
 * @param {number} u
 */
function placeOnArc(arc, u) {
  return mixed(arc, [(2 * u + 1) * (u - 1) ** 2, u ** 2 * (3 - 2 * u), u * (u - 1) ** 2, u ** 2 * (u - 1)]);
}

/**
 * Return a part of an arc.
 * @param {CubicArc} arc
 * @param {number} u
 * @param {number} v
 * @returns {CubicArc}
 */
function partOfArc(arc, u, v) {
  if (u === 0 && v === 1) return arc;
  const along = (/** @type {number} */ t) => {
    const way = mixed(arc, [6 * t * (t - 1), 6 * t * (1 - t), (3 * t - 1) * (t - 1), t * (3 * t - 2)]);
    return { re: (v - u) * way.re, im: (v - u) * way.im };
  };
  return [placeOnArc(arc, u), placeOnArc(arc, v), along(u), along(v)];
}

/**
 * Return a place on a curve whose knots are the positions.
 * @param {DrawnCurve} curve
 * @param {number} number
 * @returns {Complex | undefined}
 */
export function placeOnCurve(curve, number) {
  const count = curve.knots[0]?.length ?? 1;
  const first = ((Math.floor(number) % count) + count) % count;
  const arc = arcOf(curve, first);
  return arc === undefined ? undefined : placeOnArc(arc, number - Math.floor(number));
}

/**
 * Return a curve as cubic arcs on the sheet; where it has no tangent it is broken.
 * @param {DrawnCurve} curve
 * @param {[number, number]} at
 * @param {number[]} over from where to where on its base it goes, if it has one; x runs evenly along each arc
 */
export function curvePath(curve, [x, y], [from = -Infinity, to = Infinity]) {
  const on = (/** @type {number} */ u, /** @type {number} */ v) => `${hundredths(x + u)} ${hundredths(y - v)}`;
  const count = curve.knots[0]?.length ?? 0;
  let text = "";
  for (let k = 0; k < count - (curve.closed ? 0 : 1); k++) {
    const arc = arcOf(curve, k);
    if (arc === undefined) continue;
    const [start, end] = [from, to].map((foot) => Math.min(Math.max((foot - arc[0].re) / (arc[1].re - arc[0].re), 0), 1));
    const [u = 0, v = 1] = from === -Infinity ? [] : [start, end];
    if (!(v - u > 1e-9)) continue;
    const [p, q, m, n] = partOfArc(arc, u, v);
    text += `M${on(p.re, p.im)}C${on(p.re + m.re / 3, p.im + m.im / 3)} ${on(q.re - n.re / 3, q.im - n.im / 3)} ${on(q.re, q.im)}`;
  }
  return text;
}

/**
 * @param {any} value
 * @returns {value is Complex}
 */
export function isPlace(value) {
  return typeof value === "object" && "re" in value;
}

/**
 * @param {any} value
 * @returns {value is import("../types.js").DrawnLine}
 */
export function isLine(value) {
  return typeof value === "object" && "along" in value;
}

/**
 * @param {any} value
 * @returns {value is DrawnCurve}
 */
export function isCurve(value) {
  return typeof value === "object" && "knots" in value;
}

/**
 * @param {any} point
 * @returns {Complex | null}
 */
export function knownPoint(point) {
  return isPlace(point) && Number.isFinite(point.re + point.im) ? point : null;
}

/**
 * Tell whether two values are the same; what is not there is like nothing.
 * @param {any} a
 * @param {any} b
 * @returns {boolean}
 */
export function sameValue(a, b) {
  if (a === undefined || b === undefined) return a === b;
  if (typeof a !== "object") return a === b || Math.abs(a - b) <= MOVED * Math.max(1, Math.abs(a)) || (Number.isNaN(a) && Number.isNaN(b));
  return a === b || Object.keys(a).every((key) => sameValue(a[key], b[key]));
}
