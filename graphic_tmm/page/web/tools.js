import { drawnElement, element } from "./dom.js";
import { outlinesOf } from "./outlines.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Tool} Tool
 * @typedef {import("./types.js").View} View
 */

/** On a drawing of this size, mm, instruments are shown as large as they usually are; on a smaller one smaller. */
const ROOMY = 140;

/**
 * The instrument of a step, hinted over the drawing as an outline that does not hide its ink.
 */
export class Tools {
  /**
   * @param {SVGElement} svg
   * @param {View} view
   */
  constructor(svg, view) {
    this.view = view;
    this.layer = drawnElement("g", { class: "instrument", "aria-hidden": "true" });
    svg.prepend(this.layer);
  }

  /**
   * Lay the instrument where the step of a stop needs it.
   * @param {number} n
   */
  show(n) {
    const lines = this.view.pictures[n]?.lines ?? [];
    const made = this.view.pictures[n]?.again ? [] : lines.flatMap((line) => (line.tool ? this.outlines(line.tool) : []));
    this.layer.replaceChildren(...made);
  }

  /**
   * @param {Tool} tool
   */
  outlines([kind, , ...numbers]) {
    /** @type {[number, number][]} */
    const spots = [];
    for (let k = 0; k + 1 < numbers.length; k += 2) spots.push([numbers[k] ?? 0, numbers[k + 1] ?? 0]);
    const [, , width = 0, height = 0] = this.view.box;
    const scale = Math.min(1, Math.max(width, height) / ROOMY);
    return outlinesOf(kind, spots, scale).map(({ d, ghost }) => drawnElement("path", ghost ? { d, class: "ghost" } : { d }));
  }
}

/**
 * Return the switch that takes the instruments off the board.
 * @param {Data} data
 * @param {Element} board
 */
export function toolSwitch(data, board) {
  const box = /** @type {HTMLInputElement} */ (element("input", { type: "checkbox" }));
  box.checked = true;
  box.addEventListener("change", () => board.classList.toggle("bare", !box.checked));
  return element("label", { class: "switch" }, box, ` ${data.words["instrument"] ?? ""}`);
}
