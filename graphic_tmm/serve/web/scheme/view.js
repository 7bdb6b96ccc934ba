/**
 * Where the paper lies in the window: metres to dots and back; signs and letters keep their size in dots.
 *
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {[number, number]} Dots from the upper left corner of the paper's window, downward
 */

/** So many dots about a mechanism that is shown whole, and of a small window at most this share. */
const MARGIN = 90;
const SHARE = 0.22;
/** How wide the window is at first, m. */
const FIRST = 0.6;
/** The least and the greatest number of dots of a metre. */
const LEAST = 2;
const MOST = 200_000;
/** Squares of the paper, mm; the finest whose lines stand so many dots apart is drawn. */
const SQUARES = [1, 5, 10, 50, 100, 500, 1000, 5000];
const CLEAR = 7;

export class View {
  constructor() {
    this.width = 800;
    this.height = 600;
    /** Dots of a metre; where the origin lies. */
    this.scale = this.width / FIRST;
    /** @type {Dots} */
    this.origin = [this.width / 2, this.height / 2];
    this.begun = false;
  }

  /**
   * Take notice of the size of the window.
   * @param {number} width
   * @param {number} height
   */
  resize(width, height) {
    if (!this.begun) {
      this.scale = width / FIRST;
      this.origin = [width / 2, height * 0.6];
      this.begun = width > 0;
    }
    this.width = width;
    this.height = height;
  }

  /**
   * @param {Place} place
   * @returns {Dots}
   */
  dots([x, y]) {
    return [this.origin[0] + x * this.scale, this.origin[1] - y * this.scale];
  }

  /**
   * @param {Dots} dots
   * @returns {Place}
   */
  place([x, y]) {
    return [(x - this.origin[0]) / this.scale, (this.origin[1] - y) / this.scale];
  }

  /**
   * Show larger or smaller, about a spot.
   * @param {number} by
   * @param {Dots} about
   */
  zoom(by, [x, y] = [this.width / 2, this.height / 2]) {
    const scale = Math.min(Math.max(this.scale * by, LEAST), MOST);
    const real = scale / this.scale;
    this.origin = [x + (this.origin[0] - x) * real, y + (this.origin[1] - y) * real];
    this.scale = scale;
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  pan(x, y) {
    this.origin = [this.origin[0] + x, this.origin[1] + y];
  }

  /**
   * Show all of something; null: as at first.
   * @param {{left: number, right: number, low: number, high: number} | null} bounds
   */
  fit(bounds) {
    if (bounds === null || (bounds.left === bounds.right && bounds.low === bounds.high)) {
      this.begun = false;
      this.resize(this.width, this.height);
      return;
    }
    const margin = Math.min(MARGIN, SHARE * Math.min(this.width, this.height));
    const across = (this.width - 2 * margin) / Math.max(bounds.right - bounds.left, 1e-9);
    const down = (this.height - 2 * margin) / Math.max(bounds.high - bounds.low, 1e-9);
    this.scale = Math.min(Math.max(Math.min(across, down), LEAST), MOST);
    this.origin = [
      this.width / 2 - ((bounds.left + bounds.right) / 2) * this.scale,
      this.height / 2 + ((bounds.low + bounds.high) / 2) * this.scale,
    ];
  }

  /**
   * Show a place in the middle of the window.
   * @param {number} scale
   * @param {Place} middle
   */
  lie(scale, [x, y]) {
    this.scale = Math.min(Math.max(scale, LEAST), MOST);
    this.origin = [this.width / 2 - x * this.scale, this.height / 2 + y * this.scale];
  }

  /** The side of the squares that are drawn, m. */
  get square() {
    const fine = SQUARES.find((one) => (one * this.scale) / 1000 >= CLEAR) ?? SQUARES.at(-1) ?? 1;
    return fine / 1000;
  }
}
