/**
 * @typedef {import("./picking.js").Move} Move
 * @typedef {import("./practising.js").Practising} Practising
 * @typedef {import("./task.js").Task} Task
 */

/** What appears by itself once it is known what it is drawn through. */
export const DRAWN = ["line", "arc", "angle"];

/**
 * Whether a line can be drawn in two ways, and a student says in which.
 * @param {Pick<Task, "kindOf">} task
 * @param {Move} move
 */
export function hasSides(task, move) {
  return DRAWN.includes(task.kindOf(move.it)) && move.uses.some((slot) => task.kindOf(slot) === "side");
}

/**
 * Say on which of its two sides the line that is asked is drawn; return whether it is.
 * @param {Task} task
 * @param {number} side +1 or -1
 */
export function tellSide(task, side) {
  const { asked } = task;
  if (asked === null) return false;
  const due = asked.uses.find((slot) => task.kindOf(slot) === "side") ?? -1;
  const right = task.bench.value(due) === side;
  if (right) task.take(asked.it, null);
  else task.score.charge(asked.it);
  return right;
}

/**
 * Let a student say it, and show what comes of it.
 * @param {Practising} work
 * @param {number} side
 */
export function showSide(work, side) {
  const slot = work.task.asked?.it ?? -1;
  work.settle(tellSide(work.task, side) ? { kind: "drawn", slot } : { kind: "wrong side" });
}
