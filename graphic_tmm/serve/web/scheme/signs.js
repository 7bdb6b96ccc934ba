import { drawnElement } from "../../../page/web/dom.js";
import { numberAt } from "./numbers.js";
import { alongOf, apart, bodiesAt, bodyOf, cornersOf, cylinderOf, frameOf, lineOf, minus, movingOf, placeOf, stonesAt, unit } from "./sketch.js";
import { weldSigns } from "./weld-signs.js";

/**
 * A mechanism as it is drawn: pins, bars, plates, supports, stones and guides, in dots of the screen.
 *
 * @typedef {import("./sketch.js").Body} Body
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./view.js").Dots} Dots
 * @typedef {import("./view.js").View} View
 * @typedef {{letter?: string, number?: number, drawn?: boolean}} Chosen a pin, or a link; drawn: a pin that a link was just drawn to:
 *   the next link begins there
 */

const PIN = 6;
const SUPPORT = 20;
const STONE = [26, 16];
/** How far a guide of the frame is drawn to both sides of its stone, and how far apart its hatches stand. */
const REACH = 70;
const HATCH = 8;
/** How far a letter stands from its pin. */
const LETTER = 17;
const CENTRE = 8;
/** A letter beside a stone stands so much farther. */
const BESIDE_STONE = 8;
/** The circle on which the arrow of the driving link stands. */
const DRIVE = 30;

/**
 * @param {Sketch} sketch
 * @param {View} view
 * @param {Chosen} chosen
 * @returns {SVGElement[]}
 */
export function drawnSketch(sketch, view, chosen) {
  const lit = (/** @type {boolean} */ yes) => (yes ? " chosen" : "");
  const bodies = movingOf(sketch);
  const how = (/** @type {Body} */ body) => `${lit(chosen.number === body.number)}${body.passive === true ? " passive" : ""}`;
  const made = bodies.flatMap((body) => bar(sketch, body, view, how(body)));
  made.unshift(...bodies.flatMap((body) => body.slides.flatMap((slide) => rail(sketch, body, slide, view))));
  made.push(...bodies.flatMap((body) => block(sketch, body, view, how(body))));
  made.push(...weldSigns(sketch, view));
  for (const letter of frameOf(sketch).points) made.push(support(view.dots(placeOf(sketch, letter))));
  for (const letter of Object.keys(sketch.places)) made.push(...pin(sketch, letter, view, lit(chosen.letter === letter)));
  made.push(...sketch.drives.flatMap((one) => arrow(sketch, one, view)));
  return made;
}

/**
 * @param {Sketch} sketch
 * @param {Body} body
 * @param {View} view
 * @param {string} lit
 */
function bar(sketch, body, view, lit) {
  const dots = cornersOf(sketch, body).map((one) => view.dots(placeOf(sketch, one)));
  const made = [];
  if (dots.length > 1) {
    const d = `M${dots.map((one) => one.map(round).join(" ")).join("L")}${dots.length > 2 ? "Z" : ""}`;
    made.push(drawnElement("path", { class: `bar${lit}${body.slides.length > 0 ? " slides" : ""}`, d }));
  }
  made.push(...cylinder(sketch, body, view, lit));
  const at = numberAt(sketch, body, view);
  if (at !== null) made.push(drawnElement("text", { class: `number${lit}`, x: round(at[0]), y: round(at[1]) }, text(String(body.number))));
  return made;
}

/**
 * The cylinder of a rod: two lines along its guide, closed at its pivot.
 * @param {Sketch} sketch
 * @param {Body} rod
 * @param {View} view
 * @param {string} lit
 */
function cylinder(sketch, rod, view, lit) {
  const ends = cylinderOf(sketch, rod);
  if (ends === null) return [];
  const [a, b] = /** @type {[Dots, Dots]} */ (ends.map((one) => view.dots(placeOf(sketch, one))));
  const [x, y] = unit(minus(b, a));
  const long = apart(a, b);
  const spot = (/** @type {number} */ along, /** @type {number} */ up) => `${round(a[0] + along * x - up * y)} ${round(a[1] + along * y + up * x)}`;
  const open = 0.62 * long;
  const barrel = `M${spot(open, 9)}L${spot(10, 9)}L${spot(10, -9)}L${spot(open, -9)}M${spot(0, 0)}L${spot(10, 0)}`;
  const piston = `M${spot(0.5 * long, 9)}L${spot(0.5 * long, -9)}M${spot(0.5 * long, 0)}L${spot(long, 0)}`;
  return [drawnElement("path", { class: `bar${lit}`, d: barrel }), drawnElement("path", { class: `bar slides${lit}`, d: piston })];
}

/**
 * The guide of a stone: on the frame with hatches, on a link nothing but the bar that is there.
 * @param {Sketch} sketch
 * @param {Body} body
 * @param {Body["slides"][number]} slide
 * @param {View} view
 */
function rail(sketch, body, slide, view) {
  const line = lineOf(sketch, slide);
  const [letter] = body.points;
  if (line === null || letter === undefined || slide.on !== frameOf(sketch).number) return [];
  const foot = view.dots(placeOf(sketch, letter));
  const [x, y] = [line.way[0], -line.way[1]];
  const low = STONE[1] ?? 0;
  const spot = (/** @type {number} */ along, /** @type {number} */ up) => `${round(foot[0] + along * x - up * y)} ${round(foot[1] + along * y + up * x)}`;
  const side = y > 0.5 ? -1 : 1;
  const at = (side * low) / 2 + side;
  let d = `M${spot(-REACH, at)}L${spot(REACH, at)}`;
  for (let k = -REACH; k < REACH; k += HATCH) d += `M${spot(k + HATCH, at)}L${spot(k, at + side * HATCH)}`;
  return [drawnElement("path", { class: "rail", d })];
}

/**
 * The stone of a link that slides.
 * @param {Sketch} sketch
 * @param {Body} body
 * @param {View} view
 * @param {string} lit
 */
function block(sketch, body, view, lit) {
  const [letter] = body.points;
  return body.slides
    .filter((slide) => slide.on === frameOf(sketch).number || alongOf(bodyOf(sketch, slide.on) ?? body, slide.along) !== null)
    .flatMap((slide) => {
      const line = lineOf(sketch, slide);
      if (line === null || letter === undefined) return [];
      const [x, y] = view.dots(placeOf(sketch, letter));
      const angle = (-Math.atan2(line.way[1], line.way[0]) * 180) / Math.PI;
      const [width, height] = /** @type {[number, number]} */ (STONE);
      const transform = `translate(${round(x)} ${round(y)}) rotate(${round(angle)})`;
      return [drawnElement("rect", { class: `stone${lit}`, x: -width / 2, y: -height / 2, width, height, transform })];
    });
}

/** @param {Dots} at */
function support([x, y]) {
  const [low, half] = [y + SUPPORT, 0.7 * SUPPORT];
  let d = `M${round(x)} ${round(y)}L${round(x - half)} ${round(low)}H${round(x + half)}Z`;
  for (let k = -half; k <= half; k += HATCH) d += `M${round(x + k + HATCH / 2)} ${round(low)}l${-HATCH} ${HATCH}`;
  return drawnElement("path", { class: "support", d });
}

/**
 * @param {Sketch} sketch
 * @param {string} letter
 * @param {View} view
 * @param {string} lit
 */
function pin(sketch, letter, view, lit) {
  const [x, y] = view.dots(placeOf(sketch, letter));
  const bodies = bodiesAt(sketch, letter);
  const joins = bodies.length > 1;
  const centre = !joins && bodies.some((one) => one.centre === letter);
  const made = centre
    ? drawnElement("path", { class: `centre${lit}`, d: `M${round(x - CENTRE)} ${round(y)}a${CENTRE} ${CENTRE} 0 1 0 ${2 * CENTRE} 0a${CENTRE} ${CENTRE} 0 1 0 ${-2 * CENTRE} 0h${2 * CENTRE}M${round(x)} ${round(y - CENTRE)}v${2 * CENTRE}` })
    : drawnElement("circle", { class: `pin${lit}${joins ? " joined" : ""}`, cx: round(x), cy: round(y), r: joins ? PIN : PIN - 1.5 });
  const [u, v] = besideWay(sketch, letter, view);
  const far = stonesAt(sketch, letter).length > 0 ? LETTER + BESIDE_STONE : LETTER;
  const name = drawnElement("text", { class: `letter${lit}`, x: round(x + far * u), y: round(y + far * v) }, text(letter));
  return [made, name];
}

/**
 * Return the direction in which there is most room for a letter.
 * @param {Sketch} sketch
 * @param {string} letter
 * @param {View} view
 * @returns {Dots}
 */
function besideWay(sketch, letter, view) {
  const at = view.dots(placeOf(sketch, letter));
  const ways = bodiesAt(sketch, letter)
    .flatMap((body) => body.points)
    .filter((one) => one !== letter)
    .map((one) => unit(minus(view.dots(placeOf(sketch, one)), at)));
  for (const stone of stonesAt(sketch, letter)) {
    for (const slide of stone.slides) {
      const line = lineOf(sketch, slide);
      if (line !== null) ways.push([line.way[0], -line.way[1]], [-line.way[0], line.way[1]]);
    }
  }
  if (frameOf(sketch).points.includes(letter)) ways.push([0, 1]);
  let best = /** @type {Dots} */ ([0.7, -0.7]);
  let room = -Infinity;
  for (let k = 0; k < 8; k += 1) {
    const way = /** @type {Dots} */ ([Math.cos(((2 * k + 1) * Math.PI) / 8), -Math.sin(((2 * k + 1) * Math.PI) / 8)]);
    const free = -Math.max(-1, ...ways.map((one) => one[0] * way[0] + one[1] * way[1]));
    if (free > room + 1e-9) [best, room] = [way, free];
  }
  return best;
}

/**
 * The arrow of the driving link, about its pivot or along its guide.
 * @param {Sketch} sketch
 * @param {number} number
 * @param {View} view
 */
function arrow(sketch, number, view) {
  const body = bodyOf(sketch, number);
  const pivot = body?.points.find((one) => frameOf(sketch).points.includes(one));
  if (body === undefined) return [];
  if (pivot === undefined) {
    const slide = body.slides[0];
    const line = slide === undefined ? null : lineOf(sketch, slide);
    const [letter] = body.points;
    if (line === null || letter === undefined) return [];
    const [x, y] = view.dots(placeOf(sketch, letter));
    const transform = `translate(${round(x)} ${round(y)}) rotate(${round((-Math.atan2(line.way[1], line.way[0]) * 180) / Math.PI)})`;
    return [drawnElement("path", { class: "drive", transform, d: "M-22 -20H22M15 -25L23 -20L15 -15" })];
  }
  const [x, y] = view.dots(placeOf(sketch, pivot));
  const d = `M${DRIVE} 0A${DRIVE} ${DRIVE} 0 0 0 0 ${-DRIVE}M8 ${-DRIVE - 6}L-1 ${-DRIVE}L8 ${-DRIVE + 6}`;
  return [drawnElement("path", { class: "drive", transform: `translate(${round(x)} ${round(y)})`, d })];
}

/** @param {string} says */
function text(says) {
  return /** @type {any} */ (document.createTextNode(says));
}

/** @param {number} dots */
function round(dots) {
  return Math.round(dots * 10) / 10;
}
