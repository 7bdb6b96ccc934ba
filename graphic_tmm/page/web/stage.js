import { drawnElement } from "./dom.js";
import { pictureAt } from "./told.js";

/** @typedef {import("./types.js").View} View */

/** The id of what was rubbed out in a view stands behind this. */
const RUBBED = "s-of-rubbed-";

/**
 * The drawing of a view as it grows: the ink of its sheet, each stroke and letter in the stop it appears in.
 */
export class Stage {
  /** @param {View} view */
  constructor(view) {
    this.view = view;
    this.svg = drawnElement("svg", { viewBox: view.box.join(" "), class: "stage", role: "img", tabindex: 0 });
    this.svg.setAttribute("aria-label", view.title);
    /** @type {Map<string, number>} */
    this.pictures = new Map();
    view.pictures.forEach((picture, n) => picture.keys.forEach((key) => this.pictures.set(key, n)));
    this.svg.setAttribute("data-pictures", String(pictureAt(view, view.pictures.length)));
    /** What appears in a stop, by its number. @type {Map<number, Element[]>} */
    this.parts = new Map();
    /** What a mark has drawn, by its slot. @type {Map<number, Element[]>} */
    this.inks = new Map();
    /** @type {Element[]} */
    this.taken = [];
    this.shown = Infinity;
    this.add(document.getElementById(RUBBED + view.id), true);
    this.add(document.getElementById(view.id), false);
  }

  /**
   * @param {Element | null} source
   * @param {boolean} rubbed
   */
  add(source, rubbed) {
    if (source === null) return;
    const copy = /** @type {Element} */ (source.cloneNode(true));
    copy.removeAttribute("id");
    if (rubbed) copy.classList.add("helping");
    for (const part of copy.querySelectorAll("path:not(.label path), g.label")) {
      const { of = "", at = "" } = /** @type {SVGElement} */ (part).dataset;
      const k = this.pictures.get(`${of}@${at}`) ?? 0;
      added(this.parts, k, part);
      if (/^\d+$/.test(of)) added(this.inks, Number(of), part);
    }
    for (const title of copy.querySelectorAll("title, desc")) title.remove();
    this.svg.append(copy);
  }

  /**
   * Show a stop: done strokes thin, new ones heavy; the last one is ready, as on the sheet.
   *
   * A step that leaves no ink reads or calculates of what is there. What is neither new nor was, nor comes or goes
   * between the stop that was shown and this one, stays as it is.
   * @param {number} n
   */
  show(n) {
    const ready = n >= this.view.pictures.length;
    this.svg.classList.toggle("ready", ready);
    this.svg.setAttribute("data-step", String(n));
    this.svg.setAttribute("data-picture", String(pictureAt(this.view, n)));
    for (const part of this.taken) part.classList.remove("taken");
    const uses = this.view.pictures[n]?.lines.flatMap((line) => line.uses ?? []) ?? [];
    this.taken = uses.flatMap((slot) => this.inks.get(slot) ?? []);
    for (const part of this.taken) part.classList.add("taken");
    const [from, to] = [Math.min(n, this.shown), Math.max(n, this.shown)];
    this.shown = n;
    for (const [k, parts] of this.parts) {
      if (k < from || k > to) continue;
      for (const part of parts) {
        part.classList.toggle("later", k > n);
        part.classList.toggle("now", k === n && n > 0 && !ready);
      }
    }
  }
}

/**
 * @param {Map<number, Element[]>} to
 * @param {number} key
 * @param {Element} part
 */
function added(to, key, part) {
  const there = to.get(key);
  if (there === undefined) to.set(key, [part]);
  else there.push(part);
}
