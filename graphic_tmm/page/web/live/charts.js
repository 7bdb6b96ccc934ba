import { drawnElement } from "../dom.js";
import { BOARD } from "../practice/board.js";
import { hundredths } from "../strokes.js";
import { curvePath, isCurve, isLine, isPlace, knownPoint, placeOnCurve, sameValue } from "./curves.js";

/**
 * @typedef {import("../types.js").Dense} Dense
 * @typedef {import("../types.js").AcrossMark} AcrossMark
 * @typedef {import("../types.js").DrawnCurve} DrawnCurve
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").Cursor} Cursor
 * @typedef {import("./run.js").LiveRun} LiveRun
 * @typedef {(Complex | null)[]} Ways
 */

/** The path of a dot: a whole circle. */
const DOT = /^M[^LC]*Z$/;
/** The way of what did not move. @type {Complex} */
const UNMOVED = { re: 0, im: 0 };

/**
 * The view of a sheet that bears diagrams, with other lengths: what moved is hidden, letters go with their points,
 * curves are drawn anew.
 */
export class LiveChart {
  /**
   * @param {LiveRun} run
   * @param {Dense} dense
   * @param {Element} ink
   * @param {Cursor[]} cursors
   */
  constructor(run, dense, ink, cursors) {
    this.run = run;
    this.dense = dense;
    this.cursors = cursors;
    const parts = /** @type {SVGElement[]} */ ([...ink.querySelectorAll("[data-of]")]);
    this.parts = parts.map((part) => {
      const dot = DOT.test(part.getAttribute("d") ?? "");
      return { part, slots: slotsOfPart(part), at: Number(part.getAttribute("data-at") ?? -1), dot, sign: dot || part.matches(".label") };
    });
    this.curves = cursors.map((one) => beside(ink, one.curve ?? -1));
    const segments = (dense.segments ?? []).filter(([view]) => view === cursors[0]?.view);
    this.segments = segments.map(([, slot, width, ...rest]) => ({ path: beside(ink, slot, width), rest }));
    /** All marks as the scene has them, once they are asked for. @type {AcrossMark[][]} */
    this.own = [];
    this.shown = 0;
  }

  /**
   * Let the ink follow what is given.
   * @param {boolean} changed
   */
  follow(changed) {
    const version = changed ? this.run.version : 0;
    if (version === this.shown || (!changed && this.own.length === 0)) return;
    if (this.own.length === 0) this.own = this.run.ownCharts();
    const now = changed ? this.run.charts() : this.own;
    this.shown = changed ? this.run.version : 0;
    const ways = this.ways(now);
    for (const one of this.parts) letFollow(one.part, one.dot ? this.wayOfDot(one.slots, one.at, now) : this.wayOf(one.slots, one.at, ways), one.sign);
    for (const { path, rest } of this.segments) path.setAttribute("d", changed ? this.linesOf(rest, now) : "");
    this.cursors.forEach((one, n) => {
      const [curve, ...ends] = [one.curve, ...(one.base ?? [])].map((slot) => (changed ? now[0]?.[slot ?? -1] : undefined));
      const over = ends.flatMap((end) => (isPlace(end) ? [end.re] : []));
      this.curves[n]?.setAttribute("d", isCurve(curve) ? curvePath(curve, one.at ?? [0, 0], over) : "");
    });
  }

  /**
   * Return the lines from mark to mark in all positions of the row.
   * @param {number[]} line both marks, where their plan begins on the sheet, how far it goes on beyond each
   * @param {AcrossMark[][]} now
   */
  linesOf([first = -1, last = -1, x = 0, y = 0, before = 0, behind = 0], now) {
    const [, , count] = this.dense.numbers ?? [0, 0, now.length];
    const lines = now.slice(0, count).map((marks) => {
      const [from, to] = [spotOfMark(marks[first]), spotOfMark(marks[last])];
      if (from === null || to === null) return "";
      const long = Math.hypot(to.re - from.re, to.im - from.im) || 1;
      const on = (/** @type {number} */ by) => `${hundredths(x + from.re + by * (to.re - from.re))} ${hundredths(y - from.im - by * (to.im - from.im))}`;
      return `M${on(-before / long)}L${on(1 + behind / long)}`;
    });
    return [...new Set(lines)].join("");
  }

  /**
   * Return how far what is drawn of some marks is from where it was; null where that is no mere shift.
   * @param {number[]} slots
   * @param {number} at its position; -1 for all
   * @param {Map<number, Ways>} ways
   * @returns {Complex | null}
   */
  wayOf(slots, at, ways) {
    const own = slots.flatMap((slot) => (ways.get(slot) ?? []).filter((_, k) => at < 0 || k === at));
    const [first = UNMOVED] = own;
    if (first === null || own.some((way) => way === null || !sameValue(way, first))) return null;
    if (first !== UNMOVED) return slots.length === 1 ? first : null;
    const under = slots.flatMap((slot) => this.dense.hangs?.[slot] ?? []);
    return under.some((slot) => (ways.get(slot) ?? []).some((way) => way !== UNMOVED)) ? null : UNMOVED;
  }

  /**
   * @param {number[]} slots
   * @param {number} at
   * @param {AcrossMark[][]} now
   * @returns {Complex | null}
   */
  wayOfDot([slot = -1], at, now) {
    const k = Math.max(at, 0);
    const [from, to] = [spotOfMark(this.own[k]?.[slot]), spotOfMark(now[k]?.[slot])];
    return from === null || to === null ? null : { re: to.re - from.re, im: to.im - from.im };
  }

  /**
   * Return how far all marks are from where they were in each position; null of those that are no points.
   * @param {AcrossMark[][]} now
   * @returns {Map<number, Ways>}
   */
  ways(now) {
    const slots = new Set(this.parts.flatMap((one) => [...one.slots, ...one.slots.flatMap((slot) => this.dense.hangs?.[slot] ?? [])]));
    const way = (/** @type {AcrossMark} */ before, /** @type {AcrossMark} */ after) => {
      if (sameValue(before, after)) return UNMOVED;
      return isPlace(before) && isPlace(after) ? { re: after.re - before.re, im: after.im - before.im } : null;
    };
    return new Map([...slots].map((slot) => [slot, now.map((marks, k) => way(this.own[k]?.[slot], marks[slot]))]));
  }

  /**
   * Return where a cursor stands at an angle, mm of the sheet, y downward; null where that is not known.
   * @param {number} n
   * @param {number} k
   * @returns {Complex | null}
   */
  place(n, k) {
    const one = this.cursors[n];
    const point = this.point(n, k);
    const [x = 0, y = 0] = one?.at ?? [];
    return point === null ? null : { re: x + point.re, im: y - point.im };
  }

  /**
   * Return what a cursor tells at an angle.
   * @param {number} n
   * @param {number} k
   */
  value(n, k) {
    const one = this.cursors[n];
    const [first = []] = this.run.charts();
    const origin = first[one?.base?.[0] ?? -1];
    const mu = Number(first[one?.of ?? -1] ?? one?.mu);
    return ((this.point(n, k)?.im ?? NaN) - (isPlace(origin) ? origin.im : 0)) * mu;
  }

  /**
   * @param {number} n
   * @param {number} k
   * @returns {Complex | null}
   */
  point(n, k) {
    const one = this.cursors[n];
    return one?.point === undefined ? this.onCurve(one, k) : knownPoint(this.run.marks(k)[one.point]);
  }

  /**
   * @param {Cursor | undefined} cursor
   * @param {number} k
   * @returns {Complex | null}
   */
  onCurve(cursor, k) {
    const [from, by, count] = this.dense.numbers ?? [NaN, NaN, NaN];
    const { base, curve, behind = 0 } = cursor ?? {};
    const [first = []] = this.run.charts();
    const own = first[curve ?? -1];
    if (base === undefined || !isCurve(own)) return null;
    const number = from + by * (this.run.frames[k] ?? NaN) - behind;
    const [origin, end] = base.map((slot) => first[slot]);
    if (!isPlace(origin) || !isPlace(end)) return knownPoint(placeOnCurve(own, number));
    const share = number / count;
    const foot = { re: origin.re + share * (end.re - origin.re), im: origin.im + share * (end.im - origin.im) };
    return knownPoint(BOARD.log["erect"]?.(own, [[foot]])[0][0]);
  }
}

/**
 * Put an empty path beside the ink of a mark, of the same pen.
 * @param {Element} ink
 * @param {number} slot
 * @param {number} width of the pen, if it has several
 */
function beside(ink, slot, width = 0) {
  const path = drawnElement("path", {});
  const all = [...ink.querySelectorAll(`path[data-of="${slot}"]`)];
  const own = all.find((one) => Number(one.closest("[stroke-width]")?.getAttribute("stroke-width")) === width);
  (own ?? all[0])?.after(path);
  return path;
}

/**
 * Let a letter or a dot go with its point; hide whatever else moved.
 * @param {SVGElement} part
 * @param {Complex | null} way
 * @param {boolean} sign whether it is a letter or a dot
 */
function letFollow(part, way, sign) {
  part.setAttribute("visibility", way !== null && (sign || way === UNMOVED) ? "inherit" : "hidden");
  // a letter's transform is that by which it grows
  if (sign && way !== null) part.style.setProperty("translate", `${hundredths(way.re)}px ${hundredths(-way.im)}px`);
}

/**
 * Return a point, or where a line begins.
 * @param {AcrossMark} mark
 */
function spotOfMark(mark) {
  return knownPoint(isLine(mark) ? mark.at : mark);
}

/** @param {Element} part */
function slotsOfPart(part) {
  return (part.getAttribute("data-of") ?? "").split(" ").filter(Boolean).map(Number);
}
