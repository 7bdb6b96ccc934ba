import { Bench } from "../practice/bench.js";
import { Judging } from "../practice/judging.js";
import { seenOf, shareOfSlip } from "../practice/limits.js";

/**
 * @typedef {import("../types.js").Practice} Practice
 * @typedef {import("../types.js").Task} Task
 * @typedef {import("../practice/judging.js").Judged} Judged
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {{slot: number, letter: string, name: string}} SoughtPoint a point by its mark, as mark-up, as plain text;
 *   the origin of the plan is -1
 */

/** The origin of a plan: its pole, or the pivot of the crank. */
export const ORIGIN = -1;
/** Readings are kept, judged and written to so many decimals, mm; half a unit of the last is what is lost. */
const DECIMALS = 3;
const LOST = 0.5 * 10 ** -DECIMALS;

/** The points of a plan in one position, read off a drawing, judged as a check does. */
export class PlanReadings {
  /**
   * @param {Practice} practice
   * @param {Task} task
   */
  constructor(practice, task) {
    this.practice = practice;
    this.task = task;
    this.bench = new Bench(practice, task, "points");
    /** How often something was taken; what was judged when. */
    this.version = 0;
    /** @type {{key: string, judging: Judging} | null} */
    this.kept = null;
    /** Where points are on the drawing, mm, y upward. @type {Map<number, Spot>} */
    this.spots = new Map();
    const steps = new Map(practice.steps.map((step) => [step.it, step]));
    const read = task.steps.filter((slot) => steps.get(slot)?.read?.as === "point" && this.bench.ready(slot));
    this.rows = new Map(read.map((slot) => [slot, steps.get(slot)?.read]));
    /** In the order in which they are asked for, the origin first. @type {SoughtPoint[]} */
    this.points = [
      { slot: ORIGIN, ...this.calledOrigin() },
      ...read.map((slot) => ({ slot, ...called(practice, slot) })),
    ];
  }

  /** The name of the position. */
  get position() {
    return this.practice.names[this.task.at] ?? "";
  }

  /** The first point that is not read yet. */
  get next() {
    return this.points.find((one) => !this.spots.has(one.slot));
  }

  /** What the origin is called: the pole, else the point that is given there. */
  calledOrigin() {
    const { practice, task } = this;
    if (task.pole >= 0) return called(practice, task.pole);
    const there = [...task.shown, ...Object.keys(practice.given).map(Number)].find((slot) => {
      const [x, y, ...more] = [practice.given[String(slot)]].flat();
      const mark = practice.marks[String(slot)];
      return mark?.k === "point" && mark.v === task.plan && x === 0 && y === 0 && more.length === 0;
    });
    return there === undefined ? { letter: "", name: "" } : called(practice, there);
  }

  /**
   * Take a point of the drawing; of the origin all others follow.
   * @param {number} slot
   * @param {Spot} spot mm, y upward
   */
  take(slot, spot) {
    this.spots.set(slot, spot);
    this.version += 1;
    const moved = slot === ORIGIN ? [...this.spots.keys()] : [slot];
    for (const one of moved) {
      const found = this.figure(one);
      if (found !== null && one !== ORIGIN) this.bench.take(one, { re: found[0], im: found[1] }, { x: LOST, y: LOST });
    }
  }

  /**
   * Return what was read of a point, mm from the origin; null if it, or the origin, was not.
   * @param {number} slot
   * @returns {Spot | null}
   */
  figure(slot) {
    const [origin, spot] = [this.spots.get(ORIGIN), this.spots.get(slot)];
    if (origin === undefined || spot === undefined) return null;
    return [rounded(spot[0] - origin[0]), rounded(spot[1] - origin[1])];
  }

  /**
   * Return all judgements, by the marks, as a check of all that was read of a drawing has them.
   * @param {Iterable<PlanReadings>} drawing
   * @returns {Map<number, Judged>}
   */
  judged(drawing) {
    const all = [...drawing];
    const judging = this.judging(all);
    // how finely points were read all of the drawing tells
    const seen = all.flatMap((one) => seenOf(one.judging(all)));
    judging.share = shareOfSlip(seen, this.practice.reader);
    return judging.all();
  }

  /**
   * Return the judging of these readings, with what was read of other plans in the same position.
   * @param {PlanReadings[]} all
   */
  judging(all) {
    const { log, manner } = this.bench;
    const beside = all.filter((one) => one !== this && one.task.at === this.task.at && one.bench.taken().length > 0);
    const key = [this, ...beside].map((one) => `${one.task.plan}:${one.version}`).join(" ");
    if (this.kept?.key === key) return this.kept.judging;
    const others = beside.map((one) => ({ plan: one.task.plan, rows: one.bench.taken() }));
    this.kept = { key, judging: new Judging(log, this.task, manner, this.bench.taken(), others) };
    return this.kept.judging;
  }

  /**
   * Return the rows of a file of readings.
   * @param {string} decimal sign
   * @returns {import("../practice/record.js").Reading[]}
   */
  written(decimal) {
    return [...this.rows].flatMap(([slot, read]) => {
      const found = this.figure(slot);
      if (found === null || read === undefined) return [];
      const [x, y] = found.map((one) => one.toFixed(DECIMALS).replace(".", decimal));
      return [{ plan: read.name, position: this.position, segment: read.key, x, y }];
    });
  }
}

/**
 * @param {Practice} practice
 * @param {number} slot
 */
function called(practice, slot) {
  const mark = practice.marks[String(slot)];
  return { letter: mark?.l ?? "", name: mark?.n ?? "" };
}

/** @param {number} x */
function rounded(x) {
  const found = Number(x.toFixed(DECIMALS));
  return found === 0 ? 0 : found;
}
