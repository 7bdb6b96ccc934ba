import { drawnElement } from "../../../page/web/dom.js";

/**
 * The squares of the paper, every tenth line stronger and with its millimetres from the first support.
 *
 * @typedef {import("./sketch.js").Place} Place
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./view.js").View} View
 */

const TENTH = 10;
/** How far a figure stands from the edge of the window, dots. */
const EDGE = 4;

/**
 * Return where millimetres are counted from: the first support, else the middle of the paper at first.
 * @param {Sketch} sketch
 * @returns {Place}
 */
export function countedFrom(sketch) {
  const [first = ""] = sketch.links[0]?.points ?? [];
  return sketch.places[first] ?? [0, 0];
}

/**
 * Draw the squares, and the figures of their stronger lines.
 * @param {View} view
 * @param {Place} from
 * @param {string} mm their unit, which stands at the nought below
 */
export function drawnGrid(view, [x0, y0], mm) {
  const step = view.square;
  const [left, top] = view.place([0, 0]);
  const [right, low] = view.place([view.width, view.height]);
  let fine = "";
  let coarse = "";
  /** @type {SVGElement[]} */
  const figures = [];
  const add = (/** @type {number} */ n, /** @type {string} */ d, /** @type {[number, number, string]} */ [x, y, edge]) => {
    if (n % TENTH !== 0) return void (fine += d);
    coarse += d;
    const figure = drawnElement("text", { class: `figure ${edge}`, x, y });
    figure.append(inMillimetres(n * step), n === 0 && edge === "below" ? ` ${mm}` : "");
    figures.push(figure);
  };
  for (let n = Math.ceil((left - x0) / step); x0 + n * step <= right; n += 1) {
    const [x] = view.dots([x0 + n * step, 0]);
    add(n, `M${x.toFixed(1)} 0V${view.height}`, [x, view.height - 2 * EDGE, "below"]);
  }
  for (let n = Math.ceil((low - y0) / step); y0 + n * step <= top; n += 1) {
    const [, y] = view.dots([0, y0 + n * step]);
    add(n, `M0 ${y.toFixed(1)}H${view.width}`, [EDGE, y, "beside"]);
  }
  return [drawnElement("path", { class: "fine", d: fine }), drawnElement("path", { class: "coarse", d: coarse }), ...figures];
}

/**
 * Say where a place is.
 * @param {Place} place
 * @param {Place} from
 * @param {string} mm
 */
export function whereabouts([x, y], [x0, y0], mm) {
  return `x = ${inMillimetres(x - x0)}, y = ${inMillimetres(y - y0)} ${mm}`;
}

/** @param {number} metres */
function inMillimetres(metres) {
  const told = Math.round(TENTH * 1000 * metres) / TENTH;
  return told < 0 ? `−${-told}` : String(Math.abs(told));
}
