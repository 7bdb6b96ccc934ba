import { distance, frameOf } from "./figures.js";
import { shownNumber } from "./typed.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("../types.js").Practice} Practice
 * @typedef {import("../types.js").PracticeMark} PracticeMark
 * @typedef {import("../types.js").PracticeStep} PracticeStep
 * @typedef {import("../types.js").Task} Task
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("./bench.js").Bench} Bench
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {import("./figures.js").Frame} Frame
 * @typedef {import("./shapes.js").Values} Values
 */

/** White about a plan, as a share of it and at least, mm. */
const PLAN_ROOM = 0.22;
const PLAN_LEAST = 10;
/** A plan without a size is shown so large, mm. */
const EMPTY = 30;

/** What lies on the easel for a task: its marks as they are called, as they stand now, as they are written. */
export class Easel {
  /**
   * @param {Practice} practice
   * @param {Task} task
   * @param {Bench} bench
   * @param {Record<string, string>} words
   */
  constructor(practice, task, bench, words) {
    this.practice = practice;
    this.task = task;
    this.bench = bench;
    this.words = words;
    this.decimal = words["decimal sign"] ?? ".";
    this.steps = new Map(practice.steps.map((step) => [step.it, step]));
    /** @type {Values} */
    this.values = {
      spot: (slot) => {
        const value = this.kindOf(slot) === "point" ? this.value(slot) : null;
        return value === null ? null : spotOf(/** @type {Complex} */ (value));
      },
      line: (slot) => {
        const value = this.kindOf(slot) === "line" ? this.value(slot) : null;
        if (value === null) return null;
        const { at, along } = /** @type {import("../types.js").DrawnLine} */ (value);
        return { at: spotOf(at), along: spotOf(along) };
      },
      arc: (slot) => {
        const value = this.kindOf(slot) === "arc" ? this.value(slot) : null;
        if (value === null) return null;
        const { centre, radius } = /** @type {import("../types.js").DrawnArc} */ (value);
        return { centre: spotOf(centre), radius };
      },
    };
  }

  /** @param {number} slot */
  markOf(slot) {
    return /** @type {PracticeMark} */ (this.practice.marks[String(slot)]);
  }

  /** @param {number} slot */
  kindOf(slot) {
    return this.practice.marks[String(slot)]?.k ?? "side";
  }

  /**
   * Return the letter of a mark as mark-up; "" if it has none.
   * @param {number} slot
   */
  letterOf(slot) {
    return this.practice.marks[String(slot)]?.l ?? "";
  }

  /**
   * Whether a mark stands on the plan of the task.
   * @param {number} slot
   */
  isHere(slot) {
    return this.markOf(slot).v === this.task.plan;
  }

  /**
   * Whether a mark is a scale factor: so much a millimetre.
   * @param {number} slot
   */
  isScale(slot) {
    return this.markOf(slot).s === 1;
  }

  /**
   * Return what a mark is as it stands; null if it is not there.
   * @param {number} slot
   */
  value(slot) {
    const value = this.bench.value(slot);
    return value !== undefined && value !== null && isKnown(value) ? value : null;
  }

  /**
   * Return the unit in which a mark is told.
   * @param {number} slot
   */
  unitOf(slot) {
    const mark = this.markOf(slot);
    if (mark.k === "length") return this.words["mm"] ?? "";
    return mark.k === "angle" ? "°" : (mark.u ?? "");
  }

  /**
   * Return what a mark comes to, with its unit; "" of a figure.
   * @param {number} slot
   */
  toldOf(slot) {
    const value = this.value(slot);
    if (typeof value !== "number") return "";
    const unit = this.unitOf(slot);
    return `${this.numberOf(value)}${unit === "°" || unit === "" ? unit : ` ${unit}`}`;
  }

  /**
   * Return a number to four digits, without needless noughts.
   * @param {number} value
   */
  numberOf(value) {
    const size = Math.abs(value) < 1e-9 ? 0 : Math.floor(Math.log10(Math.abs(value)));
    const places = Math.max(0, Math.min(9, DIGITS - 1 - size));
    const text = shownNumber(value, places, this.decimal);
    return places > 0 ? text.replace(/0+$/, "").replace(/\D$/, "") : text;
  }

  /**
   * Return where the points of the plan will be.
   * @returns {Spot[]}
   */
  exact() {
    const slots = [...this.task.steps, ...this.task.shown.filter((slot) => this.isHere(slot)), this.task.pole];
    const exact = slots.filter((slot) => this.kindOf(slot) === "point").map((slot) => this.bench.log.exact.get(slot));
    return exact.filter((value) => isKnown(value)).map((value) => spotOf(/** @type {Complex} */ (value)));
  }

  /**
   * Return the frame of the plan: all of it as it will be.
   * @returns {Frame}
   */
  frame() {
    const spots = this.exact();
    const first = spots[0] ?? [0, 0];
    const size = Math.max(0, ...spots.map((spot) => distance(spot, first)));
    return frameOf(spots.length > 0 ? spots : [first], PLAN_ROOM, size < PLAN_LEAST ? EMPTY : PLAN_LEAST);
  }
}

/** Significant digits of a quantity. */
const DIGITS = 4;

/**
 * @param {Complex} z
 * @returns {Spot}
 */
export function spotOf({ re, im }) {
  return [re, im];
}

/**
 * Whether every number of a value is there.
 * @param {unknown} value a number, or an object of such
 * @returns {boolean}
 */
export function isKnown(value) {
  if (typeof value === "number") return Number.isFinite(value);
  return typeof value === "object" && value !== null && Object.values(value).every(isKnown);
}
