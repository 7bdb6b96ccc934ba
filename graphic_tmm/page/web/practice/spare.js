import { DRAWN } from "./sides.js";

/**
 * @typedef {import("./picking.js").Move} Move
 * @typedef {import("./task.js").Task} Task
 */

/**
 * Whether a line that is not drawn leads to nothing more: what is found by it was found by other lines.
 * @param {Task} task
 * @param {Move} move
 */
export function isSpare(task, move) {
  const users = task.moves.filter(({ uses }) => uses.includes(move.it));
  return DRAWN.includes(task.kindOf(move.it)) && users.length > 0 && users.every(({ it }) => task.isDone(it));
}

/**
 * Return how many steps a task has as it is worked: those that are due, and other lines that were drawn instead.
 * @param {Task} task
 */
export function countOf(task) {
  const due = task.moves.filter((move) => task.isDone(move.it) || !isSpare(task, move));
  return due.length + task.free.filter((move) => task.isDone(move.it)).length;
}
