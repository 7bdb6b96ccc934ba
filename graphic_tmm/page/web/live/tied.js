import { BY_SIGN } from "./bysign.js";

/**
 * @typedef {import("../types.js").Ties} Ties
 * @typedef {import("../types.js").Variant} Variant
 * @typedef {import("../types.js").Drawn} Drawn
 */

/** An arc whose bulge is more is no arc; as in page/strands.py. */
const UNBENT = 500;
/** How many numbers stand for an operation, where not one; before those of "#" stands how many there are. @type {Record<string, number>} */
const TAKES = { m: 2, n: 2, "+": 2, "-": 2, "*": 2, "/": 2, c: 2, _: 2, "=": 2, "<": 2, "?": 3 };

/**
 * The expressions of marks that ink is tied to, calculated from the marks in one position: page/tied_pack.py packs
 * them, and paper/expressions.py says what each operation makes.
 */
export class Expressions {
  /** @param {Ties} told */
  constructor(told) {
    this.ops = [...told.ops];
    this.holds = told.holds;
    this.numbers = told.numbers;
    this.operations = this.ops.map((sign) => BY_SIGN[sign] ?? absent);
    this.re = new Float64Array(this.ops.length);
    this.im = new Float64Array(this.ops.length);
    /** @type {(Drawn | undefined)[]} */
    this.marks = [];
    /** What is found over the turn, by node. @type {Map<number, number>} */
    this.turned = new Map();
    this.of = Int32Array.from(told.of);
    /** Where what a node is made of begins. */
    this.begins = begun(this.ops, this.of);
    this.every = this.ops.map((_, k) => k);
    this.over = this.every.filter((k) => this.ops[k] === "v" || this.ops[k] === "^");
    this.wanted = this.over.map((k) => this.of[this.begins[k] ?? 0] ?? 0);
    this.slice = this.needed(this.wanted);
    /** The marks that are needed at all angles, by slots. */
    this.turning = this.slice.filter((k) => this.ops[k] === "m").map((k) => this.of[this.begins[k] ?? 0] ?? 0);
  }

  /**
   * Find what is found over the turn: of each such expression its least or its greatest value. Where it is not
   * everywhere, as beside a lock, that lies between two whole degrees and is not known.
   * @param {Iterable<(Drawn | undefined)[]>} positions the marks in all of them
   */
  turn(positions) {
    const { slice, wanted } = this;
    if (wanted.length === 0) return;
    const ends = this.over.map((k) => (this.ops[k] === "v" ? Infinity : -Infinity));
    for (const marks of positions) {
      this.some(slice, marks);
      this.over.forEach((k, n) => {
        const [value, end] = [this.re[wanted[n] ?? 0] ?? NaN, ends[n] ?? NaN];
        ends[n] = this.ops[k] === "v" ? Math.min(value, end) : Math.max(value, end);
      });
    }
    this.over.forEach((k, n) => this.turned.set(k, ends[n] ?? NaN));
  }

  /**
   * Return the nodes that some are made of, they among them, in their order.
   * @param {number[]} wanted
   */
  needed(wanted) {
    const found = new Set();
    const ahead = [...wanted];
    for (let k = ahead.pop(); k !== undefined; k = ahead.pop()) {
      if (found.has(k)) continue;
      found.add(k);
      const op = this.ops[k] ?? "";
      const from = this.begins[k] ?? 0;
      if (op === "#") ahead.push(...this.of.slice(from + 1, from + 1 + (this.of[from] ?? 0)).filter((n) => n >= 0));
      else if (op !== "m" && op !== "n") ahead.push(...this.of.slice(from, from + (TAKES[op] ?? 1)));
    }
    return [...found].sort((a, b) => a - b);
  }

  /**
   * Return the nodes that variants are made of, and those that tell which of them holds.
   * @param {Variant[]} variants
   */
  nodesOf(variants) {
    const holding = (/** @type {number} */ which) => (this.holds[which] ?? []).map((one) => Math.abs(one) - 1);
    return this.needed(variants.flatMap(([which, at, bulges]) => [...at, ...(bulges === 0 ? [] : bulges), ...holding(which)]));
  }

  /**
   * Calculate nodes from the marks in a position, by their slots.
   * @param {number[]} nodes
   * @param {(Drawn | undefined)[]} marks
   */
  some(nodes, marks) {
    const { operations, begins } = this;
    this.marks = marks;
    for (const k of nodes) (operations[k] ?? absent)(this, k, begins[k] ?? 0);
  }

  /**
   * Return which of some variants is the one that is drawn; undefined where none is sure.
   * @param {Variant[]} variants
   */
  drawn(variants) {
    return variants.find((one) => this.sure(one));
  }

  /** @param {Variant} variant */
  sure([which, places, bulges]) {
    const { re, im } = this;
    const alike = (this.holds[which] ?? []).every((told) => re[Math.abs(told) - 1] === Number(told > 0));
    if (!alike || !places.every((k) => Number.isFinite(re[k]) && Number.isFinite(im[k]))) return false;
    return bulges === 0 || bulges.every((k) => Math.abs(re[k] ?? NaN) < UNBENT);
  }
}

/**
 * Return where what each node is made of begins, and let that name nodes by their own numbers.
 * @param {string[]} ops
 * @param {Int32Array} of
 */
function begun(ops, of) {
  const begins = new Int32Array(ops.length);
  let from = 0;
  ops.forEach((op, k) => {
    begins[k] = from;
    const first = op === "#" ? from + 1 : from;
    const behind = first + (op === "#" ? (of[from] ?? 0) : (TAKES[op] ?? 1));
    for (let n = first; n < behind && op !== "m" && op !== "n"; n++) {
      const back = of[n] ?? 0;
      if (back > 0) of[n] = k - back;
    }
    from = behind;
  });
  return begins;
}

/** @type {import("./bysign.js").Operation} */
function absent({ re }, k) {
  re[k] = NaN;
}
