import { besideOf } from "./beside-point.js";
import { drawnElement } from "../dom.js";
import { headOfArrow, mmText, pathThrough } from "./figures.js";
import { letterText } from "./lettering.js";

/**
 * @typedef {import("./figures.js").Spot} Spot
 * @typedef {import("./shapes.js").Shape} Shape
 */

/** Sizes on the screen, px: the head of an arrow, a letter, how far it stands from its point. */
const HEAD = 12;
const LETTER = 17;
const AWAY = 13;
/** Between places of ink that letters keep from, px. */
const PACE = 9;

/**
 * Return the ink of a shape.
 * @param {Shape} shape
 * @param {number} mm of the board, a pixel of the screen
 * @param {boolean} arrows
 * @returns {SVGElement[]}
 */
export function markInk(shape, mm, arrows) {
  const of = { "data-of": shape.of };
  if (shape.sort === "P") {
    return [drawnElement("circle", { ...of, class: "dot", cx: mmText(shape.spot[0]), cy: mmText(-shape.spot[1]) })];
  }
  if (shape.sort === "A") {
    const { centre, radius } = shape.arc;
    return [drawnElement("circle", { ...of, class: "bow", cx: mmText(centre[0]), cy: mmText(-centre[1]), r: mmText(radius) })];
  }
  const path = drawnElement("path", { ...of, d: pathThrough(shape.ends), class: shape.sort === "L" ? "line" : "segment" });
  if (shape.sort === "L") return [path];
  if (!shape.main) path.classList.add("between");
  const head = arrows ? headOfArrow(...shape.ends, HEAD * mm) : "";
  return head === "" ? [path] : [path, drawnElement("path", { ...of, d: head, class: "head" })];
}

/**
 * Return the letters of points, each where there is room; of points in one place they stand beside each other.
 * @param {Shape[]} shapes
 * @param {(slot: number) => string} letterOf
 * @param {number} mm of the board, a pixel of the screen
 */
export function lettersOf(shapes, letterOf, mm) {
  const black = shapes.flatMap((shape) => placesOf(shape, PACE * mm));
  /** @type {Map<string, {spot: Spot, slots: number[]}>} */
  const places = new Map();
  for (const shape of shapes) {
    if (shape.sort !== "P") continue;
    const key = shape.spot.map((x) => Math.round(x / (3 * mm))).join(" ");
    const there = places.get(key);
    if (there === undefined) places.set(key, { spot: shape.spot, slots: [shape.slot] });
    else there.slots.push(shape.slot);
  }
  return [...places.values()].map(({ spot, slots }) => {
    const down = /** @type {Spot} */ ([spot[0], spot[1]]);
    const at = besideOf(down, AWAY * mm, black);
    for (let k = -1; k <= 1; k += 1) black.push([at[0] + 0.4 * k * LETTER * mm, at[1]]);
    const told = slots.map(letterOf).join(", ");
    const side = slots.length < 2 ? "" : at[0] > down[0] ? " onward" : " back";
    return letterText(told, { x: mmText(at[0]), y: mmText(-at[1]), "data-of": slots.join(" "), class: `letter${side}` });
  });
}

/**
 * Return places on the ink of a shape.
 * @param {Shape} shape
 * @param {number} pace
 * @returns {Spot[]}
 */
function placesOf(shape, pace) {
  if (shape.sort === "P") return [shape.spot];
  if (shape.sort === "A") return [];
  const [from, to] = shape.ends;
  const count = Math.max(1, Math.round(Math.hypot(to[0] - from[0], to[1] - from[1]) / pace));
  return Array.from({ length: count + 1 }, (_, k) => [
    from[0] + ((to[0] - from[0]) * k) / count,
    from[1] + ((to[1] - from[1]) * k) / count,
  ]);
}

/**
 * Return a ruler along a line both ways from its zero: a stroke a millimetre, a number each ten.
 * @param {Spot} zero
 * @param {Spot} along
 * @param {number} from mm
 * @param {number} to
 * @param {number} mm of the board, a pixel of the screen
 */
export function rulerOf(zero, along, from, to, mm) {
  const across = [-along[1], along[0]];
  const at = (/** @type {number} */ way, /** @type {number} */ off) =>
    /** @type {Spot} */ ([zero[0] + way * along[0] - off * (across[0] ?? 0), zero[1] + way * along[1] - off * (across[1] ?? 0)]);
  const every = mm > COARSE ? 5 : 1;
  const strokes = [];
  const numbers = [];
  for (let way = Math.ceil(from / every) * every; way <= to; way += every) {
    const long = way % 10 === 0 ? 14 : way % 5 === 0 ? 10 : 6;
    strokes.push(pathThrough([at(way, 0), at(way, long * mm)]));
    if (way % 10 !== 0) continue;
    const [x, y] = at(way, 22 * mm);
    numbers.push(letterText(String(Math.abs(way)), { x: mmText(x), y: mmText(-y), class: "division" }));
  }
  const edge = pathThrough([at(from, 0), at(to, 0)]);
  return [drawnElement("path", { d: edge + strokes.join(""), class: "ruler" }), ...numbers];
}

/** Where a pixel is more, millimetres would run together. */
const COARSE = 0.45;
