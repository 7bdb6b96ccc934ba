import { looksTurned } from "./corners.js";

/**
 * @typedef {import("./laying.js").LaidFlat} LaidFlat
 * @typedef {import("./corners.js").OwnPack} OwnPack
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {(key: string, values?: Record<string, string | number>) => string} Say
 */

/** No bend is told finer, mm. */
const LEAST_TOLD = 0.1;

/**
 * Return what there is to be told of a photograph that lies flat.
 * @param {LaidFlat} found
 * @param {Spot[]} corners
 * @param {OwnPack} pack
 * @param {{say: Say, number: (x: number, places: number) => string}} speech
 */
export function findingsOf({ of, residual, bowed, missing }, corners, pack, speech) {
  const bend = (/** @type {number} */ mm) => ({ bend: speech.number(Math.max(mm, LEAST_TOLD), 1) });
  const edges = missing.map((k) => speech.say(`own edge ${k}`)).join(", ");
  const found = [
    looksTurned(corners, of) ? speech.say("own turned") : "",
    edges !== "" ? speech.say("own missing", { edges }) : "",
    bowed > pack.bowed ? speech.say("own bowed", bend(bowed)) : "",
    residual > pack.bent ? speech.say("own bent", bend(residual)) : "",
  ].filter((one) => one !== "");
  if (found.length > 0) return found;
  return [Number.isNaN(residual) ? speech.say("own lies") : speech.say("own flat", bend(residual))];
}
