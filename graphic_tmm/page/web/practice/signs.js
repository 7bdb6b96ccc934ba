/**
 * @typedef {import("./log.js").Log} Log
 * @typedef {import("./judging.js").Taken} Taken
 */

/**
 * The signs of rates: once a column bears a minus its signs are meant (checking/readings/signs.py).
 */
export class Signs {
  /**
   * @param {Log} log
   * @param {Taken[]} rows
   */
  constructor(log, rows) {
    this.log = log;
    this.columns = new Set(rows.filter(({ found }) => Number(found) < 0).map((row) => this.column(row)));
  }

  /**
   * Return what is written in one column with a figure: rates of a plan that are called by one letter.
   * @param {Taken} row
   */
  column({ slot }) {
    const { as, name, key } = this.log.steps.get(slot)?.read ?? {};
    return as === "rate" ? `${name} ${key?.replace(/\d+$/, "")}` : "";
  }

  /**
   * Whether a plus is a sign.
   * @param {Taken} row
   */
  has(row) {
    const column = this.column(row);
    return column !== "" && this.columns.has(column);
  }
}
