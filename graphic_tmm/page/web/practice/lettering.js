import { drawnElement } from "../dom.js";

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
