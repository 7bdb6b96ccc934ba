/** @typedef {import("./sheet-bounds.js").Box} Box */

/** The largest zoom, CSS px a millimetre: ten times true size on a usual screen. */
const MOST_ZOOM = 40;
/** How much smaller than the whole sheet it may get. */
const SMALLEST_OF_WHOLE = 0.7;
/** White about what fills the screen, px. */
const RIM = 8;

/**
 * Where one looks at a sheet from: the point at the upper left of the window, mm, and how large, px a millimetre.
 */
export class Camera {
  /**
   * @param {number} width of the sheet, mm
   * @param {number} height
   */
  constructor(width, height) {
    this.sheet = { width, height };
    this.window = { width: 1, height: 1 };
    this.x = 0;
    this.y = 0;
    this.zoom = 1;
    /** Whether the whole sheet is shown, and goes on to be when the window changes. */
    this.whole = true;
  }

  /** The zoom at which the whole sheet is seen. */
  get fitting() {
    return this.zoomFor(this.sheet.width, this.sheet.height);
  }

  /** @returns {Box} */
  get seen() {
    return [this.x, this.y, this.x + this.window.width / this.zoom, this.y + this.window.height / this.zoom];
  }

  /**
   * @param {number} width mm
   * @param {number} height
   */
  zoomFor(width, height) {
    const across = (this.window.width - 2 * RIM) / width;
    return Math.max(0.05, Math.min(across, (this.window.height - 2 * RIM) / height, MOST_ZOOM));
  }

  /**
   * Tell how large the window is, px; what stood in its middle stays there.
   * @param {number} width
   * @param {number} height
   */
  resize(width, height) {
    const [left, top, right, bottom] = this.seen;
    this.window = { width, height };
    if (this.whole) this.showWhole();
    else this.look((left + right) / 2, (top + bottom) / 2, this.zoom);
  }

  showWhole() {
    this.look(this.sheet.width / 2, this.sheet.height / 2, this.fitting);
    this.whole = true;
  }

  /**
   * Look at a point in the middle of the window.
   * @param {number} x mm
   * @param {number} y
   * @param {number} zoom
   */
  look(x, y, zoom) {
    this.zoom = Math.min(Math.max(zoom, SMALLEST_OF_WHOLE * this.fitting), MOST_ZOOM);
    this.x = within(x, this.window.width / this.zoom, this.sheet.width);
    this.y = within(y, this.window.height / this.zoom, this.sheet.height);
    this.whole = false;
  }

  /**
   * Let a box fill the window.
   * @param {Box} box mm
   */
  fill([left, top, right, bottom]) {
    this.look((left + right) / 2, (top + bottom) / 2, this.zoomFor(right - left, bottom - top));
  }

  /**
   * Move what is seen.
   * @param {number} dx px
   * @param {number} dy
   */
  shift(dx, dy) {
    const [left, top, right, bottom] = this.seen;
    this.look((left + right) / 2 - dx / this.zoom, (top + bottom) / 2 - dy / this.zoom, this.zoom);
  }

  /**
   * Zoom about a point of the window, which stays where it is.
   * @param {number} factor
   * @param {number} px
   * @param {number} py
   */
  zoomAt(factor, px, py) {
    const [x, y] = this.onSheet(px, py);
    const zoom = Math.min(Math.max(this.zoom * factor, SMALLEST_OF_WHOLE * this.fitting), MOST_ZOOM);
    const { width, height } = this.window;
    this.look(x + (width / 2 - px) / zoom, y + (height / 2 - py) / zoom, zoom);
  }

  /**
   * Return the point of the sheet under a point of the window.
   * @param {number} px
   * @param {number} py
   * @returns {[number, number]}
   */
  onSheet(px, py) {
    return [this.x + px / this.zoom, this.y + py / this.zoom];
  }

  /**
   * Return where a point of the sheet stands in the window, px.
   * @param {number} x
   * @param {number} y
   * @returns {[number, number]}
   */
  onScreen(x, y) {
    return [(x - this.x) * this.zoom, (y - this.y) * this.zoom];
  }
}

/**
 * Return where the window begins when its middle would be at `middle`: the sheet is never lost from it.
 * @param {number} middle mm
 * @param {number} window how much is seen, mm
 * @param {number} sheet how long the sheet is, mm
 */
function within(middle, window, sheet) {
  const kept = window >= sheet ? sheet / 2 : Math.min(Math.max(middle, 0), sheet);
  return kept - window / 2;
}
