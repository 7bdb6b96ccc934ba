import { drawnElement } from "../../../page/web/dom.js";
import { minus, unit } from "./sketch.js";

/**
 * What acts on a mechanism: arrows of forces, moments, springs with their letters, in dots of the screen.
 *
 * @typedef {import("../types.js").LoadSign} LoadSign
 * @typedef {import("./view.js").Dots} Dots
 * @typedef {import("./view.js").View} View
 */

/** How long the arrow of a force is, and its head; it begins so far off its point, a push ends so far off it. */
const LONG = 58;
const HEAD = 13;
const BEGINS = 8;
const OFF = 16;
/** The arc of a moment: its radius, half of what it goes over. */
const ROUND = 26;
const HALF = Math.PI / 4;
/** How far beside the end of an arrow its letter stands. */
const LETTER = 16;
/** Turns of a spring, how far they go aside, and how far beside what may slide along it a spring stands. */
const COILS = 9;
const WIDE = 6;
const ASIDE = 22;
/** A place where something acts in a direction that nobody knows. */
const SPOT = 11;

/**
 * @param {LoadSign[]} loads
 * @param {View} view
 * @returns {SVGElement[]}
 */
export function drawnLoads(loads, view) {
  return loads.map((load) => drawnElement("g", { class: "load" }, ...signOf(load, view)));
}

/**
 * @param {LoadSign} load
 * @param {View} view
 */
function signOf(load, view) {
  const at = view.dots(load.at);
  const way = /** @type {Dots} */ ([load.way[0], -load.way[1]]);
  if (load.end !== null) return spring(at, view.dots(load.end), load.letter);
  if (load.turns !== 0) return moment(at, load.turns, load.letter);
  if (Math.hypot(...way) === 0) {
    return [drawnElement("circle", { cx: at[0], cy: at[1], r: SPOT }), letter(load.letter, at[0], at[1] - SPOT - LETTER)];
  }
  const [far, near] = load.pushes ? [-LONG - OFF, -OFF] : [BEGINS, LONG];
  const spot = (/** @type {number} */ along) => /** @type {Dots} */ ([at[0] + along * way[0], at[1] + along * way[1]]);
  const [x, y] = spot((load.pushes ? far : near) * 0.9);
  // beside it, above or at right: beyond it a bar may lie along it
  const side = way[0] > 0.5 || way[1] < -0.5 ? 1 : -1;
  return [...arrow(spot(far), spot(near), way), letter(load.letter, x + side * LETTER * way[1], y - side * LETTER * way[0])];
}

/**
 * @param {Dots} from
 * @param {Dots} to
 * @param {Dots} way
 */
function arrow(from, to, way) {
  const [x, y] = [to[0] - HEAD * 0.8 * way[0], to[1] - HEAD * 0.8 * way[1]];
  return [drawnElement("path", { d: `M${from.join(" ")}L${x} ${y}` }), head(to, way)];
}

/**
 * @param {Dots} at
 * @param {Dots} way
 */
function head([x, y], [u, v]) {
  const [back, half] = [HEAD, HEAD / 3];
  return drawnElement("path", { class: "head", d: `M${x} ${y}L${x - back * u - half * v} ${y - back * v + half * u}L${x - back * u + half * v} ${y - back * v - half * u}Z` });
}

/**
 * @param {Dots} at
 * @param {number} turns 1 counter-clockwise, as it is seen
 * @param {string} name
 */
function moment([x, y], turns, name) {
  const spot = (/** @type {number} */ angle) => /** @type {Dots} */ ([x + ROUND * Math.cos(angle), y - ROUND * Math.sin(angle)]);
  const [from, to] = [spot(-turns * HALF), spot(turns * HALF)];
  const way = /** @type {Dots} */ ([-turns * Math.sin(turns * HALF), -turns * Math.cos(turns * HALF)]);
  const d = `M${from.join(" ")}A${ROUND} ${ROUND} 0 0 ${turns > 0 ? 0 : 1} ${to.join(" ")}`;
  return [drawnElement("path", { d }), head(to, way), letter(name, x + ROUND + LETTER, y)];
}

/**
 * @param {Dots} from
 * @param {Dots} to
 * @param {string} name
 */
function spring(from, to, name) {
  const [u, v] = unit(minus(to, from));
  const long = Math.hypot(...minus(to, from));
  const spot = (/** @type {number} */ along, /** @type {number} */ aside) => [from[0] + along * u - aside * v, from[1] + along * v + aside * u];
  /** @type {number[][]} */
  const spots = [from, spot(0, ASIDE), spot(0.3 * long, ASIDE)];
  for (let k = 1; k < 2 * COILS; k += 1) spots.push(spot(long * (0.3 + k / (5 * COILS)), k % 2 === 0 ? ASIDE - WIDE : ASIDE + WIDE));
  const d = `M${[...spots, spot(0.7 * long, ASIDE), spot(long, ASIDE), to].map((one) => one.join(" ")).join("L")}`;
  const [x = 0, y = 0] = spot(long / 2, ASIDE + 2 * LETTER);
  return [drawnElement("path", { class: "spring", d }), letter(name, x, y)];
}

/**
 * A letter with its indices lowered: F_{32}.
 * @param {string} name
 * @param {number} x
 * @param {number} y
 */
function letter(name, x, y) {
  const pieces = name.split(/_(\{[^}]*\}|.)/);
  const spans = pieces.flatMap((piece, k) => {
    if (piece === "") return [];
    const span = drawnElement("tspan", k % 2 === 1 ? { class: "index", dy: 5 } : k > 0 ? { dy: -5 } : {});
    span.append(piece.replace(/[{}]/g, ""));
    return [span];
  });
  return drawnElement("text", { class: "letter-of-load", x, y }, ...spans);
}
