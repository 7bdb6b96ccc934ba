import { inkOf } from "../sheet-ink.js";

/**
 * @typedef {import("../sheet-ink.js").Ink} Ink
 * @typedef {import("../sheet-ink.js").SheetInk} SheetInk
 * @typedef {import("../types.js").Data} Data
 * @typedef {import("../types.js").Task} Task
 */

/** The exact plans as paths, read off the sheets in the page when they are asked for; mm, y downward. */
export class ExactPlans {
  /** @param {Data} data */
  constructor(data) {
    this.data = data;
    /** @type {Map<number, SheetInk>} */
    this.read = new Map();
    /** @type {Map<string, Path2D>} */
    this.made = new Map();
  }

  /** @param {number} number */
  inkOn(number) {
    const known = this.read.get(number);
    if (known !== undefined) return known;
    const svg = document.querySelectorAll("#sheets figure.sheet > svg")[number];
    const size = this.data.sheets[number];
    if (svg === undefined || size === undefined) return undefined;
    const ink = inkOf(svg, size);
    this.read.set(number, ink);
    return ink;
  }

  /**
   * Return what is drawn of a plan in a position.
   * @param {Task} task
   */
  plan(task) {
    const key = `${task.view} ${task.at}`;
    const path = this.made.get(key) ?? this.drawn(task);
    this.made.set(key, path);
    return path;
  }

  /** @param {Task} task */
  drawn(task) {
    const view = this.data.views[task.view];
    const sheet = this.inkOn(task.sheet);
    if (view === undefined || sheet === undefined) return new Path2D();
    const name = this.data.practice?.names[task.at] ?? "";
    const shown = sheet.views.findIndex((one) => one.id === view.id);
    const here = (/** @type {Ink} */ one) => one.at < 0 || view.names[String(one.at)] === name;
    return linesOf(sheet.ink.filter((one) => one.view === shown && here(one)));
  }
}

/** @param {Ink[]} ink */
function linesOf(ink) {
  const path = new Path2D();
  for (const one of ink) if (!one.rubbed && one.pen.stroke !== "") path.addPath(one.path);
  return path;
}
