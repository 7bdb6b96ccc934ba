import { CALCULATOR, instrumentOf, isAsked, LINKED } from "./palette.js";

/**
 * What an instrument is laid to: any order, any step whose marks are there.
 *
 * @typedef {import("./palette.js").Instrument} Instrument
 * @typedef {import("./palette.js").Sort} Sort
 * @typedef {{it: number, op: string, uses: number[]}} Move a step: the mark that it leaves, its operation, its marks
 * @typedef {{move: Move} | {why: "done" | "not yet" | "other instrument" | "no such step", near?: Move}} Answer
 */

/** What a formula is given. @type {Sort[]} */
const FIGURES = ["N", "M", "G"];

/** The steps of a task as one picks what they are laid to. */
export class Picking {
  /**
   * @param {Move[]} moves the steps that are asked for
   * @param {(slot: number) => Sort | undefined} sortOf undefined: it is never picked (a side)
   * @param {(slot: number) => boolean} isScale of a scale factor: it lies with what it belongs to
   * @param {(slot: number) => boolean} isHere whether a mark stands on the plan itself
   */
  constructor(moves, sortOf, isScale, isHere) {
    this.moves = moves;
    this.sortOf = sortOf;
    this.isScale = isScale;
    this.isHere = isHere;
    const there = new Set(moves.map((move) => move.op));
    /** The sorts that operations of this task ask for, by instrument. @type {Map<string, string[]>} */
    this.patterns = new Map();
    this.patternsOf = (/** @type {Instrument} */ { name, ops }) => {
      const own = Object.keys(ops).filter((op) => there.has(op));
      const found = (own.length > 0 ? own : Object.keys(ops)).map((op) => ops[op] ?? "");
      if (!this.patterns.has(name)) this.patterns.set(name, found);
      return this.patterns.get(name) ?? [];
    };
  }

  /**
   * Return the marks that a step asks for.
   * @param {Move} move
   */
  asked(move) {
    const own = move.uses.filter((slot, place) => isAsked(move.op, place) && this.sortOf(slot) !== undefined);
    const bare = own.filter((slot) => !this.isScale(slot));
    return bare.length > 0 ? bare : own;
  }

  /**
   * Whether one more mark may be picked for an instrument.
   * @param {Instrument} instrument
   * @param {number[]} picks
   * @param {number} slot
   */
  fits(instrument, picks, slot) {
    const sort = this.sortOf(slot);
    if (sort === undefined || picks.includes(slot)) return false;
    if (sort === "P" && instrument.name !== LINKED && !this.isHere(slot)) return false;
    if (instrument.name === CALCULATOR) return FIGURES.includes(sort);
    const wanted = [...picks, slot].map((one) => this.sortOf(one) ?? "");
    return this.patternsOf(instrument).some((pattern) => isWithin(wanted, pattern));
  }

  /**
   * Whether so many marks may be all that an instrument needs.
   * @param {Instrument} instrument
   * @param {number[]} picks
   */
  isWhole(instrument, picks) {
    if (instrument.name === CALCULATOR) return picks.length > 0;
    return this.patternsOf(instrument).some((pattern) => pattern.length === picks.length);
  }

  /**
   * Whether nothing more can be picked: the answer is due by itself.
   * @param {Instrument} instrument
   * @param {number[]} picks
   */
  isFull(instrument, picks) {
    if (instrument.name === CALCULATOR) return false;
    return this.isWhole(instrument, picks) && this.patternsOf(instrument).every((one) => one.length <= picks.length);
  }

  /**
   * Return the step that an instrument does with what is picked, or why there is none.
   * @param {Instrument} instrument
   * @param {number[]} picks
   * @param {(slot: number) => boolean} isDone
   * @param {Pick<import("./bench.js").Bench, "ready" | "match">} bench
   * @returns {Answer}
   */
  answer(instrument, picks, isDone, bench) {
    const alike = this.moves.filter((move) => this.agrees(move, picks));
    const own = alike.filter((move) => instrumentOf(move.op) === instrument);
    const open = own.filter((move) => !isDone(move.it));
    const ready = open.find((move) => bench.ready(move.it));
    if (ready !== undefined) return { move: ready };
    if (open[0] !== undefined) return { why: "not yet", near: open[0] };
    if (own[0] !== undefined) return { why: "done", near: own[0] };
    const like = this.alike(instrument, picks, bench);
    if (like !== undefined) return { move: like };
    const other = alike.find((move) => !isDone(move.it));
    return other === undefined ? { why: "no such step" } : { why: "other instrument", near: other };
  }

  /**
   * Return a step that comes to the same as what an instrument does with what is picked.
   * @param {Instrument} instrument
   * @param {number[]} picks
   * @param {Pick<import("./bench.js").Bench, "match">} bench
   */
  alike(instrument, picks, bench) {
    for (const [op, pattern] of Object.entries(instrument.ops)) {
      const uses = inOrder(picks, pattern, this.sortOf);
      const found = uses === null ? null : bench.match(op, uses);
      if (found !== null && "slot" in found) return this.moves.find((move) => move.it === found.slot);
    }
    return undefined;
  }

  /**
   * Whether what is picked is what a step asks for, in any order; what lies with it may be named too.
   * @param {Move} move
   * @param {number[]} picks
   */
  agrees(move, picks) {
    return this.asked(move).every((slot) => picks.includes(slot)) && picks.every((slot) => move.uses.includes(slot));
  }
}

/**
 * Whether sorts are a part of a pattern, each counted.
 * @param {string[]} sorts
 * @param {string} pattern
 */
function isWithin(sorts, pattern) {
  const left = [...pattern];
  for (const sort of sorts) {
    const place = left.indexOf(sort);
    if (place < 0) return false;
    left.splice(place, 1);
  }
  return true;
}

/**
 * Return what is picked in the order of a pattern's sorts; null if it is not of them.
 * @param {number[]} picks
 * @param {string} pattern
 * @param {(slot: number) => Sort | undefined} sortOf
 */
function inOrder(picks, pattern, sortOf) {
  const left = [...picks];
  const found = [];
  for (const sort of pattern) {
    const place = left.findIndex((slot) => sortOf(slot) === sort);
    if (place < 0) return null;
    found.push(...left.splice(place, 1));
  }
  return left.length === 0 ? found : null;
}
