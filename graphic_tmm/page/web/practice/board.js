/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").DrawnLine} DrawnLine
 * @typedef {import("../types.js").DrawnArc} DrawnArc
 * @typedef {(...values: any[]) => Drawn} Operation values of marks, then choices
 * @typedef {(M: any, ...further: any[]) => any} StraightLog values by slots, or in the second table those in each of several positions (page/live/log.py)
 * @typedef {{
 *   off_line: (line: DrawnLine, found: Complex) => number,
 *   off_arc: (arc: DrawnArc, found: Complex) => number,
 *   off_place: (found: Complex, due: Complex) => number,
 *   off_length: (line: DrawnLine, length: number, found: Complex) => number,
 *   off_meeting: (found: Complex, due: Complex, other: Complex) => number,
 *   off_ray: (found: Complex, due: Complex, centre: Complex) => number,
 *   off_opening: (found: Complex, due: Complex, centre: Complex) => number,
 *   sine_between: (due: Complex, first: Complex, second: Complex) => number,
 *   reflected: (due: Complex, first: Complex, second: Complex) => Complex,
 *   nearer: (one: number, other: number) => number,
 *   excess: (found: number, due: number) => number,
 *   directed: (found: number, due: number) => number,
 *   counted: (error: number, grain: number) => number,
 *   sized: (blunt: number, sharp: number, share: number) => number,
 *   swung: (far: number, swing: number) => number,
 *   opened: (share: number, compass: number, reading: number, half: number) => number,
 *   found_within: (slip: number, prick: number, pointing: number) => number,
 *   severity: (deviation: number, times: number, doubtful: number, wrong: number, absurd: number) => number,
 *   times_off: (found: number, due: number) => number,
 *   unblurred: (half: number, written: number, reading: number) => number,
 *   lost: (x: number, y: number, slip: number) => number,
 *   rounding: (digits: number, figure: number) => number,
 * }} Slips the functions of checking/judging/slips.py
 */

/**
 * The operations of the board and what tells how far something is off. They are written down from their Python
 * sources where a page is written (board/script.py), and entered here before anything else runs.
 */
export const BOARD = {
  /** @type {Record<string, Operation>} */
  operations: {},
  /** @type {Slips} */
  slips: /** @type {Slips} */ ({}),
  /** Rows of steps of the log, each entering the values of its marks by their slots. @type {Record<string, StraightLog>} */
  log: {},
};

/** @param {typeof BOARD} written */
export function enterBoard(written) {
  Object.assign(BOARD.operations, written.operations);
  Object.assign(BOARD.slips, written.slips);
  Object.assign(BOARD.log, written.log);
}
