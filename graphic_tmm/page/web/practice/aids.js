import { distance } from "./figures.js";
import { shownNumber } from "./typed.js";

/**
 * @typedef {import("./easel.js").Easel} Easel
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {import("./picking.js").Move} Move
 * @typedef {import("./paper.js").Ruler} Ruler
 */

/** The ruler goes so far beyond what is read or laid off on it, mm. */
const MORE = 15;

/**
 * Return how the ruler lies for a step whose answer is due; null if it needs none.
 * @param {Move} move
 * @param {Easel} easel
 * @returns {Ruler | null}
 */
export function rulerFor(move, easel) {
  if (LAYINGS.includes(move.op)) return layingRuler(move, easel);
  return READINGS.includes(move.op) ? readingRuler(move, easel) : null;
}

/**
 * Return the ruler along a line, its zero where that begins.
 * @param {Move} move
 * @param {Easel} easel
 * @returns {Ruler | null}
 */
function layingRuler({ uses }, easel) {
  const [on, length] = uses;
  const line = easel.values.line(on ?? -1);
  const long = Math.abs(Number(easel.value(length ?? -1) ?? 0)) + MORE;
  return line === null ? null : { zero: line.at, along: line.along, from: -long, to: long, read: null };
}

/**
 * Return the ruler from a point to another one.
 * @param {Move} move
 * @param {Easel} easel
 * @returns {Ruler | null}
 */
function readingRuler({ uses }, easel) {
  const [from, to] = [easel.values.spot(uses[0] ?? -1), easel.values.spot(uses[1] ?? -1)];
  if (from === null || to === null) return null;
  const whole = distance(from, to);
  const along = /** @type {Spot} */ (whole < NO_WAY ? [1, 0] : [(to[0] - from[0]) / whole, (to[1] - from[1]) / whole]);
  return { zero: from, along, from: -5, to: whole + MORE, read: to };
}

/** Operations that lay a length off along a line. */
const LAYINGS = ["lay_off", "place"];
/** Operations that read a length. */
const READINGS = ["measure", "measure_along"];
/** Points so near are one, mm. */
const NO_WAY = 0.001;

/**
 * Return what the compass tells while a similar figure is built: distances of the link, those of the cross.
 * @param {Move} move
 * @param {Easel} easel
 * @param {Spot} aim
 * @returns {[string, string][]} of each two letters as mark-up, the distance
 */
export function distancesFor(move, easel, aim) {
  const base = BASES[move.op];
  if (base === undefined) return [];
  const told = (/** @type {number} */ mm) => shownNumber(mm, 1, easel.decimal);
  const spots = move.uses.map((slot) => easel.values.spot(slot));
  const named = move.uses.map((slot) => easel.letterOf(slot));
  /** @type {[string, string][]} */
  const found = base.link.flatMap(([a, b]) => {
    const [one, other] = [spots[a], spots[b]];
    return one && other ? [[`${named[a]}${named[b]}`, told(distance(one, other))]] : [];
  });
  for (const k of base.plan) {
    const spot = spots[k];
    if (spot) found.push([`${named[k]}${easel.letterOf(move.it)}`, told(distance(spot, aim))]);
  }
  return found;
}

/**
 * Of a similar figure: which distances of the plan and of the link are read, from which points the cross is seen.
 * @type {Record<string, {link: [number, number][], plan: number[]}>}
 */
const BASES = {
  similar: { link: [[0, 1], [2, 3], [2, 4], [3, 4]], plan: [0, 1] },
  homologous: { link: [[1, 2], [3, 4], [5, 6]], plan: [0] },
};

/**
 * Return where the cross stands when a point is to be pricked: where the ruler begins, else in the middle.
 * @param {Ruler | null} ruler
 * @param {import("./figures.js").Frame} frame
 * @returns {Spot}
 */
export function beginningOf(ruler, [left, low, right, high]) {
  return ruler === null ? [(left + right) / 2, (low + high) / 2] : [...ruler.zero];
}
