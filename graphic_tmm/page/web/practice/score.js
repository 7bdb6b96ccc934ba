/**
 * How a task was done, by its steps; there is no clock.
 *
 * @typedef {"once" | "helped" | "shown" | "wrong"} Mark a step was right at once, after help or again, was shown, or
 *   stands though it is wrong
 * @typedef {{once: number, helped: number, shown: number, wrong: number, count: number}} Tally of all steps
 */

/** The stages of help for a step, in their order. */
export const STAGES = ["why", "what", "show"];

/** What each step of a task has cost. */
export class Score {
  /** @param {number} count of the steps that are asked for */
  constructor(count) {
    this.count = count;
    /** @type {Map<number, Mark>} */
    this.marks = new Map();
    /** Steps that were wrong, or helped with, before they were right. @type {Set<number>} */
    this.charged = new Set();
    /** Whether a choice was wrong that no step is known for: the next one bears it. */
    this.strayed = false;
  }

  /** A choice that was no step. */
  stray() {
    this.strayed = true;
  }

  /**
   * A step was wrong, or helped with.
   * @param {number} slot
   */
  charge(slot) {
    this.charged.add(slot);
  }

  /**
   * A step is done; what it was worth at first it stays worth, unless it is shown or is wrong now.
   * @param {number} slot
   * @param {boolean} shown
   * @param {boolean} wrong it is let stand though it is wrong
   */
  done(slot, shown = false, wrong = false) {
    const clean = !this.charged.has(slot) && !this.strayed;
    this.strayed = false;
    const before = this.marks.get(slot);
    if (shown) this.marks.set(slot, "shown");
    else if (wrong) this.marks.set(slot, "wrong");
    else if (before === undefined || before === "wrong") this.marks.set(slot, clean ? "once" : "helped");
  }

  /** @returns {Tally} */
  tally() {
    const found = { once: 0, helped: 0, shown: 0, wrong: 0, count: this.count };
    for (const mark of this.marks.values()) found[mark] += 1;
    return found;
  }
}
