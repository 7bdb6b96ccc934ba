import { renumbered } from "./changes.js";
import { bodiesAt, bodyOf, frameOf } from "./sketch.js";

/**
 * What a link is for: it drives, it repeats what others hold, it is an arm of another. Each act returns another mechanism, null where that
 * would be none.
 *
 * @typedef {import("./sketch.js").Body} Body
 * @typedef {import("./sketch.js").Sketch} Sketch
 */

/**
 * Let a link drive, or drive no more. The first that drives is number 1, and the one that was has its number.
 * @param {Sketch} sketch
 * @param {number} number
 * @returns {{sketch: Sketch | null, numbers: Record<string, number>}} numbers: links that are called otherwise now
 */
export function drivenBy(sketch, number) {
  if (!isMoving(sketch, number)) return { sketch: null, numbers: {} };
  const first = sketch.drives.length === 0;
  const whole = bodyOf(sketch, number)?.weld ?? number;
  const made = (first ? renumbered(sketch, whole, 1) : null) ?? structuredClone(sketch);
  const link = first ? 1 : whole;
  made.drives = made.drives.includes(link) ? made.drives.filter((one) => one !== link) : [...made.drives, link];
  return { sketch: made, numbers: first && whole !== 1 ? { [whole]: 1 } : {} };
}

/**
 * Let a link be passive, or count again. One that drives does so no more.
 * @param {Sketch} sketch
 * @param {number} number
 * @returns {Sketch | null}
 */
export function repeating(sketch, number) {
  const made = structuredClone(sketch);
  const body = bodyOf(made, number);
  if (body === undefined || !isMoving(sketch, number)) return null;
  if (body.passive === true) delete body.passive;
  else body.passive = true;
  made.drives = made.drives.filter((one) => one !== number);
  return made;
}

/**
 * Weld two links to each other at the pin that both have, or part them again: the one that drives, or has arms, has
 * the other as an arm.
 * @param {Sketch} sketch
 * @param {number} one
 * @param {number} other
 * @returns {Sketch | null}
 */
export function welded(sketch, one, other) {
  const made = structuredClone(sketch);
  const [a, b] = [bodyOf(made, one), bodyOf(made, other)];
  if (a === undefined || b === undefined || !isMoving(sketch, one) || !isMoving(sketch, other)) return null;
  const there = [a, b].find((body) => body.weld === one || body.weld === other);
  if (there !== undefined) {
    delete there.weld;
    return made;
  }
  const [whole, arm] = isWhole(sketch, b) && !isWhole(sketch, a) ? [b, a] : [a, b];
  if (whole.weld !== undefined || !mayBeArm(sketch, arm, whole)) return null;
  arm.weld = whole.number;
  return made;
}

/**
 * Tell whether a link drives, or has arms: it cannot be an arm itself.
 * @param {Sketch} sketch
 * @param {Body} body
 */
function isWhole(sketch, { number }) {
  return sketch.drives.includes(number) || sketch.links.some((arm) => arm.weld === number);
}

/**
 * @param {Sketch} sketch
 * @param {Body} arm
 * @param {Body} whole
 */
function mayBeArm(sketch, arm, whole) {
  const shared = arm.points.filter((letter) => whole.points.includes(letter));
  return shared.length === 1 && !isWhole(sketch, arm) && arm.weld === undefined && arm.slides.length === 0;
}

/**
 * Return the two links that alone meet at a pin, besides the frame and sliders.
 * @param {Sketch} sketch
 * @param {string} letter
 * @returns {[number, number] | null}
 */
export function meeting(sketch, letter) {
  const bars = bodiesAt(sketch, letter).filter((one) => one !== frameOf(sketch) && one.points.length > 1);
  const [first, second] = bars.map((one) => one.number);
  return first === undefined || second === undefined || bars.length > 2 ? null : [first, second];
}

/**
 * @param {Sketch} sketch
 * @param {number} number
 */
function isMoving(sketch, number) {
  return number !== frameOf(sketch).number && bodyOf(sketch, number) !== undefined;
}
