import { BOARD } from "./board.js";

/**
 * @typedef {{b: number[], s: number[], d: number, w: number, m: number}} Limit the sizes of the errors that a hand makes
 *   at one mark in one position, see OwnLimit
 * @typedef {{limit: Limit, errors: number[], steady: boolean[]}} Seen the errors of a point; which of them a hand
 *   does not make only now and then
 * @typedef {{shares: number[], few: number, most: number, sure: number}} Sureness
 */

/**
 * Return the limits of a plan where plans before it are read too.
 * @param {import("../types.js").Practice} data
 * @param {import("../types.js").Task} task
 * @param {import("../types.js").Manner} manner
 * @param {import("./judging.js").Beside[]} beside
 * @returns {import("../types.js").Manner}
 */
export function withOthers(data, task, manner, beside) {
  const plans = [...new Set(data.tasks.map((one) => one.plan))];
  const before = plans.slice(0, plans.indexOf(task.plan));
  const read = before.filter((plan) => beside.some((one) => one.plan === plan && one.rows.length > 0));
  return { ...manner, own: manner.with[read.join(" ")] ?? manner.own };
}

/**
 * Return the limits of a mark's own errors in a position (its number among those of its plan); undefined where a
 * check knows none.
 * @param {import("../types.js").Manner} manner
 * @param {number} slot
 * @param {number} place
 * @returns {Limit | undefined}
 */
export function limitAt(manner, slot, place) {
  const own = manner.own[String(slot)];
  if (own === undefined) return undefined;
  const [b = [], d = -1, w = Infinity] = [own.b[place], own.d[place], own.w[place]];
  if (b.length === 0 || d < 0) return undefined;
  return { b, d, w, s: own.s?.[place] ?? b, m: own.m?.[place] ?? Infinity };
}

/**
 * Return how large an error a hand makes that reads points with a share of the slip counted upon.
 * @param {Limit} limit
 * @param {number} k
 * @param {number} share
 */
export function sizeAt({ b, s }, k, share) {
  const blunt = b[k] ?? 1;
  return share === 1 ? blunt : BOARD.slips.sized(blunt, s[k] ?? blunt, share);
}

/**
 * Return with which share of the slip that was counted upon the points of a drawing were read: what most of their
 * errors are below tells (checking/judging/step_scatter.py).
 * @param {Seen[]} seen
 * @param {Sureness} sureness
 */
export function shareOfSlip(seen, { shares, few, most, sure }) {
  const rows = seen.flatMap(({ limit, errors, steady }) =>
    errors.map((error, k) => ({ limit, k, error })).filter(({ k }) => steady[k]),
  );
  if (rows.length < few) return 1;
  const wide = 1 + sure / Math.sqrt(rows.length);
  const bound = quantile(seen.map(({ limit }) => limit.m), 0.5);
  /** @param {number} share */
  const near = (share) => quantile(rows.map(({ limit, k, error }) => error / sizeAt(limit, k, share)), most);
  return shares.find((share) => near(share) * wide <= bound) ?? 1;
}

/**
 * Return how far each point is off what it may be off, with the limits of that.
 * @param {Pick<import("./judging.js").Judging, "log" | "rows" | "run" | "manner" | "place">} judging
 * @returns {Seen[]}
 */
export function seenOf({ log, rows, run, manner, place }) {
  return rows.flatMap(({ slot, found }) => {
    const limit = limitAt(manner, slot, place);
    if (typeof found === "number" || limit === undefined) return [];
    const parts = log.steps.get(slot)?.parts ?? [];
    const errors = (run.errors.get(slot) ?? []).map(({ error }) => (Number.isFinite(error) ? Math.abs(error) : 0));
    return [{ limit, errors, steady: parts.map(([kind]) => kind !== "met") }];
  });
}

/**
 * Return below what a share of numbers is, between the two that are next to it in proportion.
 * @param {number[]} numbers
 * @param {number} share
 */
function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const at = share * (sorted.length - 1);
  const [low = 0, high = 0] = [sorted[Math.floor(at)], sorted[Math.ceil(at)]];
  return low + (high - low) * (at - Math.floor(at));
}
