import { bodiesAt, bodyOf, freeLetter } from "./sketch.js";

/**
 * How pins come to stand on pins and bars.
 *
 * @typedef {import("./sketch.js").Bar} Bar
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./sketch.js").Target} Target
 */

/**
 * Return the letter of what is meant, put there if it has none.
 * @param {Sketch} sketch that is changed
 * @param {Target} target
 */
export function letterAt(sketch, target) {
  if ("letter" in target) return target.letter;
  const letter = freeLetter(sketch);
  sketch.places[letter] = target.place;
  if ("bar" in target) insert(sketch, target.bar, letter);
  return letter;
}

/**
 * Put a letter on a bar, between its ends.
 * @param {Sketch} sketch that is changed
 * @param {Bar} bar
 * @param {string} letter
 */
function insert(sketch, { number, ends }, letter) {
  const body = bodyOf(sketch, number);
  if (body === undefined) return;
  const at = body.points.indexOf(ends[1]);
  const straight = body.points.length === 2;
  if (straight || at < 0) body.points.push(letter);
  else body.points.splice(at === 0 ? body.points.length : at, 0, letter);
}

/**
 * Join a pin that is there with another, or put it on a bar; null where one link would have both.
 * @param {Sketch} sketch
 * @param {string} letter
 * @param {Target} target
 * @returns {Sketch | null}
 */
export function joined(sketch, letter, target) {
  const made = structuredClone(sketch);
  if ("bar" in target) {
    made.places[letter] = target.place;
    insert(made, target.bar, letter);
    return made;
  }
  if (!("letter" in target)) return null;
  if (bodiesAt(sketch, letter).some((one) => one.points.includes(target.letter))) return null;
  for (const body of made.links) body.points = body.points.map((one) => (one === letter ? target.letter : one));
  delete made.places[letter];
  return made;
}
