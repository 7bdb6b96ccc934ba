/** @typedef {import("./figures.js").Spot} Spot */

/** On so many sides of a point its letter is tried. */
const AROUND = 16;

/**
 * Return a place beside a point that is farthest from ink and from other letters.
 * @param {Spot} spot
 * @param {number} away
 * @param {Spot[]} black what is taken
 * @returns {Spot}
 */
export function besideOf([x, y], away, black) {
  /** @type {Spot} */
  let best = [x + away, y + away];
  let most = -1;
  for (let k = 0; k < AROUND; k += 1) {
    const turn = (2 * Math.PI * (k + 1)) / AROUND;
    /** @type {Spot} */
    const tried = [x + away * Math.cos(turn), y + away * Math.sin(turn)];
    const free = Math.min(2 * away, ...black.map(([px, py]) => Math.hypot(px - tried[0], py - tried[1])));
    if (free > most + 1e-9) [best, most] = [tried, free];
  }
  return best;
}
