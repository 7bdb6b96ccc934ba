import { element } from "../../page/web/dom.js";
import { Loupe, AS_IT_IS } from "../../page/web/own/loupe.js";
import { canvasOf, contextOn } from "../../page/web/own/photo.js";
import { ZoomDesk } from "./desk.js";

/** @typedef {import("./types.js").Mark} Mark */
/** @typedef {import("./types.js").Spot} Spot */
/** @typedef {import("./types.js").Words} Words */
/** @typedef {{place: (spot: Spot) => void, move: (spot: Spot) => void, undo: () => void}} Acts */

/** A larger photograph is shown smaller: some telephones hold no more on a canvas. */
const MOST_DOTS = 16.5e6;
/** A pointer that moved farther has moved the photograph, and clicked nothing, px. */
const CLICKED_WITHIN = 5;
const LEAST = 0.01;
/** Nudges that follow each other within this time are held, ms; then each is farther, up to so many dots. */
const HELD = 160;
const GROWS = 1.15;
const FARTHEST = 60;
/** @type {Record<string, Spot>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** A photograph to be clicked: its marks on it, a loupe over the last of them. */
export class PhotoDesk extends ZoomDesk {
  /**
   * @param {Words} words
   * @param {Acts} acts
   */
  constructor(words, acts) {
    super(words, words["photo desk"] ?? "", ["larger", "smaller", "whole"]);
    this.acts = acts;
    this.least = LEAST;
    /** Dots of what is shown for one of the photograph. */
    this.part = 1;
    this.canvas = canvasOf(1, 1);
    /** @type {Mark | null} */
    this.last = null;
    this.step = 1;
    this.nudged = 0;
    /** @type {Spot} */
    this.way = [0, 0];
    this.down = [0, 0];
    this.loupe = new Loupe(words["photo loupe"] ?? "", ([x, y]) => this.move([x / this.part, y / this.part]));
    this.marks = element("div", { class: "marks" });
    this.desk.addEventListener("pointerdown", (event) => (this.down = [event.clientX, event.clientY]), true);
    this.desk.addEventListener("click", (event) => this.click(event));
  }

  /** Whether there is a photograph. */
  get there() {
    return this.sizes.length > 0;
  }

  /**
   * Show a photograph; whether it could be read.
   * @param {Blob} file
   */
  async open(file) {
    try {
      const whole = await createImageBitmap(file, { imageOrientation: "from-image" });
      this.part = Math.min(1, Math.sqrt(MOST_DOTS / (whole.width * whole.height)));
      this.canvas = canvasOf(whole.width * this.part, whole.height * this.part);
      const { width, height } = this.canvas;
      contextOn(this.canvas).drawImage(whole, 0, 0, width, height);
      whole.close();
    } catch {
      return false;
    }
    this.sizes = [{ width: this.canvas.width, height: this.canvas.height }];
    (this.figures[0] ?? this.figure()).replaceChildren(this.canvas, this.marks);
    this.scale = 0;
    this.size();
    return true;
  }

  /**
   * Show marks; the loupe is over one, if it is new or was moved.
   * @param {Mark[]} marks
   * @param {Mark | null} last
   */
  show(marks, last) {
    this.marks.replaceChildren(...marks.map((mark) => this.mark(mark, mark === last)));
    this.last = last;
    this.look();
  }

  /**
   * @param {Mark} mark
   * @param {boolean} last
   */
  mark({ spot, text, kind }, last) {
    const made = element("span", { class: `mark ${kind}${last ? " last" : ""}` }, element("b", {}, text));
    const [x, y] = this.shown(spot);
    made.style.left = `${(100 * (x + 0.5)) / this.canvas.width}%`;
    made.style.top = `${(100 * (y + 0.5)) / this.canvas.height}%`;
    return made;
  }

  /** Show what is about the last mark. */
  look() {
    const { last, canvas } = this;
    this.loupe.root.hidden = last === null;
    if (last === null) return;
    const picture = /** @type {any} */ ({ source: canvas, width: canvas.width, height: canvas.height });
    this.loupe.show(picture, this.shown(last.spot), AS_IT_IS);
  }

  /**
   * Return the dot of what is shown where a dot of the photograph is; both from the centre of the first.
   * @param {Spot} spot
   * @returns {Spot}
   */
  shown([x, y]) {
    return [(x + 0.5) * this.part - 0.5, (y + 0.5) * this.part - 0.5];
  }

  /**
   * @param {Spot} spot
   * @returns {Spot}
   */
  onScreen(spot) {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = this.shown(spot);
    return [box.left + ((x + 0.5) / this.canvas.width) * box.width, box.top + ((y + 0.5) / this.canvas.height) * box.height];
  }

  /**
   * Return the place of the photograph under one of the screen, as near as it has one.
   * @param {number} x
   * @param {number} y
   * @returns {Spot}
   */
  under(x, y) {
    const box = this.canvas.getBoundingClientRect();
    const across = ((x - box.left) / box.width) * this.canvas.width;
    const down = ((y - box.top) / box.height) * this.canvas.height;
    return this.kept([across / this.part - 0.5, down / this.part - 0.5]);
  }

  /**
   * @param {Spot} spot
   * @returns {Spot}
   */
  kept([x, y]) {
    const { width, height } = this.canvas;
    return [within(x, width / this.part), within(y, height / this.part)];
  }

  /** @param {MouseEvent} event */
  click(event) {
    const [x = 0, y = 0] = this.down;
    const { left, right, top, bottom } = this.canvas.getBoundingClientRect();
    const inner = event.clientX >= left && event.clientX < right && event.clientY >= top && event.clientY < bottom;
    if (!inner || Math.hypot(event.clientX - x, event.clientY - y) > CLICKED_WITHIN) return;
    this.acts.place(this.under(event.clientX, event.clientY));
  }

  /** @param {Spot} spot */
  move(spot) {
    if (this.last !== null) this.acts.move(this.kept(spot));
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (!this.there) return;
    const held = event.ctrlKey || event.metaKey || event.altKey;
    const act = this.act(held && event.key === "z" ? "Backspace" : event.key);
    if (act === null || (held && event.key !== "z")) return super.key(event);
    act();
    event.preventDefault();
  }

  /**
   * Return what a key does; null if nothing of this desk's own.
   * @param {string} key
   */
  act(key) {
    const arrow = ARROWS[key];
    if (arrow !== undefined) return this.last === null ? null : () => this.nudge(arrow);
    if (key === "Enter" || key === " ") return () => this.placed();
    return key === "Backspace" ? () => this.acts.undo() : null;
  }

  /** Place a mark where the last one is, if that is in sight, else in the middle of what is. */
  placed() {
    const box = this.desk.getBoundingClientRect();
    const at = this.last === null ? null : this.onScreen(this.last.spot);
    const seen = at !== null && at[0] > box.left && at[0] < box.right && at[1] > box.top && at[1] < box.bottom;
    const [x, y] = seen ? at : [box.left + box.width / 2, box.top + box.height / 2];
    this.acts.place(this.under(x, y));
  }

  /**
   * Move the last mark by a dot; held, farther and farther.
   * @param {Spot} way
   */
  nudge(way) {
    if (this.last === null) return;
    const now = performance.now();
    this.step = way === this.way && now - this.nudged < HELD ? Math.min(this.step * GROWS, FARTHEST) : 1;
    this.nudged = now;
    this.way = way;
    const [across, down] = way;
    const [x, y] = this.last.spot;
    this.move([x + across * this.step, y + down * this.step]);
  }
}

/**
 * @param {number} x
 * @param {number} size
 */
function within(x, size) {
  return Math.min(Math.max(x, -0.5), size - 0.5);
}
