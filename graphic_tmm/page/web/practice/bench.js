import { BOARD } from "./board.js";
import { Judging, verdictOf } from "./judging.js";
import { Log } from "./log.js";
import { matched } from "./matching.js";

/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").Practice} Practice
 * @typedef {import("../types.js").Task} Task
 * @typedef {import("./judging.js").Judged} Judged
 * @typedef {import("./judging.js").Last} Last
 * @typedef {import("./judging.js").Taken} Taken
 * @typedef {import("./matching.js").Match} Match
 */

/**
 * A plan in one position while a student makes it: the marks he made, each judged as `graphic-tmm check` would.
 *
 * A line or an arc is drawn by an instrument and stands as it has to from the marks it was drawn by. A point, a
 * length, a figure is `found`: {re, im} in mm from the origin of the plan, y upward; mm; the unit of the mark. What
 * no check reads (a figure on the way, a length of the scene) is judged by its digits, and later steps go on from
 * what it has to be.
 */
export class Bench {
  /**
   * @param {Practice} data
   * @param {Task} task
   * @param {string} manner "plan": all of it is read; "points": its points alone
   */
  constructor(data, task, manner = "plan") {
    const limits = data.manners[manner];
    if (limits === undefined) throw new Error(manner);
    this.data = data;
    this.task = task;
    this.whole = manner === "plan";
    this.manner = limits;
    this.log = new Log(data, task.at);
    /** What the student made. @type {Map<number, Taken | undefined>} */
    this.made = new Map();
    this.own = new Set([...task.steps, ...(task.free ?? [])]);
    this.run = this.log.run(new Map());
  }

  /**
   * Return a mark as it stands: as the student made it, as it is given; undefined where it is not there.
   * @param {number} slot
   * @returns {Drawn | undefined}
   */
  value(slot) {
    if (this.own.has(slot) && !this.made.has(slot)) return undefined;
    return this.run.values.get(slot);
  }

  /**
   * Whether a step can be done: what it uses is there. Where only points are read each of them can.
   * @param {number} slot
   */
  ready(slot) {
    if (!this.own.has(slot)) return false;
    const step = this.log.steps.get(slot);
    if (!this.whole) return step?.read?.as === "point";
    return (step?.uses ?? []).every((one) => !this.own.has(one) || this.made.has(one));
  }

  /** The steps that can be done and are not. */
  open() {
    return this.task.steps.filter((slot) => !this.made.has(slot) && this.ready(slot));
  }

  /**
   * Return what a step has to come to, from the student's marks as they stand.
   * @param {number} slot
   * @returns {Drawn}
   */
  due(slot) {
    return /** @type {Drawn} */ (this.run.due.get(slot) ?? this.run.values.get(slot));
  }

  /**
   * Judge what was found of a mark, with the earlier marks as they stand; nothing is kept of it.
   * @param {number} slot
   * @param {Drawn | undefined} found nothing of a line, an arc
   * @param {Last} last
   * @returns {Judged}
   */
  judge(slot, found, last = {}) {
    const nothing = { slot, error: 0, parts: [], verdict: verdictOf(0), blamed: slot, deviation: 0, follows: false };
    if (!isFound(found)) return nothing;
    if (!this.reads(slot)) return { ...nothing, ...this.byDigits(slot, Number(found), last) };
    const rows = this.taken().filter((row) => row.slot !== slot);
    const judging = new Judging(this.log, this.task, this.manner, [...rows, { slot, found, last }]);
    return judging.all().get(slot) ?? nothing;
  }

  /** All that was made and is read, judged together. */
  judged() {
    return new Judging(this.log, this.task, this.manner, this.taken()).all();
  }

  /**
   * Keep what was found of a mark; of a line, an arc: that it was drawn.
   * @param {number} slot
   * @param {Drawn} [found]
   * @param {Last} last
   */
  take(slot, found, last = {}) {
    this.made.set(slot, !isFound(found) ? undefined : { slot, found, last });
    this.again();
  }

  /**
   * Take a mark away, with all that was made of it; return what went.
   * @param {number} slot
   */
  drop(slot) {
    const gone = new Set([slot]);
    for (const one of this.own) {
      if (this.whole && this.log.steps.get(one)?.uses.some((mark) => gone.has(mark))) gone.add(one);
    }
    const went = [...gone].filter((one) => this.made.delete(one));
    this.again();
    return went;
  }

  /**
   * Return which step an instrument does that is applied to marks, or why it does none.
   * @param {string} op
   * @param {number[]} uses
   * @param {number[]} [choice]
   * @returns {Match}
   */
  match(op, uses, choice) {
    return matched(this, op, uses, choice);
  }

  /** The readings so far. */
  taken() {
    return [...this.made.values()].filter((row) => row !== undefined).filter((row) => this.reads(row.slot));
  }

  /**
   * Whether a check reads a mark, in the position and in the manner of this one.
   * @param {number} slot
   */
  reads(slot) {
    return this.log.steps.get(slot)?.read !== undefined && this.manner.own[String(slot)] !== undefined;
  }

  /** Run the log with what there is. */
  again() {
    this.run = new Judging(this.log, this.task, this.manner, this.taken()).run;
  }

  /**
   * Judge a figure that no check reads by its digits: they tell whether it was calculated so.
   * @param {number} slot
   * @param {number} found
   * @param {Last} last
   */
  byDigits(slot, found, last) {
    const { slips } = BOARD;
    const due = Number(this.due(slot));
    const length = this.data.marks[String(slot)]?.k === "length";
    const { half, digits, wrong } = this.data.reader;
    const most = slips.rounding(digits, due) + (length ? half : 0);
    const grain = (length ? last.mm : last.value) ?? 0;
    const error = length ? slips.excess(found, due) : found - due;
    const counted = slips.counted(error, Math.max(grain, most));
    return { error, deviation: error, verdict: verdictOf(slips.severity(counted, 0, 0, wrong * most, Infinity)) };
  }
}

/**
 * Whether something was found of a mark: a point, a figure; a line or an arc is as it is drawn.
 * @param {Drawn | undefined} found
 * @returns {found is number | Complex}
 */
function isFound(found) {
  return typeof found === "number" || (found !== undefined && "re" in found);
}
