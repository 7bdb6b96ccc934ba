import { holdsWell, settled } from "./settled.js";
import { Expressions } from "./tied.js";

/** @typedef {import("../types.js").Drawn} Drawn */

/**
 * The ink that follows the marks of a mechanism: its expressions, calculated for the angle that is shown. Who runs the
 * log tells it when something given is changed.
 */
export class LiveInk {
  /**
   * @param {import("../types.js").Ties} ties
   * @param {number} whole so many whole degrees, or steps, are in the row
   * @param {number[]} frames all of them, then what is between two
   * @param {(k: number) => (Drawn | undefined)[]} marks at an angle (index), by their slots
   * @param {(k: number) => (Drawn | undefined)[]} few the same, at least of the marks in `turning` of its expressions
   */
  constructor(ties, whole, frames, marks, few = marks) {
    this.expressions = new Expressions(ties);
    this.whole = whole;
    this.frames = frames;
    this.marks = marks;
    this.few = few;
    /** Whether something given is not as the sheet has it. */
    this.changed = false;
    this.version = 0;
    this.turned = -1;
    /** How often changing has ended; the angles at which letters are placed then; whether an angle is drawn. */
    this.released = 0;
    /** @type {number[]} */
    this.places = [];
    this.drawn = (/** @type {number} */ _k) => true;
  }

  /**
   * Take notice that what is given has changed.
   * @param {boolean} changed whether it is not as the sheet has it
   */
  given(changed) {
    this.changed = changed;
    this.version++;
  }

  /**
   * Calculate the ink of an angle (index), or what of it some nodes are.
   * @param {number} k
   * @param {number[]} nodes
   */
  at(k, nodes = this.expressions.every) {
    if (this.turned !== this.version) {
      this.turned = this.version;
      this.expressions.turn(this.positions());
    }
    this.expressions.some(nodes, this.marks(k));
  }

  /**
   * Place the letters of a figure anew; return its box, null where that is as the sheet has it.
   * @param {import("../moving.js").Moving} moving
   * @param {number} k the angle that is shown
   */
  settle(moving, k) {
    moving.asides = [];
    if (!this.changed) return null;
    this.at(k, []);
    const box = settled(this, moving, [...new Set([...this.places, k])], this.drawn);
    return box === null || holdsWell(moving.figure.box, box) ? null : box;
  }

  *positions() {
    for (let k = 0; k < this.whole; k++) yield this.few(k);
  }
}
