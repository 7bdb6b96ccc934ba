import { drawnElement, element } from "./dom.js";
import { coveredBy, divided, freeSide, onScreen, placesOfInk, placesOn } from "./inset-places.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").View} View
 * @typedef {import("./types.js").Joint} Joint
 * @typedef {import("./inset-places.js").Spot} Spot
 */

/** What of the ink of a mechanism says nothing of the position it stands in. */
const LEFT_OUT = ".label, title, desc, [data-part=number], [data-part=leader], [data-part=turning], path:not([data-of])";
/** White about the mechanism, for its letters, as a share of it. */
const INSET_EDGE = 0.1;
/** Sizes that are tried, as a share of the paper; the first that hides no ink, else the place that hides least. */
const SHARES = [0.36, 0.27, 0.22, 0.17];
/** It is at most so much larger in height than in width, as shares of the paper. */
const UPRIGHT = 1.6;
/** Letters: at least so many px, a share of the height of the paper. */
const LETTERING = { least: 13, share: 1 / 42 };
/** What a letter takes of the sheet, as shares of its size (system-ui, with its leading). */
const LETTER_BOX = { across: 0.85, down: 1.2 };

/**
 * Put the mechanism in the position of a view on its paper; null if the view has none.
 * @param {Data} data
 * @param {View} view
 * @param {SVGElement} stage
 * @param {HTMLElement} paper
 */
export function insetOf(data, view, stage, paper) {
  const lead = data.views[view.mechanism ?? -1];
  const ink = document.getElementById(lead?.id ?? "");
  paper.classList.remove("across", "down");
  if (lead === undefined || ink === null) return null;
  const inset = new Inset(view, lead, ink, stage, paper);
  inset.svg.setAttribute("aria-label", data.words["mechanism"] ?? "");
  return inset;
}

/**
 * The mechanism in the position of a view that is played: in a part of the paper of its own where that is large, else
 * small, where the drawing leaves room.
 */
export class Inset {
  /**
   * @param {View} view
   * @param {View} lead
   * @param {Element} source
   * @param {SVGElement} stage
   * @param {HTMLElement} paper
   */
  constructor(view, lead, source, stage, paper) {
    this.view = view;
    this.lead = lead;
    this.source = source;
    this.stage = stage;
    this.paper = paper;
    this.joined = lead.joined ?? {};
    this.used = /** @type {Set<number>} */ (new Set());
    this.name = "";
    this.mm = 0;
    this.ink = /** @type {SVGGraphicsElement} */ (drawnElement("g", {}));
    /** @type {Joint[]} */
    this.joints = [];
    /** @type {Map<number, Spot>} */
    this.spots = new Map();
    this.always = new Set((lead.joints ?? []).filter((one) => one[2]).map((one) => one[0]));
    this.marks = drawnElement("g", { class: "marks" });
    this.svg = drawnElement("svg", { class: view === lead ? "inset own" : "inset", role: "img" }, this.ink, this.marks);
    this.stand(nameAt(view, view.pictures.length));
    paper.append(this.svg);
    const watch = new ResizeObserver((seen) => {
      if (!this.svg.isConnected) return watch.disconnect();
      if (seen.some((one) => one.target === paper)) this.fit();
      this.mark();
    });
    watch.observe(paper);
    watch.observe(this.svg);
  }

  /**
   * Stand in a position; nowhere if the mechanism is not drawn in it.
   * @param {string} name
   */
  stand(name) {
    if (name === this.name) return;
    this.name = name;
    const { lead, svg } = this;
    const at = Object.keys(lead.names).find((k) => lead.names[k] === name);
    svg.toggleAttribute("hidden", at === undefined);
    if (at === undefined) return;
    const copy = /** @type {SVGGraphicsElement} */ (/** @type {unknown} */ (this.source.cloneNode(true)));
    copy.removeAttribute("id");
    for (const part of copy.querySelectorAll(`${LEFT_OUT}, [data-at]:not([data-at="${at}"])`)) part.remove();
    this.ink.replaceWith(copy);
    this.ink = copy;
    this.joints = (lead.joints ?? []).filter((one) => placeOfJoint(one, Number(at)).some((x) => x !== 0));
    this.spots = new Map(this.joints.map((one) => [one[0], placeOfJoint(one, Number(at))]));
  }

  /**
   * Stand in the position of a stop, and light what its step takes from the mechanism.
   * @param {number} n
   */
  show(n) {
    const lines = this.view.pictures[n]?.lines ?? [];
    this.used = new Set(lines.flatMap((line) => [...(line.uses ?? []), ...(line.it === undefined ? [] : [line.it])]));
    this.stand(nameAt(this.view, n));
    this.svg.classList.toggle("begun", n > 0);
    this.mark();
  }

  /** Stand beside the plan on a large paper, else where there is room, large enough for the letters. */
  fit() {
    const { svg, paper } = this;
    const [across, down] = [paper.clientWidth, paper.clientHeight];
    if (across === 0) return;
    const box = this.box();
    const [wide, high] = [box.width, box.height];
    svg.setAttribute("viewBox", [box.x, box.y, wide, high].map((x) => x.toFixed(2)).join(" "));
    const [, , planWide = 1, planHigh = 1] = (this.stage.getAttribute("viewBox") ?? "").split(" ").map(Number);
    if (divided(paper, [wide, high], [planWide, planHigh])) return;
    const taken = onScreen(this.stage, paper);
    const found = SHARES.flatMap((share) => {
      const scale = Math.min((across * share) / wide, (down * share * UPRIGHT) / high);
      return placesOn(paper, wide * scale, high * scale);
    });
    const hidden = found.map((place) => taken.filter((spot) => coveredBy(spot, place)).length);
    const [left, top, width, height] = found[hidden.indexOf(Math.min(...hidden))] ?? [0, 0, 1, 1];
    for (const [side, px] of Object.entries({ left, top, width, height })) svg.style.setProperty(`--${side}`, `${px}px`);
  }

  /** Return what of the sheet is shown, mm: the mechanism and white for its letters; where it moves, in all positions. */
  box() {
    const own = this.ink.getBBox();
    const [xs, ys] = [[own.x, own.x + own.width], [own.y, own.y + own.height]];
    for (const joint of this.view.position === "" ? (this.lead.joints ?? []).filter((one) => one[2]) : []) {
      for (const at of Object.keys(this.lead.names)) {
        const [x, y] = placeOfJoint(joint, Number(at));
        if (x === 0 && y === 0) continue;
        xs.push(x);
        ys.push(y);
      }
    }
    const [x, y] = [Math.min(...xs), Math.min(...ys)];
    const [width, height] = [Math.max(...xs) - x, Math.max(...ys) - y];
    const around = Math.max(width, height) * INSET_EDGE;
    return { x: x - around, y: y - around, width: width + 2 * around, height: height + 2 * around };
  }

  /** Draw the lines and the letters over the ink. */
  mark() {
    const { spots, used, svg } = this;
    const [, , wide = 0, high = 0] = (svg.getAttribute("viewBox") ?? "").split(" ").map(Number);
    if (wide === 0 || svg.clientWidth === 0) return;
    this.mm = Math.max(wide / svg.clientWidth, high / svg.clientHeight);
    /** @type {Set<number>} */
    const named = new Set();
    const made = [];
    for (const slot of used) {
      const on = this.pointsOf(slot);
      const d = on.map((one, k) => `${k === 0 ? "M" : "L"}${spots.get(one)?.join(" ")}`).join("");
      if (on.length > 1) made.push(drawnElement("path", { d, class: "used", "data-of": slot }));
      on.forEach((one) => named.add(one));
    }
    for (const part of this.ink.querySelectorAll("path")) {
      const slots = (part.getAttribute("data-of") ?? "").split(" ").map(Number);
      part.classList.toggle("used", slots.some((slot) => used.has(slot) && this.pointsOf(slot).length === 0));
    }
    this.marks.replaceChildren(...made, ...this.letters(named));
  }

  /**
   * Return the points that a mark stands for: itself, those that a line joins.
   * @param {number} slot
   */
  pointsOf(slot) {
    if (this.spots.has(slot)) return [slot];
    return (this.joined[slot] ?? []).filter((one) => this.always.has(one));
  }

  /**
   * Return the letters of the points, and dots on those that are used; a letter with no room among the others is left out.
   * @param {Set<number>} named
   */
  letters(named) {
    const size = Math.max(LETTERING.least, this.paper.clientHeight * LETTERING.share) * this.mm;
    const black = placesOfInk(this.ink);
    const made = [];
    /** @type {Spot[]} */
    const placed = [];
    const due = this.joints.filter((one) => one[2] || named.has(one[0]));
    for (const [slot, letter] of due.sort((a, b) => Number(named.has(b[0])) - Number(named.has(a[0])))) {
      const spot = this.spots.get(slot) ?? [0, 0];
      const side = named.has(slot) ? "used" : "";
      const dot = { cx: spot[0], cy: spot[1], r: 3.5 * this.mm, class: "used", "data-of": slot };
      if (side !== "") made.push(drawnElement("circle", dot));
      const [x, y] = freeSide(spot, 0.85 * size, black);
      if (placed.some(([px, py]) => Math.abs(px - x) < LETTER_BOX.across * size && Math.abs(py - y) < LETTER_BOX.down * size)) continue;
      placed.push([x, y]);
      for (let k = -1; k <= 1; k += 1) black.push([x + 0.4 * k * size, y]);
      const text = drawnElement("text", { x, y, "font-size": size, class: side, "data-of": slot });
      text.textContent = letter;
      made.push(text);
    }
    return made;
  }
}

/**
 * Return the name of the position in which a view is at a stop; ready it is in its main one.
 * @param {View} view
 * @param {number} n
 */
function nameAt(view, n) {
  return view.position || (view.names[String(view.pictures[n]?.at ?? view.first)] ?? "");
}

/**
 * @param {Joint} joint
 * @param {number} at
 * @returns {Spot}
 */
function placeOfJoint(joint, at) {
  return [Number(joint[3 + 2 * at] ?? 0), Number(joint[4 + 2 * at] ?? 0)];
}

/**
 * Return the switch that takes the mechanism off the paper.
 * @param {Data} data
 */
export function insetSwitch(data) {
  const box = /** @type {HTMLInputElement} */ (element("input", { type: "checkbox" }));
  box.checked = true;
  box.addEventListener("change", () => document.documentElement.classList.toggle("alone", !box.checked));
  return element("label", { class: "switch" }, box, ` ${data.words["mechanism"] ?? ""}`);
}
