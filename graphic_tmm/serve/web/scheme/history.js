/**
 * What was, to come back to it: acts taken back can be done again until another is done.
 *
 * @template T
 */
export class History {
  /** @param {number} most acts that can be taken back */
  constructor(most) {
    this.most = most;
    /** @type {T[]} */
    this.past = [];
    /** @type {T[]} */
    this.future = [];
  }

  /**
   * Keep what is before an act.
   * @param {T} moment
   */
  keep(moment) {
    this.past = [...this.past.slice(1 - this.most), moment];
    this.future = [];
    return moment;
  }

  /**
   * Forget an act that was refused, and those behind it.
   * @param {T} moment that was kept before it
   */
  forget(moment) {
    const at = this.past.indexOf(moment);
    if (at >= 0) this.past = this.past.slice(0, at);
  }

  /**
   * Return what was before the last act; null if there is none.
   * @param {T} now
   */
  back(now) {
    return History.swap(this.past, this.future, now);
  }

  /**
   * Return what was before it was taken back; null if nothing was.
   * @param {T} now
   */
  forth(now) {
    return History.swap(this.future, this.past, now);
  }

  /**
   * @template S
   * @param {S[]} from
   * @param {S[]} to
   * @param {S} now
   */
  static swap(from, to, now) {
    const moment = from.pop();
    if (moment !== undefined) to.push(now);
    return moment ?? null;
  }
}
