import { drawnElement } from "../dom.js";
import { divided } from "../inset-places.js";
import { distance, frameOf, mmText, pieceIn } from "./figures.js";
import { markInk, lettersOf } from "./ink.js";
import { kinematicOf } from "./kinematic.js";
import { meantAt } from "./shapes.js";

/**
 * @typedef {import("./easel.js").Easel} Easel
 * @typedef {import("../types.js").View} View
 * @typedef {import("./figures.js").Frame} Frame
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {import("./shapes.js").Shape} Shape
 */

/** How near a pointer has to come to a part of the mechanism, px. */
const NEAR = 16;
/** White about the mechanism, as a share of it and at least, mm. */
const BESIDE_ROOM = 0.2;
const BESIDE_LEAST = 4;

/** Corners, the best first: right, low. @type {[number, number][]} */
const CORNERS = [[1, 0], [0, 0], [1, 1], [0, 1]];
/** So near to it nothing of the plan is to stand, px. */
const CLEAR = 16;

/** The mechanism beside the board, in its position: points and lines of it that a plan is laid to. */
export class Beside {
  /**
   * @param {string} name
   * @param {(slots: number[], at: [number, number]) => void} onMeant
   */
  constructor(name, onMeant) {
    this.svg = drawnElement("svg", { class: "beside", role: "img", "aria-label": name });
    /** @type {Shape[]} */
    this.shapes = [];
    /** @type {Frame} */
    this.frame = [0, 0, 1, 1];
    this.mm = 1;
    /** Its symbols, where the sheet has them. @type {import("./kinematic.js").Kinematic | null} */
    this.kinematic = null;
    /** @type {(slot: number) => boolean} */
    this.fits = () => false;
    /** @type {number[]} */
    this.picks = [];
    /** @type {(slot: number) => string} */
    this.letterOf = () => "";
    this.svg.addEventListener("click", (event) => {
      const to = /** @type {SVGSVGElement} */ (this.svg).getScreenCTM();
      const paper = this.svg.parentElement?.getBoundingClientRect();
      if (to === null || paper === undefined) return;
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(to.inverse());
      const open = (/** @type {number} */ slot) => this.fits(slot) || this.picks.includes(slot);
      onMeant(meantAt(this.shapes, [at.x, -at.y], NEAR * this.mm, open), [event.clientX - paper.left, event.clientY - paper.top]);
    });
    new ResizeObserver(() => this.draw()).observe(this.svg);
  }

  /**
   * Put the mechanism of a task there; none where the plan is that of the mechanism.
   * @param {Easel} easel
   * @param {View | undefined} lead the view of the mechanism
   */
  begin(easel, lead) {
    this.shapes = lead === undefined ? [] : shapesBeside(easel, lead);
    this.kinematic = lead === undefined ? null : kinematicOf(easel, lead);
    this.letterOf = (slot) => easel.letterOf(slot);
    const spots = this.shapes.flatMap((shape) => (shape.sort === "P" ? [shape.spot] : []));
    this.svg.toggleAttribute("hidden", spots.length === 0);
    if (spots.length > 0) this.frame = frameOf(spots, BESIDE_ROOM, BESIDE_LEAST);
    if (this.kinematic !== null) this.frame = this.withInk(this.kinematic.ink);
    const [left, low, right, high] = this.frame;
    this.svg.setAttribute("viewBox", [left, -high, right - left, high - low].map(mmText).join(" "));
    this.svg.style.setProperty("aspect-ratio", `${mmText(right - left)} / ${mmText(high - low)}`);
  }

  /**
   * Return the frame with all symbols in it.
   * @param {SVGGraphicsElement} ink
   * @returns {Frame}
   */
  withInk(ink) {
    this.svg.replaceChildren(ink);
    const [left, low, right, high] = this.frame;
    const { x, y, width, height } = ink.getBBox();
    const by = ink.transform.baseVal.consolidate()?.matrix;
    if (width === 0 || by === undefined) return this.frame;
    const [a, b] = [x + by.e - BESIDE_LEAST, -(y + by.f) + BESIDE_LEAST];
    return [Math.min(left, a), Math.min(low, b - height - 2 * BESIDE_LEAST), Math.max(right, a + width + 2 * BESIDE_LEAST), Math.max(high, b)];
  }

  /**
   * @param {(slot: number) => boolean} fits
   * @param {number[]} picks
   */
  show(fits, picks) {
    this.fits = fits;
    this.picks = picks;
    this.draw();
  }

  /**
   * Stand in the corner of the paper in which least of the plan will be; return which: [right, low], as 0 or 1.
   * @param {Spot[]} spots of the plan as it will be
   * @param {Frame} frame of the plan
   * @returns {[number, number]}
   */
  stand(spots, [left, low, right, high]) {
    const paper = this.svg.parentElement?.getBoundingClientRect();
    const own = this.svg.getBoundingClientRect();
    if (paper === undefined || own.width === 0) return [1, 0];
    const [x0, y0, x1, y1] = this.frame;
    const parent = /** @type {HTMLElement} */ (this.svg.parentElement);
    if (divided(parent, [x1 - x0, y1 - y0], [right - left, high - low])) return [0, 0];
    const mm = Math.max((right - left) / paper.width, (high - low) / paper.height);
    const [x, y] = [(left + right) / 2, (low + high) / 2];
    const hidden = CORNERS.map(([a, b]) =>
      spots.filter((spot) => {
        const [px, py] = [(spot[0] - x) / mm, (y - spot[1]) / mm];
        const [across, down] = [a === 1 ? paper.width / 2 - px : paper.width / 2 + px, b === 1 ? paper.height / 2 - py : paper.height / 2 + py];
        return across < own.width + CLEAR && down < own.height + CLEAR;
      }).length,
    );
    const corner = CORNERS[hidden.indexOf(Math.min(...hidden))] ?? [1, 0];
    this.svg.classList.toggle("left", corner[0] === 0);
    this.svg.classList.toggle("low", corner[1] === 1);
    return corner;
  }

  /**
   * Whether the symbols of the mechanism draw a shape already: it is seen only where it can be picked.
   * @param {Shape} shape
   */
  isInk({ sort, slot }) {
    return this.kinematic !== null && (sort === "V" || this.kinematic.drawn.has(slot));
  }

  draw() {
    const { width, height } = this.svg.getBoundingClientRect();
    if (width === 0 || height === 0) return;
    const [left, low, right, high] = this.frame;
    this.mm = Math.max((right - left) / width, (high - low) / height);
    this.svg.style.setProperty("--mm", `${this.mm}px`);
    const parts = this.shapes.flatMap((shape) =>
      markInk(shape, this.mm, false).map((part) => {
        part.classList.toggle("fits", this.fits(shape.slot));
        part.classList.toggle("picked", this.picks.includes(shape.slot));
        part.classList.toggle("bare", this.isInk(shape));
        return part;
      }),
    );
    const symbols = this.kinematic === null ? [] : [this.kinematic.ink];
    this.svg.replaceChildren(...symbols, drawnElement("g", { class: "pencil" }, ...parts), ...lettersOf(this.shapes, this.letterOf, this.mm));
  }
}

/**
 * Return the points and lines of a mechanism that are there.
 * @param {Easel} easel
 * @param {View} lead
 * @returns {Shape[]}
 */
function shapesBeside(easel, lead) {
  const known = Object.keys(easel.practice.marks).map(Number).filter((slot) => !easel.isHere(slot));
  const asked = new Set(easel.task.shown);
  const named = new Set((lead.joints ?? []).filter((one) => one[2] || asked.has(one[0])).map((one) => one[0]));
  const points = known.filter((slot) => named.has(slot) || asked.has(slot));
  const spots = new Map(points.map((slot) => [slot, easel.values.spot(slot)]));
  const there = [...spots.values()].filter((spot) => spot !== null);
  if (there.length === 0) return [];
  const frame = frameOf(there, 0, BESIDE_LEAST);
  const lines = known.flatMap((slot) => {
    const line = easel.values.line(slot);
    if (line === null) return [];
    const on = (lead.joined?.[slot] ?? []).map((one) => spots.get(one) ?? null).filter((spot) => spot !== null);
    const link = on.length > 1 && !isGround(easel, slot);
    const ends = on.length > 1 ? farthest(on) : asked.has(slot) ? pieceIn(line, frame) : null;
    if (ends === null || (!link && !asked.has(slot))) return [];
    return [/** @type {Shape} */ ({ slot, of: slot, sort: link ? "V" : "L", line, ends, main: true })];
  });
  const dots = points.flatMap((slot) => {
    const spot = spots.get(slot) ?? null;
    return spot === null ? [] : [/** @type {Shape} */ ({ slot, of: slot, sort: "P", spot })];
  });
  return [...lines, ...dots];
}

/**
 * Whether a line never turns: it is drawn at a given angle.
 * @param {Easel} easel
 * @param {number} slot
 */
function isGround(easel, slot) {
  const step = easel.steps.get(slot);
  return step?.op === "ray" && typeof easel.practice.given[step.uses[1] ?? -1] === "number";
}

/**
 * Return the two of several places that are farthest distance.
 * @param {Spot[]} spots
 * @returns {[Spot, Spot]}
 */
function farthest(spots) {
  const pairs = spots.flatMap((one) => spots.map((other) => /** @type {[Spot, Spot]} */ ([one, other])));
  return pairs.reduce((best, pair) => (distance(...pair) > distance(...best) ? pair : best));
}
