/**
 * The instruments of practice. A step is taken in three moves: an instrument is chosen, then what it is laid to, then
 * what comes of it is told: a line or an arc appears by itself, a point is pricked, a length or a rate is written.
 *
 * One instrument may do several operations of the board: to a student a rocker's line is drawn with the edge of the
 * ruler, as any other line is.
 *
 * @typedef {"P" | "L" | "A" | "M" | "N" | "G"} Sort point, line, arc, length in mm, number, angle
 * @typedef {{name: string, key: string, sign: string, ops: Record<string, string>}} Instrument its name among the
 *   words, its key, its sign (path data in a box of 24), the sorts that each of its operations asks for
 */

/** The sorts of marks by their kinds on the board. @type {Record<string, Sort>} */
export const SORTS = { point: "P", line: "L", arc: "A", length: "M", number: "N", angle: "G" };

/**
 * The sorts that are asked for, one letter each; "*": as many numbers, lengths and angles as a formula needs. What is
 * not asked for lies with what is: the line along which is measured, the figure of the link, scale factors, sides.
 * @type {Instrument[]}
 */
export const INSTRUMENTS = [
  { name: "edge", key: "1", sign: "M3 17 21 7M6 15.5h.1M18 8.7h.1", ops: { join: "PP", rocker_line: "PP", cylinder_axis: "PP" } },
  {
    name: "parallel",
    key: "2",
    sign: "M3 19 15 4M9 21 21 6",
    ops: { parallel: "PL", directed: "PL", shift: "LM" },
  },
  { name: "square", key: "3", sign: "M4 20h17M8 20V4M8 16h4v4", ops: { square: "PL" } },
  {
    name: "protractor",
    key: "4",
    sign: "M4 20h17M4 20 17 6M13 20a9 9 0 0 0-2.9-6.6",
    ops: { ray: "PG", incline: "PLG", tangent: "PPM" },
  },
  { name: "compass", key: "5", sign: "M12 3v3M12 6 6 20M12 6l6 14M5 14c4 4 10 4 14 0", ops: { strike: "PM" } },
  { name: "laying", key: "6", sign: "M2 8h20v8H2zM6 8v4M10 8v3M14 8v4M18 8v3", ops: { lay_off: "LM", place: "LMM" } },
  { name: "meeting", key: "7", sign: "M4 4l16 16M20 4 4 20M12 12h.1", ops: { meet: "LL", cut: "LA", cross: "AA" } },
  {
    name: "figure",
    key: "8",
    sign: "M3 20h7L5 12zM12 20h9l-6.5-15z",
    ops: { similar: "PPP", homologous: "PP", coincide: "P", carry_over: "P" },
  },
  { name: "reading", key: "9", sign: "M2 12h20M5 9v6M19 9v6M9 12V9M12 12V8M15 12V9", ops: { measure: "PP", measure_along: "PP" } },
  { name: "formula", key: "0", sign: "M6 3h12v18H6zM9 7h6M9 12h.1M12 12h.1M15 12h.1M9 16h.1M12 16h.1M15 16h.1", ops: {} },
];

/** What a student writes is calculated by a formula; its operations are the chapters' own. */
export const CALCULATOR = "formula";

/** Only this one goes out from points of another plan, those of the link. */
export const LINKED = "figure";

/**
 * What lies with the rest, by the places of an operation's arguments.
 * @type {Record<string, number[]>}
 */
const LYING = { carry_over: [1, 2], measure_along: [2], similar: [2, 3], homologous: [1, 2, 3, 4, 5] };

/**
 * Return the instrument of an operation.
 * @param {string} op
 * @returns {Instrument}
 */
export function instrumentOf(op) {
  const found = INSTRUMENTS.find((one) => op in one.ops) ?? INSTRUMENTS.find((one) => one.name === CALCULATOR);
  return /** @type {Instrument} */ (found);
}

/**
 * Whether an argument of an operation is asked for.
 * @param {string} op
 * @param {number} place
 */
export function isAsked(op, place) {
  return !(LYING[op] ?? []).includes(place);
}
