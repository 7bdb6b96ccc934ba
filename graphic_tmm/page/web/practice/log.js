import { ARITHMETIC } from "./arithmetic.js";
import { BOARD } from "./board.js";
import { givenAt } from "./given.js";

/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").Practice} Practice
 * @typedef {import("../types.js").PracticeStep} PracticeStep
 * @typedef {import("../types.js").Part} Part
 * @typedef {{found: number | Complex, read: number, used: number}} Read what was read of a mark; how far rounding
 *   alone may carry it as it was read, and as others are calculated with it
 * @typedef {{slot: number, error: number, grain: number}} OwnError of a step (its mark), mm or in the unit of a rate
 * @typedef {{values: Map<number, Drawn>, due: Map<number, Drawn>, errors: Map<number, OwnError[]>}} Run
 */

/**
 * The log of a mechanism in one position: what is given there, its steps, run with what was read in the place of
 * what it measured, calculated and marked, as checking/judging/own_errors.py does.
 */
export class Log {
  /**
   * @param {Practice} data
   * @param {number} at position
   */
  constructor(data, at) {
    this.data = data;
    /** @type {Map<number, PracticeStep>} */
    this.steps = new Map(data.steps.map((step) => [step.it, step]));
    /** @type {Map<number, Drawn>} */
    this.given = new Map();
    for (const [slot, told] of Object.entries(data.given)) this.given.set(Number(slot), givenAt(data.marks[slot]?.k ?? "number", told, at));
    /** What the exact hand has of every mark. @type {Map<number, Drawn>} */
    this.exact = this.run(new Map()).values;
  }

  /**
   * Run the log with what was read.
   * @param {Map<number, Read>} found
   * @returns {Run}
   */
  run(found) {
    const run = { values: new Map(this.given), due: new Map(), errors: new Map() };
    for (const step of this.data.steps) {
      const taken = step.uses.map((slot) => run.values.get(slot));
      let value = done(step, taken);
      const read = found.get(step.it);
      if (read !== undefined) {
        run.due.set(step.it, value);
        run.errors.set(step.it, this.errors(step, read, value, taken, found, run));
        value = typeof read.found === "number" ? BOARD.slips.directed(read.found, /** @type {number} */ (value)) : read.found;
      }
      run.values.set(step.it, value);
    }
    return run;
  }

  /**
   * Return the errors that a step made itself.
   * @param {PracticeStep} step
   * @param {Read} read
   * @param {Drawn} due
   * @param {any[]} taken
   * @param {Map<number, Read>} found
   * @param {Run} run
   * @returns {OwnError[]}
   */
  errors(step, read, due, taken, found, run) {
    if (typeof read.found === "number") {
      const error = BOARD.slips.excess(read.found, /** @type {number} */ (due));
      return [{ slot: step.it, error, grain: this.grain(step, read, /** @type {number} */ (due), taken, found) }];
    }
    const spot = read.found;
    return (step.parts ?? []).map((part) => ({
      slot: part[1],
      error: this.off(part, step, spot, /** @type {Complex} */ (due), taken, run),
      grain: read.read,
    }));
  }

  /**
   * Return how far a point is off a line, an arc, a length, a meeting, its place.
   * @param {Part} part
   * @param {PracticeStep} step
   * @param {Complex} spot
   * @param {Complex} due
   * @param {any[]} taken
   * @param {Run} run
   */
  off([kind, , use], step, spot, due, taken, run) {
    const slips = BOARD.slips;
    if (kind === "line") return slips.off_line(taken[use], spot);
    if (kind === "arc") return slips.off_arc(taken[use], spot);
    if (kind === "place") return slips.off_place(spot, due);
    if (kind === "met") return slips.off_meeting(spot, due, /** @type {Complex} */ (done(step, turned(taken, use))));
    const mark = step.uses[1] ?? -1;
    let off = slips.off_length(taken[0], taken[1], spot);
    // whether the length was laid off right, and read wrongly, or the other way round
    for (const other of run.due.has(mark) ? [run.due.get(mark), this.exact.get(mark)] : []) {
      off = slips.nearer(off, slips.off_length(taken[0], /** @type {number} */ (other), spot));
    }
    return off;
  }

  /**
   * Return how far a figure may be off by the rounding of what it was found from, and by its own.
   * @param {PracticeStep} step
   * @param {Read} read
   * @param {number} due
   * @param {any[]} taken
   * @param {Map<number, Read>} found
   */
  grain(step, read, due, taken, found) {
    return step.uses.reduce((whole, slot, k) => {
      const used = found.get(slot);
      if (used === undefined || typeof used.found !== "number") return whole;
      const moved = done(step, taken.map((value, n) => (n === k ? value + used.used : value)));
      return whole + ARITHMETIC.known(Math.abs(/** @type {number} */ (moved) - due));
    }, read.read);
  }

  /**
   * Return the marks that were read and that a step starts from, nothing read being between.
   * @param {number} slot
   * @param {Map<number, Read>} found
   */
  sources(slot, found) {
    const looked = new Set();
    const seen = [];
    const ahead = [...(this.steps.get(slot)?.uses ?? [])];
    for (let mark = ahead.shift(); mark !== undefined; mark = ahead.shift()) {
      if (looked.has(mark)) continue;
      looked.add(mark);
      if (found.has(mark)) seen.push(mark);
      else ahead.push(...(this.steps.get(mark)?.uses ?? []));
    }
    return seen;
  }
}

/**
 * Return what an operation makes of values.
 * @param {{op: string, choice?: number[]}} step
 * @param {any[]} values
 */
export function done(step, values) {
  const operation = BOARD.operations[step.op];
  if (operation === undefined) throw new Error(step.op);
  return operation(...values, ...(step.choice ?? []));
}

/**
 * Return values with the side of one turned.
 * @param {any[]} values
 * @param {number} k
 */
function turned(values, k) {
  return values.map((value, n) => (n === k ? -value : value));
}
