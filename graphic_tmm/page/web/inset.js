import { drawnElement, element } from "./dom.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").View} View
 * @typedef {import("./types.js").Joint} Joint
 * @typedef {[number, number]} Spot
 */

/** What of the ink of a mechanism says nothing of the position it stands in. */
const LEFT_OUT = ".label, title, desc, [data-part=number], [data-part=leader], [data-part=turning], path:not([data-of])";
/** Sizes that are tried, as a share of the paper; the first that hides no ink, else the place that hides least. */
const SHARES = [0.27, 0.22, 0.17];
/** It is at most so much larger in height than in width, as shares of the paper. */
const UPRIGHT = 1.6;
/** Letters: at least so many px, a share of the height of the paper; on so many sides of a point they are tried. */
const LETTERING = { least: 13, share: 1 / 42 };
const SIDES = 16;
/** Between places that are asked for their ink, mm. */
const STRIDE = 2;

/**
 * Put the mechanism in the position of a view on its paper; null if the view has none.
 * @param {Data} data
 * @param {View} view
 * @param {SVGElement} stage
 * @param {HTMLElement} paper
 */
export function insetOf(data, view, stage, paper) {
  const lead = data.views[view.mechanism ?? -1];
  if (lead === undefined) return null;
  const at = Object.keys(lead.names).find((k) => lead.names[k] === view.position);
  const ink = document.getElementById(lead.id);
  if (at === undefined || ink === null) return null;
  const copy = /** @type {SVGGraphicsElement} */ (/** @type {unknown} */ (ink.cloneNode(true)));
  copy.removeAttribute("id");
  for (const part of copy.querySelectorAll(`${LEFT_OUT}, [data-at]:not([data-at="${at}"])`)) part.remove();
  const inset = new Inset(view, lead, Number(at), copy, stage, paper);
  inset.svg.setAttribute("aria-label", data.words["mechanism"] ?? "");
  return inset;
}

/** The mechanism in the position of a view that is played, small, where the drawing leaves room. */
export class Inset {
  /**
   * @param {View} view
   * @param {View} lead
   * @param {number} at
   * @param {SVGGraphicsElement} ink
   * @param {SVGElement} stage
   * @param {HTMLElement} paper
   */
  constructor(view, lead, at, ink, stage, paper) {
    this.view = view;
    this.ink = ink;
    this.stage = stage;
    this.paper = paper;
    this.joined = lead.joined ?? {};
    this.used = /** @type {Set<number>} */ (new Set());
    this.mm = 0;
    this.joints = (lead.joints ?? []).filter((one) => placeOfJoint(one, at).some((x) => x !== 0));
    this.spots = new Map(this.joints.map((one) => [one[0], placeOfJoint(one, at)]));
    this.always = new Set(this.joints.filter((one) => one[2]).map((one) => one[0]));
    this.marks = drawnElement("g", { class: "marks" });
    this.svg = drawnElement("svg", { class: "inset", role: "img" }, ink, this.marks);
    paper.append(this.svg);
    const watch = new ResizeObserver(() => (this.svg.isConnected ? this.fit() : watch.disconnect()));
    watch.observe(paper);
  }

  /**
   * Light what the step of a stop takes from the mechanism.
   * @param {number} n
   */
  show(n) {
    const lines = this.view.pictures[n]?.lines ?? [];
    this.used = new Set(lines.flatMap((line) => [...(line.uses ?? []), ...(line.it === undefined ? [] : [line.it])]));
    this.mark();
  }

  /** Stand where the paper has room for it, large enough for its letters. */
  fit() {
    const { svg, ink, paper } = this;
    if (paper.clientWidth === 0) return;
    const own = ink.getBBox();
    const around = Math.max(own.width, own.height) * 0.07;
    const [wide, high] = [own.width + 2 * around, own.height + 2 * around];
    const box = [own.x - around, own.y - around, wide, high];
    svg.setAttribute("viewBox", box.map((x) => x.toFixed(2)).join(" "));
    const taken = onScreen(this.stage, paper);
    const found = SHARES.flatMap((share) => {
      const scale = Math.min((paper.clientWidth * share) / wide, (paper.clientHeight * share * UPRIGHT) / high);
      return placesOn(paper, wide * scale, high * scale);
    });
    const hidden = found.map((place) => taken.filter((spot) => coveredBy(spot, place)).length);
    const [left, top, width, height] = found[hidden.indexOf(Math.min(...hidden))] ?? [0, 0, 1, 1];
    for (const [side, px] of Object.entries({ left, top, width, height })) svg.style.setProperty(side, `${px}px`);
    this.mm = wide / width;
    this.mark();
  }

  /** Draw the lines and the letters over the ink. */
  mark() {
    if (this.mm === 0) return;
    const { spots, used } = this;
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
   * Return the letters of the points, and dots on those that are used.
   * @param {Set<number>} named
   */
  letters(named) {
    const size = Math.max(LETTERING.least, this.paper.clientHeight * LETTERING.share) * this.mm;
    const black = placesOfInk(this.ink);
    const made = [];
    for (const [slot, letter] of this.joints.filter((one) => one[2] || named.has(one[0]))) {
      const spot = this.spots.get(slot) ?? [0, 0];
      const side = named.has(slot) ? "used" : "";
      const dot = { cx: spot[0], cy: spot[1], r: 3.5 * this.mm, class: "used", "data-of": slot };
      if (side !== "") made.push(drawnElement("circle", dot));
      const [x, y] = freeSide(spot, 0.85 * size, black);
      for (let k = -1; k <= 1; k += 1) black.push([x + 0.4 * k * size, y]);
      const text = drawnElement("text", { x, y, "font-size": size, class: side, "data-of": slot });
      text.textContent = letter;
      made.push(text);
    }
    return made;
  }
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
 * Return where something of a size may stand on the paper, the best first: left, top, width, height, px.
 * @param {HTMLElement} paper
 * @param {number} w
 * @param {number} h
 * @returns {[number, number, number, number][]}
 */
function placesOn(paper, w, h) {
  const [right, low] = [paper.clientWidth - w, paper.clientHeight - h];
  return [0, low, low / 2].flatMap((y) => [right, 0].map((x) => /** @type {[number, number, number, number]} */ ([x, y, w, h])));
}

/**
 * @param {Spot} spot
 * @param {[number, number, number, number]} box
 */
function coveredBy([x, y], [left, top, width, height]) {
  return x > left && x < left + width && y > top && y < top + height;
}

/**
 * Return the place beside a point that is farthest from ink.
 * @param {Spot} spot
 * @param {number} away
 * @param {Spot[]} black
 * @returns {Spot}
 */
function freeSide([x, y], away, black) {
  let [best, most] = [/** @type {Spot} */ ([x, y]), -1];
  for (let k = 0; k < SIDES; k += 1) {
    const turn = (2 * Math.PI * k) / SIDES;
    const [tx, ty] = [x + away * Math.cos(turn), y + away * Math.sin(turn)];
    const free = Math.min(...black.map(([px, py]) => Math.hypot(px - tx, py - ty)));
    if (free > most) [best, most] = [[tx, ty], free];
  }
  return best;
}

/**
 * Return places on the ink of a drawing, in its own millimetres.
 * @param {Element} drawing
 * @returns {Spot[]}
 */
function placesOfInk(drawing) {
  /** @type {Spot[]} */
  const found = [];
  for (const path of drawing.querySelectorAll("path")) {
    const long = path.getTotalLength();
    for (let at = 0; at <= long; at += STRIDE) {
      const { x, y } = path.getPointAtLength(at);
      found.push([x, y]);
    }
  }
  return found;
}

/**
 * Return where the ink of a stage is within the paper, px.
 * @param {SVGElement} stage
 * @param {HTMLElement} paper
 * @returns {Spot[]}
 */
function onScreen(stage, paper) {
  const to = /** @type {SVGSVGElement} */ (stage).getScreenCTM();
  const { left, top } = paper.getBoundingClientRect();
  if (to === null) return [];
  return [...stage.querySelectorAll("g.drawing")].flatMap(placesOfInk).map(([x, y]) => [x * to.a + to.e - left, y * to.d + to.f - top]);
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
