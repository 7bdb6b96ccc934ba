/**
 * Plane figures of a board, mm, y upward: what of them is seen, how near they are.
 *
 * @typedef {[number, number]} Spot
 * @typedef {[number, number, number, number]} Frame left, low, right, high
 * @typedef {{at: Spot, along: Spot}} Ray a line from where it begins, its direction of length 1
 * @typedef {{centre: Spot, radius: number}} Circle
 */

/**
 * Return the piece of a line within a frame; null if it passes by.
 * @param {Ray} line
 * @param {Frame} frame
 * @returns {[Spot, Spot] | null}
 */
export function pieceIn({ at, along }, frame) {
  let [from, to] = [-Infinity, Infinity];
  for (const axis of /** @type {(0 | 1)[]} */ ([0, 1])) {
    const ends = [frame[axis] - at[axis], frame[axis === 0 ? 2 : 3] - at[axis]];
    if (Math.abs(along[axis]) < LEVEL) {
      if (Math.min(...ends) > 0 || Math.max(...ends) < 0) return null;
      continue;
    }
    const ways = ends.map((end) => end / along[axis]);
    from = Math.max(from, Math.min(...ways));
    to = Math.min(to, Math.max(...ways));
  }
  return from < to && Number.isFinite(to - from) ? [onLine({ at, along }, from), onLine({ at, along }, to)] : null;
}

/** A direction whose part along an axis is less has none. */
const LEVEL = 1e-9;

/**
 * Return the place on a line so far from its beginning.
 * @param {Ray} line
 * @param {number} way
 * @returns {Spot}
 */
export function onLine({ at, along }, way) {
  return [at[0] + way * along[0], at[1] + way * along[1]];
}

/**
 * Return how far along a line a place lies from its beginning.
 * @param {Ray} line
 * @param {Spot} spot
 */
export function wayAlong({ at, along }, spot) {
  return (spot[0] - at[0]) * along[0] + (spot[1] - at[1]) * along[1];
}

/**
 * @param {Spot} one
 * @param {Spot} other
 */
export function distance(one, other) {
  return Math.hypot(one[0] - other[0], one[1] - other[1]);
}

/**
 * @param {Ray} line
 * @param {Spot} spot
 */
export function besideLine({ at, along }, spot) {
  return Math.abs((spot[0] - at[0]) * along[1] - (spot[1] - at[1]) * along[0]);
}

/**
 * @param {Circle} arc
 * @param {Spot} spot
 */
export function besideArc({ centre, radius }, spot) {
  return Math.abs(distance(centre, spot) - radius);
}

/**
 * Return a frame about places, with room about them; upright or broad at most so many times.
 * @param {Spot[]} spots
 * @param {number} room a share of the larger side
 * @param {number} least room, mm
 * @returns {Frame}
 */
export function frameOf(spots, room, least) {
  const xs = spots.map((spot) => spot[0]);
  const ys = spots.map((spot) => spot[1]);
  const [left, low, right, high] = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
  const more = Math.max(least, room * Math.max(right - left, high - low));
  return [left - more, low - more, right + more, high + more];
}

/**
 * Return an arrow's head at the end of a segment, as path data with y downward; "" where there is no room for one.
 * @param {Spot} from
 * @param {Spot} to
 * @param {number} long
 */
export function headOfArrow(from, to, long) {
  const whole = distance(from, to);
  if (whole < LEVEL) return "";
  const size = Math.min(long, whole / 2);
  const [c, s] = [(to[0] - from[0]) / whole, (to[1] - from[1]) / whole];
  const back = [to[0] - size * c, to[1] - size * s];
  const half = size / 4;
  const corners = [to, [(back[0] ?? 0) - half * s, (back[1] ?? 0) + half * c], [(back[0] ?? 0) + half * s, (back[1] ?? 0) - half * c]];
  return `M${corners.map((spot) => `${mmText(spot[0] ?? 0)} ${mmText(-(spot[1] ?? 0))}`).join("L")}Z`;
}

/**
 * Return path data through places, y downward.
 * @param {Spot[]} spots
 */
export function pathThrough(spots) {
  return `M${spots.map(([x, y]) => `${mmText(x)} ${mmText(-y)}`).join("L")}`;
}

/** @param {number} value */
export function mmText(value) {
  return String(Math.round(value * 1000) / 1000 + 0);
}
