import { BOARD } from "../practice/board.js";
import { givenAt, NUMBERS_OF } from "../practice/given.js";

/**
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").Told} Told
 * @typedef {import("../types.js").AcrossMark} AcrossMark
 * @typedef {import("../types.js").LiveData} LiveData
 */

/**
 * The log of a mechanism, run at every angle with what is given now. Marks are known by their slots.
 */
export class LiveRun {
  /**
   * @param {LiveData} data
   * @param {number} whole so many whole degrees, or steps, are in the row
   */
  constructor(data, whole) {
    this.data = data;
    this.frames = [...Array.from({ length: whole }, (_, k) => k), ...data.more];
    this.whole = whole;
    /** What is given and not as the scene has it. @type {Map<number, number>} */
    this.changed = new Map();
    /** @type {(Drawn | undefined)[][]} */
    this.rows = this.frames.map(() => new Array(data.size));
    /** So often something was given. */
    this.version = 0;
    this.shown = new Uint8Array(this.frames.length);
    /** @type {(Drawn | undefined)[]} */
    this.full = new Array(data.size);
    /** @type {(Drawn | undefined)[]} */
    this.way = new Array(data.size);
    /** The angle that is in full. */
    this.at = -1;
    /** Of which marks the values at all angles are kept. @type {number[]} */
    this.kept = [];
    /** @type {(Drawn | undefined)[]} */
    this.alike = new Array(data.size);
    /** All marks in each position of the sheet, once they are asked for. @type {AcrossMark[][] | null} */
    this.table = null;
    /** Whether diagrams are among them. */
    this.charted = false;
    this.turning = Object.entries(data.given).filter(([, one]) => varies(one));
    this.begin();
  }

  /**
   * Take some givens other than the scene has them; all others are as it has them.
   * @param {Map<number, number>} changed by their slots
   */
  give(changed) {
    this.changed = changed;
    this.begin();
  }

  /**
   * Return the values of all marks in each position of the sheet, those of diagrams among them.
   */
  charts() {
    const table = this.positions();
    if (!this.charted) BOARD.log["charts"]?.(table);
    this.charted = true;
    return table;
  }

  /** Return the same with what the scene gives. */
  ownCharts() {
    const { changed } = this;
    this.give(new Map());
    const found = this.charts();
    this.give(changed);
    return found;
  }

  begin() {
    const { alike, data } = this;
    this.version++;
    this.shown.fill(0);
    this.at = -1;
    alike.fill(undefined);
    for (const [slot, one] of Object.entries(data.given)) if (!varies(one)) alike[Number(slot)] = this.taken(Number(slot), one, 0);
    this.table = null;
    this.charted = false;
    if (this.changed.size === 0) for (const [slot, one] of Object.entries(data.kept)) alike[Number(slot)] = givenAt(one.k, one.v ?? null, 0);
    BOARD.log["still"]?.(alike);
    // what turns is entered anew at each angle
    for (let slot = 0; slot < alike.length; slot++) this.full[slot] = this.way[slot] = alike[slot];
  }

  /**
   * @param {number} slot
   * @param {Told} one
   * @param {number} k
   * @returns {Drawn}
   */
  taken(slot, one, k) {
    const own = this.changed.get(slot);
    if (own !== undefined) return own;
    const [from = 0, by = 0] = one.row ?? [];
    return one.row === undefined ? givenAt(one.k, one.v ?? null, k) : from + by * (this.frames[k] ?? NaN);
  }

  /**
   * Return the values of all marks at an angle (index), until those at another are; undefined of what is known on the
   * sheet alone. Kept for all angles they would cost the collector of garbage more than they cost.
   * @param {number} k
   */
  marks(k) {
    if (k === this.at) return this.full;
    const { after, sheet } = BOARD.log;
    const [first = []] = after === undefined ? [] : this.positions();
    const M = this.full;
    for (const [slot, one] of this.turning) M[Number(slot)] = this.taken(Number(slot), one, k);
    BOARD.log["way"]?.(M);
    BOARD.log["turn"]?.(M);
    for (const slot of this.data.carried) M[slot] = /** @type {Drawn | undefined} */ (first[slot]);
    after?.([M]);
    if (this.changed.size === 0) sheet?.(M);
    this.at = k;
    return M;
  }

  /**
   * Return the values in each position of the sheet of all marks that angles hang on, across positions too.
   * @returns {AcrossMark[][]}
   */
  positions() {
    if (this.table !== null) return this.table;
    const rowed = Object.entries(this.data.rowed);
    const table = Array.from({ length: this.data.positions }, (_, n) => {
      const M = [...this.alike];
      for (const [slot, one] of rowed) M[Number(slot)] = this.changed.get(Number(slot)) ?? givenAt(one.k, one.v ?? null, n);
      BOARD.log["way"]?.(M);
      BOARD.log["turn"]?.(M);
      return M;
    });
    BOARD.log["across"]?.(table);
    this.table = table;
    return table;
  }

  /**
   * Return the values of those marks at an angle (index) that are kept for all angles.
   * @param {number} k
   */
  few(k) {
    const row = this.rows[k] ?? [];
    if (this.shown[k] === 1) return row;
    const M = this.way;
    this.shown[k] = 1;
    for (const [slot, one] of this.turning) M[Number(slot)] = this.taken(Number(slot), one, k);
    BOARD.log["way"]?.(M);
    for (const slot of this.kept) row[slot] = M[slot];
    return row;
  }
}

/** @param {Told} one */
function varies(one) {
  return one.row !== undefined || (one.v?.length ?? 0) > NUMBERS_OF[one.k];
}
