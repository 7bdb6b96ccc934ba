import { fourFigures } from "./crank-values.js";
import { drawnElement } from "./dom.js";
import { hundredths, placeOf } from "./strokes.js";
import { presenceOf } from "./dense.js";

/**
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./types.js").Cursor} Cursor
 * @typedef {import("./types.js").View} View
 */

/** The radius of the point on a curve, mm. */
const POINT = 1.8;

/**
 * The view of a sheet whose curves bear points that follow the crank.
 */
export class Cursors {
  /**
   * @param {View} view
   * @param {Cursor[]} cursors
   * @param {Float32Array[]} rows
   * @param {import("./lengths.js").Lengths | null} lengths that can be changed
   * @param {string} decimal what stands between the whole and the rest
   */
  constructor(view, cursors, rows, lengths = null, decimal = ".") {
    this.decimal = decimal;
    this.svg = drawnElement("svg", { viewBox: view.box.join(" "), class: "moving stage ready", role: "img", "aria-label": view.title });
    const copy = /** @type {Element | undefined} */ (document.getElementById(view.id)?.cloneNode(true));
    copy?.removeAttribute("id");
    for (const title of copy?.querySelectorAll("title, desc") ?? []) title.remove();
    if (copy !== undefined) this.svg.append(copy);
    this.over = drawnElement("g", { class: "cursor" });
    /** @type {((k: number) => void)[]} */
    this.acts = [];
    this.lengths = lengths;
    this.chart = copy === undefined ? null : (lengths?.chart(copy, cursors) ?? null);
    cursors.forEach((one, n) => this.follow(one, rows, n));
    this.svg.append(this.over);
  }

  /**
   * @param {Cursor} one
   * @param {Float32Array[]} rows
   * @param {number} n
   */
  follow(one, rows, n) {
    const [x, y] = [placeOf(one.x, rows), placeOf(one.y, rows)];
    const there = presenceOf(one.there, Array.from({ length: rows[0]?.length ?? 0 }, (_, k) => k));
    const point = drawnElement("circle", { r: POINT });
    const line = drawnElement("line", {});
    const lined = one.upright;
    this.over.append(...(lined ? [line] : []), point);
    this.acts.push((k) => {
      const live = this.lengths?.changed() === true ? (this.chart?.place(n, k) ?? null) : undefined;
      const seen = live === undefined ? there === null || there[k] === 1 : live !== null;
      point.setAttribute("visibility", seen ? "visible" : "hidden");
      line.setAttribute("visibility", seen ? "visible" : "hidden");
      if (!seen) return;
      const [u, v] = live ? [hundredths(live.re), hundredths(live.im)] : [hundredths(x(k)), hundredths(y(k))];
      point.setAttribute("cx", String(u));
      point.setAttribute("cy", String(v));
      if (!lined) return;
      line.setAttribute("x1", String(u));
      line.setAttribute("x2", String(u));
      line.setAttribute("y1", String(one.origin));
      line.setAttribute("y2", String(v));
    });
  }

  /**
   * Return what a cursor tells at an angle with lengths that are not as given; null of what is not known.
   * @param {number} n
   * @param {number} k
   */
  told(n, k) {
    const value = this.chart?.value(n, k) ?? NaN;
    return Number.isFinite(value) ? fourFigures(value, this.decimal) : null;
  }

  /**
   * @param {number} k
   * @param {boolean} drawn
   */
  show(k, drawn) {
    this.chart?.follow(this.lengths?.changed() === true);
    this.over.setAttribute("visibility", drawn ? "visible" : "hidden");
    if (drawn) for (const act of this.acts) act(k);
  }
}
