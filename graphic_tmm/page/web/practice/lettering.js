import { drawnElement } from "../dom.js";

/** @typedef {import("./figures.js").Spot} Spot */

/** On so many sides of a point its letter is tried. */
const AROUND = 16;
/** How much smaller an index is, how far down or up it stands, em. */
const INDEX = { size: 0.7, down: 0.3, up: -0.45 };

/**
 * Return a letter as SVG: v_{BA} has an index, a^{n} stands raised.
 * @param {string} markup
 * @param {Record<string, string | number>} attributes
 */
export function letterText(markup, attributes) {
  const text = drawnElement("text", attributes);
  /** @type {string[]} */
  const open = [];
  let height = 0;
  for (const piece of markup.split(/([_^]\{|\})/)) {
    if (piece === "_{" || piece === "^{") open.push(piece);
    else if (piece === "}") open.pop();
    else if (piece !== "") {
      const own = open.reduce((sum, sign) => sum + (sign === "_{" ? INDEX.down : INDEX.up), 0);
      const part = drawnElement("tspan", { dy: `${Number((own - height).toFixed(3))}em` });
      if (open.length > 0) part.classList.add("index");
      part.textContent = piece;
      text.append(part);
      height = own;
    }
  }
  return text;
}

/**
 * Return a place beside a point that is farthest from ink and from other letters.
 * @param {Spot} spot
 * @param {number} away
 * @param {Spot[]} black what is taken
 * @returns {Spot}
 */
export function besideOf([x, y], away, black) {
  /** @type {Spot} */
  let best = [x + away, y + away];
  let most = -1;
  for (let k = 0; k < AROUND; k += 1) {
    const turn = (2 * Math.PI * (k + 1)) / AROUND;
    /** @type {Spot} */
    const tried = [x + away * Math.cos(turn), y + away * Math.sin(turn)];
    const free = Math.min(2 * away, ...black.map(([px, py]) => Math.hypot(px - tried[0], py - tried[1])));
    if (free > most + 1e-9) [best, most] = [tried, free];
  }
  return best;
}
