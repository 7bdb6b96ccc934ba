import { relettered, withoutPin } from "./changes.js";
import { letterAt } from "./joining.js";
import {
  bodiesAt,
  bodyOf,
  frameOf,
  freeGuide,
  freeNumber,
  isFree,
  isOnlyCentre,
  minus,
  placeOf,
  stonesAt,
  unit,
} from "./sketch.js";

/**
 * What a hand does to a mechanism: each returns another one, or null where that would be none.
 *
 * @typedef {import("./sketch.js").Body} Body
 * @typedef {import("./sketch.js").Bar} Bar
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./sketch.js").Target} Target
 */

const HALF_TURN = 180;
/** The first support, and the letters that the pins of a first link have until there is one. */
const ORIGIN = "O";
const FIRST = ["A", "B"];

/**
 * Return a copy that may be changed.
 * @param {Sketch} sketch
 * @returns {Sketch}
 */
function copyOf(sketch) {
  return structuredClone(sketch);
}

/**
 * Return a number for a link that is put in.
 * @param {Sketch} sketch that is changed
 * @param {string[]} points
 * @returns {Body}
 */
function newBody(sketch, points) {
  const body = { number: freeNumber(sketch), points, guides: {}, slides: [] };
  sketch.links.push(body);
  return body;
}

/**
 * Draw a link from one pin to another.
 * @param {Sketch} sketch
 * @param {Target} start
 * @param {Target} end
 * @returns {{sketch: Sketch, letter: string} | null}
 */
export function linked(sketch, start, end) {
  const made = copyOf(sketch);
  const a = letterAt(made, start);
  const b = letterAt(made, end);
  if (a === b || bodiesAt(made, a).some((one) => one.points.includes(b))) return null;
  newBody(made, [a, b]);
  return { sketch: made, letter: b };
}

/**
 * Add what is meant as a further pin of a link.
 * @param {Sketch} sketch
 * @param {number} number
 * @param {Target} target
 * @returns {{sketch: Sketch, letter: string} | null}
 */
export function pinned(sketch, number, target) {
  const made = copyOf(sketch);
  const letter = letterAt(made, target);
  const body = bodyOf(made, number);
  if (body === undefined || body.points.includes(letter)) return null;
  body.points.push(letter);
  return { sketch: made, letter };
}

/**
 * Make a pin a pivot of the frame, or a loose one again.
 * @param {Sketch} sketch
 * @param {string} letter
 * @returns {Sketch}
 */
export function supported(sketch, letter) {
  const first = frameOf(sketch).points.length === 0 && FIRST.includes(letter) && isFree(sketch, ORIGIN);
  if (first) return supported(withOrigin(sketch, letter), ORIGIN);
  const made = copyOf(sketch);
  const frame = frameOf(made);
  const there = frame.points.includes(letter);
  frame.points = there ? frame.points.filter((one) => one !== letter) : [...frame.points, letter];
  return made;
}

/**
 * Call the first support O, and the other pin of a first link A, where nobody has called them otherwise.
 * @param {Sketch} sketch
 * @param {string} letter
 * @returns {Sketch}
 */
function withOrigin(sketch, letter) {
  const made = relettered(sketch, letter, ORIGIN) ?? sketch;
  const [first = "", second = ""] = FIRST;
  return letter === first && Object.keys(made.places).length === 2 ? (relettered(made, second, first) ?? made) : made;
}

/**
 * Let a pin slide along a guide of the frame in a direction (degrees); a slider that is there is turned.
 * @param {Sketch} sketch
 * @param {string} letter
 * @param {number} angle
 * @returns {Sketch}
 */
export function guided(sketch, letter, angle) {
  const made = copyOf(sketch);
  const frame = frameOf(made);
  const turned = ((Math.round(angle * 1e6) / 1e6) % HALF_TURN + HALF_TURN) % HALF_TURN;
  const there = stonesAt(made, letter)
    .flatMap((one) => one.slides)
    .find((one) => one.on === frame.number && one.along in frame.guides);
  const name = there?.along ?? freeGuide(made);
  frame.guides[name] = { through: placeOf(made, letter), angle: turned };
  if (there === undefined) newBody(made, [letter]).slides.push({ on: frame.number, along: name });
  return made;
}

/**
 * Put a stone at a pin that slides along a bar; a bar that has one pivot is turned so that it passes there.
 * @param {Sketch} sketch
 * @param {string} letter
 * @param {Bar} bar
 * @returns {Sketch | null}
 */
export function stoned(sketch, letter, { number, ends }) {
  const made = copyOf(sketch);
  const body = bodyOf(made, number);
  if (body === undefined || body.points.includes(letter) || !ends.every((one) => body.points.includes(one))) return null;
  const [first, second] = body.points.indexOf(ends[0]) <= body.points.indexOf(ends[1]) ? ends : [ends[1], ends[0]];
  turnAbout(made, body, letter, [first, second]);
  newBody(made, [letter]).slides.push({ on: number, along: `${first}${second}` });
  return made;
}

/**
 * Turn a link about the end of a bar that the frame holds, until the bar passes through a pin.
 * @param {Sketch} sketch that is changed
 * @param {Body} body
 * @param {string} letter
 * @param {[string, string]} ends
 */
function turnAbout(sketch, body, letter, ends) {
  const fixed = frameOf(sketch).points;
  const pivot = ends.find((one) => fixed.includes(one));
  const other = ends.find((one) => one !== pivot);
  if (pivot === undefined || other === undefined || fixed.includes(other)) return;
  const about = placeOf(sketch, pivot);
  const [cx, cy] = unit(minus(placeOf(sketch, other), about));
  const [sx, sy] = unit(minus(placeOf(sketch, letter), about));
  const cos = cx * sx + cy * sy;
  const sin = cx * sy - cy * sx;
  const [c, s] = cos < 0 ? [-cos, -sin] : [cos, sin];
  for (const one of body.points) {
    if (fixed.includes(one)) continue;
    const [x, y] = minus(placeOf(sketch, one), about);
    sketch.places[one] = [about[0] + c * x - s * y, about[1] + s * x + c * y];
  }
}

/**
 * Draw a cylinder from its pivot to the pin of its rod.
 * @param {Sketch} sketch
 * @param {Target} start
 * @param {Target} end
 * @returns {{sketch: Sketch, letter: string} | null}
 */
export function cylinder(sketch, start, end) {
  const made = copyOf(sketch);
  const a = letterAt(made, start);
  const b = letterAt(made, end);
  if (a === b) return null;
  const [x, y] = minus(placeOf(made, b), placeOf(made, a));
  const name = freeGuide(made);
  const barrel = newBody(made, [a]);
  barrel.guides[name] = { through: placeOf(made, a), angle: (Math.atan2(y, x) * HALF_TURN) / Math.PI };
  newBody(made, [b]).slides.push({ on: barrel.number, along: name, cylinder: "oil" });
  return { sketch: made, letter: b };
}

/**
 * Put the mass centre of a link at one of its pins, or at a place; the one that it has is moved there. A slider has it
 * at its pin.
 * @param {Sketch} sketch
 * @param {number} number
 * @param {Target} target
 * @returns {Sketch | null}
 */
export function centred(sketch, number, target) {
  const body = bodyOf(sketch, number);
  if (body === undefined || body === frameOf(sketch)) return null;
  if (body.slides.length > 0 && body.points.length === 1) return withCentre(sketch, number, body.points[0] ?? "");
  const own = body.points.find((one) => isOnlyCentre(sketch, body, one));
  if ("letter" in target && target.letter !== own) return centredOn(sketch, body, target.letter, own);
  const letter = own ?? `S${number}`;
  if (!body.points.includes(letter) && !isFree(sketch, letter)) return null;
  const made = withCentre(sketch, number, letter);
  if ("place" in target) made.places[letter] = target.place;
  return made;
}

/**
 * Put the mass centre of a link on its pin; none on an end that nothing is joined to: no bar would be drawn to it.
 * @param {Sketch} sketch
 * @param {Body} body
 * @param {string} pin
 * @param {string | undefined} own the mass centre that it has, if that is no pin
 */
function centredOn(sketch, body, pin, own) {
  if (!body.points.includes(pin) || bodiesAt(sketch, pin).length === 1) return null;
  return withCentre(own === undefined ? sketch : withoutPin(sketch, own), body.number, pin);
}

/**
 * @param {Sketch} sketch
 * @param {number} number
 * @param {string} letter
 */
function withCentre(sketch, number, letter) {
  const made = copyOf(sketch);
  const body = /** @type {Body} */ (bodyOf(made, number));
  if (!body.points.includes(letter)) body.points.push(letter);
  body.centre = letter;
  return made;
}
