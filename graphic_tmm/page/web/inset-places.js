/** @typedef {[number, number]} Spot */

/** A paper of so many px either way has a part for the mechanism, so large a share of it. */
const LARGE_PAPER = 420;
const ASIDE = 0.38;
/** It keeps so far from the edges of the paper, that its letters have room, px. */
const CLEAR_EDGE = 10;
/** On so many sides of a point its letter is tried. */
const SIDES = 16;
/** Between places that are asked for their ink, mm. */
const STRIDE = 2;

/**
 * Return where something of a size may stand on the paper, the best first: left, top, width, height, px.
 * @param {HTMLElement} paper
 * @param {number} w
 * @param {number} h
 * @returns {[number, number, number, number][]}
 */
export function placesOn(paper, w, h) {
  const [right, low] = [paper.clientWidth - w - CLEAR_EDGE, paper.clientHeight - h - CLEAR_EDGE];
  return [CLEAR_EDGE, low, low / 2].flatMap((y) => [right, CLEAR_EDGE].map((x) => /** @type {[number, number, number, number]} */ ([x, y, w, h])));
}

/**
 * @param {Spot} spot
 * @param {[number, number, number, number]} box
 */
export function coveredBy([x, y], [left, top, width, height]) {
  return x > left && x < left + width && y > top && y < top + height;
}

/**
 * Return the place beside a point that is farthest from ink.
 * @param {Spot} spot
 * @param {number} away
 * @param {Spot[]} black
 * @returns {Spot}
 */
export function freeSide([x, y], away, black) {
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
export function placesOfInk(drawing) {
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
export function onScreen(stage, paper) {
  const to = /** @type {SVGSVGElement} */ (stage).getScreenCTM();
  const { left, top } = paper.getBoundingClientRect();
  if (to === null) return [];
  return [...stage.querySelectorAll("g.drawing")].flatMap(placesOfInk).map(([x, y]) => [x * to.a + to.e - left, y * to.d + to.f - top]);
}

/**
 * Divide a large paper between mechanism and plan, where both are largest; return whether it is divided.
 * @param {HTMLElement} paper
 * @param {[number, number]} own width and height of the mechanism, mm
 * @param {[number, number]} plan
 */
export function divided(paper, own, plan) {
  const [wide, high] = [paper.clientWidth, paper.clientHeight];
  const scale = (/** @type {number} */ w, /** @type {number} */ h, /** @type {[number, number]} */ of) => Math.min(w / of[0], h / of[1]);
  const across = scale(ASIDE * wide, high, own) * scale((1 - ASIDE) * wide, high, plan);
  const down = scale(wide, ASIDE * high, own) * scale(wide, (1 - ASIDE) * high, plan);
  const large = Math.min(wide, high) >= LARGE_PAPER;
  paper.classList.toggle("across", large && across >= down);
  paper.classList.toggle("down", large && across < down);
  return large;
}
