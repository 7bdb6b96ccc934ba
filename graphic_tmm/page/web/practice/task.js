import { isKnown } from "./easel.js";
import { INSTRUMENTS, instrumentOf, SORTS } from "./palette.js";
import { Picking } from "./picking.js";
import { Score, STAGES } from "./score.js";
import { DRAWN, hasSides } from "./sides.js";
import { countOf, isSpare } from "./spare.js";

/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("./judging.js").Last} Last
 * @typedef {import("./judging.js").Verdict} Verdict
 * @typedef {import("./bench.js").Bench} Bench
 * @typedef {import("./palette.js").Instrument} Instrument
 * @typedef {import("./picking.js").Move} Move
 * @typedef {import("./picking.js").Answer} Answer
 * @typedef {{slot: number, error: number}} Part
 * @typedef {{slot: number, found: number | Complex, texts: string[], last: Last, error: number, parts: Part[],
 *   verdict: Verdict, blamed: number, missed: boolean}} Tried what was told of a step, as it was written, and how it
 *   was judged; `missed`: a point that is not where it is drawn through
 * @typedef {{slot: number, stage: string}} Help
 * @typedef {{kind: "more"} | {kind: "drawn", slot: number} | {kind: "asked", slot: number}
 *   | {kind: "none", answer: Answer} | {kind: "undrawable", slot: number}
 *   | {kind: "wrong side"}} Outcome
 */

/**
 * A hand's own lines swing, and a check allows a point as much. Here the lines are drawn true: who marks a point farther
 * from them has missed, mm.
 */
export const MISSED = 1;
/** So does an image that falls on another one. */
const FALLS = "coincide";

/**
 * Whether what was told of a step is wrong.
 * @param {Tried} tried
 */
export function isWrong(tried) {
  return tried.verdict === "wrong" || tried.missed;
}

/**
 * A task: one plan in one position. A step is taken in three moves: an instrument, what it is laid to, what comes of
 * it. Any step whose marks are there is right. What was drawn stands as it was drawn, with all that comes of it.
 */
export class Task {
  /**
   * @param {Bench} bench
   * @param {Move[]} moves the steps that are asked for, in the order of the plan
   * @param {{kindOf: (slot: number) => string, isScale: (slot: number) => boolean, isHere: (slot: number) => boolean}} marks
   *   what a mark is on the board, whether it is a scale factor, whether it stands on the plan
   * @param {Move[]} free lines that may be drawn besides: they lead to a point as well as its own
   */
  constructor(bench, moves, { kindOf, isScale, isHere }, free = []) {
    this.bench = bench;
    this.moves = moves;
    this.kindOf = kindOf;
    this.free = free;
    this.picking = new Picking([...moves, ...free], (slot) => SORTS[kindOf(slot)], isScale, isHere);
    this.score = new Score(moves.length);
    this.own = new Map([...moves, ...free].map((move) => [move.it, move]));
    /** @type {Instrument | null} */
    this.instrument = null;
    /** @type {number[]} */
    this.picks = [];
    /** The step whose answer is due. @type {Move | null} */
    this.asked = null;
    /** What was told of it last and is not taken. @type {Tried | null} */
    this.refused = null;
    /** What each step that is done came to, as it was told. @type {Map<number, Tried | null>} */
    this.results = new Map();
    /** @type {Tried[]} */
    this.tries = [];
    /** How far a step was helped with. @type {Map<number, number>} */
    this.helped = new Map();
  }

  /** @param {number} slot */
  isDone(slot) {
    return this.results.has(slot);
  }

  /** Whether every step is done. */
  get ready() {
    return this.results.size === this.score.count;
  }

  /** The step that comes next: of the chosen instrument, else in the order of the plan; null when all is done. */
  get next() {
    const open = this.moves.filter((move) => !this.isDone(move.it) && !isSpare(this, move));
    const can = open.filter((move) => this.bench.ready(move.it));
    const meant = can.filter((move) => instrumentOf(move.op).name === this.instrument?.name);
    const laid = meant.find((move) => this.picks.every((slot) => move.uses.includes(slot)));
    return laid ?? meant[0] ?? can[0] ?? open[0] ?? null;
  }

  /**
   * Take an instrument; what was picked for another one is let go.
   * @param {string} name
   */
  choose(name) {
    this.instrument = INSTRUMENTS.find((one) => one.name === name) ?? null;
    this.picks = [];
    this.asked = null;
    this.refused = null;
  }

  /** Put the instrument down. */
  rest() {
    this.choose("");
  }

  /**
   * Whether a mark is there, and may be picked now.
   * @param {number} slot
   */
  fits(slot) {
    const free = this.instrument !== null && this.asked === null;
    if (!free || (this.own.has(slot) && !this.isDone(slot))) return false;
    return this.picking.fits(/** @type {Instrument} */ (this.instrument), this.picks, slot);
  }

  /**
   * Pick a mark, or let it go.
   * @param {number} slot
   * @returns {Outcome}
   */
  pick(slot) {
    if (this.picks.includes(slot)) this.picks = this.picks.filter((one) => one !== slot);
    else if (this.fits(slot)) this.picks = [...this.picks, slot];
    if (this.instrument === null || !this.picking.isFull(this.instrument, this.picks)) return { kind: "more" };
    return this.submit();
  }

  /**
   * Lay the instrument to what is picked.
   * @returns {Outcome}
   */
  submit() {
    if (this.instrument === null || this.picks.length === 0) return { kind: "more" };
    const answer = this.picking.answer(this.instrument, this.picks, (slot) => this.isDone(slot), this.bench);
    if ("move" in answer) return this.begin(answer.move);
    if (answer.why !== "done") this.score.stray();
    this.picks = [];
    return { kind: "none", answer };
  }

  /**
   * @param {Move} move
   * @returns {Outcome}
   */
  begin(move) {
    if (!isKnown(this.bench.due(move.it))) {
      this.picks = [];
      return { kind: "undrawable", slot: move.it };
    }
    if (!this.isTold(move)) {
      this.take(move.it, null);
      return { kind: "drawn", slot: move.it };
    }
    this.asked = move;
    this.picks = [];
    return { kind: "asked", slot: move.it };
  }

  /**
   * Whether a student tells what comes of a step.
   * @param {Move} move
   */
  isTold(move) {
    return (!DRAWN.includes(this.kindOf(move.it)) || hasSides(this, move)) && move.op !== FALLS;
  }

  /**
   * Tell what came of the step that is asked; what is not wrong is taken.
   * @param {number | Complex} found
   * @param {string[]} texts as it was written
   * @param {Last} last half a unit of the last digit that was written
   * @returns {Tried | null}
   */
  tell(found, texts, last) {
    if (this.asked === null) return null;
    const slot = this.asked.it;
    const { error, parts, verdict, blamed } = this.bench.judge(slot, found, last);
    const missed = typeof found !== "number" && parts.some((part) => Math.abs(part.error) > MISSED);
    const tried = { slot, found, texts, last, error, parts, verdict, blamed, missed };
    this.tries.push(tried);
    if (isWrong(tried)) {
      this.score.charge(slot);
      this.refused = tried;
    } else this.take(slot, tried);
    return tried;
  }

  /**
   * Let what was told last stand, though it is wrong.
   * @returns {Tried | null}
   */
  leave() {
    const tried = this.refused;
    if (tried !== null) this.take(tried.slot, tried);
    return tried;
  }

  /**
   * Do a step again: what it came to stands until then.
   * @param {number} slot
   */
  redo(slot) {
    const move = this.own.get(slot);
    if (move === undefined || !this.isDone(slot) || !this.isTold(move)) return;
    this.rest();
    this.asked = move;
  }

  /**
   * Help with the step that is asked or comes next, each time further; in the end it is shown.
   * @returns {Help | null}
   */
  help() {
    const move = this.asked ?? this.next;
    if (move === null) return null;
    const stage = Math.min(this.helped.get(move.it) ?? 0, STAGES.length - 1);
    this.helped.set(move.it, stage + 1);
    this.score.charge(move.it);
    if (STAGES[stage] === "show") this.take(move.it, null, true);
    return { slot: move.it, stage: STAGES[stage] ?? "" };
  }

  /** The stage of the help that would come next. */
  get stage() {
    const move = this.asked ?? this.next;
    return STAGES[Math.min(this.helped.get(move?.it ?? -1) ?? 0, STAGES.length - 1)] ?? "";
  }

  /**
   * Keep a step as it was told; what nobody told is what it has to be.
   * @param {number} slot
   * @param {Tried | null} tried
   * @param {boolean} shown
   */
  take(slot, tried, shown = false) {
    if (tried !== null) this.bench.take(slot, tried.found, tried.last);
    else this.bench.take(slot, DRAWN.includes(this.kindOf(slot)) ? undefined : this.bench.due(slot));
    this.results.set(slot, tried);
    this.score.count = countOf(this);
    this.score.done(slot, shown, tried !== null && isWrong(tried));
    this.rest();
  }
}
