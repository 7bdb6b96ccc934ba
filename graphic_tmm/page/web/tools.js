import { drawnElement, element } from "./dom.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Tool} Tool
 * @typedef {import("./types.js").View} View
 */

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
    svg.append(this.layer);
  }

  /**
   * Lay the instrument where the step of a stop needs it.
   * @param {number} n
   */
  show(n) {
    const lines = this.view.pictures[n]?.lines ?? [];
    this.layer.replaceChildren(...lines.flatMap((line) => (line.tool ? outlineOf(line.tool) : [])));
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

/**
 * @param {Tool} tool
 * @returns {SVGElement[]}
 */
function outlineOf(tool) {
  return tool.length > 2 ? [drawnElement("path", { d: "M0 0" })] : [];
}
