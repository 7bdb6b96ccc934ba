import { apart, cornersOf, minus, movingOf, placeOf, unit } from "./sketch.js";

/**
 * Where the number of a link stands: beside its bar, clear of other bars and of letters.
 *
 * @typedef {import("./sketch.js").Body} Body
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./view.js").Dots} Dots
 * @typedef {import("./view.js").View} View
 */

/** How far from its bar it stands, dots; under a stone. */
const OFF = 14;
const UNDER = [22, 20];
/** Along the bar it stands in the middle, else at the next of these shares where there is more room. */
const SHARES = [0.5, 0.35, 0.65, 0.25, 0.75];
/** So many dots about it are room enough; a letter stands so far from its pin, and needs as much itself. */
const ROOM = 13;
const LETTER = 14;

/**
 * @param {Sketch} sketch
 * @param {Body} body
 * @param {View} view
 * @returns {Dots | null}
 */
export function numberAt(sketch, body, view) {
  const dots = cornersOf(sketch, body).map((one) => view.dots(placeOf(sketch, one)));
  const [first, last] = dots;
  if (first === undefined) return null;
  if (last === undefined) return [first[0] + (UNDER[0] ?? 0), first[1] + (UNDER[1] ?? 0)];
  if (dots.length > 2) return [mean(dots.map((one) => one[0])), mean(dots.map((one) => one[1]))];
  const [x, y] = unit(minus(last, first));
  const places = SHARES.flatMap((share) =>
    [OFF, -OFF].map((off) => /** @type {Dots} */ ([first[0] + share * (last[0] - first[0]) + off * y, first[1] + share * (last[1] - first[1]) - off * x])),
  );
  const rooms = places.map((place) => roomAt(sketch, body, view, place));
  const best = rooms.findIndex((room) => room >= ROOM);
  return places[best < 0 ? rooms.indexOf(Math.max(...rooms)) : best] ?? null;
}

/**
 * How far it is from a place to the nearest bar of another link, or to the letters about a pin.
 * @param {Sketch} sketch
 * @param {Body} body
 * @param {View} view
 * @param {Dots} place
 */
function roomAt(sketch, body, view, place) {
  const pins = Object.values(sketch.places).map((one) => apart(place, view.dots(one)) - LETTER);
  const bars = movingOf(sketch).flatMap((other) => {
    const dots = other === body ? [] : cornersOf(sketch, other).map((one) => view.dots(placeOf(sketch, one)));
    return dots.map((end, k) => toSegment(place, dots.at(k - 1) ?? end, end));
  });
  return Math.min(...pins, ...bars);
}

/**
 * @param {Dots} place
 * @param {Dots} start
 * @param {Dots} end
 */
function toSegment(place, start, end) {
  const [x, y] = minus(end, start);
  const [u, v] = minus(place, start);
  const share = Math.min(Math.max((u * x + v * y) / (x * x + y * y || 1), 0), 1);
  return Math.hypot(u - share * x, v - share * y);
}

/** @param {number[]} row */
function mean(row) {
  return row.reduce((sum, one) => sum + one, 0) / row.length;
}
