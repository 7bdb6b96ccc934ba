import { BOARD } from "./board.js";
import { mildest } from "./equivalents.js";
import { limitAt, seenOf, shareOfSlip, sizeAt, withOthers } from "./limits.js";
import { Signs } from "./signs.js";

/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").Manner} Manner
 * @typedef {import("../types.js").Task} Task
 * @typedef {import("./log.js").Log} Log
 * @typedef {import("./log.js").Run} Run
 * @typedef {import("./log.js").OwnError} OwnError
 * @typedef {"fine" | "doubtful" | "wrong"} Verdict
 * @typedef {{x?: number, y?: number, mm?: number, value?: number}} Last half a unit of the last digit that was
 *   written of each figure; nothing: all digits are known
 * @typedef {{slot: number, found: number | Complex, last: Last}} Taken a mark as it was read
 * @typedef {{slot: number, error: number, parts: {slot: number, error: number}[], verdict: Verdict, blamed: number,
 *   deviation: number, follows: boolean}} Judged `error`: that of the step itself, mm or in the unit of a rate;
 *   `blamed`: the mark whose step made it; `deviation`: from what the exact hand has; `follows`: it is far off
 *   though it is right, for an earlier mark is off
 * @typedef {{plan: number, rows: Taken[]}} Beside
 * @typedef {{counted: number, doubtful: number, wrong: number, error: number, by: number}} Own
 */

/** The verdicts in their order. @type {Verdict[]} */
export const VERDICTS = ["fine", "doubtful", "wrong"];
/** A deviation below this share of the plan is none; checking/judging/judge.py. */
const NO_ERROR = 1e-9;

/**
 * @param {number} k
 * @returns {Verdict}
 */
export function verdictOf(k) {
  return VERDICTS[k] ?? "fine";
}

/**
 * The readings of one drawing, judged as `check` does it (checking/judging/judge.py).
 */
export class Judging {
  /**
   * @param {Log} log
   * @param {Task} task
   * @param {Manner} manner
   * @param {Taken[]} rows
   * @param {Beside[]} beside what was read of other plans in this position
   */
  constructor(log, task, manner, rows, beside = []) {
    this.log = log;
    this.reader = log.data.reader;
    this.manner = withOthers(log.data, task, manner, beside);
    this.task = task;
    this.place = (log.data.at[task.plan] ?? []).indexOf(task.at);
    this.rows = [...rows].sort((a, b) => a.slot - b.slot);
    const all = [...this.rows, ...beside.flatMap((one) => one.rows)];
    this.found = new Map(all.map((row) => [row.slot, this.read(row)]));
    this.signs = new Signs(log, all);
    /** @type {Run} */
    this.run = log.run(this.found);
    this.share = shareOfSlip(seenOf(this), log.data.reader);
  }

  /** Return all judgements, in the order of the log. */
  all() {
    /** @type {Map<number, Judged>} */
    const found = new Map();
    for (const row of this.rows) found.set(row.slot, this.judged(row, found));
    return found;
  }

  /**
   * Return what was read of a mark, with how far rounding may carry it.
   * @param {Taken} row
   */
  read({ slot, found, last }) {
    const { half, reading } = this.reader;
    if (typeof found !== "number") return { found, read: this.lost(last, 1), used: 0 };
    if (this.kind(slot) === "rate") return { found, read: last.value ?? 0, used: last.value ?? 0 };
    const written = last.mm ?? 0;
    return { found, read: BOARD.slips.unblurred(half, written, reading), used: written + half };
  }

  /** @param {number} slot */
  kind(slot) {
    return this.log.steps.get(slot)?.read?.as ?? "";
  }

  /**
   * @param {Last} last
   * @param {number} share
   */
  lost(last, share) {
    return BOARD.slips.lost(last.x ?? 0, last.y ?? 0, share * this.manner.pointing);
  }

  /**
   * @param {Taken} row
   * @param {Map<number, Judged>} before
   * @returns {Judged}
   */
  judged(row, before) {
    const { slot } = row;
    const off = this.off(row);
    const own = this.own(row, off);
    const total = this.total(row, off);
    const mine = own === undefined ? total : this.mine(row, own);
    const parts = (this.run.errors.get(slot) ?? []).map(({ slot: by, error }) => ({ slot: by, error }));
    const found = { slot, error: own?.error ?? off.signed, parts, deviation: off.signed };
    if (own === undefined || !(mine <= total || this.strict(row, before))) {
      return { ...found, verdict: verdictOf(total), blamed: slot, follows: false };
    }
    return { ...found, verdict: verdictOf(mine), blamed: own.by, follows: mine < total };
  }

  /**
   * Return the number of the verdict on a step's own error.
   * @param {Taken} row
   * @param {Own} own
   */
  mine(row, own) {
    if (this.none(row, own.error)) return 0;
    return BOARD.slips.severity(own.counted, 0, own.doubtful, own.wrong, Infinity);
  }

  /**
   * Return a reading against what the exact hand has: the deviation, what rounding may carry, how many times.
   * @param {Taken} row
   */
  off(row) {
    const { slot, found, last } = row;
    const due = this.log.exact.get(slot);
    const { slips } = BOARD;
    if (typeof found !== "number") {
      return { signed: slips.off_place(found, /** @type {Complex} */ (due)), grain: this.lost(last, 1), times: 0 };
    }
    const rate = this.kind(slot) === "rate";
    const goal = rate ? /** @type {number} */ (due) : Math.abs(/** @type {number} */ (due));
    const { half, reading } = this.reader;
    const grain = rate ? (last.value ?? 0) : slips.unblurred(half, last.mm ?? 0, reading);
    const signed = this.signs.has(row) ? found - goal : slips.excess(found, goal);
    return { signed, grain, times: slips.times_off(found, goal) };
  }

  /**
   * Return the number of the verdict on a figure's deviation from what the exact hand has; of a point it is not
   * asked for.
   * @param {Taken} row
   * @param {{signed: number, grain: number, times: number}} off
   */
  total(row, off) {
    const { slot, found } = row;
    if (typeof found !== "number" || this.none(row, off.signed)) return 0;
    const limits = this.manner.total[String(slot)];
    const [d = -1, w = -1, t = -1] = [limits?.d[this.place], limits?.w[this.place], limits?.t[this.place]];
    if (d < 0) return 2;
    return BOARD.slips.severity(BOARD.slips.counted(off.signed, off.grain), off.times, d, w, t < 0 ? Infinity : t);
  }

  /**
   * Whether an error is nothing but the rounding of the machine.
   * @param {Taken} row
   * @param {number} error
   */
  none({ slot, found }, error) {
    const due = this.log.exact.get(slot);
    const whole = this.kind(slot) === "rate" ? 0 : this.task.whole;
    const size = typeof found === "number" ? Math.abs(/** @type {number} */ (due)) : sizeOf(/** @type {Complex} */ (due));
    return Math.abs(error) <= NO_ERROR * Math.max(whole, size);
  }

  /**
   * Return a reading against what earlier readings make of it; undefined where that cannot be told.
   * @param {Taken} row
   * @param {{signed: number}} off
   * @returns {Own | undefined}
   */
  own(row, off) {
    const limit = limitAt(this.manner, row.slot, this.place);
    const errors = this.errors(row);
    const [first] = errors;
    if (first === undefined || limit === undefined || !Number.isFinite(off.signed) || this.otherSense(row)) return undefined;
    const share = typeof row.found === "number" ? 1 : this.share;
    const times = errors.map(({ error, grain }, k) => BOARD.slips.counted(error, grain) / sizeAt(limit, k, share));
    const worst = times.indexOf(Math.max(...times));
    const { error, slot } = errors[worst] ?? first;
    return mildest(this, row, { counted: times[worst] ?? 0, doubtful: limit.d, wrong: limit.w, error, by: slot });
  }

  /**
   * Return the errors of the steps that led to a reading; none if they are not known.
   * @param {Taken} row
   */
  errors({ slot, found, last }) {
    const errors = this.run.errors.get(slot) ?? [];
    if (!errors.some(({ error }) => Number.isFinite(error))) return [];
    return errors.map(({ slot: by, error, grain }) => ({
      slot: by,
      error: Number.isFinite(error) ? error : 0,
      grain: typeof found === "number" ? grain : this.lost(last, this.share),
    }));
  }

  /**
   * Whether a reading is of a length that its step lays off from a calculated number.
   * @param {Taken} row
   */
  calculated({ slot }) {
    return this.kind(slot) === "length" && this.log.steps.get(slot)?.measures !== true;
  }

  /**
   * Whether a rate has the other sense than is due: lengths are read without one, so they do not tell it. Of what is
   * no larger than a hand is off by it the sign is chance.
   * @param {Taken} row
   */
  otherSense(row) {
    const { slot, found } = row;
    const due = Number(this.log.exact.get(slot));
    const chance = this.manner.total[String(slot)]?.d[this.place] ?? Infinity;
    if (this.signs.has(row) && due < -chance) return Number(found) > 0;
    return this.kind(slot) === "rate" && Number(found) < 0 && due > 0;
  }

  /**
   * Whether only what earlier readings make of a reading counts: always of a point; of what is calculated, or
   * measured between points that were read, if they are right.
   * @param {Taken} row
   * @param {Map<number, Judged>} before
   */
  strict(row, before) {
    const { slot, found } = row;
    if (typeof found !== "number") return true;
    const sources = this.log.sources(slot, this.found);
    const measured = this.kind(slot) !== "rate" && !this.calculated(row);
    if (measured && !(sources.length > 0 && sources.every((one) => this.kind(one) === "point"))) return false;
    return sources.every((one) => before.get(one)?.verdict === "fine");
  }
}

/** @param {Complex} z */
function sizeOf(z) {
  return Math.hypot(z.re, z.im);
}
