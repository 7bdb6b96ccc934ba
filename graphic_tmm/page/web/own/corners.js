import { element } from "../dom.js";

/**
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("./projection.js").Spot} Spot
 *
 * What Python packs for a drawing of one's own; the names are those of page/practice/own.py.
 * @typedef {import("./projection.js").Rectangle} Rectangle
 * @typedef {{frames: Rectangle[], papers: [string, number, number][],
 *   seeking: import("./strip.js").Seeking, bent: number, bowed: number}} OwnPack
 *   `frames`: of each sheet, mm from its lower left corner; `papers`: formats, mm; how a frame is sought; from where on a bent sheet, a bowing lens is told of, mm
 * What four corners are clicked of: a rectangle of the sheet, what of it is looked at, the number of the sheet whose
 * frame it is (-1: of none); whether its lines are sought
 * @typedef {{box: Rectangle, area: Rectangle, sheet: number, lines: boolean}} Cornered
 */

/** What is shown about a rectangle of one's own, as a share of its longer side. */
const ABOUT_IT = 0.1;
const USUAL_SIDES = { width: 250, height: 180 };
const LEAST_SIDE = 20;
const MOST_SIDE = 2000;

/**
 * The choice of what the four corners are of: a frame, a paper, a rectangle whose sides are written.
 * @param {Data} data
 * @param {OwnPack} pack
 * @param {(key: string, values: Record<string, string | number>) => string} told
 * @param {() => void} changed
 */
export function cornerChoice(data, pack, told, changed) {
  const options = [
    ...pack.frames.map((_, k) => told("own frame", { sheet: k + 1 })),
    ...pack.papers.map(([name]) => told("own paper", { name })),
    told("own rectangle", {}),
  ];
  const select = /** @type {HTMLSelectElement} */ (element("select", {}));
  select.append(...options.map((name, k) => element("option", { value: String(k) }, name)));
  const width = sideInput(USUAL_SIDES.width);
  const height = sideInput(USUAL_SIDES.height);
  const sides = element(
    "span",
    { class: "own-sides" },
    element("label", {}, told("own width", {}), " ", width),
    element("label", {}, told("own height", {}), " ", height),
  );
  const show = () => (sides.hidden = Number(select.value) !== options.length - 1);
  show();
  select.addEventListener("change", () => {
    show();
    changed();
  });
  for (const one of [width, height]) one.addEventListener("change", changed);
  const root = element("span", { class: "corner-choice" }, element("label", {}, told("own of", {}), " ", select), sides);
  return { root, chosen: () => cornered(data, pack, Number(select.value), sideOf(width), sideOf(height)) };
}

/** @param {number} usual */
function sideInput(usual) {
  const made = element("input", { type: "number", min: String(LEAST_SIDE), max: String(MOST_SIDE), value: String(usual) });
  return /** @type {HTMLInputElement} */ (made);
}

/** @param {HTMLInputElement} input */
function sideOf(input) {
  const found = Number(input.value.replace(",", "."));
  return found >= LEAST_SIDE && found <= MOST_SIDE ? found : USUAL_SIDES.width;
}

/**
 * Return what corners are of, by the number of the choice.
 * @param {Data} data
 * @param {OwnPack} pack
 * @param {number} n
 * @param {number} width
 * @param {number} height
 * @returns {Cornered}
 */
export function cornered(data, pack, n, width, height) {
  const [frame, sheet] = [pack.frames[n], data.sheets[n]];
  if (frame !== undefined && sheet !== undefined) {
    return { box: frame, area: [0, 0, sheet.width, sheet.height], sheet: n, lines: true };
  }
  const paper = pack.papers[n - pack.frames.length];
  if (paper !== undefined) {
    const [, across, up] = paper;
    return { box: [0, 0, across, up], area: [0, 0, across, up], sheet: -1, lines: false };
  }
  const rim = ABOUT_IT * Math.max(width, height);
  return { box: [0, 0, width, height], area: [-rim, -rim, width + rim, height + rim], sheet: -1, lines: true };
}

/**
 * Whether corners rather look like those of the rectangle turned by a quarter.
 * @param {Spot[]} corners in the order of `verticesOf`
 * @param {Cornered} of
 */
export function looksTurned(corners, { box: [left, bottom, right, top] }) {
  const side = (/** @type {number} */ k) => {
    const [a, b] = [corners[k], corners[(k + 1) % 4]];
    return a === undefined || b === undefined ? NaN : Math.hypot(b[0] - a[0], b[1] - a[1]);
  };
  const seen = Math.log((side(0) + side(2)) / (side(1) + side(3)));
  const drawn = Math.log((right - left) / (top - bottom));
  return Math.abs(seen - drawn) > Math.abs(seen + drawn);
}
