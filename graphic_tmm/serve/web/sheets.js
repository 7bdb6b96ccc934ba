import { element, filled } from "../../page/web/dom.js";
import { ZoomDesk } from "./desk.js";

/** @typedef {import("./types.js").Sheet} Sheet */
/** @typedef {import("./types.js").Words} Words */

/** Pictures of sheets at their true shape, one below the other; a new one takes the place of the one before. */
export class Sheets extends ZoomDesk {
  /** @param {Words} words */
  constructor(words) {
    super(words, words["desk"] ?? "", ["larger", "smaller", "whole", "true size"]);
    /** @type {Sheet[]} */
    this.sheets = [];
    this.nothing = element("p", { class: "hint" }, words["no sheets"] ?? "");
    this.desk.append(this.nothing);
    this.element = element("div", { class: "sheets" }, this.tools, this.desk);
  }

  /**
   * Show sheets; those that stayed are not touched, nor is the place that is looked at.
   * @param {Sheet[]} sheets
   */
  show(sheets) {
    const sized = sheets.map((one) => `${one.width} ${one.height}`).join();
    const before = this.sheets.map((one) => `${one.width} ${one.height}`).join();
    const had = this.sheets;
    this.sheets = sheets;
    this.sizes = sheets;
    this.nothing.hidden = sheets.length > 0;
    while (this.figures.length > sheets.length) this.figures.pop()?.remove();
    sheets.forEach((sheet, k) => {
      const figure = this.figures[k] ?? this.figure();
      if (had[k]?.hash !== sheet.hash) this.picture(figure, sheet, k + 1);
    });
    if (sized !== before) this.size();
  }

  /**
   * Put the picture of a sheet into its figure as soon as it is there; until then the one before stays.
   * @param {HTMLElement} figure
   * @param {Sheet} sheet
   * @param {number} n which it is
   */
  picture(figure, sheet, n) {
    const made = new Image();
    made.alt = filled(this.words["sheet"] ?? "", { n });
    made.draggable = false;
    figure.dataset["wanted"] = sheet.hash;
    made.addEventListener("load", () => {
      if (figure.dataset["wanted"] !== sheet.hash) return;
      figure.dataset["shown"] = sheet.hash;
      figure.replaceChildren(made);
    });
    made.src = `sheet/${sheet.hash}.svg`;
  }
}
