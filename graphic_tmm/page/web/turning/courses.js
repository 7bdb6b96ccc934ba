/** @typedef {number | number[]} Course what goes with the turn: so much by degree, or one of each degree of a turn */

/** Degrees. */
export const WHOLE_TURN = 360;

/**
 * Return what goes with the turn, there (degrees): between two degrees of a row in proportion.
 * @param {Course} course
 * @param {number} turn
 */
export function alongCourse(course, turn) {
  if (typeof course === "number") return course * turn;
  const at = withinTurn(turn);
  const k = Math.floor(at);
  const [low = 0, high = 0] = [course[k % WHOLE_TURN], course[(k + 1) % WHOLE_TURN]];
  return low + (at - k) * (high - low);
}

/**
 * Return how far a turn is behind its last whole one, degrees.
 * @param {number} turn
 */
export function withinTurn(turn) {
  return ((turn % WHOLE_TURN) + WHOLE_TURN) % WHOLE_TURN;
}
