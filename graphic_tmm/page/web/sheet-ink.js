import { boxAbout, pathBox } from "./sheet-bounds.js";

/** @typedef {import("./sheet-bounds.js").Box} Box */

/**
 * One path of a sheet: its pen as its attributes say, the view it stands in, the marks it comes from.
 * `label`: which letters of the sheet it belongs to (-1: none); `at`: the position (-1: all).
 * @typedef {{path: Path2D, box: Box, pen: Pen, view: number, label: number, of: string, at: number,
 *   part: string, rubbed: boolean, element: Element}} Ink
 * @typedef {{width: number, stroke: string, fill: string, cap: string, join: string, dashes: number[],
 *   key: string}} Pen
 * @typedef {{id: string, title: string, frame: boolean, box: Box}} SheetView
 * A label `names` a mark of the drawing, or it is a title, a table's, an equation's.
 * @typedef {{text: string, box: Box, size: number, names: boolean}} SheetLabel
 * @typedef {{width: number, height: number, ink: Ink[], views: SheetView[], labels: SheetLabel[]}} SheetInk
 */

const NOTHING = "none";
const RUBBED_ID = "s-of-rubbed-";
/** How much higher capitals are than their pen is wide. */
const CAPITALS = 10;

/**
 * Read the ink of a sheet from the SVG that stands in the page, in its order.
 * @param {Element} svg
 * @param {{width: number, height: number}} size
 * @returns {SheetInk}
 */
export function inkOf(svg, size) {
  /** @type {SheetInk} */
  const sheet = { width: size.width, height: size.height, ink: [], views: [], labels: [] };
  for (const group of svg.querySelectorAll(":scope > g.drawing")) {
    const view = sheet.views.length;
    const first = sheet.ink.length;
    const rubbed = document.getElementById(RUBBED_ID + group.id);
    if (rubbed !== null) readGroup(sheet, rubbed, view, true);
    readGroup(sheet, group, view, false);
    const title = group.querySelector(":scope > title")?.textContent ?? "";
    const box = boxAbout(sheet.ink.slice(first).flatMap((one) => (one.rubbed ? [] : [one.box])));
    sheet.views.push({ id: group.id, title, frame: group.classList.contains("frame"), box });
  }
  return sheet;
}

/**
 * @param {SheetInk} sheet
 * @param {Element} group
 * @param {number} view
 * @param {boolean} rubbed
 */
function readGroup(sheet, group, view, rubbed) {
  for (const layer of group.querySelectorAll(":scope > g")) {
    const letters = layer.classList.contains("lettering");
    for (const one of layer.children) {
      if (one.tagName === "path") sheet.ink.push(strokeOf(one, [layer], view, -1, rubbed));
      else if (one.tagName === "g" && letters) readLabel(sheet, one, layer, view);
    }
  }
}

/**
 * @param {SheetInk} sheet
 * @param {Element} group
 * @param {Element} layer
 * @param {number} view
 */
function readLabel(sheet, group, layer, view) {
  const own = [...group.querySelectorAll("path")].map((path) =>
    strokeOf(path, [group, layer], view, sheet.labels.length, false),
  );
  sheet.ink.push(...own);
  const size = CAPITALS * Number(layer.getAttribute("stroke-width"));
  const text = group.getAttribute("aria-label") ?? "";
  sheet.labels.push({ text, box: boxAbout(own.map((one) => one.box)), size, names: group.hasAttribute("data-of") });
}

/**
 * @param {Element} path
 * @param {Element[]} about what it takes its pen from where it has none of its own, the nearest first
 * @param {number} view
 * @param {number} label
 * @param {boolean} rubbed
 * @returns {Ink}
 */
function strokeOf(path, about, view, label, rubbed) {
  const chain = [path, ...about];
  const told = (/** @type {string} */ name) =>
    chain.find((one) => one.hasAttribute(name))?.getAttribute(name) ?? "";
  const data = path.getAttribute("d") ?? "";
  const pen = penOf(told);
  const box = boxAbout([pathBox(data)], pen.width / 2);
  const at = told("data-at");
  return {
    path: new Path2D(data),
    box,
    pen,
    view,
    label,
    of: told("data-of"),
    at: at === "" ? -1 : Number(at),
    part: told("data-part"),
    rubbed,
    element: label < 0 ? path : /** @type {Element} */ (path.parentElement),
  };
}

/**
 * @param {(name: string) => string} told
 * @returns {Pen}
 */
function penOf(told) {
  const colour = (/** @type {string} */ name) => (told(name) === NOTHING ? "" : told(name));
  const pen = {
    width: Number(told("stroke-width")),
    stroke: colour("stroke"),
    fill: colour("fill"),
    cap: told("stroke-linecap") || "butt",
    join: told("stroke-linejoin") || "miter",
    dashes: told("stroke-dasharray").split(/[ ,]+/).filter(Boolean).map(Number),
  };
  return { ...pen, key: Object.values(pen).join("|") };
}
