import { drawnElement } from "../dom.js";

/**
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").JointLimbs} JointLimbs
 */

/** The radius of a joint's ring, a share of the figure's larger side; so far off the crank's pin its own stands. */
const [RING, OFF_PIN] = [0.02, 0.07];

/** A joint is taken hold of from so far, dots of the screen. */
const GRASP = 22;

/**
 * Put rings on the joints of a mechanism that can be dragged: where one is let go tells its lengths.
 * @param {SVGElement} svg
 * @param {JointLimbs[]} joints
 * @param {(k: number) => (Drawn | undefined)[]} marks
 * @param {(lengths: Map<number, number>) => void} change takes lengths, in SI, by the slots of what is given
 * @param {() => void} drop
 * @returns {(k: number) => void} lets the rings stand at an angle
 */
export function jointRings(svg, joints, marks, change, drop) {
  const [, , width = 0, height = 0] = (svg.getAttribute("viewBox") ?? "").split(" ").map(Number);
  const size = Math.max(width, height);
  let at = 0;
  const rings = joints.map(([slot, limbs, pivot = -1]) => {
    const ring = drawnElement("circle", { class: "joint", r: RING * size });
    const grip = drawnElement("circle", { class: "grip" });
    /** @type {{slot: number, pivot: number, limbs: JointLimbs[1], grip: SVGElement, both: SVGElement, stands: Complex | null}} */
    const one = { slot, pivot, limbs, grip, both: drawnElement("g", {}, ring, grip), stands: null };
    return one;
  });
  /** What is dragged, by which pointer, and how far off. */
  let [held, by, apart] = [rings[0], -1, { re: 0, im: 0 }];
  for (const { grip } of rings) {
    grip.addEventListener("pointerdown", (event) => {
      const place = event.isPrimary ? placeOn(svg, event) : null;
      if (place === null) return;
      [held, by] = [nearest(place), event.pointerId];
      apart = { re: (held?.stands?.re ?? place.re) - place.re, im: (held?.stands?.im ?? place.im) - place.im };
      grip.setPointerCapture(by);
      event.stopPropagation();
      event.preventDefault();
    });
    grip.addEventListener("pointermove", (event) => {
      const place = event.pointerId === by ? placeOn(svg, event) : null;
      if (place === null || held === undefined) return;
      event.stopPropagation();
      const now = marks(at);
      const to = { re: place.re + apart.re, im: place.im + apart.im };
      change(lengthsTo(farther(to, now[held.pivot], -OFF_PIN * size), held.limbs, now));
    });
    for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) {
      grip.addEventListener(name, () => {
        if (by >= 0) drop();
        by = -1;
      });
    }
  }
  // the joint that is found first lies on top of what hangs on it
  svg.append(...rings.map(({ both }) => both).reverse());
  // asked for in each frame this would let the browser lay out the figure there and then
  svg.addEventListener("weighed", () => {
    const dot = /** @type {SVGSVGElement} */ (svg).getScreenCTM()?.a || 1;
    for (const { grip } of rings) grip.setAttribute("r", String(GRASP / dot));
  });

  /** @param {Complex} place */
  function nearest(place) {
    const off = (/** @type {(typeof rings)[0]} */ { stands }) => (stands === null ? Infinity : Math.hypot(stands.re - place.re, stands.im - place.im));
    return rings.reduce((best, one) => (off(one) < off(best) ? one : best));
  }

  return (k) => {
    at = k;
    for (const one of rings) {
      const mark = marks(k)[one.slot];
      const there = mark !== undefined && typeof mark === "object" && "re" in mark && Number.isFinite(mark.re + mark.im);
      one.stands = there ? farther(mark, marks(k)[one.pivot], OFF_PIN * size) : null;
      one.both.setAttribute("visibility", there ? "inherit" : "hidden");
      if (one.stands === null) continue;
      one.both.setAttribute("transform", `translate(${one.stands.re} ${-one.stands.im})`);
    }
  };
}

/**
 * Return a place so much farther from a pivot; without one the place itself. The pin turns the crank, so what makes it
 * longer is taken beyond it.
 * @param {Complex} place
 * @param {Drawn | undefined} pivot
 * @param {number} by mm
 * @returns {Complex}
 */
function farther(place, pivot, by) {
  if (pivot === undefined || typeof pivot === "number" || !("re" in pivot)) return place;
  const [x, y] = [place.re - pivot.re, place.im - pivot.im];
  const times = by / (Math.hypot(x, y) || 1);
  return { re: place.re + times * x, im: place.im + times * y };
}

/**
 * Return where a pointer is, mm of the board.
 * @param {SVGElement} svg
 * @param {PointerEvent} event
 * @returns {Complex | null}
 */
function placeOn(svg, event) {
  const matrix = /** @type {SVGSVGElement} */ (svg).getScreenCTM();
  if (matrix === null) return null;
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  return { re: at.x, im: -at.y };
}

/**
 * Return the lengths that bring a joint to a place, by the slots of what is given.
 * @param {Complex} place
 * @param {JointLimbs[1]} limbs
 * @param {(Drawn | undefined)[]} marks
 */
function lengthsTo(place, limbs, marks) {
  /** @type {Map<number, number>} */
  const found = new Map();
  for (const [how, start, given, scale] of limbs) {
    const from = marks[start];
    if (from === undefined || typeof from === "number") continue;
    const origin = "at" in from ? from.at : "centre" in from ? from.centre : from;
    const along = "along" in from ? from.along : { re: 1, im: 0 };
    const [x, y] = [place.re - origin.re, place.im - origin.im];
    const mm = how === "from" ? Math.hypot(x, y) : how === "on" ? x * along.re + y * along.im : y * along.re - x * along.im;
    found.set(given, mm * Number(marks[scale]));
  }
  return found;
}
