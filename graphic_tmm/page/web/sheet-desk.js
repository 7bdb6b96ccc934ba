import { element } from "./dom.js";
import { Camera } from "./pan.js";
import { boxesMeet } from "./sheet-bounds.js";
import { grownLetters, paintNames } from "./sheet-letters.js";
import { batchesOf, paintBatches, paintLit } from "./sheet-paint.js";
import { contextOf, Surface } from "./surface.js";

/**
 * @typedef {import("./sheet-bounds.js").Box} Box
 * @typedef {import("./sheet-ink.js").Ink} Ink
 * @typedef {import("./sheet-ink.js").SheetInk} SheetInk
 * @typedef {import("./sheet-ink.js").SheetView} SheetView
 * @typedef {import("./sheet-paint.js").Batch} Batch
 */

/** So long nothing has moved before letters are set anew, ms. */
const REST = 120;
const GLIDE = 220;
const STILL_PLEASE = "(prefers-reduced-motion: reduce)";

/** The canvas on which a sheet lies. */
export class Desk extends Surface {
  /**
   * @param {HTMLElement} surface what the canvas fills
   * @param {(view: SheetView) => string} short a short name of a view
   */
  constructor(surface, short) {
    super(surface);
    this.short = short;
    /** A context in millimetres, to ask what is under a point. */
    this.asking = contextOf(element("canvas", { width: "1", height: "1" }));
    /** @type {SheetInk} */
    this.sheet = { width: 1, height: 1, ink: [], views: [], labels: [] };
    /** @type {Ink[]} */
    this.shown = [];
    /** @type {Ink[]} */
    this.lit = [];
    /** @type {SheetView | null} */
    this.chosen = null;
    this.large = true;
    /** @type {Batch[]} */
    this.batches = [];
    /** @type {Map<number, DOMMatrix>} */
    this.grown = new Map();
    this.rest = 0;
    this.onDrawn = () => {};
  }

  /**
   * Lay a sheet on the desk.
   * @param {SheetInk} sheet
   */
  lay(sheet) {
    this.sheet = sheet;
    this.lit = [];
    this.chosen = null;
    this.camera = new Camera(sheet.width, sheet.height);
    this.camera.resize(this.surface.clientWidth, this.surface.clientHeight);
  }

  /**
   * Say what of the sheet is shown.
   * @param {Ink[]} shown
   * @param {boolean} large whether letters are larger and lines wider where they could not be seen
   */
  show(shown, large) {
    this.shown = shown;
    this.large = large;
    this.lit = this.lit.filter((one) => shown.includes(one));
    this.settle();
  }

  /** What is seen has changed. */
  moved() {
    super.moved();
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => this.settle(), REST);
  }

  /** Set the letters for the size that they have now. */
  settle() {
    const grown = this.large ? grownLetters(this.sheet, this.camera.zoom) : new Map();
    const same = grown.size === 0 && this.grown.size === 0 && this.batched === this.shown;
    if (!same) {
      this.grown = grown;
      this.batches = batchesOf(this.shown, grown);
      this.batched = this.shown;
    }
    window.clearTimeout(this.rest);
    if (!same) super.moved();
  }

  draw() {
    super.draw();
    this.onDrawn();
  }

  paper() {
    return this.sheet;
  }

  /** @param {CSSStyleDeclaration} style */
  paint(style) {
    const { context, camera } = this;
    paintBatches(context, this.batches, camera.seen, this.large ? camera.zoom : 0);
    paintLit(context, this.lit, style.getPropertyValue("--lit"), camera.zoom);
    if (this.chosen !== null) this.outline(this.chosen.box, style.getPropertyValue("--lit"));
  }

  sign() {
    if (this.large) paintNames(this.context, this.sheet.views, this.short, this.camera);
  }

  /**
   * @param {Box} box
   * @param {string} colour
   */
  outline([left, top, right, bottom], colour) {
    const rim = 3 / this.camera.zoom;
    this.context.setLineDash([]);
    this.context.lineWidth = 2 / this.camera.zoom;
    this.context.strokeStyle = colour;
    this.context.strokeRect(left - rim, top - rim, right - left + 2 * rim, bottom - top + 2 * rim);
  }

  /**
   * Let a box fill the desk, gliding there unless that is not wanted.
   * @param {Box} box
   */
  glideTo(box) {
    const [left, top, right, bottom] = this.camera.seen;
    const from = [(left + right) / 2, (top + bottom) / 2, Math.log(this.camera.zoom)];
    const to = [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2];
    to.push(Math.log(this.camera.zoomFor(box[2] - box[0], box[3] - box[1])));
    const begun = performance.now();
    const length = window.matchMedia(STILL_PLEASE).matches ? 0 : GLIDE;
    const go = () => {
      const t = length === 0 ? 1 : Math.min((performance.now() - begun) / length, 1);
      const eased = t * t * (3 - 2 * t);
      const [x = 0, y = 0, zoom = 0] = from.map((one, k) => one + ((to[k] ?? one) - one) * eased);
      this.camera.look(x, y, Math.exp(zoom));
      this.moved();
      if (t < 1) requestAnimationFrame(go);
    };
    go();
  }

  /**
   * Return the ink under a point that says what it is, what lies uppermost first, ink with a title before other.
   * @param {number} px
   * @param {number} py
   * @param {number} reach px
   */
  inkAt(px, py, reach) {
    const [x, y] = this.camera.onSheet(px, py);
    const by = reach / this.camera.zoom;
    /** @type {Box} */
    const about = [x - by, y - by, x + by, y + by];
    const found = this.shown.filter((one) => {
      if (!boxesMeet(one.box, about) || (one.of === "" && one.label < 0 && !titleOf(one))) return false;
      if (one.label >= 0) return boxesMeet(this.sheet.labels[one.label]?.box ?? one.box, about);
      this.asking.lineWidth = one.pen.width + 2 * by;
      return this.asking.isPointInStroke(one.path, x, y);
    });
    const rank = (/** @type {Ink} */ one) => (titleOf(one) ? 2 : one.of !== "" ? 1 : 0);
    const sorted = found.reverse().sort((a, b) => rank(b) - rank(a));
    return sorted.filter((one, k) => one.label < 0 || sorted.findIndex((other) => other.label === one.label) === k);
  }

  /**
   * Return the view at a point; of several the smallest.
   * @param {number} px
   * @param {number} py
   */
  viewAt(px, py) {
    const [x, y] = this.camera.onSheet(px, py);
    const area = (/** @type {SheetView} */ one) => (one.box[2] - one.box[0]) * (one.box[3] - one.box[1]);
    return this.sheet.views
      .filter((one) => !one.frame && boxesMeet(one.box, [x, y, x, y]))
      .sort((a, b) => area(a) - area(b))[0];
  }
}

/**
 * Return what a path is called on the sheet.
 * @param {Ink} ink
 */
export function titleOf(ink) {
  return ink.label < 0 ? (ink.element.querySelector(":scope > title")?.textContent ?? "") : "";
}
