import { renumbered } from "./changes.js";
import { bodyOf, frameOf } from "./sketch.js";

/**
 * What a link is for: it drives, or it repeats what others hold. Each act returns another mechanism, null where that
 * would be none.
 *
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
  const made = (first ? renumbered(sketch, number, 1) : null) ?? structuredClone(sketch);
  const link = first ? 1 : number;
  made.drives = made.drives.includes(link) ? made.drives.filter((one) => one !== link) : [...made.drives, link];
  return { sketch: made, numbers: first && number !== 1 ? { [number]: 1 } : {} };
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
 * @param {Sketch} sketch
 * @param {number} number
 */
function isMoving(sketch, number) {
  return number !== frameOf(sketch).number && bodyOf(sketch, number) !== undefined;
}
