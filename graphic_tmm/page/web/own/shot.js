import { loweredSpot, noCurl, risenSpot } from "./curl.js";
import { seenSpot, straightSpot } from "./lens.js";
import { homographyOf, inverseOf, projected } from "./projection.js";

/**
 * @typedef {import("./curl.js").Curl} Curl
 * @typedef {import("./lens.js").Lens} Lens
 * @typedef {import("./projection.js").Rectangle} Rectangle
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {{width: number, height: number, data: Uint8ClampedArray}} Photograph dots of four bytes, row by row
 */

/** How a photograph shows a sheet: its curl, a pinhole's projection, then the lens; and back. */
export class Shot {
  /**
   * @param {Rectangle} box what the corners are of, mm
   * @param {Spot[]} corners where they are seen, px, as `verticesOf` has them
   * @param {Lens} lens
   * @param {Curl} curl
   */
  constructor(box, corners, lens, curl = noCurl(box)) {
    this.box = box;
    this.lens = lens;
    this.curl = curl;
    this.corners = corners;
    this.matrix = homographyOf(
      box,
      corners.map(([x, y]) => straightSpot(lens, x, y)),
    );
    this.back = inverseOf(this.matrix);
  }

  /**
   * Return where a point of the sheet is seen, px.
   * @param {number} x mm
   * @param {number} y mm, upward
   * @returns {Spot}
   */
  seen(x, y) {
    const [px, py] = projected(this.matrix, ...risenSpot(this.curl, x, y));
    return seenSpot(this.lens, px, py);
  }

  /**
   * Return which point of the sheet is seen at a place, mm.
   * @param {number} px
   * @param {number} py
   * @returns {Spot}
   */
  onSheet(px, py) {
    const [x, y] = straightSpot(this.lens, px, py);
    return loweredSpot(this.curl, ...projected(this.back, x, y));
  }

  /**
   * Return how a step of a millimetre across and one up the sheet are seen about a point, px: [across, across, up, up].
   * @param {number} x
   * @param {number} y
   */
  stepsAt(x, y) {
    const [[right, low], [left, high]] = [this.seen(x + 0.5, y), this.seen(x - 0.5, y)];
    const [[up, above], [down, under]] = [this.seen(x, y + 0.5), this.seen(x, y - 0.5)];
    return [right - left, low - high, up - down, above - under];
  }

  /**
   * Return how many dots of the photograph a millimetre about a point is.
   * @param {number} x
   * @param {number} y
   */
  dotsAt(x, y) {
    const [ax = 0, ay = 0, bx = 0, by = 0] = this.stepsAt(x, y);
    return Math.sqrt(Math.abs(ax * by - ay * bx));
  }
}

/**
 * Return the grey of a photograph between its dots, 0 ... 255; NaN outside the centres of the outermost.
 * @param {Photograph} image
 * @param {number} x
 * @param {number} y
 */
export function greyAt({ width, height, data }, x, y) {
  if (!(x >= 0 && x <= width - 1 && y >= 0 && y <= height - 1)) return NaN;
  const column = Math.min(Math.trunc(x), Math.max(width - 2, 0));
  const row = Math.min(Math.trunc(y), Math.max(height - 2, 0));
  const [right, down] = [x - column, y - row];
  const upper = 4 * (row * width + column);
  const lower = upper + (row + 1 < height ? 4 * width : 0);
  const beside = column + 1 < width ? 4 : 0;
  const above = sumAt(data, upper) * (1 - right) + sumAt(data, upper + beside) * right;
  const below = sumAt(data, lower) * (1 - right) + sumAt(data, lower + beside) * right;
  return (above * (1 - down) + below * down) / 3;
}

/**
 * @param {Uint8ClampedArray} data
 * @param {number} k
 */
function sumAt(data, k) {
  return (data[k] ?? 0) + (data[k + 1] ?? 0) + (data[k + 2] ?? 0);
}
