import { drawnElement } from "../../../page/web/dom.js";
import { bodyOf, cornersOf, minus, movingOf, placeOf, unit } from "./sketch.js";

/**
 * The filled corner in which two links are one.
 *
 * @typedef {import("./sketch.js").Body} Body
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./view.js").Dots} Dots
 * @typedef {import("./view.js").View} View
 */

/** How far a corner reaches along its links, dots. */
const REACH = 24;

/**
 * @param {Sketch} sketch
 * @param {View} view
 */
export function weldSigns(sketch, view) {
  return movingOf(sketch).flatMap((arm) => {
    const whole = bodyOf(sketch, arm.weld ?? -1);
    const letter = arm.points.find((one) => whole?.points.includes(one));
    if (whole === undefined || letter === undefined) return [];
    const at = view.dots(placeOf(sketch, letter));
    const ends = [arm, whole].map((body) => along(sketch, body, letter, view, at));
    const d = `M${[at, ...ends].map((one) => one.map((dots) => dots.toFixed(1)).join(" ")).join("L")}Z`;
    return [drawnElement("path", { class: "weld", d })];
  });
}

/**
 * Return where the corner ends on a link: towards its farthest pin.
 * @param {Sketch} sketch
 * @param {Body} body
 * @param {string} letter
 * @param {View} view
 * @param {Dots} at
 * @returns {Dots}
 */
function along(sketch, body, letter, view, at) {
  const ways = cornersOf(sketch, body).filter((one) => one !== letter).map((one) => minus(view.dots(placeOf(sketch, one)), at));
  const far = ways.sort((a, b) => Math.hypot(...b) - Math.hypot(...a))[0];
  const [x, y] = far === undefined ? [0, 0] : unit(far);
  return [at[0] + REACH * x, at[1] + REACH * y];
}
