/**
 * Return a row or a number as a function of the angle (index), mm.
 * @param {number[]} told a number of thousandths, or a row and a distance
 * @param {Float32Array[]} rows
 * @returns {(k: number) => number}
 */
export function placeOf(told, rows) {
  const [first = 0, by] = told;
  if (by === undefined) return () => first / 1000;
  const row = rows[first] ?? new Float32Array(1);
  return (k) => (row[k] ?? 0) + by / 1000;
}

/**
 * Return the data of a path through places, y upward; a bulge bends what goes to the next one, as in DXF.
 * @param {Float64Array} at x, y, x, y …
 * @param {number[] | null} bulges
 * @param {boolean} closed
 */
export function pathOf(at, bulges, closed) {
  const [x, y] = /** @type {[number, number]} */ (/** @type {unknown} */ (at));
  let text = `M${hundredths(x)} ${hundredths(-y)}`;
  const count = at.length / 2;
  const last = closed && bulges !== null ? count : count - 1;
  for (let n = 0; n < last; n++) text += segment(at, n, (n + 1) % count, bulges?.[n] ?? 0);
  return closed ? `${text}Z` : text;
}

/**
 * @param {Float64Array} at
 * @param {number} from the number of a place
 * @param {number} to
 * @param {number} bulge
 */
function segment(at, from, to, bulge) {
  const [x, y] = /** @type {[number, number]} */ ([at[2 * from], at[2 * from + 1]]);
  const [u, v] = /** @type {[number, number]} */ ([at[2 * to], at[2 * to + 1]]);
  return bulge === 0 ? `L${hundredths(u)} ${hundredths(-v)}` : arc(x, y, u, v, bulge);
}

/**
 * An arc in pieces of 90° at most, so that rounding keeps its centre.
 * @param {number} x
 * @param {number} y
 * @param {number} u
 * @param {number} v
 * @param {number} bulge
 */
function arc(x, y, u, v, bulge) {
  const side = (1 - bulge * bulge) / (4 * bulge);
  const [p, q] = [(x + u) / 2 - (v - y) * side, (y + v) / 2 + (u - x) * side];
  const radius = Math.hypot(x - p, y - q);
  const whole = 4 * Math.atan(bulge);
  const pieces = Math.max(1, Math.ceil(Math.abs(whole) / (Math.PI / 2) - 1e-9));
  const start = Math.atan2(y - q, x - p);
  const way = `A${hundredths(radius)} ${hundredths(radius)} 0 0 ${bulge > 0 ? 0 : 1} `;
  let text = "";
  for (let k = 1; k <= pieces; k++) {
    const turn = start + (whole * k) / pieces;
    const [c, d] = k === pieces ? [u, v] : [p + radius * Math.cos(turn), q + radius * Math.sin(turn)];
    text += `${way}${hundredths(c)} ${hundredths(-d)}`;
  }
  return text;
}

/**
 * A length to a hundredth of a millimetre.
 * @param {number} value
 */
export function hundredths(value) {
  return Math.round(value * 100) / 100;
}
