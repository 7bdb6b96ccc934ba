import { turnAt } from "./dense.js";
import { hundredths } from "./strokes.js";

/**
 * @typedef {import("./types.js").Complex} Complex
 * @typedef {(pins?: (Complex | null)[] | null) => void} PutNumbers
 */

/** A number that stands nearer to the pin than this in its position is that of the pin, mm. */
const BY_PIN = 12;

/**
 * Return what puts the numbers of positions about the circle of the crank's pin, so much farther off as letters are
 * larger: where the pin is at all angles, null with the lengths that are given; left out: as before.
 * @param {import("./types.js").Dense} dense
 * @param {import("./types.js").MovingFigure} figure
 * @param {SVGElement} svg
 * @param {SVGGraphicsElement[]} stays as `stands` of the figure tells them
 * @returns {PutNumbers}
 */
export function numbersAboutPin(dense, figure, svg, stays) {
  const { zero } = dense;
  const [x = 0, y = 0, length = 0] = figure.crank ?? [];
  /** @type {(Complex | null)[] | null | undefined} */
  let known = null;
  const numbers = (length > 0 ? (figure.stands ?? []) : []).flatMap(([n, left, low], at) => {
    const index = dense.positions.find(([name]) => name === dense.glyphs[n]?.[0])?.[1];
    const made = stays[at];
    if (index === undefined || made === undefined) return [];
    const angle = ((zero + dense.sense * turnAt(dense, index)) * Math.PI) / 180;
    const pin = { re: x + length * Math.cos(angle), im: y + length * Math.sin(angle) };
    if (Math.hypot(left - pin.re, low - pin.im) > BY_PIN) return [];
    made.classList.add("numbered");
    return [{ made, index, pin, off: { re: left - pin.re, im: low - pin.im } }];
  });
  return (pins = known) => {
    known = pins;
    const larger = Number(svg.style.getPropertyValue("--larger")) || 1;
    const turn = ((dense.zero - zero) * Math.PI) / 180;
    const [cos, sin] = [larger * Math.cos(turn), larger * Math.sin(turn)];
    for (const { made, index, pin, off } of numbers) {
      const now = pins ? (pins[index] ?? null) : pin;
      made.setAttribute("visibility", now === null ? "hidden" : "inherit");
      if (now === null) continue;
      const box = made.getBBox();
      const [u, v] = [box.x + box.width / 2, -box.y - box.height / 2];
      const [p, q] = [off.re + u, off.im + v];
      const place = [now.re + cos * p - sin * q - u, v - now.im - sin * p - cos * q];
      made.setAttribute("transform", `translate(${place.map(hundredths).join(" ")})`);
    }
  };
}
