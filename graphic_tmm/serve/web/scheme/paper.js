import { drawnElement, element } from "../../../page/web/dom.js";
import { countedFrom, drawnGrid, whereabouts } from "./grid.js";
import { listenToKeys } from "./paper-keys.js";
import { listenToPointers } from "./pointers.js";
import { drawnLoads } from "./load-signs.js";
import { boundsOf, placeOf } from "./sketch.js";
import { drawnSketch } from "./signs.js";
import { meant } from "./snap.js";
import { View } from "./view.js";

/**
 * The paper: what is drawn on it, and what a pointer, fingers or the keys do there; what that means is an editor's.
 *
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./signs.js").Chosen} Chosen
 * @typedef {import("./snap.js").Meant} Meant
 * @typedef {import("./view.js").Dots} Dots
 * @typedef {{from: Place | null, to: Meant | null, angle?: number, says: string}} Rubber what is being drawn
 * @typedef {{press: (meant: Meant) => void, hover: (meant: Meant) => void, release: (meant: Meant, drawn: boolean) => void,
 *   cancel: () => void, begun: () => void, key: (event: KeyboardEvent) => boolean, how: () => import("./snap.js").How}} Hand
 */

const RING = 18;

export class Paper {
  /**
   * @param {string} label
   * @param {Hand} hand
   * @param {string} mm
   */
  constructor(label, hand, mm) {
    this.hand = hand;
    this.mm = mm;
    this.view = new View();
    /** Where the pointer, or the cross, is. */
    this.at = element("output", { class: "scheme-at", "aria-hidden": "true" });
    this.svg = drawnElement("svg", { class: "scheme-paper", tabindex: 0, role: "application", "aria-label": label });
    this.layers = ["squares", "mechanism", "loads", "over"].map((name) => drawnElement("g", { class: name }));
    this.svg.append(...this.layers);
    this.element = element("div", { class: "scheme-window" }, this.svg, this.at);
    /** @type {Sketch | null} */
    this.sketch = null;
    /** @type {Chosen} */
    this.chosen = {};
    /** @type {import("../types.js").LoadSign[]} */
    this.loads = [];
    /** @type {Rubber} */
    this.rubber = { from: null, to: null, says: "" };
    /** Where the keys are, m; null while a pointer is at work. @type {Place | null} */
    this.cross = null;
    /** Where the cross was last, m. @type {Place | null} */
    this.rest = null;
    /** What is to be done when the paper lies elsewhere. */
    this.under = () => {};
    listenToPointers(this);
    listenToKeys(this);
    new ResizeObserver(() => this.measure()).observe(this.element);
  }

  measure() {
    const { width, height } = this.element.getBoundingClientRect();
    if (width === 0 || height === 0) return;
    this.view.resize(width, height);
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.draw();
  }

  /**
   * @param {Sketch} sketch
   * @param {Chosen} chosen
   * @param {import("../types.js").LoadSign[]} loads what acts on it; of before if nothing is told
   */
  show(sketch, chosen, loads = this.loads) {
    this.sketch = sketch;
    this.chosen = chosen;
    this.loads = loads;
    this.draw();
  }

  /** Show all of the mechanism. */
  fit() {
    this.view.fit(this.sketch === null ? null : boundsOf(this.sketch));
    this.draw();
  }

  /**
   * Let the origin lie elsewhere, and what is drawn stay where it is seen.
   * @param {Place} by m
   */
  shift([x, y]) {
    this.view.pan(-x * this.view.scale, y * this.view.scale);
    const there = (/** @type {Place | null} */ one) => (one === null ? null : /** @type {Place} */ ([one[0] + x, one[1] + y]));
    [this.cross, this.rest] = [there(this.cross), there(this.rest)];
  }

  /**
   * Let what is drawn look as large as before, and lie where it lay, now that it is larger.
   * @param {number} by
   */
  enlarged(by) {
    const there = (/** @type {Place | null} */ one) => (one === null ? null : /** @type {Place} */ ([by * one[0], by * one[1]]));
    [this.cross, this.rest] = [there(this.cross), there(this.rest)];
    this.view.zoom(1 / by, this.view.origin);
    this.draw();
  }

  /** @param {number} by */
  zoom(by) {
    this.view.zoom(by);
    this.draw();
  }

  /** @param {Rubber} rubber */
  stretch(rubber) {
    this.rubber = rubber;
    this.drawOver();
  }

  draw() {
    if (this.sketch === null) return;
    const [squares, mechanism, loads] = this.layers;
    squares?.replaceChildren(...drawnGrid(this.view, countedFrom(this.sketch), this.mm));
    loads?.replaceChildren(...drawnLoads(this.loads, this.view));
    mechanism?.replaceChildren(...drawnSketch(this.sketch, this.view, this.chosen.drawn ? {} : this.chosen));
    this.under();
    this.drawOver();
  }

  /** Where the pointer, or the cross of the keys, is. */
  whereabouts() {
    const place = this.rubber.to?.place ?? this.cross;
    return place === null || this.sketch === null ? "" : whereabouts(place, countedFrom(this.sketch), this.mm);
  }

  /** What is being drawn: a line, what it is in line with, what will be joined; the cross of the keys. */
  drawOver() {
    const { view, rubber } = this;
    const made = [];
    this.at.textContent = this.whereabouts();
    if (rubber.to !== null) {
      const [x, y] = view.dots(rubber.to.place);
      for (const line of rubber.to.lines) made.push(drawnElement("path", { class: "in-line", d: `M${line.map((one) => view.dots(one).join(" ")).join("L")}` }));
      if (rubber.from !== null) made.push(drawnElement("path", { class: "rubber", d: `M${view.dots(rubber.from).join(" ")}L${x} ${y}` }));
      if (rubber.to.letter !== undefined || rubber.to.bar !== undefined) made.push(drawnElement("circle", { class: "joins", cx: x, cy: y, r: RING }));
      if (rubber.says !== "") made.push(says(rubber.says, x, y - RING - above(rubber.to)));
    }
    const { letter, drawn } = this.chosen;
    if (letter !== undefined && !drawn && this.sketch !== null) {
      const [x, y] = view.dots(placeOf(this.sketch, letter));
      made.push(drawnElement("circle", { class: "grip", cx: x, cy: y, r: RING - 4 }));
    }
    if (this.cross !== null) {
      const [x, y] = view.dots(this.cross);
      made.push(drawnElement("path", { class: "cross", d: `M${x - 22} ${y}H${x + 22}M${x} ${y - 22}V${y + 22}` }));
    }
    this.layers[3]?.replaceChildren(...made);
  }

  /**
   * @param {Dots} spot
   * @param {boolean} coarse
   */
  meant(spot, coarse = false) {
    const sketch = /** @type {Sketch} */ (this.sketch);
    return meant(sketch, this.view, spot, { ...this.hand.how(), coarse });
  }

  /**
   * @param {PointerEvent | WheelEvent} event
   * @returns {Dots}
   */
  spot(event) {
    const box = this.svg.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
}

/**
 * How far above its ring it is said what is meant: the letter of a pin stands between.
 * @param {Meant} to
 */
function above(to) {
  return to.letter === undefined ? 8 : 24;
}

/**
 * A word beside what is being drawn.
 * @param {string} word
 * @param {number} x
 * @param {number} y
 */
function says(word, x, y) {
  const made = drawnElement("text", { class: "says", x, y });
  made.append(word);
  return made;
}
