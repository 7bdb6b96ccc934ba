import {
  alongOf,
  bodyOf,
  footOf,
  frameOf,
  isOnlyCentre,
  lineOf,
  minus,
  movingOf,
  placeOf,
  stonesAt,
  unit,
} from "./sketch.js";

/**
 * What a hand changes in a mechanism that is there: numbers, letters, places, what is taken away; each returns another
 * one, or null where that would be none.
 *
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./sketch.js").Sketch} Sketch
 */

const HALF_TURN = 180;

/**
 * Give a link another number; one that has it gets the number of this one.
 * @param {Sketch} sketch
 * @param {number} from
 * @param {number} to
 * @returns {Sketch | null}
 */
export function renumbered(sketch, from, to) {
  if (from === to) return null;
  const made = structuredClone(sketch);
  const other = (/** @type {number} */ one) => (one === from ? to : one === to ? from : one);
  for (const body of made.links) {
    body.number = other(body.number);
    if (body.weld !== undefined) body.weld = other(body.weld);
    for (const slide of body.slides) slide.on = other(slide.on);
  }
  made.drives = made.drives.map(other);
  return made;
}

/**
 * Call a pin by another letter; the pin that has it gets this one's.
 * @param {Sketch} sketch
 * @param {string} from
 * @param {string} to
 * @returns {Sketch | null}
 */
export function relettered(sketch, from, to) {
  if (from === to || !(from in sketch.places)) return null;
  const made = structuredClone(sketch);
  const known = (/** @type {string} */ one) => (one === from ? to : one === to ? from : one);
  const renamed = new Map();
  for (const body of made.links) {
    for (const slide of body.slides) {
      const ends = alongOf(bodyOf(sketch, slide.on) ?? body, slide.along);
      if (ends !== null) renamed.set(slide, ends.map(known).join(""));
    }
  }
  for (const body of made.links) {
    body.points = body.points.map(known);
    if (body.centre !== undefined) body.centre = known(body.centre);
    for (const slide of body.slides) slide.along = renamed.get(slide) ?? slide.along;
  }
  made.places = Object.fromEntries(Object.entries(made.places).map(([letter, place]) => [known(letter), place]));
  return made;
}

/**
 * Move a pin, along what holds it if something does.
 * @param {Sketch} sketch
 * @param {string} letter
 * @param {Place} place
 * @returns {Sketch}
 */
export function moved(sketch, letter, place) {
  const made = structuredClone(sketch);
  const line = heldTo(sketch, letter);
  const to = line === null ? place : footOf(line, place);
  made.places[letter] = to;
  for (const body of made.links) for (const slide of body.slides) follow(sketch, made, body, slide, letter);
  return made;
}

/**
 * Let what an act has not moved stand where it stands by now.
 * @param {Sketch} sketch
 * @param {Sketch} was on which it was drawn
 * @param {Sketch} now
 * @returns {Sketch}
 */
export function rebased(sketch, was, now) {
  const places = Object.entries(sketch.places).map(([letter, place]) => [letter, String(place) === String(was.places[letter]) ? (now.places[letter] ?? place) : place]);
  return { ...sketch, places: Object.fromEntries(places) };
}

/**
 * Let the guide of a cylinder go with its pivot, and towards the pin of its rod.
 * @param {Sketch} before
 * @param {Sketch} sketch that is changed
 * @param {import("./sketch.js").Body} rod
 * @param {import("./sketch.js").Slide} slide
 * @param {string} letter that has moved
 */
function follow(before, sketch, rod, slide, letter) {
  const barrel = bodyOf(sketch, slide.on);
  const guide = barrel?.guides[slide.along];
  const pin = rod.points[0] ?? "";
  const pivot = barrel?.points[0] ?? "";
  if (guide === undefined || barrel === frameOf(sketch) || (letter !== pin && letter !== pivot)) return;
  const way = (/** @type {Sketch} */ one) => minus(placeOf(one, pin), placeOf(one, pivot));
  const [old, now] = [way(before), way(sketch)];
  guide.angle += ((Math.atan2(now[1], now[0]) - Math.atan2(old[1], old[0])) * HALF_TURN) / Math.PI;
  const [x, y] = minus(placeOf(sketch, pivot), placeOf(before, pivot));
  guide.through = [guide.through[0] + x, guide.through[1] + y];
}

/**
 * Return the line that a pin is held to: the guide of its slider, or the bar of a stone that passes another pin.
 * @param {Sketch} sketch
 * @param {string} letter
 */
function heldTo(sketch, letter) {
  const frame = frameOf(sketch);
  const fixed = stonesAt(sketch, letter).flatMap((stone) => stone.slides.filter((slide) => slide.on === frame.number));
  const guide = fixed.map((slide) => lineOf(sketch, slide)).find((one) => one !== null);
  if (guide) return guide;
  for (const stone of movingOf(sketch)) {
    for (const slide of stone.slides) {
      const body = bodyOf(sketch, slide.on);
      const ends = body === undefined ? null : alongOf(body, slide.along);
      const other = ends?.includes(letter) === true ? ends.find((one) => one !== letter) : undefined;
      if (other === undefined || stone.points[0] === undefined) continue;
      const about = placeOf(sketch, other);
      return { through: about, way: unit(minus(placeOf(sketch, stone.points[0]), about)) };
    }
  }
  return null;
}

/**
 * Take a link away, with what slides on it and the pins that nothing has then.
 * @param {Sketch} sketch
 * @param {number} number
 * @returns {Sketch | null}
 */
export function withoutLink(sketch, number) {
  if (number === frameOf(sketch).number) return null;
  const made = structuredClone(sketch);
  made.links = made.links.filter((one) => one.number !== number);
  for (const body of made.links) body.slides = body.slides.filter((one) => one.on !== number);
  return tidied(made);
}

/**
 * Take a pin away: links that had two lose their bar; stones at it go.
 * @param {Sketch} sketch
 * @param {string} letter
 * @returns {Sketch}
 */
export function withoutPin(sketch, letter) {
  const made = structuredClone(sketch);
  const gone = new Set();
  for (const body of made.links) {
    const had = body.points.length;
    if (!body.points.includes(letter)) continue;
    body.points = body.points.filter((one) => one !== letter);
    const only = isOnlyCentre(sketch, bodyOf(sketch, body.number) ?? body, letter);
    if (body.centre === letter) delete body.centre;
    if (!only && body !== frameOf(made) && (had <= 2 || body.slides.length > 0)) gone.add(body.number);
  }
  delete made.places[letter];
  made.links = made.links.filter((one) => !gone.has(one.number));
  return tidied(made);
}

/**
 * Take away pins that stand on nothing, guides on which nothing slides, and slides on what is not there.
 * @param {Sketch} sketch that is changed
 * @returns {Sketch}
 */
function tidied(sketch) {
  for (const body of sketch.links) {
    body.slides = body.slides.filter((one) => {
      const on = bodyOf(sketch, one.on);
      return on !== undefined && (one.along in on.guides || alongOf(on, one.along) !== null);
    });
  }
  const stones = movingOf(sketch).filter((one) => one.points.length === 1);
  const loose = stones.filter((one) => one.slides.length === 0 && Object.keys(one.guides).length === 0);
  sketch.links = sketch.links.filter((one) => !loose.includes(one));
  const slid = new Set(sketch.links.flatMap((one) => one.slides.map((slide) => slide.along)));
  const frame = frameOf(sketch);
  frame.guides = Object.fromEntries(Object.entries(frame.guides).filter(([name]) => slid.has(name)));
  const there = new Set(movingOf(sketch).flatMap((one) => one.points));
  frame.points = frame.points.filter((one) => there.has(one));
  sketch.places = Object.fromEntries(Object.entries(sketch.places).filter(([letter]) => there.has(letter)));
  for (const body of sketch.links) {
    const points = bodyOf(sketch, body.weld ?? -1)?.points ?? [];
    if (!body.points.some((one) => points.includes(one))) delete body.weld;
  }
  sketch.drives = sketch.drives.filter((one) => bodyOf(sketch, one) !== undefined);
  return sketch;
}
