/**
 * @typedef {import("./projection.js").Rectangle} Rectangle
 * @typedef {import("./shot.js").Photograph} Photograph
 * @typedef {import("./shot.js").Shot} Shot
 */

/** Between places so many dots apart the projection is taken to be linear: 0.01 px at the most. */
const GRID = 16;
const PAPER = 255;

/** A photograph seen straight from above, in the making: a few rows at a time, so that the page stays awake. */
export class Flattening {
  /**
   * @param {Photograph} image
   * @param {Shot} shot
   * @param {Rectangle} area what of the sheet is wanted, mm
   * @param {number} dots to the mm
   */
  constructor(image, shot, [left, bottom, right, top], dots) {
    this.image = image;
    this.shot = shot;
    this.left = left;
    this.top = top;
    this.dots = dots;
    this.width = Math.max(Math.ceil((right - left) * dots), 1);
    this.height = Math.max(Math.ceil((top - bottom) * dots), 1);
    this.data = new Uint8ClampedArray(4 * this.width * this.height).fill(PAPER);
    this.row = 0;
    this.upper = this.placesAt(0);
  }

  /** The share that is done. */
  get share() {
    return Math.min(this.row / this.height, 1);
  }

  get done() {
    return this.row >= this.height;
  }

  /** Make the next rows: as many as lie between two rows of the grid. */
  step() {
    const lower = this.placesAt(this.row + GRID);
    const rows = Math.min(GRID, this.height - this.row);
    for (let k = 0; k < rows; k += 1) this.fill(this.row + k, k / GRID, lower);
    this.upper = lower;
    this.row += rows;
  }

  /**
   * Return where the places of a row of the grid are seen: x and y in turn, px.
   * @param {number} row
   */
  placesAt(row) {
    const count = Math.ceil(this.width / GRID) + 1;
    const places = new Float64Array(2 * count);
    for (let n = 0; n < count; n += 1) {
      const x = this.left + (GRID * n + 0.5) / this.dots;
      places.set(this.shot.seen(x, this.top - (row + 0.5) / this.dots), 2 * n);
    }
    return places;
  }

  /**
   * @param {number} row
   * @param {number} down share of the way from the upper row of the grid to the lower
   * @param {Float64Array} lower
   */
  fill(row, down, lower) {
    const { upper, width } = this;
    for (let first = 0; first < width; first += GRID) {
      const n = (2 * first) / GRID;
      const x = blended(upper, lower, n, down);
      const y = blended(upper, lower, n + 1, down);
      const dx = (blended(upper, lower, n + 2, down) - x) / GRID;
      const dy = (blended(upper, lower, n + 3, down) - y) / GRID;
      this.sample(row * width + first, Math.min(GRID, width - first), x, y, dx, dy);
    }
  }

  /**
   * Take some dots from places in a line.
   * @param {number} to
   * @param {number} count
   * @param {number} x
   * @param {number} y
   * @param {number} dx
   * @param {number} dy
   */
  sample(to, count, x, y, dx, dy) {
    const { width, height, data: from } = this.image;
    const { data } = this;
    const across = 4 * width;
    for (let k = 0; k < count; k += 1) {
      const px = x + k * dx;
      const py = y + k * dy;
      if (!(px >= 0 && px < width - 1 && py >= 0 && py < height - 1)) continue;
      const column = px | 0;
      const line = py | 0;
      const a = 4 * (line * width + column);
      const right = px - column;
      const low = py - line;
      const [w1, w2, w3] = [right * (1 - low), (1 - right) * low, right * low];
      const w0 = 1 - w1 - w2 - w3;
      for (let c = 0; c < 3; c += 1) {
        const b = a + c;
        data[4 * (to + k) + c] =
          w0 * byteAt(from, b) + w1 * byteAt(from, b + 4) + w2 * byteAt(from, b + across) + w3 * byteAt(from, b + across + 4);
      }
    }
  }
}

/**
 * @param {Uint8ClampedArray} data
 * @param {number} k
 */
function byteAt(data, k) {
  return /** @type {number} */ (data[k]);
}

/**
 * @param {Float64Array} upper
 * @param {Float64Array} lower
 * @param {number} n
 * @param {number} down
 */
function blended(upper, lower, n, down) {
  const above = upper[n] ?? NaN;
  return above + ((lower[n] ?? NaN) - above) * down;
}
