import { leftOfLine } from "./fitting.js";

/**
 * What a lens does, as checking/photo/camera.py has it: a ray seen at `off` from the middle a pinhole shows at
 * `off · (1 + share · |off / radius|²)`.
 * @typedef {{x: number, y: number, radius: number, share: number}} Lens px, px, half the width, a share there
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {{x: Float64Array, y: Float64Array, weights: Float64Array}} SeenLine places seen, px, and how far each is believed
 */

/** Newton's steps for the place at which a ray is seen, and when it is found, as a share of the half width. */
const NEWTON = 8;
const FOUND = 1e-9;

/**
 * Return the lens that bows nothing.
 * @param {{width: number, height: number}} photograph
 * @returns {Lens}
 */
export function pinholeOf({ width, height }) {
  return { x: (width - 1) / 2, y: (height - 1) / 2, radius: width / 2, share: 0 };
}

/**
 * Return where a pinhole would show what is seen at a place.
 * @param {Lens} lens
 * @param {number} x
 * @param {number} y
 * @returns {Spot}
 */
export function straightSpot(lens, x, y) {
  const [dx, dy] = [x - lens.x, y - lens.y];
  const grown = 1 + (lens.share * (dx * dx + dy * dy)) / (lens.radius * lens.radius);
  return [lens.x + dx * grown, lens.y + dy * grown];
}

/**
 * Return where is seen what a pinhole would show at a place; NaN where no ray is.
 * @param {Lens} lens
 * @param {number} x
 * @param {number} y
 * @returns {Spot}
 */
export function seenSpot(lens, x, y) {
  if (lens.share === 0) return [x, y];
  const [dx, dy] = [x - lens.x, y - lens.y];
  const due = Math.hypot(dx, dy) / lens.radius;
  if (due === 0) return [x, y];
  let far = due;
  for (let k = 0; k < NEWTON; k += 1) {
    const slope = 1 + 3 * lens.share * far * far;
    if (!(slope > 0)) return [NaN, NaN];
    far -= (far + lens.share * far ** 3 - due) / slope;
  }
  if (!(Math.abs(far + lens.share * far ** 3 - due) < FOUND)) return [NaN, NaN];
  const part = far / due;
  return [lens.x + dx * part, lens.y + dy * part];
}

/**
 * Return the lens that makes lines straight; with fewer than two lines as it is.
 * @param {Lens} lens
 * @param {SeenLine[]} lines
 * @param {number} most no share is believed to be larger
 * @returns {Lens}
 */
export function straightening(lens, lines, most) {
  let square = 0;
  let both = 0;
  for (const line of lines) {
    const { off, by } = bowOf(lens, line);
    line.weights.forEach((weight, k) => {
      square += weight * (by[k] ?? 0) ** 2;
      both += weight * (off[k] ?? 0) * (by[k] ?? 0);
    });
  }
  if (lines.length < 2 || !(square > 0)) return lens;
  return { ...lens, share: Math.min(Math.max(-both / square, -most), most) };
}

/**
 * Return how far a line's points are from straight, px, and what a share of 1 adds to that.
 * @param {Lens} lens
 * @param {SeenLine} line
 */
export function bowOf(lens, { x, y, weights }) {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = [x[0], y[0], x.at(-1), y.at(-1)];
  const far = Math.hypot(x1 - x0, y1 - y0);
  const [wx, wy] = [(x1 - x0) / far, (y1 - y0) / far];
  const along = x.map((one, k) => (one - x0) * wx + ((y[k] ?? 0) - y0) * wy);
  const across = x.map((one, k) => ((y[k] ?? 0) - y0) * wx - (one - x0) * wy);
  const by = x.map((one, k) => {
    const [dx, dy] = [one - lens.x, (y[k] ?? 0) - lens.y];
    return ((dy * wx - dx * wy) * (dx * dx + dy * dy)) / (lens.radius * lens.radius);
  });
  return { off: leftOfLine(along, across, weights), by: leftOfLine(along, by, weights) };
}
