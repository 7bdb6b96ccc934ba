import { distance, besideArc, besideLine, onLine, pieceIn, wayAlong } from "./figures.js";

/**
 * What stands on the board, as it is drawn and picked.
 *
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {import("./figures.js").Frame} Frame
 * @typedef {import("./figures.js").Ray} Ray
 * @typedef {import("./figures.js").Circle} Circle
 * @typedef {import("./picking.js").Move} Move
 * @typedef {{slot: number, of: number, sort: "P", spot: Spot}} Dot
 * @typedef {{slot: number, of: number, sort: "L", line: Ray, ends: [Spot, Spot]}} Stroke
 * @typedef {{slot: number, of: number, sort: "A", arc: Circle}} Bow
 * @typedef {{slot: number, of: number, sort: "V", ends: [Spot, Spot], main: boolean}} Vector a length that is laid off or read
 * @typedef {Dot | Stroke | Bow | Vector} Shape `slot` is what one picks there, `of` the step whose ink it is
 * @typedef {{spot: (slot: number) => Spot | null, line: (slot: number) => Ray | null, arc: (slot: number) => Circle | null}} Values
 */

/** A line goes so far beyond what stands on it, mm. */
const BEYOND = 6;
/** A segment that is shorter is none, mm. */
const SHORTEST = 0.05;
/** From which of its marks to which an operation leaves a segment that stays. @type {Record<string, [number, number]>} */
const SEGMENTS = { measure: [0, 1], measure_along: [0, 1], join: [0, 1], rocker_line: [0, 1], cylinder_axis: [0, 1] };

/**
 * Return what is drawn of marks: lines thin, segments over them, points on top.
 * @param {number[]} slots the marks that are there
 * @param {Move[]} moves the steps that are done
 * @param {Values} values
 * @param {Frame} frame
 * @returns {Shape[]}
 */
export function shapesOf(slots, moves, values, frame) {
  /** @type {Shape[]} */
  const found = [];
  for (const slot of slots) {
    const arc = values.arc(slot);
    const line = values.line(slot);
    if (arc !== null) found.push({ slot, of: slot, sort: "A", arc });
    if (line !== null) found.push(...lineShape(slot, line, spotsOn(slot, moves, values), frame));
  }
  found.push(...moves.flatMap((move) => vectorOf(move, values)));
  for (const slot of slots) {
    const spot = values.spot(slot);
    if (spot !== null) found.push({ slot, of: slot, sort: "P", spot });
  }
  return found;
}

/**
 * Return a line as far as it is of use: through the whole frame until points stand on it.
 * @param {number} slot
 * @param {Ray} line
 * @param {Spot[]} on
 * @param {Frame} frame
 * @returns {Stroke[]}
 */
function lineShape(slot, line, on, frame) {
  const ends = pieceIn(line, frame);
  if (ends === null) return [];
  if (on.length === 0) return [{ slot, of: slot, sort: "L", line, ends }];
  const [from, to] = ends.map((end) => wayAlong(line, end));
  const ways = [0, ...on.map((spot) => wayAlong(line, spot))];
  const first = Math.max(Math.min(...ways) - BEYOND, from ?? 0);
  const last = Math.min(Math.max(...ways) + BEYOND, to ?? 0);
  return first < last ? [{ slot, of: slot, sort: "L", line, ends: [onLine(line, first), onLine(line, last)] }] : [];
}

/**
 * Return the points that were found on a line.
 * @param {number} slot
 * @param {Move[]} moves
 * @param {Values} values
 */
function spotsOn(slot, moves, values) {
  const found = moves.filter((move) => move.uses.includes(slot)).map((move) => values.spot(move.it));
  const own = moves.find((move) => move.it === slot && move.op in SEGMENTS);
  return [...found, ...(own === undefined ? [] : endsOf(own, values))].filter((spot) => spot !== null);
}

/**
 * Return the segment that a step leaves: a length laid off, read or joined.
 * @param {Move} move
 * @param {Values} values
 * @returns {Vector[]}
 */
function vectorOf(move, values) {
  const [from, to] = endsOf(move, values);
  if (from === null || to === null || distance(from, to) < SHORTEST) return [];
  const slot = move.op === "lay_off" ? (move.uses[1] ?? move.it) : move.it;
  return [{ slot, of: move.it, sort: "V", ends: [from, to], main: move.op !== "measure_along" }];
}

/**
 * @param {Move} move
 * @param {Values} values
 * @returns {[Spot | null, Spot | null]}
 */
function endsOf({ op, uses, it }, values) {
  if (op === "lay_off") return [values.line(uses[0] ?? -1)?.at ?? null, values.spot(it)];
  const [a, b] = SEGMENTS[op] ?? [-1, -1];
  return [values.spot(uses[a] ?? -1), values.spot(uses[b] ?? -1)];
}

/**
 * Return how far a place is from a shape, mm.
 * @param {Shape} shape
 * @param {Spot} spot
 */
export function awayFrom(shape, spot) {
  if (shape.sort === "P") return distance(shape.spot, spot);
  if (shape.sort === "A") return besideArc(shape.arc, spot);
  const [from, to] = shape.ends;
  const whole = distance(from, to);
  const line = { at: from, along: /** @type {Spot} */ ([(to[0] - from[0]) / whole, (to[1] - from[1]) / whole]) };
  const way = wayAlong(line, spot);
  if (way < 0) return distance(from, spot);
  return way > whole ? distance(to, spot) : besideLine(line, spot);
}

/**
 * Return what may be meant at a place, the likeliest first: points before what goes through them, what is alike near
 * together.
 * @param {Shape[]} shapes
 * @param {Spot} spot
 * @param {number} reach mm
 * @param {(slot: number) => boolean} fits
 * @returns {number[]} slots
 */
export function meantAt(shapes, spot, reach, fits) {
  const near = shapes
    .filter((shape) => fits(shape.slot))
    .map((shape) => ({ slot: shape.slot, point: shape.sort === "P", away: awayFrom(shape, spot) }))
    .filter((one) => one.away <= reach)
    .sort((a, b) => Number(b.point) - Number(a.point) || a.away - b.away);
  const first = near[0];
  if (first === undefined) return [];
  const alike = near.filter((one) => one.point === first.point && one.away - first.away < reach / 3);
  return [...new Set(alike.map((one) => one.slot))];
}
