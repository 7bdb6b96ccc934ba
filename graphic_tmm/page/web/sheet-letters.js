import { boxesMeet } from "./sheet-bounds.js";

/**
 * @typedef {import("./sheet-bounds.js").Box} Box
 * @typedef {import("./pan.js").Camera} Camera
 * @typedef {import("./sheet-ink.js").SheetInk} SheetInk
 * @typedef {import("./sheet-ink.js").SheetView} SheetView
 */

/** How high capitals are at least, where there is room, px. */
const HIGH = 8;
const MOST_GROWTH = 3;
/** Where the capitals of titles (7 mm) are lower than this, px, views are named in letters of the screen. */
const UNREADABLE = 6;
const TITLE = 7;
const PLATE = { font: 12, pad: 4, least: 16 };
const CELL = 20;

/**
 * Return how letters of marks are enlarged so that they can be read: those that have the room, about their middles.
 * @param {SheetInk} sheet
 * @param {number} zoom px a millimetre
 * @returns {Map<number, DOMMatrix>} by their numbers; who is not there stays as on paper
 */
export function grownLetters(sheet, zoom) {
  /** @type {Map<number, DOMMatrix>} */
  const grown = new Map();
  if (sheet.labels.every((one) => !one.names || one.size * zoom >= HIGH)) return grown;
  const boxes = sheet.labels.map((one) => one.box);
  const cells = cellsOf(boxes);
  sheet.labels.forEach((one, k) => {
    const factor = Math.min(HIGH / (one.size * zoom), MOST_GROWTH);
    if (factor <= 1 || !one.names) return;
    const x = (one.box[0] + one.box[2]) / 2;
    const y = (one.box[1] + one.box[3]) / 2;
    const larger = scaledBox(one.box, x, y, factor);
    if (larger[0] < 0 || larger[1] < 0 || larger[2] > sheet.width || larger[3] > sheet.height) return;
    if (near(cells, larger).some((other) => other !== k && boxesMeet(boxes[other] ?? larger, larger))) return;
    boxes[k] = larger;
    enter(cells, larger, k);
    grown.set(k, new DOMMatrix([factor, 0, 0, factor, x - factor * x, y - factor * y]));
  });
  return grown;
}

/**
 * @param {Box} box
 * @param {number} x
 * @param {number} y
 * @param {number} factor
 * @returns {Box}
 */
function scaledBox(box, x, y, factor) {
  const [left, top, right, bottom] = box;
  return [x + factor * (left - x), y + factor * (top - y), x + factor * (right - x), y + factor * (bottom - y)];
}

/** @param {Box[]} boxes */
function cellsOf(boxes) {
  /** @type {Map<string, number[]>} */
  const cells = new Map();
  boxes.forEach((box, k) => enter(cells, box, k));
  return cells;
}

/**
 * @param {Map<string, number[]>} cells
 * @param {Box} box
 * @param {number} k
 */
function enter(cells, box, k) {
  for (const key of keysOf(box)) {
    const cell = cells.get(key);
    if (cell === undefined) cells.set(key, [k]);
    else cell.push(k);
  }
}

/**
 * @param {Map<string, number[]>} cells
 * @param {Box} box
 */
function near(cells, box) {
  return keysOf(box).flatMap((key) => cells.get(key) ?? []);
}

/** @param {Box} box */
function keysOf(box) {
  const [left = 0, top = 0, right = 0, bottom = 0] = box.map((one) => Math.floor(one / CELL));
  const keys = [];
  for (let i = left; i <= right; i++) for (let j = top; j <= bottom; j++) keys.push(`${i} ${j}`);
  return keys;
}

/**
 * Name views in letters of the screen where those of the sheet are too small: in full, else by the position.
 * @param {CanvasRenderingContext2D} context set to CSS px
 * @param {SheetView[]} views
 * @param {(view: SheetView) => string} short
 * @param {Camera} camera
 */
export function paintNames(context, views, short, camera) {
  if (TITLE * camera.zoom >= UNREADABLE) return;
  context.font = `${PLATE.font}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const view of views) {
    if (view.frame) continue;
    const [left, top] = camera.onScreen(view.box[0], view.box[1]);
    const [right, bottom] = camera.onScreen(view.box[2], view.box[3]);
    if (bottom - top < PLATE.least) continue;
    const fits = (/** @type {string} */ text) => context.measureText(text).width + 2 * PLATE.pad <= right - left;
    const name = [view.title, short(view)].find((text) => text !== "" && fits(text));
    if (name === undefined) continue;
    const x = (left + right) / 2;
    const y = (top + bottom) / 2;
    const half = context.measureText(name).width / 2 + PLATE.pad;
    context.fillStyle = "rgb(255 255 255 / 85%)";
    context.fillRect(x - half, y - PLATE.font * 0.75, 2 * half, PLATE.font * 1.5);
    context.fillStyle = "#111";
    context.fillText(name, x, y);
  }
}
