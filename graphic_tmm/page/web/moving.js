import { nearestDrawn, presenceOf, spreadRow } from "./dense.js";
import { drawnElement } from "./dom.js";
import { pathOf, placeOf, told } from "./strokes.js";

/**
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./types.js").MovingFigure} MovingFigure
 * @typedef {import("./types.js").Glyph} Glyph
 */

/** White about a letter that stands on lines, in widths of its pen. */
const HALO = 5;

/**
 * A figure that moves with the crank: built once, then only what changes is told anew.
 */
export class Moving {
  /**
   * @param {Dense} dense
   * @param {MovingFigure} figure
   * @param {Int32Array[]} packed
   */
  constructor(dense, figure, packed) {
    this.figure = figure;
    const [begun, count] = figure.rows;
    const kept = packed.slice(begun, begun + count);
    const rows = kept.map((row) => spreadRow(row, dense.whole, dense.step, figure.refined));
    this.drawn = nearestDrawn(dense.whole, dense.step, figure.refined, dense.more.length);
    this.svg = drawnElement("svg", { viewBox: figure.box.join(" "), class: "stage", role: "img", "aria-label": figure.title });
    /** @type {((k: number) => void)[]} */
    this.acts = [];
    this.body = drawnElement("g", {});
    const pens = layers(dense, figure.still ?? []);
    for (const line of figure.lines) this.line(line, rows, pens);
    for (const layer of pens.values()) if (layer.childElementCount > 0) this.body.append(layer);
    this.svg.append(this.body);
    for (const [n, x, y] of figure.stands ?? []) {
      this.svg.append(drawnElement("g", { transform: `translate(${x} ${-y})` }, ...written(dense.glyphs[n])));
    }
    const letters = drawnElement("g", { class: "letters" });
    for (const [n, x, y, there] of figure.letters) {
      const made = drawnElement("g", {}, ...written(dense.glyphs[n]));
      const places = [placeOf(x, rows), placeOf(y, rows)];
      this.act(made, there, (k) => moved(made, places[0]?.(k), places[1]?.(k)));
      letters.append(made);
    }
    this.body.append(letters);
    this.last = -1;
  }

  /**
   * @param {MovingFigure["lines"][number]} line
   * @param {Float32Array[]} rows
   * @param {Map<string, Element>} pens
   */
  line([pen, flags, coordinates, bends, there], rows, pens) {
    const made = drawnElement("path", {});
    if (flags >= 2) {
      made.setAttribute("fill", "var(--ink)");
      made.setAttribute("stroke", "none");
    }
    const closed = flags % 2 === 1;
    const places = coordinates.map((one) => placeOf(one, rows));
    const curves = bends === 0 ? null : bends.map((one) => placeOf(one, rows));
    const bulges = (/** @type {number} */ k) => curves?.map((bend) => bend(k) / 1000) ?? null;
    const together = sameRow(coordinates, 0) && sameRow(coordinates, 1) && (bends === 0 || bends.every((one) => one.length === 1));
    if (together) {
      const [x0, y0] = [coordinates[0]?.[1] ?? coordinates[0]?.[0] ?? 0, coordinates[1]?.[1] ?? coordinates[1]?.[0] ?? 0];
      const own = coordinates.map((one, n) => ((one[1] ?? one[0] ?? 0) - (n % 2 === 0 ? x0 : y0)) / 1000);
      made.setAttribute("d", pathOf(own, bulges(0), closed));
      if (coordinates.every((one) => one.length === 1)) moved(made, places[0]?.(0), places[1]?.(0));
      else this.act(made, there, (k) => moved(made, places[0]?.(k), places[1]?.(k)));
    } else {
      const at = new Array(places.length).fill(0);
      this.act(made, there, (k) => {
        for (let n = 0; n < places.length; n++) at[n] = places[n]?.(k) ?? 0;
        made.setAttribute("d", pathOf(at, bulges(k), closed));
      });
    }
    pens.get(pen)?.append(made);
  }

  /**
   * Let something follow the angle wherever it is there.
   * @param {SVGElement} made
   * @param {number[] | 0} runs
   * @param {(k: number) => void} follow
   */
  act(made, runs, follow) {
    const there = presenceOf(runs, this.drawn);
    let seen = true;
    this.acts.push((k) => {
      const now = there === null || there[k] === 1;
      if (now !== seen) made.setAttribute("visibility", now ? "inherit" : "hidden");
      seen = now;
      if (now) follow(k);
    });
  }

  /**
   * Show an angle.
   * @param {number} k
   * @param {boolean} drawn
   */
  show(k, drawn) {
    if (k === this.last) return;
    this.last = k;
    this.body.setAttribute("visibility", drawn ? "visible" : "hidden");
    if (drawn) for (const act of this.acts) act(k);
  }
}

/**
 * @param {SVGElement} made
 * @param {number | undefined} x
 * @param {number | undefined} y
 */
function moved(made, x, y) {
  made.setAttribute("transform", `translate(${told(x)} ${told(-(y ?? 0))})`);
}

/**
 * Whether all x (0) or all y (1) of a stroke are one row and distances from it, or numbers.
 * @param {number[][]} coordinates
 * @param {number} first
 */
function sameRow(coordinates, first) {
  const own = coordinates.filter((_, n) => n % 2 === first);
  const row = own[0]?.length === 2 ? own[0]?.[0] : undefined;
  return own.every((one) => (one.length === 2 ? one[0] : undefined) === row);
}

/**
 * Return a group for each pen, in their order, with what stands still already in it.
 * @param {Dense} dense
 * @param {[string, string][]} still
 * @returns {Map<string, Element>}
 */
function layers(dense, still) {
  const found = new Map();
  for (const [pen, [width, dashes, fill]] of Object.entries(dense.pens)) {
    const group = drawnElement("g", {
      fill: fill === "none" ? "none" : "var(--paper)",
      stroke: width > 0 ? "var(--ink)" : "none",
      "stroke-width": width,
      "stroke-linecap": dashes.length > 0 ? "butt" : "round",
      "stroke-linejoin": "round",
    });
    if (dashes.length > 0) group.setAttribute("stroke-dasharray", dashes.join(" "));
    for (const [of, d] of still) if (of === pen) group.append(drawnElement("path", { d, class: "still" }));
    found.set(pen, group);
  }
  return found;
}

/**
 * Return the strokes of a letter, white about them.
 * @param {Glyph | undefined} glyph
 */
function written(glyph) {
  const strokes = glyph?.[1] ?? [];
  const shared = { fill: "none", "stroke-linecap": "round", "stroke-linejoin": "round" };
  return [
    ...strokes.map(([pen, d]) => drawnElement("path", { ...shared, d, stroke: "var(--paper)", "stroke-width": HALO * pen })),
    ...strokes.map(([pen, d]) => drawnElement("path", { ...shared, d, stroke: "var(--ink)", "stroke-width": pen })),
  ];
}
