import { element } from "./dom.js";
import { tilePages } from "./print-tiles.js";

/** @typedef {import("./types.js").Data} Data */

/** What is printed, told to the style sheet: on the root, and on the sheet. */
const PRINTING = "printing";
const PRINTED = "printed";
const TILES = { name: "tiles", width: 210, height: 297 };

/**
 * Print a sheet on paper of its own size: the SVG that stands in the page.
 * @param {Data} data
 * @param {number} number of the sheet
 */
export function printSheet(data, number) {
  const size = data.sheets[number];
  const figure = document.querySelectorAll("figure.sheet")[number];
  if (size === undefined || figure === undefined) return;
  printing("sheet", size.width, size.height);
  figure.classList.add(PRINTED);
  window.addEventListener("afterprint", () => figure.classList.remove(PRINTED), { once: true });
  window.print();
}

/**
 * Print a sheet on several A4 to be glued together.
 * @param {Data} data
 * @param {number} number of the sheet
 */
export function printTiles(data, number) {
  const size = data.sheets[number];
  const figure = document.querySelectorAll("figure.sheet")[number];
  if (size === undefined || figure === undefined) return;
  const pages = element("div", { class: "tiles" }, ...tilePages(figure, size, number, data.words));
  document.body.append(pages);
  printing(TILES.name, TILES.width, TILES.height);
  window.addEventListener("afterprint", () => pages.remove(), { once: true });
  window.print();
}

/**
 * Set the size of the paper until all is printed.
 * @param {string} what
 * @param {number} width mm
 * @param {number} height
 */
function printing(what, width, height) {
  const sheet = /** @type {CSSStyleSheet} */ (document.styleSheets[0]);
  const rule = sheet.insertRule(`@page { size: ${width}mm ${height}mm; margin: 0 }`, sheet.cssRules.length);
  document.documentElement.dataset[PRINTING] = what;
  window.addEventListener(
    "afterprint",
    () => {
      sheet.deleteRule(rule);
      delete document.documentElement.dataset[PRINTING];
    },
    { once: true },
  );
}
