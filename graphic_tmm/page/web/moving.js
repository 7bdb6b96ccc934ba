import { nearestDrawn, presenceOf, spreadRow } from "./dense.js";
import { drawnElement } from "./dom.js";
import { numbersAboutPin } from "./numbers.js";
import { layers, written } from "./pens.js";
import { hundredths, pathOf, placeOf } from "./strokes.js";

/**
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./types.js").MovingFigure} MovingFigure
 * @typedef {import("./types.js").Variant} Variant
 * @typedef {import("./live/tied.js").Expressions} Expressions
 * @typedef {import("./live/liveink.js").LiveInk} LiveInk
 */

/** A figure that moves with the crank: built once, then only what changes is told anew. */
export class Moving {
  /**
   * @param {Dense} dense
   * @param {MovingFigure} figure
   * @param {Int32Array[]} packed
   * @param {LiveInk | null} ink what the figure is tied to
   */
  constructor(dense, figure, packed, ink = null) {
    this.figure = figure;
    this.ink = ink;
    const [begun, count] = figure.rows;
    const kept = packed.slice(begun, begun + count);
    const rows = kept.map((row) => spreadRow(row, dense.whole, dense.step, figure.refined));
    this.drawn = nearestDrawn(dense.whole, dense.step, figure.refined, dense.more.length);
    this.svg = drawnElement("svg", { viewBox: figure.box.join(" "), class: "moving", role: "img", "aria-label": figure.title });
    /** @type {((k: number) => void)[]} */
    this.acts = [];
    /** What is tied: strokes; letters, with how far each is off its point on the sheet, and since lengths were changed. */
    /** @type {Variant[][]} */
    this.strokes = [];
    /** @type {{made: SVGElement, variants: Variant[], aside: (k: number) => [number, number]}[]} */
    this.letters = [];
    /** @type {(((k: number) => [number, number]) | null)[]} */
    this.asides = [];
    this.box = figure.box;
    this.released = 0;
    /** How much larger letters are than on the sheet: so much farther they stand off their points. */
    this.larger = 1;
    /** @type {[number, boolean] | null} */
    this.shown = null;
    this.body = drawnElement("g", { class: "body" });
    const pens = layers(dense, figure.still ?? []);
    for (const line of figure.lines) this.line(line, rows, pens);
    for (const layer of pens.values()) if (layer.childElementCount > 0) this.body.append(layer);
    this.svg.append(this.body);
    const stays = (figure.stands ?? []).map(([n, x, y]) => drawnElement("g", { class: "stays", transform: `translate(${hundredths(x)} ${hundredths(-y)})` }, written(dense.glyphs[n])));
    this.svg.append(...stays);
    this.numbers = numbersAboutPin(dense, figure, this.svg, /** @type {SVGGraphicsElement[]} */ (stays));
    const letters = drawnElement("g", { class: "letters" });
    for (const [n, x, y, there, variants] of figure.letters) {
      const made = drawnElement("g", {}, written(dense.glyphs[n]));
      const [u, v] = [placeOf(x, rows), placeOf(y, rows)];
      if (variants === undefined) this.act(made, there, (k) => moved(made, u(k), v(k)));
      else this.letter(made, variants, (k) => [u(k), v(k)]);
      letters.append(made);
    }
    this.body.append(letters);
    /** What its ink is tied to. */
    this.nodes = ink?.expressions.nodesOf([...this.strokes, ...this.letters.map((one) => one.variants)].flat()) ?? [];
    this.last = "";
  }

  /**
   * @param {SVGElement} made
   * @param {Variant[]} variants
   * @param {(k: number) => [number, number]} aside
   */
  letter(made, variants, aside) {
    const n = this.letters.push({ made, variants, aside }) - 1;
    made.classList.add("tied");
    this.tie(made, variants, ([, [at = 0]], { re, im }, k) => {
      const own = this.asides[n];
      const [u, v] = (own ?? aside)(k);
      const times = own ? 1 : this.larger;
      moved(made, (re[at] ?? 0) + times * u, (im[at] ?? 0) + times * v);
    });
  }

  /**
   * @param {MovingFigure["lines"][number]} line
   * @param {Float32Array[]} rows
   * @param {Map<string, Element>} pens
   */
  line([pen, flags, coordinates, bends, there, variants], rows, pens) {
    const made = drawnElement("path", flags >= 2 ? { fill: "var(--ink)", stroke: "none" } : {});
    const closed = flags % 2 === 1;
    const places = coordinates.map((one) => placeOf(one, rows));
    const bulges = bulgesOf(bends, rows);
    const at = new Float64Array(places.length);
    pens.get(pen)?.append(made);
    if (variants !== undefined) {
      this.strokes.push(variants);
      this.tie(made, variants, ([, nodes, bent], { re, im }) => {
        const own = new Float64Array(2 * nodes.length);
        nodes.forEach((node, n) => {
          own[2 * n] = re[node] ?? NaN;
          own[2 * n + 1] = im[node] ?? NaN;
        });
        made.setAttribute("d", pathOf(own, bent === 0 ? null : bent.map((node) => re[node] ?? 0), closed));
      }, coordinates.length === 0);
    }
    if (coordinates.length === 0) return;
    if (rigid(coordinates, bends)) {
      const first = [apart(coordinates[0]), apart(coordinates[1])];
      coordinates.forEach((one, n) => (at[n] = apart(one) - (first[n % 2] ?? 0)));
      made.setAttribute("d", pathOf(at, bulges(0), closed));
      const [x, y] = /** @type {[(k: number) => number, (k: number) => number]} */ (places);
      this.act(made, there, (k) => moved(made, x(k), y(k)));
    } else {
      this.act(made, there, (k) => {
        places.forEach((place, n) => (at[n] = place(k)));
        made.setAttribute("d", pathOf(at, bulges(k), closed));
      });
    }
  }

  /**
   * Let something follow the angle wherever it is there, with the lengths that are given.
   * @param {SVGElement} made
   * @param {number[] | 0} runs
   * @param {(k: number) => void} follow
   */
  act(made, runs, follow) {
    const there = presenceOf(runs, this.drawn);
    this.acts.push((k) => {
      const now = this.ink?.changed !== true && (there === null || there[k] === 1);
      show(made, now);
      if (now) follow(k);
    });
  }

  /**
   * Let something follow its marks by the variant that holds.
   * @param {SVGElement} made
   * @param {Variant[]} variants
   * @param {(own: Variant, of: Expressions, k: number) => void} follow
   * @param {boolean} always also with the lengths that are given
   */
  tie(made, variants, follow, always = true) {
    const { ink } = this;
    if (ink === null) return;
    this.acts.push((k) => {
      if (!always && !ink.changed) return;
      const own = ink.expressions.drawn(variants);
      show(made, own !== undefined);
      if (own !== undefined) follow(own, ink.expressions, k);
    });
  }

  /**
   * Show an angle.
   * @param {number} k
   * @param {boolean} drawn
   */
  show(k, drawn) {
    this.shown = [k, drawn];
    this.settle(k);
    const place = `${k} ${this.ink?.version ?? 0}`;
    if (place === this.last) return;
    this.last = place;
    this.ink?.at(k, this.nodes);
    this.body.setAttribute("visibility", drawn ? "visible" : "hidden");
    if (drawn) for (const act of this.acts) act(k);
  }

  /**
   * Take notice of how much larger letters are.
   * @param {number} larger
   */
  enlarged(larger) {
    if (larger === this.larger) return;
    this.larger = larger;
    this.last = "";
    this.numbers();
    if (this.shown !== null) this.show(...this.shown);
  }

  /**
   * Take the room that it needs once lengths are no longer being changed.
   * @param {number} k
   */
  settle(k) {
    const { ink } = this;
    if (ink === null || ink.released === this.released) return;
    this.released = ink.released;
    this.last = "";
    let larger = "";
    // in another box letters are told larger, and take more of it
    for (let n = 0; n < 2 && larger !== this.svg.style.getPropertyValue("--larger"); n++) {
      larger = this.svg.style.getPropertyValue("--larger");
      this.box = ink.settle(this, k) ?? this.figure.box;
      this.svg.dispatchEvent(new Event("settled"));
    }
  }
}

/**
 * Show an element or hide it, if it is not as that already.
 * @param {SVGElement} made
 * @param {boolean} now
 */
function show(made, now) {
  const told = now ? "inherit" : "hidden";
  if (made.getAttribute("visibility") !== told) made.setAttribute("visibility", told);
}

/**
 * @param {SVGElement} made
 * @param {number} x
 * @param {number} y
 */
function moved(made, x, y) {
  made.setAttribute("transform", `translate(${hundredths(x)} ${hundredths(-y)})`);
}

/**
 * How far a coordinate is from its row, mm; a number is from none.
 * @param {number[] | undefined} told
 */
function apart(told) {
  return (told?.at(-1) ?? 0) / 1000;
}

/**
 * @param {0 | number[][]} bends
 * @param {Float32Array[]} rows
 * @returns {(k: number) => number[] | null}
 */
function bulgesOf(bends, rows) {
  if (bends === 0) return () => null;
  const bulges = bends.map((one) => placeOf(one, rows));
  return (k) => bulges.map((bulge) => bulge(k) / 1000);
}

/**
 * Whether a stroke only shifts: all its x are one row and distances from it, or numbers, and all its y; no bend varies.
 * @param {number[][]} coordinates
 * @param {0 | number[][]} bends
 */
function rigid(coordinates, bends) {
  const row = (/** @type {number[] | undefined} */ one) => (one?.length === 2 ? one[0] : undefined);
  const bent = bends === 0 || bends.every((one) => one.length === 1);
  return bent && coordinates.every((one, n) => row(one) === row(coordinates[n % 2]));
}
