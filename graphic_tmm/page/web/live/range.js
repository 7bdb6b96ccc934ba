import { drawnElement } from "../dom.js";

/**
 * @typedef {import("../types.js").Dense} Dense
 * @typedef {import("../types.js").Complex} Complex
 */

/**
 * Put on the figure of a mechanism the arc of the pin's circle over which it can be assembled, and the paths of points;
 * what stands about it for the lengths that are given is hidden while others are.
 * @param {SVGElement} svg
 * @param {Dense} dense
 * @param {number} count how many paths there are
 * @param {import("../numbers.js").PutNumbers} [numbers] puts the numbers of positions
 */
export function turnedInk(svg, dense, count, numbers) {
  const range = drawnElement("path", { class: "range" });
  const paths = Array.from({ length: count }, () => drawnElement("path", { class: "way" }));
  svg.prepend(range, ...paths);
  return (/** @type {boolean} */ own, /** @type {(Complex | null)[]} */ pins, /** @type {(Complex | null)[][]} */ ways) => {
    svg.classList.toggle("own", own);
    numbers?.(own ? pins : null);
    range.setAttribute("d", own ? through(pins, dense) : "");
    paths.forEach((path, n) => path.setAttribute("d", own ? through(ways[n] ?? [], dense) : ""));
  };
}

/**
 * Return the path through places at all angles, broken where there is none.
 * @param {(Complex | null)[]} places
 * @param {Dense} dense
 */
function through(places, dense) {
  let text = "";
  let goes = false;
  const count = dense.ends === undefined ? dense.whole + 1 : dense.whole;
  for (let n = 0; n < count; n++) {
    const place = places[n % dense.whole] ?? null;
    if (place !== null) text += `${goes ? "L" : "M"}${place.re.toFixed(2)} ${(-place.im).toFixed(2)}`;
    goes = place !== null;
  }
  return text;
}
