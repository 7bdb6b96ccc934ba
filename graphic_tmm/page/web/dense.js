/** @typedef {import("./types.js").Dense} Dense */

/**
 * Return a row of drawn angles at every degree, mm: what lies between is laid through four places by Lagrange's cubic,
 * but for the intervals that were drawn degree by degree. It does what page/strands.py does.
 * @param {Int32Array} row
 * @param {number} whole
 * @param {number} step
 * @param {number[]} refined
 * @returns {Float32Array}
 */
export function spreadRow(row, whole, step, refined) {
  const count = whole / step;
  const inside = (step - 1) * refined.length;
  const found = new Float32Array(whole + row.length - count - inside);
  const at = (/** @type {number} */ k) => row[(k + count) % count] ?? 0;
  const bad = new Set(refined);
  for (let i = 0; i < count; i++) {
    found[step * i] = at(i);
    if (bad.has(i)) continue;
    const start = bad.has((i + count - 1) % count) ? 0 : bad.has((i + 1) % count) ? -2 : -1;
    for (let j = 1; j < step; j++) {
      const share = weights(j / step - 1 - start);
      let value = 0;
      for (let n = 0; n < 4; n++) value += (share[n] ?? 0) * at(i + start + n);
      found[step * i + j] = value;
    }
  }
  refined.forEach((i, n) => {
    for (let j = 1; j < step; j++) {
      const straight = Math.floor(((at(i + 1) - at(i)) * j) / step);
      found[step * i + j] = (row[count + (step - 1) * n + j - 1] ?? 0) + at(i) + straight;
    }
  });
  for (let k = count + inside; k < row.length; k++) found[whole + k - count - inside] = row[k] ?? 0;
  return found.map((value) => value / 1000);
}

/**
 * Return how much of four even places makes what lies between the middle two, `u` of the way on.
 * @param {number} u
 */
function weights(u) {
  return [
    (-u * (u - 1) * (u - 2)) / 6,
    ((u + 1) * (u - 1) * (u - 2)) / 2,
    (-(u + 1) * u * (u - 2)) / 2,
    ((u + 1) * u * (u - 1)) / 6,
  ];
}

/**
 * Return at which degrees something is there; null: at all of them.
 * @param {number[] | 0} runs from which to behind which drawn angle
 * @param {number[]} drawn for each degree the number of the drawn angle that tells of it
 * @returns {Uint8Array | null}
 */
export function presenceOf(runs, drawn) {
  if (runs === 0) return null;
  return Uint8Array.from(drawn, (k) => {
    const passed = runs.filter((end) => end <= k).length;
    return passed % 2;
  });
}

/**
 * Return for each degree the number of the drawn angle that is nearest.
 * @param {number} whole
 * @param {number} step
 * @param {number[]} refined
 * @param {number} more
 */
export function nearestDrawn(whole, step, refined, more) {
  const count = whole / step;
  const found = Array.from({ length: whole }, (_, k) => Math.round(k / step) % count);
  refined.forEach((i, n) => {
    for (let j = 1; j < step; j++) found[step * i + j] = count + (step - 1) * n + j - 1;
  });
  for (let k = 0; k < more; k++) found.push(count + (step - 1) * refined.length + k);
  return found;
}

/**
 * Return a turn from the beginning of the row on: round and round, or no farther than its ends.
 * @param {Dense} dense
 * @param {number} turn
 */
export function turnWithin(dense, turn) {
  if (dense.ends !== undefined) return Math.min(Math.max(turn, 0), dense.whole - 1);
  return ((turn % dense.whole) + dense.whole) % dense.whole;
}

/**
 * Return the index of the angle nearest to a turn: a whole degree, or a position between two.
 * @param {Dense} dense
 * @param {number} turn
 */
export function indexAt(dense, turn) {
  const own = turnWithin(dense, turn);
  let best = Math.round(own) % dense.whole;
  let off = Math.abs(own - Math.round(own));
  dense.more.forEach((at, k) => {
    if (Math.abs(at - own) < off) [best, off] = [dense.whole + k, Math.abs(at - own)];
  });
  return best;
}

/**
 * Return the turn at an index.
 * @param {Dense} dense
 * @param {number} index
 */
export function turnAt(dense, index) {
  return index < dense.whole ? index : (dense.more[index - dense.whole] ?? 0);
}

/**
 * Return why an angle cannot be drawn; "" if it can.
 * @param {Dense} dense
 * @param {number} index
 */
export function whyNot(dense, index) {
  return dense.why.find(([from, to]) => from <= index && index <= to)?.[2] ?? "";
}
