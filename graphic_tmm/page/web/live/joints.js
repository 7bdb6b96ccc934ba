import { drawnElement } from "../dom.js";

/**
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").JointLimbs} JointLimbs
 */

/** The radius of a joint's ring, a share of the figure's larger side; so far off the crank's pin its own stands. */
const [RING, OFF_PIN] = [0.02, 0.07];

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
    const grip = drawnElement("circle", { class: "grip", r: 0.1 });
    const both = drawnElement("g", {}, ring, grip);
    let held = -1;
    grip.addEventListener("pointerdown", (event) => {
      if (!event.isPrimary) return;
      held = event.pointerId;
      grip.setPointerCapture(held);
      event.stopPropagation();
      event.preventDefault();
    });
    grip.addEventListener("pointermove", (event) => {
      const place = event.pointerId === held ? placeOn(svg, event) : null;
      if (place === null) return;
      event.stopPropagation();
      const now = marks(at);
      change(lengthsTo(farther(place, now[pivot], -OFF_PIN * size), limbs, now));
    });
    for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) {
      grip.addEventListener(name, () => {
        if (held >= 0) drop();
        held = -1;
      });
    }
    return { slot, pivot, both };
  });
  // the joint that is found first lies on top of what hangs on it
  svg.append(...rings.map(({ both }) => both).reverse());
  return (k) => {
    at = k;
    for (const { slot, pivot, both } of rings) {
      const mark = marks(k)[slot];
      const there = mark !== undefined && typeof mark === "object" && "re" in mark && Number.isFinite(mark.re + mark.im);
      both.setAttribute("visibility", there ? "inherit" : "hidden");
      if (!there) continue;
      const { re, im } = farther(mark, marks(k)[pivot], OFF_PIN * size);
      both.setAttribute("transform", `translate(${re} ${-im})`);
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
