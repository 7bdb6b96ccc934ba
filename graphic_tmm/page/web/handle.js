import { turnWithin } from "./dense.js";
import { drawnElement } from "./dom.js";

/**
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./types.js").MovingFigure} MovingFigure
 */

/** The radius of the handle, mm of the figure's height of 100. */
const SIZE = 0.03;

/**
 * Put a handle on the crank of a figure; it is dragged round by pointer or touch, from wherever it is taken.
 * @param {Dense} dense
 * @param {MovingFigure} figure
 * @param {SVGElement} svg
 * @param {() => number} turn where the crank is now
 * @param {(turn: number) => void} go
 * @returns {(turn: number, pin?: import("./types.js").Complex | null) => void} lets the handle stand at a turn, where the
 *   pin is if it is not as given
 */
export function putHandle(dense, figure, svg, turn, go) {
  const per = dense.ends?.per ?? dense.sense;
  const [x = 0, y = 0, length = 0] = figure.crank ?? [];
  const size = SIZE * Math.max(figure.box[2] ?? 0, figure.box[3] ?? 0);
  const ring = drawnElement("circle", { class: "handle", r: size });
  svg.append(ring);
  let held = -1;
  let apart = 0;
  svg.style.touchAction = "none";
  svg.addEventListener("pointerdown", (event) => {
    const found = bearing(event);
    if (found === null || !event.isPrimary) return;
    held = event.pointerId;
    const near = event.target === ring;
    apart = near ? difference(turnOf(found), turn()) : 0;
    svg.setPointerCapture(held);
    svg.classList.add("held");
    event.preventDefault();
    follow(found);
  });
  svg.addEventListener("pointermove", (event) => {
    if (event.pointerId !== held) return;
    const found = bearing(event);
    if (found !== null) follow(found);
  });
  for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) {
    svg.addEventListener(name, () => {
      held = -1;
      svg.classList.remove("held");
    });
  }

  /** @param {number} found */
  function follow(found) {
    const now = turn();
    go(turnWithin(dense, now + difference(turnOf(found) - apart, now)));
  }

  /**
   * Return the direction from the pivot to the pointer, degrees, counter-clockwise from the x axis.
   * @param {PointerEvent} event
   */
  function bearing(event) {
    const matrix = /** @type {SVGSVGElement} */ (svg).getScreenCTM();
    if (matrix === null) return null;
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return (Math.atan2(-at.y - y, at.x - x) * 180) / Math.PI;
  }

  /** @param {number} angle */
  function turnOf(angle) {
    return (angle - dense.zero) / per;
  }

  /**
   * Return by how much to go on from one turn to another, the shorter way round.
   * @param {number} to
   * @param {number} from
   */
  function difference(to, from) {
    const round = 360 / Math.abs(per);
    return ((((to - from + round / 2) % round) + round) % round) - round / 2;
  }

  return (at, pin = null) => {
    const angle = ((dense.zero + per * at) * Math.PI) / 180;
    ring.setAttribute("cx", String(pin?.re ?? x + length * Math.cos(angle)));
    ring.setAttribute("cy", String(-(pin?.im ?? y + length * Math.sin(angle))));
  };
}
